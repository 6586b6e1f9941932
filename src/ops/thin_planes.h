// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detection/labelled_planes.h"

namespace pcl_ops::internal {

/** \brief Has no plane be thicker than so many times the noise of its surroundings:
 * of one whose rms exceeds that only the points within the limit stay, so that its rms
 * does not. Such planes come from leaves and points that went to likelier planes; most
 * are divided before. */
LabelledPlanes
keepThin (const Points& points,
          double max_noises,
          unsigned threads,
          LabelledPlanes found);

} // namespace pcl_ops::internal
