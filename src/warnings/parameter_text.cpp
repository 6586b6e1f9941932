// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "warnings/parameter_text.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

namespace pcl_ops::internal {

namespace {

/** \brief The parameter of Python's segment that an option stands for. */
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

} // namespace

std::string
roundedLength (double length)
{
  constexpr double tenth_of_digit = 10.0;
  const double unit = std::pow (10.0, std::floor (std::log10 (length)));
  std::ostringstream text;
  text.imbue (std::locale::classic());
  text << std::round (tenth_of_digit * length / unit) * unit / tenth_of_digit;
  return text.str();
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
