// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <limits>
#include <string>

namespace pcl_ops::apps {

/** \brief The numbers an option takes; its text ("above 0 and up to 1") is part of the
 * error message. */
struct Range {
  double lowest = -std::numeric_limits<double>::infinity();
  bool lowest_included = false;
  double highest = std::numeric_limits<double>::infinity();
  bool highest_included = false;

  static Range
  any ()
  {
    return {};
  }
  static Range
  above (double bound)
  {
    return {bound, false};
  }
  static Range
  from (double bound)
  {
    return {bound, true};
  }
  Range
  upTo (double bound) const
  {
    return {lowest, lowest_included, bound, true};
  }
  Range
  below (double bound) const
  {
    return {lowest, lowest_included, bound, false};
  }

  /** \brief False for NaN and the infinities, whatever the bounds. */
  bool
  contains (double number) const;
  std::string
  text () const;
};

/** \brief The number a text stands for.
 * \param[in] option names the option in the error
 * \throws UsageError if the text is no number or the number is out of range */
template <typename Number>
Number
parseNumber (const std::string& option, const std::string& text, const Range& range);

/** \brief A vector "x,y,z" other than zero.
 * \throws UsageError if the text is anything else */
Eigen::Vector3f
parseDirection (const std::string& option, const std::string& text);

/** \brief The same, or "camera" for up in the optical frame of a level camera.
 * \throws UsageError if the text is anything else */
Eigen::Vector3f
parseUpAxis (const std::string& option, const std::string& text);

} // namespace pcl_ops::apps
