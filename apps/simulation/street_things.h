// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"
#include <base/random.h>

namespace pcl_ops::simulation {

/** \brief A facade towards +y with windows, a door and often a gable roof; its middle
 * stands on the origin. All windows are equally deep. Faces in one plane are one
 * surface.
 * \param[in] width of the facade [m] */
Body
makeTownHouse (double width, internal::RandomGenerator& generator);

/** \brief A car along x on round wheels; the triangles beside its slanted windows are
 * open. */
Body
makeCar (internal::RandomGenerator& generator);

/** \brief A trunk and a crown of scattered leaves: no planes. */
Body
makeTree (internal::RandomGenerator& generator);

/** \brief Scattered leaves on the ground. */
Body
makeBush (double radius, internal::RandomGenerator& generator);

/** \brief The pole of a lamp or a sign. */
Body
makePole (internal::RandomGenerator& generator);

} // namespace pcl_ops::simulation
