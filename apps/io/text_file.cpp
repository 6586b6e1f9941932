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

/** \brief The names that a column with a coordinate may have: first the name of the
 * field, then the names that surveyors use, then that of ParaView. */
using AxisNames = std::array<const char*, 5>;

constexpr std::array<AxisNames, 3> axes = {
    {{"x", "easting", "east", "e", "points:0"},
     {"y", "northing", "north", "n", "points:1"},
     {"z", "elevation", "height", "h", "points:2"}}};

/** \brief Whether a word is a name: it begins with a letter, which may be beyond ASCII,
 * or with an underscore, and is not a number ("nan" is one). */
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

/** \brief Returns a name in lower case, without its unit, which begins at the first
 * bracket, and without blanks and underscores at the end. */
std::string
plainName (const std::string& name)
{
  std::string plain = name.substr (0, name.find_first_of ("[("));
  plain.resize (plain.find_last_not_of (" \t_") + 1);
  return boost::algorithm::to_lower_copy (plain, std::locale::classic());
}

/** \brief Finds the name of the column of a coordinate. This is the name that equals
 * the first axis name exactly. If there is none, it is the first name whose \ref
 * plainName is the first axis name, else the first one whose plain name is the second
 * axis name, and so on.
 * \param[in] names of all columns
 * \return the end of \p names if no column has the coordinate */
Words::const_iterator
findAxis (const Words& names, const AxisNames& axis_names)
{
  auto found = std::find (names.begin(), names.end(), axis_names[0]);
  for (std::size_t i = 0; i < axis_names.size() && found == names.end(); ++i)
    found = std::find_if (names.begin(), names.end(), [&] (const std::string& name) {
      return plainName (name) == axis_names[i];
    });
  return found;
}

/** \brief Returns a name in a form that headers of clouds allow: without blanks, and
 * short. Empty if it is only an underscore, the name of padding in a PCD. */
std::string
allowedName (std::string name)
{
  constexpr std::size_t max_length = 100; // [bytes], chosen by hand
  name.resize (std::min (name.size(), max_length));
  for (char& c : name)
    c = std::isspace (static_cast<unsigned char> (c)) != 0 ||
                std::iscntrl (static_cast<unsigned char> (c)) != 0
            ? '_'
            : c;
  return name == "_" ? "" : name;
}

/** \brief Returns the separator of the words of a line, for \ref splitWords: a
 * semicolon if the line has one, else a comma if it has one, else a space. */
char
separatorOf (const std::string& line)
{
  for (const char separator : {';', ','})
    if (line.find (separator) != std::string::npos)
      return separator;
  return ' ';
}

/** \brief Returns the words of a line, without blanks and quotes around them. */
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

/** \brief Returns a line divided at its quotes: the parts of odd index are in quotes.
 * Empty if the last quote is not closed. */
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

/** \brief Whether the first word of a line begins with # or //. */
bool
isComment (const std::string& line)
{
  const std::size_t begin = std::min (line.find_first_not_of (" \t"), line.size());
  return line.compare (begin, 1, "#") == 0 || line.compare (begin, 2, "//") == 0;
}

/** \brief Removes the quotes from a line. Separators in quotes become underscores, as
 * they do not divide a word. A line whose last quote is not closed does not change.
 * \throws WorkError if a quoted number has a decimal comma; but not in a comment, nor
 * where semicolons separate the words, as commas are decimal commas there */
void
removeQuotes (const FileReader& reader, std::string& line)
{
  std::vector<std::string> parts = quotedParts (line);
  if (parts.size() < 2)
    return;
  std::string unquoted_parts;
  for (std::size_t i = 0; i < parts.size(); i += 2)
    unquoted_parts += parts[i];
  const char separator = separatorOf (unquoted_parts);
  // The characters that would divide a quoted word, or change the result of
  // separatorOf.
  const std::string replaced_characters = separator == ';'   ? ";"
                                          : separator == ',' ? ",;"
                                                             : ",; \t";
  for (std::size_t i = 1; i < parts.size(); i += 2) {
    const bool is_number =
        parts[i].find_first_not_of ("0123456789+-.,") == std::string::npos;
    const bool has_comma = parts[i].find (',') != std::string::npos;
    if (is_number && has_comma && separator != ';' && !isComment (line))
      reader.failAtLine ("has '" + parts[i] +
                         "', a number with a decimal comma in place of a point");
    for (char& c : parts[i])
      c = replaced_characters.find (c) == std::string::npos ? c : '_';
  }
  line = boost::algorithm::join (parts, "");
}

/** \brief Whether commas that divide a line into words look like decimal commas, as in
 * 3,05,4,25,1,75: there are six words or more, all of them whole numbers, and a word
 * other than the first one begins with a zero that another digit follows. */
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

/** \brief Whether words can be the names of columns: one or more of them are names, and
 * all others are empty. */
bool
areNames (const Words& words)
{
  return std::any_of (words.begin(), words.end(), isName) &&
         std::all_of (words.begin(), words.end(), [] (const std::string& word) {
           return word.empty() || isName (word);
         });
}

/** \brief Returns the indices of the columns with x, y and z: by \ref findAxis; if
 * columns have no names, the first three columns of numbers.
 * \param[in] names of all columns, or none
 * \param[in] has_words for each column, whether it has words
 * \throws WorkError if columns have names, but no column has one of the coordinates */
std::vector<std::size_t>
columnsOfAxes (const std::string& file,
               const Words& names,
               const std::vector<bool>& has_words)
{
  std::vector<std::size_t> columns;
  if (names.empty()) {
    for (std::size_t i = 0; i < has_words.size() && columns.size() < axes.size(); ++i)
      if (!has_words[i])
        columns.push_back (i);
    return columns;
  }
  for (const AxisNames& axis_names : axes) {
    const auto found = findAxis (names, axis_names);
    if (found == names.end())
      throw WorkError (
          file,
          std::string ("has names of columns, but none is ") + axis_names[0] +
              "; call the coordinates x, y and z, or remove the line of names");
    columns.push_back (std::size_t (found - names.begin()));
  }
  return columns;
}

/** \brief Returns for each column the name of the field that it becomes; empty if the
 * column has words. The fields x, y and z are the columns of \ref columnsOfAxes. Other
 * columns get the \ref allowedName of their name. If it is empty or taken, the fourth
 * column becomes field_4, and so on.
 * \param[in] names, has_words as of \ref columnsOfAxes
 * \throws WorkError as \ref columnsOfAxes */
Words
fieldNames (const std::string& file,
            const Words& names,
            const std::vector<bool>& has_words)
{
  Words fields (has_words.size());
  std::set<std::string> taken;
  const std::vector<std::size_t> columns = columnsOfAxes (file, names, has_words);
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const std::string coordinate = axes[i][0];
    fields[columns[i]] = coordinate;
    taken.insert (coordinate);
  }
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const bool is_coordinate = !fields[i].empty();
    if (is_coordinate || has_words[i])
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
    if (extensionOf (file) == ".xyzrgb") // usual there, if no line or comment has names
      comment_names_ = {"x", "y", "z", "r", "g", "b"};
  }

  pcl::PCLPointCloud2
  read ()
  {
    readHead();
    PointRows rows (reader_);
    const Words fields = fieldNames (file_, names_, has_words_);
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (fields[i].empty())
        rows.skipColumn();
      else {
        reader_.number (i); // fails if it is a word
        rows.addColumn (fields[i], pcl::PCLPointField::FLOAT64);
      }
    // Most lines are about as long as the first one.
    const std::uint64_t expected_points = reader_.fileSize() / (line_.size() + 1) + 1;
    rows.cloud.data.reserve (
        std::min (expected_points, promised_points_.value_or (expected_points)) *
        rows.cloud.point_step);
    do {
      splitLine();
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
  /** \brief Goes on to the next line that is neither empty nor a comment. From comments
   * before the first point it takes names of columns (\ref noteComment).
   * \return false at the end of the file */
  bool
  nextLine ()
  {
    while (reader_.readLine (line_)) {
      line_.resize (line_.find_last_not_of (" \t\r") + 1);
      removeQuotes (reader_, line_);
      if (line_.find ('\r') != std::string::npos)
        reader_.failAtLine ("has a carriage return within, as if it were several");
      if (line_.find_first_not_of (" \t") == std::string::npos)
        continue;
      if (!isComment (line_))
        return true;
      if (!has_points_)
        noteComment();
    }
    return false;
  }

  /** \brief If the current line, a comment, has names for x, y and z, takes its words
   * for the names of columns. */
  void
  noteComment ()
  {
    const std::size_t begin = line_.find_first_not_of ("#/ \t");
    const Words words = wordsOf (line_.substr (std::min (begin, line_.size())));
    const auto is_named = [&] (const AxisNames& axis_names) {
      return findAxis (words, axis_names) != words.end();
    };
    if (std::all_of (axes.begin(), axes.end(), is_named))
      comment_names_ = words;
  }

  /** \brief Makes the current line also that of the reader, which divides it into
   * words.
   */
  void
  splitLine ()
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
      splitLine();
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

  /** \brief Finds by the reader's current line which columns have words.
   * \param[in] words of the line, without quotes
   * \throws WorkError if the line has words and fewer than three numbers, or, where no
   * line before names the columns, a word such as 5abc that is neither a number nor a
   * name */
  void
  findColumnsOfWords (const Words& words)
  {
    has_words_.clear();
    for (std::size_t i = 0; i < reader_.wordCount(); ++i)
      has_words_.push_back (!reader_.isNumber (i));
    const auto number_count = std::count (has_words_.begin(), has_words_.end(), false);
    for (std::size_t i = 0; i < has_words_.size(); ++i) {
      const bool may_be_word = !names_.empty() || isName (words[i]);
      if (number_count < 3 || !may_be_word)
        reader_.number (i); // fails if it is a word
    }
  }

  /** \brief Compares the number of columns of the first point with that of their names.
   * If no line has names, takes \ref comment_names_ if they are as many as the columns.
   * \throws WorkError if a line has more or fewer names than there are columns, or if
   * the number of columns is not allowed (FileReader::checkColumnCount) */
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
  /** \brief The names of columns; empty if they have none. */
  Words names_;
  /** \brief Names of columns in a comment, else those that are usual for the extension;
   * used if no line has names. */
  Words comment_names_;
  /** \brief The number of points, if a line before them tells it. */
  std::optional<std::uint64_t> promised_points_;
  /** \brief For each column, whether it has words: such a column becomes no field. */
  std::vector<bool> has_words_;
  /** \brief The separator of the words of a line (\ref splitWords). */
  char separator_ = ' ';
  /** \brief Whether \ref nextLine has reached the first point. */
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
  reader.skipByteOrderMark();
  std::vector<double> numbers;
  while (reader.nextWords()) {
    reader.expectWordCount (1);
    numbers.push_back (reader.number (0));
  }
  return numbers;
}

} // namespace pcl_ops::apps
