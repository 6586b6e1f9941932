// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/join.hpp>
#include <boost/algorithm/string/trim.hpp>

#include "cloud_formats.h"
#include "file_reader.h"
#include "number_list.h"
#include "output_file.h"
#include "point_rows.h"
#include <cli/errors.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <locale>
#include <optional>
#include <set>
#include <string_view>

namespace pcl_ops::apps {

namespace {

/** \brief The names of a coordinate: first that of the field, then those that surveyors
 * and ParaView use. */
using AxisNames = std::array<const char*, 5>;

constexpr std::array<AxisNames, 3> axes = {
    {{"x", "easting", "east", "e", "points:0"},
     {"y", "northing", "north", "n", "points:1"},
     {"z", "elevation", "height", "h", "points:2"}}};

/** \brief Whether a word is a name: it begins with a letter, which may be beyond ASCII,
 * or with an underscore, and is no number as "nan" is. */
bool
isName (const std::string& word)
{
  constexpr unsigned char last_ascii = 127;
  const auto first = static_cast<unsigned char> (word[0]);
  const bool begins_as_name =
      std::isalpha (first) != 0 || first == '_' || first > last_ascii;
  double ignored = 0.0;
  return begins_as_name &&
         !numberType (pcl::PCLPointField::FLOAT64).parse (word, &ignored);
}

/** \brief A name in small letters, up to the first bracket, in which is a unit. */
std::string
plainName (const std::string& name)
{
  std::string plain = name.substr (0, name.find_first_of ("[("));
  plain.resize (plain.find_last_not_of (" \t_") + 1);
  return boost::algorithm::to_lower_copy (plain, std::locale::classic());
}

/** \brief The column of a coordinate: the one called exactly axis[0]. Else it is looked
 * up by the \ref plainName of the columns: the first one called axis[0], else the first
 * one called axis[1], and so on. The end of \p names if there is none. */
Words::const_iterator
findAxis (const Words& names, const AxisNames& axis)
{
  auto found = std::find (names.begin(), names.end(), axis[0]);
  for (std::size_t i = 0; i < axis.size() && found == names.end(); ++i)
    found = std::find_if (names.begin(), names.end(), [&] (const std::string& name) {
      return plainName (name) == axis[i];
    });
  return found;
}

/** \brief Returns a name in a form that headers of clouds allow: without blanks, and
 * short. Empty if it is only an underscore, which a PCD calls padding. */
std::string
allowedName (std::string name)
{
  constexpr std::size_t max_length = 100;
  name.resize (std::min (name.size(), max_length));
  for (char& c : name)
    c = std::isspace (static_cast<unsigned char> (c)) != 0 ||
                std::iscntrl (static_cast<unsigned char> (c)) != 0
            ? '_'
            : c;
  return name == "_" ? "" : name;
}

/** \brief What separates the words of a line, for \ref splitWords: a semicolon if it
 * has one, else a comma, else blanks. */
char
separatorOf (const std::string& line)
{
  for (const char separator : {';', ','})
    if (line.find (separator) != std::string::npos)
      return separator;
  return ' ';
}

/** \brief The words of a line, without blanks and quotes around them. */
Words
wordsOf (const std::string& line)
{
  std::vector<std::string_view> parts;
  splitWords (line, separatorOf (line), parts);
  Words words (parts.begin(), parts.end());
  for (std::string& word : words)
    boost::algorithm::trim_if (word, boost::algorithm::is_any_of ("\"'"));
  return words;
}

/** \brief A line divided at its quotes: parts of odd index are quoted. Empty if the
 * last quote is not closed. */
std::vector<std::string>
quotedParts (const std::string& line)
{
  std::vector<std::string> parts (1);
  for (const char c : line)
    if (c == '"')
      parts.emplace_back();
    else
      parts.back() += c;
  if (parts.size() % 2 == 0)
    parts.clear();
  return parts;
}

/** \brief Removes the quotes from a line, and puts underscores in place of separators
 * within them, which would divide a word. A line whose last quote is not closed stays.
 * \throws WorkError if a quoted number has a decimal comma, but commas separate words
 */
void
removeQuotes (const FileReader& reader, std::string& line)
{
  std::vector<std::string> parts = quotedParts (line);
  if (parts.size() < 2)
    return;
  std::string outside;
  for (std::size_t i = 0; i < parts.size(); i += 2)
    outside += parts[i];
  const char separator = separatorOf (outside);
  // Characters that would divide a quoted word, or change the separator of the line.
  const std::string replaced = separator == ';'   ? ";"
                               : separator == ',' ? ",;"
                                                  : ",; \t";
  for (std::size_t i = 1; i < parts.size(); i += 2) {
    const bool is_number =
        parts[i].find_first_not_of ("0123456789+-.,") == std::string::npos;
    const bool has_comma = parts[i].find (',') != std::string::npos;
    if (is_number && has_comma && separator != ';')
      reader.failAtLine ("has '" + parts[i] +
                         "', a number with a decimal comma in place of a point");
    for (char& c : parts[i])
      c = replaced.find (c) == std::string::npos ? c : '_';
  }
  line = boost::algorithm::join (parts, "");
}

/** \brief Whether the commas between the words of a line look like decimal commas: all
 * words are whole numbers, and one of several digits, behind the first word, begins
 * with a zero, as 05 in 3,05. */
bool
mayHaveDecimalCommas (const FileReader& reader)
{
  constexpr std::size_t min_words = 6; // two for each of three coordinates
  bool has_leading_zero = false;
  for (std::size_t i = 0; i < reader.wordCount(); ++i) {
    const std::string_view word = reader.word (i);
    const std::size_t first_digit = !word.empty() && word[0] == '-' ? 1 : 0;
    if (word.find_first_not_of ("0123456789", first_digit) != std::string_view::npos)
      return false;
    has_leading_zero = has_leading_zero || (i > 0 && word.size() > 1 && word[0] == '0');
  }
  return has_leading_zero && reader.wordCount() >= min_words;
}

/** \brief Whether words can be the names of columns: one is a name, and the others are
 * names or empty. */
bool
areNames (const Words& words)
{
  return std::any_of (words.begin(), words.end(), isName) &&
         std::all_of (words.begin(), words.end(), [] (const std::string& word) {
           return word.empty() || isName (word);
         });
}

/** \brief The column of each coordinate by \ref findAxis, or the first three columns of
 * numbers where there are no names.
 * \param[in] are_words for each column, whether it has words
 * \throws WorkError where columns have names, but a coordinate has none */
std::vector<std::size_t>
columnsOfAxes (const std::string& file,
               const Words& names,
               const std::vector<bool>& are_words)
{
  std::vector<std::size_t> columns;
  if (names.empty()) {
    for (std::size_t i = 0; i < are_words.size() && columns.size() < axes.size(); ++i)
      if (!are_words[i])
        columns.push_back (i);
    return columns;
  }
  for (const auto& axis : axes) {
    const auto found = findAxis (names, axis);
    if (found == names.end())
      throw WorkError (
          file,
          std::string ("has names of columns, but none is ") + axis[0] +
              "; call the coordinates x, y and z, or remove the line of names");
    columns.push_back (std::size_t (found - names.begin()));
  }
  return columns;
}

/** \brief The name of the field that each column becomes; empty if the column has
 * words. The coordinates are those of \ref columnsOfAxes. Other columns keep their
 * names if a field can have them and no other has; else column 4 becomes field_4, and
 * so on.
 * \throws WorkError where columns have names, but a coordinate has none */
Words
fieldNames (const std::string& file,
            const Words& names,
            const std::vector<bool>& are_words)
{
  Words fields (are_words.size());
  std::set<std::string> taken;
  const std::vector<std::size_t> columns = columnsOfAxes (file, names, are_words);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    fields[columns[i]] = axes[i][0];
    taken.insert (axes[i][0]);
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (!fields[i].empty() || are_words[i])
      continue;
    std::string name = names.empty() ? "" : allowedName (names[i]);
    if (name.empty() || taken.count (name) > 0)
      name = "field_" + std::to_string (i + 1);
    while (!taken.insert (name).second)
      name += "_";
    fields[i] = name;
  }
  return fields;
}

/** \brief Reads a text file: comments, then perhaps the names of columns and the number
 * of points, in any order, then a line for each point. */
class TextReader {
public:
  explicit TextReader (const std::string& file) : file_ (file), reader_ (file, "text")
  {
    reader_.skipByteOrderMark();
    if (extensionOf (file) == ".xyzrgb")
      comment_names_ = {"x", "y", "z", "r", "g", "b"}; // for 6 columns without names
  }

  pcl::PCLPointCloud2
  read ()
  {
    readHead();
    PointRows rows (reader_);
    const Words names = fieldNames (file_, names_, are_words_);
    for (std::size_t i = 0; i < names.size(); ++i)
      if (names[i].empty())
        rows.skipColumn();
      else {
        reader_.number (i); // fails if it is a word
        rows.addColumn (names[i], pcl::PCLPointField::FLOAT64);
      }
    // Lines are about as long as the first.
    const std::uint64_t expected = reader_.fileSize() / (line_.size() + 1) + 1;
    rows.cloud.data.reserve (std::min (expected, promised_points_.value_or (expected)) *
                             rows.cloud.point_step);
    do {
      takeLine();
      rows.addPoint();
      if (rows.size() > promised_points_.value_or (rows.size()))
        reader_.failAtLine ("is more than its header promises");
    }
    while (nextLine());
    if (promised_points_ && rows.size() < *promised_points_)
      reader_.failTruncated();
    return rows.take();
  }

private:
  /** \brief Goes on to the next line that is neither empty nor a comment. Notes
   * comments before the first point that name columns.
   * \return false at the end of the file */
  bool
  nextLine ()
  {
    while (reader_.readLine (line_)) {
      line_.resize (line_.find_last_not_of (" \t\r") + 1);
      removeQuotes (reader_, line_);
      if (line_.find ('\r') != std::string::npos)
        reader_.failAtLine ("has a carriage return within, as if it were several");
      const std::size_t begin = line_.find_first_not_of (" \t");
      if (begin == std::string::npos)
        continue;
      if (line_[begin] != '#' && line_.compare (begin, 2, "//") != 0)
        return true;
      if (!has_points_)
        noteComment();
    }
    return false;
  }

  /** \brief Takes a comment for names of columns if x, y and z are among its words. */
  void
  noteComment ()
  {
    const std::size_t begin = line_.find_first_not_of ("#/ \t");
    const Words words = wordsOf (line_.substr (std::min (begin, line_.size())));
    const auto has_name = [&] (const AxisNames& axis) {
      return findAxis (words, axis) != words.end();
    };
    if (std::all_of (axes.begin(), axes.end(), has_name))
      comment_names_ = words;
  }

  /** \brief Has the reader divide the line into numbers and words. */
  void
  takeLine ()
  {
    if (separator_ == ';') // then commas are decimal commas
      std::replace (line_.begin(), line_.end(), ',', '.');
    reader_.setLine (line_, separator_);
    if (separator_ == ',' && names_.empty() && mayHaveDecimalCommas (reader_))
      reader_.failAtLine ("has whole numbers with zeros in front, as if commas were "
                          "decimal points, too");
  }

  /** \brief Reads the lines up to the first point, whose line becomes the current one.
   */
  void
  readHead ()
  {
    while (nextLine()) {
      const Words words = wordsOf (line_);
      const bool is_point_count = words.size() == 1 && !promised_points_;
      if (names_.empty() && areNames (words)) {
        names_ = words;
        continue;
      }
      if (plainName (words[0]) == "ncols")
        throw WorkError (file_,
                         "is a raster (ESRI grid); convert it to points, e.g. by "
                         "gdal_translate -of XYZ");
      separator_ = separatorOf (line_);
      takeLine();
      findColumnsOfWords (words);
      if (is_point_count) {
        promised_points_ = reader_.parseCount ("its number of points", words[0]);
        continue;
      }
      has_points_ = true;
      return applyNames();
    }
    reader_.failEmpty();
  }

  /** \brief Finds which columns have words, by the line that was taken.
   * \param[in] words of the line, without quotes
   * \throws WorkError if it has words but fewer than three numbers, or, while columns
   * have no names, a word such as 5abc that is neither a number nor a name */
  void
  findColumnsOfWords (const Words& words)
  {
    are_words_.clear();
    for (std::size_t i = 0; i < reader_.wordCount(); ++i)
      are_words_.push_back (!reader_.isNumber (i));
    const auto numbers = std::count (are_words_.begin(), are_words_.end(), false);
    for (std::size_t i = 0; i < are_words_.size(); ++i) {
      const bool can_be_word = !names_.empty() || isName (words[i]);
      if (numbers < 3 || !can_be_word)
        reader_.number (i); // fails if it is a word
    }
  }

  /** \brief Compares the columns of the first point with their names. Uses the names in
   * a comment if no line has names, and the comment has as many as there are columns.
   * \throws WorkError if names in a line are not as many */
  void
  applyNames ()
  {
    const std::size_t count = reader_.wordCount();
    reader_.checkColumnCount();
    if (!names_.empty() && names_.size() != count)
      reader_.failAtLine ("has " + std::to_string (count) + " numbers for " +
                          std::to_string (names_.size()) + " names of columns");
    if (names_.empty() && comment_names_.size() == count)
      names_ = comment_names_;
  }

  std::string file_;
  FileReader reader_;
  /** \brief The current line without quotes. */
  std::string line_;
  /** \brief The names of columns in a line of their own, and those in a comment or
   * usual for the extension. */
  Words names_, comment_names_;
  /** \brief The number of points, where a line before them tells it. */
  std::optional<std::uint64_t> promised_points_;
  /** \brief For each column, whether it has words: it becomes no field. */
  std::vector<bool> are_words_;
  /** \brief Between the words of a line, as of \ref splitWords. */
  char separator_ = ' ';
  /** \brief Whether the line of the first point was reached. */
  bool has_points_ = false;
};

} // namespace

FileCloud
readTextCloud (const std::string& file)
{
  return {TextReader (file).read()};
}

std::vector<double>
readTextNumbers (const std::string& file)
{
  FileReader reader (file, "text");
  std::vector<double> numbers;
  while (reader.nextWords()) {
    reader.expectWordCount (1);
    numbers.push_back (reader.number (0));
  }
  return numbers;
}

} // namespace pcl_ops::apps
