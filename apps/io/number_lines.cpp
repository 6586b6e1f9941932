// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "number_lines.h"

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <utility>

namespace pcl_ops::apps {

namespace {

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

bool
NumberLines::next()
{
  if (!reader_.readLine (line_))
    reader_.failTruncated();
  take (std::move (line_), ' ');
  return !line_.empty();
}

void
NumberLines::take (std::string line, char separator)
{
  line_ = std::move (line);
  splitWords (line_, separator, words_);
}

void
NumberLines::read (std::size_t word, const NumberType& type, std::uint8_t* bytes) const
{
  const std::string_view text = words_[word];
  if (!type.parse (text.empty() ? "nan" : text, bytes))
    reader_.failAtLine ("has '" + std::string (text) + "', which is no number");
}

double
NumberLines::number (std::size_t word) const
{
  const NumberType& type = numberType (pcl::PCLPointField::FLOAT64);
  std::uint8_t bytes[sizeof (double)];
  read (word, type, bytes);
  return type.read (bytes);
}

void
NumberLines::expectNumbers (std::size_t count) const
{
  if (words_.size() == count)
    return;
  for (std::size_t i = 0; i < words_.size(); ++i)
    number (i); // what is no number is the better reason
  reader_.failAtLine ("has " + std::to_string (words_.size()) + " numbers instead of " +
                      std::to_string (count));
}

void
NumberLines::expectEnd()
{
  while (reader_.readLine (line_))
    if (line_.find_first_not_of (blanks) != std::string::npos)
      reader_.failAtLine ("is more than its header promises");
}

} // namespace pcl_ops::apps
