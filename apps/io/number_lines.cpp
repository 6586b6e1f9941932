// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "number_lines.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace pcl_ops::apps {

namespace {

/** \brief What PCL's readers separate numbers by. */
constexpr const char* blanks = " \t\r";

bool
isBlank (char c)
{
  return c == ' ' || c == '\t' || c == '\r';
}

} // namespace

bool
NumberLines::next()
{
  if (!reader_.readLine (line_))
    reader_.failTruncated();
  numbers_.clear();
  const char* at = line_.data();
  const char* const end = at + line_.size();
  while ((at = std::find_if_not (at, end, isBlank)) != end) {
    const char* const word = at;
    if (*at == '+' && at + 1 != end && at[1] != '-')
      ++at; // the only difference to what the standard library reads
    double number = 0.0;
    const auto [rest, error] = std::from_chars (at, end, number);
    if (error == std::errc::invalid_argument || (rest != end && !isBlank (*rest)))
      reader_.failAtLine ("has '" +
                          std::string (word, std::find_if (word, end, isBlank)) +
                          "', which is no number");
    numbers_.push_back (number);
    at = rest;
  }
  return !line_.empty();
}

void
NumberLines::expectNumbers (std::size_t count) const
{
  if (numbers_.size() != count)
    reader_.failAtLine ("has " + std::to_string (numbers_.size()) +
                        " numbers instead of " + std::to_string (count));
}

void
NumberLines::expectEnd()
{
  while (reader_.readLine (line_))
    if (line_.find_first_not_of (blanks) != std::string::npos)
      reader_.failAtLine ("is more than its header promises");
}

} // namespace pcl_ops::apps
