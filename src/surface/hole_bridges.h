// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <vector>

namespace pcl_ops {

/** \brief An outline with holes as one ring, in which a bridge leads to each hole and
 * back (Eberly, Triangulation by ear clipping, 2002, section 3).
 * \param[in] rings none of which touches another
 * \param[in] corners of all rings, ring after ring
 * \return their numbers; the ends of bridges come twice */
std::vector<std::size_t>
joinByBridges (const PlanarRings& rings, const PlanarPoints& corners);

} // namespace pcl_ops
