// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "file_reader.h"

#include <pcl/PCLPointField.h>
#include <pcl/types.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief Returns text from a file in a form that fits a message: one short line
 * without control characters. */
std::string
printable (const std::string& text)
{
  constexpr std::size_t max_length = 200; // two or three lines of a terminal
  std::string shown = text.substr (0, max_length);
  for (char& c : shown)
    c = std::isprint (static_cast<unsigned char> (c)) != 0 ? c : '?';
  return shown;
}

constexpr std::string_view blanks = " \t\r";

std::string_view
trimmed (std::string_view text)
{
  text.remove_prefix (std::min (text.find_first_not_of (blanks), text.size()));
  return text.substr (0, text.find_last_not_of (blanks) + 1);
}

} // namespace

void
splitWords (std::string_view line, char separator, std::vector<std::string_view>& words)
{
  words.clear();
  const bool splits_at_blanks = separator == ' ';
  const std::string_view separators =
      splits_at_blanks ? blanks : std::string_view (&separator, 1);
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end =
        std::min (line.find_first_of (separators, begin), line.size());
    const std::string_view word = trimmed (line.substr (begin, end - begin));
    if (!word.empty() || !splits_at_blanks)
      words.push_back (word);
    begin = end + 1;
  }
}

std::vector<std::size_t>
FileReader::joinNextLines (std::size_t count)
{
  // With the first one. RealSense's viewer has 2; more are for others like it.
  constexpr std::size_t max_lines = 8;
  const std::string first_line = line_;
  const std::uint64_t first_line_number = lines_;
  std::vector<std::size_t> lengths = {words_.size()};
  std::string next;
  while (words_.size() < count && lengths.back() > 0 && lengths.size() < max_lines &&
         readLine (next)) {
    const std::size_t words_before = words_.size();
    setLine (line_ + ' ' + next, ' ');
    lengths.push_back (words_.size() - words_before);
  }
  if (words_.size() == count && lengths.back() > 0)
    return lengths;
  setLine (first_line, ' ');
  lines_ = first_line_number; // errors are about this line
  return {words_.size()};
}

void
FileReader::nextJoinedLines (const std::vector<std::size_t>& lengths)
{
  std::string joined;
  for (const std::size_t length : lengths) {
    nextNumbers();
    expectWordCount (length);
    joined += line_ + ' ';
  }
  setLine (joined, ' ');
}

FileReader::FileReader (const std::string& file,
                        std::string format,
                        const std::string& name_in_messages)
: file_ (name_in_messages.empty() ? file : name_in_messages)
, format_ (std::move (format))
, stream_ (file, std::ios::binary)
{
  stream_.seekg (0, std::ios::end);
  file_size_ = offset();
  stream_.seekg (0);
  if (!stream_)
    throw WorkError (file_, "cannot be read; check its permissions");
  if (file_size_ == 0)
    throw WorkError (file_, "is empty; write it again");
}

Words
FileReader::nextHeaderLine (const std::string& last_key)
{
  constexpr std::uint64_t max_header_size = 1U << 20U; // 1 MiB, as the message says
  ++lines_;
  line_.clear();
  char c = '\0';
  for (std::uint64_t i = offset(); i < max_header_size && stream_.get (c); ++i) {
    if (c == '\n')
      break;
    line_ += c;
  }
  if (c != '\n')
    fail (stream_ ? "its header is longer than 1 MiB"
                  : "its header has no line " + last_key);
  std::istringstream parts (line_);
  Words words;
  for (std::string word; parts >> word;)
    words.push_back (word);
  return words;
}

std::uint64_t
FileReader::parseCount (const std::string& what, const std::string& text) const
{
  constexpr std::uint64_t max_count = std::numeric_limits<pcl::index_t>::max();
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars (text.data(), end, value);
  if (error != std::errc() || rest != end || value > max_count)
    fail (what + " " + text + " is out of range");
  return value;
}

void
FileReader::fail (const std::string& reason) const
{
  throw WorkError (file_,
                   "is no valid " + format_ + " file: " + printable (reason) +
                       "; write it again");
}

void
FileReader::failAtLine (const std::string& reason) const
{
  throw WorkError (file_,
                   "is damaged: line " + std::to_string (lines_) + " " +
                       printable (reason) + "; fix it or write the file again");
}

void
FileReader::readNumber (std::size_t i, const NumberType& type, void* bytes) const
{
  const std::string_view text = words_[i];
  if (!type.parse (text.empty() ? "nan" : text, bytes))
    failAtWord (std::string (text));
}

void
FileReader::failAtWord (const std::string& word) const
{
  const NumberType& float64 = numberType (pcl::PCLPointField::FLOAT64);
  std::string with_decimal_points = word;
  std::replace (with_decimal_points.begin(), with_decimal_points.end(), ',', '.');
  std::vector<std::string_view> parts; // of "5 2" in 1,5 2,5 3,5 split at commas
  splitWords (with_decimal_points, ' ', parts);
  const bool are_numbers =
      std::all_of (parts.begin(), parts.end(), [&] (std::string_view part) {
        double ignored = 0.0;
        return float64.parse (part, &ignored);
      });
  std::string problem = "which is no number";
  if (are_numbers && parts.size() > 1 && separator_ == ';')
    problem = "several numbers between semicolons";
  else if (are_numbers && parts.size() > 1)
    problem = "several numbers between commas; decimal commas are read only where "
              "semicolons separate the numbers";
  else if (are_numbers)
    problem = "a number with a decimal comma in place of a point";
  failAtLine ("has '" + word + "', " + problem);
}

double
FileReader::number (std::size_t i) const
{
  double number = 0.0;
  readNumber (i, numberType (pcl::PCLPointField::FLOAT64), &number);
  return number;
}

bool
FileReader::isNumber (std::size_t i) const
{
  double ignored = 0.0;
  const std::string_view text = words_[i];
  return text.empty() ||
         numberType (pcl::PCLPointField::FLOAT64).parse (text, &ignored);
}

void
FileReader::expectWordCount (std::size_t count,
                             const std::vector<bool>& may_be_text) const
{
  if (words_.size() == count)
    return;
  for (std::size_t i = 0; i < words_.size(); ++i)
    if (i >= may_be_text.size() || !may_be_text[i])
      number (i); // fails if the word is no number: a better message than the count
  failAtLine ("has " + std::to_string (words_.size()) + " numbers instead of " +
              std::to_string (count));
}

void
FileReader::checkColumnCount() const
{
  const std::size_t count = words_.size();
  if (count < 3)
    failAtLine ("has " + std::to_string (count) +
                (count == 1 ? " number" : " numbers") + ", and a point has x, y and z");
  if (count > max_columns)
    failAtLine ("has more than " + std::to_string (max_columns) + " numbers");
}

bool
FileReader::nextWords()
{
  while (readLine (line_)) {
    line_.resize (std::min (line_.find ('#'), line_.size()));
    splitWords (line_, ' ', words_);
    if (!words_.empty())
      return true;
  }
  return false;
}

void
FileReader::skipByteOrderMark()
{
  const std::string utf8_mark = "\xef\xbb\xbf";
  std::string start (std::min<std::uint64_t> (utf8_mark.size(), file_size_), '\0');
  read (start.data(), start.size());
  const std::string first_two = start.substr (0, 2);
  if (first_two == "\xff\xfe" || first_two == "\xfe\xff") // marks of UTF-16
    fail ("it is UTF-16, not UTF-8");
  if (start != utf8_mark)
    goTo (0);
}

void
FileReader::expectEnd()
{
  while (readLine (line_))
    if (line_.find_first_not_of (blanks) != std::string::npos)
      failAtLine ("is more than its header promises");
}

} // namespace pcl_ops::apps
