// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/result_warnings.h>

#include <string>

namespace pcl_ops::internal {

/** \brief A length with two digits, as people write it: 0.18, 1500. */
std::string
roundedLength (double length);

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

  /** \brief "--up auto", or "up="auto"": of values that are words. */
  std::string
  ofWord (const std::string& option, const std::string& word) const;
};

} // namespace pcl_ops::internal
