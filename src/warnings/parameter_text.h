// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/result_warnings.h>

#include <cstdint>
#include <string>

namespace pcl_ops::internal {

/** \brief A number as text of up to six significant digits, with a decimal point
 * whatever the locale. */
std::string
numberText (double number);

/** \brief A length rounded to two significant digits, as text: 0.18, 1500. */
std::string
roundedLength (double length);

/** \brief The smallest number of one significant digit that is larger than a length, as
 * text: 0.2 for 0.18, and 0.4 for 0.3. Lengths below 1e-6 count as 1e-6. */
std::string
roundedUpLength (double length);

/** \brief A share, 0 to 1, in whole percent: "45 %". */
std::string
percentText (double share);

/** \brief Writes parameters as users give them: as options of the command line or as
 * arguments in Python. */
struct ParameterText {
  ParameterNames names;

  bool
  isPython () const
  {
    return names == ParameterNames::Python;
  }

  /** \brief A parameter with a value: "--threshold 0.1" or "distance_threshold=0.1".
   * \param[in] option name of the command line option, without dashes
   * \param[in] value as the user would type it; empty: the name alone */
  std::string
  of (const std::string& option, const std::string& value) const;

  /** \brief The label of the plane at a position in the list of planes: labels in files
   * begin with 1, labels in Python's arrays with 0. */
  std::string
  planeNumber (std::int32_t position) const
  {
    return std::to_string (isPython() ? position : position + 1);
  }

  /** \brief A parameter whose value is a word: "--up auto" or "up="auto"". */
  std::string
  ofWord (const std::string& option, const std::string& word) const;

  /** \brief A parameter whose value is an axis that the user has to choose:
   * "--up x,y,z" or "up=(x, y, z)". */
  std::string
  ofAxis (const std::string& option) const
  {
    return of (option, isPython() ? "(x, y, z)" : "x,y,z");
  }
};

} // namespace pcl_ops::internal
