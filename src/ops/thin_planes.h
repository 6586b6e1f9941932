// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labelled_planes.h"

#include <limits>

namespace pcl_ops::internal {

/** \brief How far points may be from their planes. */
struct ThinPlaneLimits {
  /** \brief The rms of a plane over the noise of its surroundings. */
  double noises = std::numeric_limits<double>::infinity();
  /** \brief The distance of each point [m]. */
  double distance = std::numeric_limits<double>::infinity();
};

/** \brief Has no plane be thicker than so many times the noise of its surroundings:
 * of one whose rms exceeds that only the points within the limit stay, so that its rms
 * does not. Such planes come from leaves and points that went to likelier planes; most
 * are divided before. Planes that have too few points left are dropped.
 * \param[in] found with the noise of each plane, as far as it is known */
LabelledPlanes
keepThin (const Points& points,
          const ThinPlaneLimits& limits,
          unsigned threads,
          LabelledPlanes found);

} // namespace pcl_ops::internal
