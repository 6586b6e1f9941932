// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/parameter_text.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <map>
#include <sstream>

namespace pcl_ops::internal {

namespace {

/** \brief Name in Python's segment of the parameter of a command line option. */
std::string
pythonNameOf (std::string option)
{
  static const std::map<std::string, std::string> others = {
      {"threshold", "distance_threshold"},
      {"merge-distance", "merging_distance_threshold"},
      {"min-inliers", "min_samples"},
      {"voxel-size", "surfels_voxel_size"}};
  if (const auto other = others.find (option); other != others.end())
    return other->second;
  std::replace (option.begin(), option.end(), '-', '_');
  return option;
}

/** \brief The power of ten of the first significant digit of a length; 1 for length 0.
 */
double
unitOf (double length)
{
  return length > 0.0 ? std::pow (10.0, std::floor (std::log10 (length))) : 1.0;
}

std::string
written (double number)
{
  std::ostringstream text;
  text.imbue (std::locale::classic());
  text << number;
  return text.str();
}

} // namespace

std::string
roundedLength (double length)
{
  constexpr double digits = 10.0; // two
  const double unit = unitOf (length);
  return written (std::round (digits * length / unit) * unit / digits);
}

std::string
roundedUpLength (double length)
{
  constexpr double smallest = 1e-6;
  const double unit = unitOf (std::max (length, smallest));
  // .3 / .1 is rounded to a number below 3.
  constexpr double rounding = 1e-9;
  const double digit = std::floor (std::max (length, smallest) / unit + rounding);
  return written ((digit + 1.0) * unit);
}

std::string
perCentOf (double share)
{
  return std::to_string (std::lround (100.0 * share)) + " %";
}

std::string
ParameterText::of (const std::string& option, const std::string& value) const
{
  if (isPython())
    return pythonNameOf (option) + (value.empty() ? "" : "=" + value);
  return "--" + option + (value.empty() ? "" : " " + value);
}

std::string
ParameterText::ofWord (const std::string& option, const std::string& word) const
{
  return of (option, isPython() ? '"' + word + '"' : word);
}

} // namespace pcl_ops::internal
