// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "option_value.h"

#include "errors.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <system_error>
#include <type_traits>

namespace pcl_ops::apps {

namespace {

std::string
shortText (double number)
{
  std::ostringstream text;
  text.precision (10);
  text << number;
  return text.str();
}

template <typename Number>
bool
fits (double number)
{
  using Limits = std::numeric_limits<Number>;
  if (number < static_cast<double> (Limits::lowest()))
    return false;
  // The largest integer may be no double, the one behind it always is.
  return Limits::is_integer ? number < std::ldexp (1.0, Limits::digits)
                            : number <= static_cast<double> (Limits::max());
}

} // namespace

bool
Range::contains (double number) const
{
  return std::isfinite (number) &&
         (number > lowest || (lowest_included && number == lowest)) &&
         (number < highest || (highest_included && number == highest));
}

std::string
Range::text() const
{
  const std::string lower =
      std::isinf (lowest) ? ""
                          : (lowest_included ? "from " : "above ") + shortText (lowest);
  const std::string upper =
      std::isinf (highest)
          ? (lowest_included ? "on" : "")
          : (highest_included ? "up to " : "below ") + shortText (highest);
  if (lower.empty() && std::isinf (highest))
    return "that is finite";
  if (lower.empty() || upper.empty())
    return lower + upper;
  return lower + (lowest_included ? " " : " and ") + upper;
}

template <typename Number>
Number
parseNumber (const std::string& option, const std::string& text, const Range& range)
{
  const bool whole = std::is_integral_v<Number>;
  const std::string fix =
      std::string ("; give a ") + (whole ? "whole " : "") + "number " + range.text();
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars (text.data(), end, number);
  const bool overflows = error == std::errc::result_out_of_range;
  if (rest != end || error == std::errc::invalid_argument)
    throw UsageError (option, "'" + text + "' is no number" + fix);
  if (overflows || !range.contains (number) || !fits<Number> (number))
    throw UsageError (option, text + " is out of range" + fix);
  if (whole && number != std::floor (number))
    throw UsageError (option, text + " is not whole" + fix);
  return static_cast<Number> (number);
}

template int
parseNumber (const std::string&, const std::string&, const Range&);
template std::uint32_t
parseNumber (const std::string&, const std::string&, const Range&);
template std::size_t
parseNumber (const std::string&, const std::string&, const Range&);
template float
parseNumber (const std::string&, const std::string&, const Range&);
template double
parseNumber (const std::string&, const std::string&, const Range&);

Eigen::Vector3f
parseDirection (const std::string& option, const std::string& text)
{
  Eigen::Vector3f direction;
  std::istringstream parts (text + ",");
  std::string part;
  Eigen::Index count = 0;
  for (; std::getline (parts, part, ','); ++count) {
    if (count < 3)
      direction[count] = parseNumber<float> (option, part, Range::any());
  }
  if (count != 3)
    throw UsageError (option,
                      "'" + text + "' is not x,y,z; give three numbers, as 0,0,1");
  if (!(direction.norm() > 0.0f))
    throw UsageError (option, text + " is no direction; give one such as 0,0,1");
  return direction;
}

Eigen::Vector3f
parseUpAxis (const std::string& option, const std::string& text)
{
  // The y axis of an optical frame points down.
  if (text == "camera")
    return -Eigen::Vector3f::UnitY();
  return parseDirection (option, text);
}

} // namespace pcl_ops::apps
