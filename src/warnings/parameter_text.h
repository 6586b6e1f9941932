// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/result_warnings.h>

#include <cstdint>
#include <string>

namespace pcl_ops::internal {

/** \brief A length with two digits, as people write it: 0.18, 1500. */
std::string
roundedLength (double length);

/** \brief The number above a length with one digit. */
std::string
roundedUpLength (double length);

/** \brief A share of one in per cent: "45 %". */
std::string
perCentOf (double share);

/** \brief Names of parameters where users give them. */
struct ParameterText {
  ParameterNames names;

  bool
  isPython () const
  {
    return names == ParameterNames::Python;
  }

  /** \brief "--threshold 0.1", or "distance_threshold=0.1".
   * \param[in] option without dashes
   * \param[in] value as the user would type it; may be empty for the option's name */
  std::string
  of (const std::string& option, const std::string& value) const;

  /** \brief Of the plane at a position: labels of files begin with 1, of arrays with 0.
   */
  std::string
  planeNumber (std::int32_t position) const
  {
    return std::to_string (isPython() ? position : position + 1);
  }

  /** \brief "--up auto", or "up="auto"": of values that are words. */
  std::string
  ofWord (const std::string& option, const std::string& word) const;

  /** \brief "--up x,y,z", or "up=(x, y, z)": of values that are an axis of the user's.
   */
  std::string
  ofAxis (const std::string& option) const
  {
    return of (option, isPython() ? "(x, y, z)" : "x,y,z");
  }
};

} // namespace pcl_ops::internal
