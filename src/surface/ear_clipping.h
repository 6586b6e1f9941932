// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/surface/triangulation.h>

#include <cstddef>
#include <vector>

namespace pcl_ops {

/** \brief Cuts a ring that may touch itself, as one through keyholes does, into
 * triangles: takes ears off, corners whose triangle has no other corner in it
 * (Meisters, Polygons have ears, 1975). VTK's filters refuse such rings, or lose parts
 * of them. \param[in] ring counter-clockwise, by numbers of \p corners \return
 * counter-clockwise; those up to where there was no ear */
std::vector<Triangle>
clipEars (std::vector<std::size_t> ring, const PlanarPoints& corners);

} // namespace pcl_ops
