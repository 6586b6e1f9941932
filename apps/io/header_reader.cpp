// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "header_reader.h"

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
  constexpr std::size_t longest = 200;
  std::string shown = text.substr (0, longest);
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
  const bool is_between_blanks = separator == ' ';
  const std::string_view ends =
      is_between_blanks ? blanks : std::string_view (&separator, 1);
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min (line.find_first_of (ends, begin), line.size());
    const std::string_view word = trimmed (line.substr (begin, end - begin));
    if (!word.empty() || !is_between_blanks)
      words.push_back (word);
    begin = end + 1;
  }
}

std::vector<std::size_t>
HeaderReader::joinLines (std::size_t count)
{
  constexpr std::size_t max_lines = 8;
  const std::string first = line_;
  const std::uint64_t number_of_first = lines_;
  std::vector<std::size_t> lengths = {words_.size()};
  std::string next;
  while (words_.size() < count && lengths.back() > 0 && lengths.size() < max_lines &&
         readLine (next)) {
    const std::size_t before = words_.size();
    takeNumbers (line_ + ' ' + next, ' ');
    lengths.push_back (words_.size() - before);
  }
  if (words_.size() == count && lengths.back() > 0)
    return lengths;
  takeNumbers (first, ' ');
  lines_ = number_of_first; // the line that an error names
  return {words_.size()};
}

void
HeaderReader::nextLines (const std::vector<std::size_t>& lengths)
{
  std::string lines;
  for (const std::size_t length : lengths) {
    nextNumbers();
    expectNumbers (length);
    lines += line_ + ' ';
  }
  takeNumbers (lines, ' ');
}

HeaderReader::HeaderReader (const std::string& file, std::string format)
: file_ (file), format_ (std::move (format)), stream_ (file, std::ios::binary)
{
  stream_.seekg (0, std::ios::end);
  file_size_ = position();
  stream_.seekg (0);
  if (!stream_)
    throw WorkError (file_, "cannot be read; check its permissions");
  if (file_size_ == 0)
    throw WorkError (file_, "is empty; write it again");
}

Words
HeaderReader::nextLine (const std::string& last)
{
  constexpr std::uint64_t longest_header = 1U << 20U;
  ++lines_;
  line_.clear();
  char c = '\0';
  for (std::uint64_t i = position(); i < longest_header && stream_.get (c); ++i) {
    if (c == '\n')
      break;
    line_ += c;
  }
  if (c != '\n')
    fail (stream_ ? "its header is longer than 1 MiB"
                  : "its header has no line " + last);
  std::istringstream parts (line_);
  Words words;
  for (std::string word; parts >> word;)
    words.push_back (word);
  return words;
}

std::uint64_t
HeaderReader::count (const std::string& what, const std::string& text) const
{
  constexpr std::uint64_t most = std::numeric_limits<pcl::index_t>::max();
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars (text.data(), end, value);
  if (error != std::errc() || rest != end || value > most)
    fail (what + " " + text + " is out of range");
  return value;
}

void
HeaderReader::fail (const std::string& reason) const
{
  throw WorkError (file_,
                   "is no valid " + format_ + " file: " + printable (reason) +
                       "; write it again");
}

void
HeaderReader::failAtLine (const std::string& reason) const
{
  throw WorkError (file_,
                   "is damaged: line " + std::to_string (lines_) + " " +
                       printable (reason) + "; fix it or write the file again");
}

void
HeaderReader::readNumber (std::size_t word, const NumberType& type, void* bytes) const
{
  const std::string_view text = words_[word];
  if (!type.parse (text.empty() ? "nan" : text, bytes))
    failAtWord (std::string (text));
}

void
HeaderReader::failAtWord (const std::string& word) const
{
  const NumberType& type = numberType (pcl::PCLPointField::FLOAT64);
  double number = 0.0;
  std::string with_points = word;
  std::replace (with_points.begin(), with_points.end(), ',', '.');
  std::vector<std::string_view> parts;
  splitWords (with_points, ' ', parts);
  const bool are_numbers =
      std::all_of (parts.begin(), parts.end(), [&] (std::string_view part) {
        return type.parse (part, &number);
      });
  std::string problem = "which is no number";
  if (are_numbers && parts.size() > 1)
    problem = "several numbers between commas; decimal commas are read only where "
              "semicolons separate the numbers";
  else if (are_numbers)
    problem = "a number with a decimal comma in place of a point";
  failAtLine ("has '" + word + "', " + problem);
}

double
HeaderReader::number (std::size_t word) const
{
  double number = 0.0;
  readNumber (word, numberType (pcl::PCLPointField::FLOAT64), &number);
  return number;
}

bool
HeaderReader::isNumber (std::size_t word) const
{
  double number = 0.0;
  const std::string_view text = words_[word];
  return text.empty() || numberType (pcl::PCLPointField::FLOAT64).parse (text, &number);
}

void
HeaderReader::expectNumbers (std::size_t count,
                             const std::vector<bool>& may_be_words) const
{
  if (words_.size() == count)
    return;
  for (std::size_t i = 0; i < words_.size(); ++i)
    if (i >= may_be_words.size() || !may_be_words[i])
      number (i); // fails if it is a word, which explains more than the count
  failAtLine ("has " + std::to_string (words_.size()) + " numbers instead of " +
              std::to_string (count));
}

void
HeaderReader::checkColumns() const
{
  const std::size_t count = words_.size();
  if (count < 3)
    failAtLine ("has " + std::to_string (count) +
                (count == 1 ? " number" : " numbers") + ", and a point has x, y and z");
  if (count > max_columns)
    failAtLine ("has more than " + std::to_string (max_columns) + " numbers");
}

bool
HeaderReader::nextWords()
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
HeaderReader::skipMark()
{
  std::string mark (std::min<std::uint64_t> (3, file_size_), '\0');
  read (mark.data(), mark.size());
  const std::string start = mark.substr (0, 2);
  if (start == "\xff\xfe" || start == "\xfe\xff")
    fail ("it is UTF-16, not UTF-8");
  if (mark != "\xef\xbb\xbf")
    goTo (0);
}

void
HeaderReader::expectEnd()
{
  while (readLine (line_))
    if (line_.find_first_not_of (blanks) != std::string::npos)
      failAtLine ("is more than its header promises");
}

} // namespace pcl_ops::apps
