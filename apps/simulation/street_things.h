// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"

namespace pcl_ops::simulation {

/** \brief A facade towards +y with windows, a door and often a gable roof; its middle
 * stands on the origin. All windows are equally deep. Faces in one plane are one
 * surface.
 * \param[in] width of the facade [m] */
Body
drawTownHouse (double width, Random& random);

/** \brief A car along x on round wheels; the triangles beside its slanted windows are
 * open. */
Body
drawCar (Random& random);

/** \brief A trunk and a crown of scattered leaves: no planes. */
Body
drawTree (Random& random);

/** \brief Scattered leaves on the ground. */
Body
drawBush (double radius, Random& random);

/** \brief The pole of a lamp or a sign. */
Body
drawPole (Random& random);

} // namespace pcl_ops::simulation
