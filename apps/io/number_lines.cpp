// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "number_lines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
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

/** \brief Reads the number at the start of a text that a zero ends.
 * \return where it ends; \p begin where there is none or it is too large */
const char*
readNumber (const char* begin, const char* end, double& number)
{
  // A plus is the only difference to what the standard library reads.
  const bool has_plus = *begin == '+' && begin + 1 != end && begin[1] != '-';
  const char* const digits = has_plus ? begin + 1 : begin;
  const auto [rest, error] = std::from_chars (digits, end, number);
  if (error == std::errc::invalid_argument)
    return begin;
  if (error == std::errc::result_out_of_range)
    number = std::strtod (digits, nullptr); // zero or infinity; the above leaves it
  const bool is_too_large =
      error == std::errc::result_out_of_range && std::isinf (number);
  return is_too_large ? begin : rest;
}

void
readBetweenBlanks (const HeaderReader& reader,
                   const char* at,
                   const char* end,
                   std::vector<double>& numbers)
{
  while ((at = std::find_if_not (at, end, isBlank)) != end) {
    double number = 0.0;
    const char* const rest = readNumber (at, end, number);
    if (rest == at || (rest != end && !isBlank (*rest)))
      reader.failAtLine ("has '" + std::string (at, std::find_if (at, end, isBlank)) +
                         "', which is no number");
    numbers.push_back (number);
    at = rest;
  }
}

void
readBetween (const HeaderReader& reader,
             char separator,
             const char* at,
             const char* end,
             std::vector<double>& numbers)
{
  for (;; ++at) {
    const char* const next = std::find (at, end, separator);
    at = std::find_if_not (at, next, isBlank);
    double number = std::numeric_limits<double>::quiet_NaN();
    if (at != next) {
      const char* const rest = readNumber (at, next, number);
      if (rest == at || std::find_if_not (rest, next, isBlank) != next)
        reader.failAtLine ("has '" + std::string (at, next) + "', which is no number");
    }
    numbers.push_back (number);
    at = next;
    if (at == end)
      return;
  }
}

} // namespace

void
readNumbers (const HeaderReader& reader,
             const std::string& line,
             char separator,
             std::vector<double>& numbers)
{
  numbers.clear();
  const char* const end = line.data() + line.size();
  if (separator == ' ')
    readBetweenBlanks (reader, line.data(), end, numbers);
  else
    readBetween (reader, separator, line.data(), end, numbers);
}

bool
NumberLines::next()
{
  if (!reader_.readLine (line_))
    reader_.failTruncated();
  readNumbers (reader_, line_, ' ', numbers_);
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
