// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "text_file.h"

#include <pcl/types.h>

#include "cloud_fields.h"
#include "header_reader.h"
#include "output_file.h"
#include "text_columns.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <vector>

namespace pcl_ops::apps {

namespace {

constexpr std::size_t max_columns = 1000;

class TextReader {
public:
  explicit TextReader (const std::string& file) : file_ (file), reader_ (file, "text")
  {}

  pcl::PCLPointCloud2
  read ()
  {
    readHead();
    pcl::PCLPointCloud2 cloud;
    setFields (cloud);
    // Lines are about as long as the first.
    const std::uint64_t expected = reader_.fileSize() / (line_.size() + 1) + 1;
    cloud.data.reserve (std::min (expected, promised_.value_or (expected)) *
                        cloud.point_step);
    std::uint64_t points = 0;
    do {
      const auto* const bytes = reinterpret_cast<const std::uint8_t*> (numbers_.data());
      cloud.data.insert (cloud.data.end(), bytes, bytes + cloud.point_step);
      ++points;
      checkPoints (points);
    }
    while (readPoint());
    if (promised_ && points < *promised_)
      reader_.failTruncated();
    cloud.width = static_cast<pcl::uindex_t> (points);
    cloud.height = 1;
    cloud.row_step = cloud.point_step * cloud.width;
    return cloud;
  }

private:
  /** \brief Goes on to the next line that is neither empty nor a comment. \return false
   * where there is none */
  bool
  nextLine ()
  {
    while (reader_.readLine (line_)) {
      line_.resize (line_.find_last_not_of (" \t\r") + 1);
      if (line_.find ('\r') != std::string::npos)
        reader_.failAtLine ("has a carriage return within, as if it were several");
      const std::size_t begin = line_.find_first_not_of (" \t");
      if (begin == std::string::npos)
        continue;
      if (line_[begin] != '#' && line_.compare (begin, 2, "//") != 0)
        return true;
      if (!has_points_)
        readComment (line_.substr (begin));
    }
    return false;
  }

  /** \brief A comment has names of columns where x, y and z are among them. */
  void
  readComment (const std::string& comment)
  {
    const std::size_t begin = comment.find_first_not_of ("#/ \t");
    const Words words =
        begin == std::string::npos ? Words() : wordsOf (comment.substr (begin));
    if (nameCoordinates (words))
      comment_names_ = words;
  }

  /** \brief Reads up to the first point, that too. */
  void
  readHead ()
  {
    checkEncoding();
    while (nextLine()) {
      const Words words = wordsOf (line_);
      const bool is_number_of_points = words.size() == 1 && !promised_;
      if (names_.empty() && areNames (words)) {
        names_ = words;
        continue;
      }
      separator_ = separatorOf (line_);
      readNumbers();
      if (is_number_of_points) {
        promised_ = reader_.count ("its number of points", words[0]);
        continue;
      }
      has_points_ = true;
      return checkColumns();
    }
    reader_.failEmpty();
  }

  /** \brief Leaves out the mark of UTF-8. */
  void
  checkEncoding ()
  {
    std::string mark (std::min<std::uint64_t> (3, reader_.fileSize()), '\0');
    reader_.read (mark.data(), mark.size());
    const std::string start = mark.substr (0, 2);
    if (start == "\xff\xfe" || start == "\xfe\xff")
      reader_.fail ("it is UTF-16, not UTF-8");
    if (mark != "\xef\xbb\xbf")
      reader_.goTo (0);
  }

  void
  checkColumns ()
  {
    const std::size_t count = numbers_.size();
    if (count < 3)
      reader_.failAtLine ("has " + std::to_string (count) +
                          (count == 1 ? " number" : " numbers") +
                          ", and a point has x, y and z");
    if (count > max_columns)
      reader_.failAtLine ("has more than " + std::to_string (max_columns) + " numbers");
    if (!names_.empty() && names_.size() != count)
      reader_.failAtLine ("has " + std::to_string (count) + " numbers for " +
                          std::to_string (names_.size()) + " names of columns");
    // A comment is no promise.
    if (names_.empty() && comment_names_.size() == count)
      names_ = comment_names_;
  }

  void
  setFields (pcl::PCLPointCloud2& cloud) const
  {
    cloud.point_step = 0;
    const NumberType& type = numberType (pcl::PCLPointField::FLOAT64);
    for (const std::string& name : fieldNames (file_, names_, numbers_.size()))
      addField (name, type, 1, cloud);
  }

  void
  checkPoints (std::uint64_t points) const
  {
    if (promised_ && points > *promised_)
      reader_.failAtLine ("is more than its header promises");
    if (points > static_cast<std::uint64_t> (std::numeric_limits<pcl::index_t>::max()))
      reader_.fail ("it has more points than an index can tell apart");
  }

  void
  readNumbers ()
  {
    words_.take (line_, separator_);
    numbers_.resize (words_.size());
    for (std::size_t i = 0; i < numbers_.size(); ++i)
      numbers_[i] = words_.number (i);
  }

  bool
  readPoint ()
  {
    const std::size_t count = numbers_.size();
    if (!nextLine())
      return false;
    readNumbers();
    words_.expectNumbers (count);
    return true;
  }

  std::string file_;
  HeaderReader reader_;
  NumberLines words_{reader_};
  std::string line_;
  Words names_, comment_names_;
  std::optional<std::uint64_t> promised_;
  char separator_ = ' ';
  bool has_points_ = false;
  std::vector<double> numbers_;
};

} // namespace

bool
isTextFile (const std::string& file)
{
  const std::string extension = extensionOf (file);
  return extension == ".xyz" || extension == ".txt" || extension == ".pts" ||
         extension == ".csv";
}

pcl::PCLPointCloud2
readTextCloud (const std::string& file)
{
  return TextReader (file).read();
}

} // namespace pcl_ops::apps
