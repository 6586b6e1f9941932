// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

namespace pcl_ops::internal {

/** \brief The value below which a share of the values lies; 0 for no values. Reorders.
 */
float
quantileOf (std::vector<float>& values, double share);

/** \brief What places of a density scatter by in the median, interpolated between
 * octaves: a density between two of them has something of both, so that no small change
 * of a cloud is a large one here. */
class UsualNoise {
public:
  /** \param[in] density [1/m^2], and \param[in] noise [m], of the places that tell */
  UsualNoise (const std::vector<float>& density, const std::vector<float>& noise);

  /** \brief 0 where no place tells [m]. */
  double
  of (double density) const;

private:
  std::map<int, double> of_octave_;
  double of_all_ = 0.0;
};

} // namespace pcl_ops::internal
