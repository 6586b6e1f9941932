// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parse_number.h"

#include <boost/format.hpp>

#include <charconv>
#include <system_error>

namespace pcl_ops::apps {

namespace {

/** \brief Returns a number as text, with up to ten significant digits: all those of a
 * 32-bit integer. */
std::string
shortText (double number)
{
  return str (boost::format ("%.10g") % number);
}

} // namespace

std::string
Range::text() const
{
  const bool has_lowest = std::isfinite (lowest);
  const bool has_highest = std::isfinite (highest);
  std::string text = has_lowest || has_highest ? "" : "that is finite";
  if (has_lowest)
    text = (lowest_included ? "from " : "above ") + shortText (lowest);
  if (has_lowest && has_highest)
    text += lowest_included ? " " : " and ";
  if (has_highest)
    text += (highest_included ? "up to " : "below ") + shortText (highest);
  return text + (has_highest || !lowest_included ? "" : " on");
}

double
parseNumber (const std::string& option,
             const std::string& text,
             const Range& range,
             const Range& of_type,
             bool must_be_whole)
{
  const auto fix = [must_be_whole] (const Range& wanted) {
    return std::string ("; give a ") + (must_be_whole ? "whole " : "") + "number " +
           wanted.text();
  };
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars (text.data(), end, number);
  const bool is_beyond_double = error == std::errc::result_out_of_range;
  if (rest != end || error == std::errc::invalid_argument)
    throw UsageError (option, "'" + text + "' is no number" + fix (range));
  if (is_beyond_double || !range.contains (number))
    throw UsageError (option, text + " is out of range" + fix (range));
  if (!of_type.contains (number)) {
    // For an integer type, of_type ends below 2^digits, one more than the largest
    // integer.
    const double largest =
        of_type.highest_included ? of_type.highest : of_type.highest - 1.0;
    const Range allowed = number < of_type.lowest ? range : range.upTo (largest);
    throw UsageError (option, text + " is out of range" + fix (allowed));
  }
  if (must_be_whole && number != std::floor (number))
    throw UsageError (option, text + " is not whole" + fix (range));
  return number;
}

Eigen::Vector3f
parseDirection (const std::string& option, const std::string& text)
{
  const auto numbers = parseNumbers<float, 3> (
      option,
      text,
      Range(),
      "'" + text + "' is not x,y,z; give three numbers, as 0,0,1");
  const Eigen::Vector3f direction (numbers.data());
  if (!(direction.norm() > 0.0f))
    throw UsageError (option, text + " is no direction; give one such as 0,0,1");
  return direction;
}

Eigen::Vector3f
parseUpAxis (const std::string& option, const std::string& text)
{
  // The y axis of a camera's optical frame points down.
  if (text == "camera")
    return -Eigen::Vector3f::UnitY();
  return parseDirection (option, text);
}

} // namespace pcl_ops::apps
