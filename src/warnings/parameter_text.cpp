// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/parameter_text.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <string_view>
#include <utility>

namespace pcl_ops::internal {

namespace {

/** \brief Returns the name in Python of the parameter that a command line option sets.
 * It is the name of the option with _ in place of -, except for the options in the
 * list. */
std::string
pythonNameOf (std::string option)
{
  // An array has no destructor to run: Python threads may still warn at program exit.
  constexpr std::pair<std::string_view, std::string_view> python_names[] = {
      {"threshold", "distance_threshold"},
      {"merge-distance", "merging_distance_threshold"},
      {"min-inliers", "min_samples"},
      {"voxel-size", "surfels_voxel_size"}};
  for (const auto& [of_option, python_name] : python_names)
    if (option == of_option)
      return std::string (python_name);
  std::replace (option.begin(), option.end(), '-', '_');
  return option;
}

/** \brief The power of ten of the first significant digit of a length: 0.1 for 0.18; 1
 * for length 0. */
double
unitOfFirstDigit (double length)
{
  return length > 0.0 ? std::pow (10.0, std::floor (std::log10 (length))) : 1.0;
}

} // namespace

std::string
numberText (double number)
{
  std::ostringstream text;
  text.imbue (std::locale::classic());
  text << number;
  return text.str();
}

std::string
roundedLength (double length)
{
  constexpr double steps_per_unit = 10.0; // two significant digits
  const double unit = unitOfFirstDigit (length);
  return numberText (std::round (steps_per_unit * length / unit) * unit /
                     steps_per_unit);
}

std::string
roundedUpLength (double length)
{
  constexpr double min_length = 1e-6; // a length of 0 has no first digit
  const double bounded = std::max (length, min_length);
  const double unit = unitOfFirstDigit (bounded);
  constexpr double rounding = 1e-9; // 0.3 / 0.1 is rounded to a number below 3
  return numberText ((std::floor (bounded / unit + rounding) + 1.0) * unit);
}

std::string
percentText (double share)
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
