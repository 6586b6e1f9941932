// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

namespace pcl_ops::internal {

/** \brief Lets planes grow, ring by ring: of the leaves without a plane, each goes to
 * that of the planes next to it which its points are nearest to, in units of the
 * plane's noise there.
 * \param[in] max_distance in those units
 * \param[in] max_rings how often
 * \return which planes grew */
std::vector<char>
growPlanes (const LeafCloud& cloud,
            double max_distance,
            int max_rings,
            unsigned threads,
            LeafPlanes& planes);

/** \brief Lets leaves change to the likelier of the planes next to them, the least of
 * d^2 / sigma^2 + 2 ln sigma, until none does; planes are fitted anew.
 * \return which planes changed */
std::vector<char>
relaxLabels (const LeafCloud& cloud, unsigned threads, LeafPlanes& planes);

} // namespace pcl_ops::internal
