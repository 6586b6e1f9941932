// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "errors.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <sstream>
#include <string>

namespace pcl_ops::apps {

/** \brief The range of numbers that an option takes. For "above 0 and up to 1" write
 * above (0).upTo (1). */
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  /** \brief Whether \ref lowest itself is in the range; \ref highest_included says the
   * same of \ref highest. */
  bool lowest_included = false;
  double highest = std::numeric_limits<double>::infinity();
  bool highest_included = false;

  /** \brief Returns the range with this upper bound, which is included. */
  Range
  upTo (double bound) const
  {
    return {lowest, lowest_included, bound, true};
  }

  /** \brief Returns the range with this upper bound, which is not included. */
  Range
  below (double bound) const
  {
    return {lowest, lowest_included, bound, false};
  }

  /** \brief False for NaN and the infinities, whatever the bounds. */
  bool
  contains (double number) const
  {
    return std::isfinite (number) &&
           (number > lowest || (lowest_included && number == lowest)) &&
           (number < highest || (highest_included && number == highest));
  }

  /** \brief Returns the range in words for messages: "above 0 and up to 1". */
  std::string
  text () const;
};

/** \brief Returns the range of all numbers larger than the bound. */
inline Range
above (double bound)
{
  return {bound, false};
}

/** \brief Returns the range of the bound and all larger numbers. */
inline Range
from (double bound)
{
  return {bound, true};
}

/** \brief Returns the number that a text has. It does not depend on the locale.
 * \param[in] range that the option allows
 * \param[in] of_type range of the type that the caller converts the number to
 * \param[in] must_be_whole whether the number must be an integer
 * \throws UsageError about the option if \p text is no number in both ranges */
double
parseNumber (const std::string& option,
             const std::string& text,
             const Range& range,
             const Range& of_type,
             bool must_be_whole);

/** \brief Returns the number that a text has.
 * \param[in] range that the option allows
 * \throws UsageError about the option if \p text is no Number in this range */
template <typename Number>
Number
parseNumber (const std::string& option, const std::string& text, const Range& range)
{
  using Limits = std::numeric_limits<Number>;
  const Range from_lowest = from (static_cast<double> (Limits::lowest()));
  // A double holds not every largest integer, but the integer after it, 2^digits.
  const Range of_type = Limits::is_integer
                            ? from_lowest.below (std::ldexp (1.0, Limits::digits))
                            : from_lowest.upTo (static_cast<double> (Limits::max()));
  return static_cast<Number> (
      parseNumber (option, text, range, of_type, Limits::is_integer));
}

/** \brief Returns the numbers of a text such as "1,2,3".
 * \param[in] problem message and fix if \p text has more or fewer than \p count numbers
 * \throws UsageError with \p problem, or as \ref parseNumber */
template <typename Number, std::size_t count>
std::array<Number, count>
parseNumbers (const std::string& option,
              const std::string& text,
              const Range& range,
              const std::string& problem)
{
  std::array<Number, count> numbers{};
  std::size_t found = 0;
  std::istringstream parts (text + ",");
  for (std::string part; std::getline (parts, part, ','); ++found)
    if (found < count)
      numbers[found] = parseNumber<Number> (option, part, range);
  if (found != count)
    throw UsageError (option, problem);
  return numbers;
}

/** \brief Returns the vector of a text "x,y,z", not normalized.
 * \throws UsageError if \p text is anything else or the vector is zero */
Eigen::Vector3f
parseDirection (const std::string& option, const std::string& text);

/** \brief As \ref parseDirection, but "camera" gives (0, -1, 0): up in the optical
 * frame of a level camera. */
Eigen::Vector3f
parseUpAxis (const std::string& option, const std::string& text);

} // namespace pcl_ops::apps
