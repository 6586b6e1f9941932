// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene.h"
#include <base/random.h>

namespace pcl_ops::simulation {

/** \brief A piece of furniture standing on z = 0 around the origin, its back towards
 * -y. Sizes are drawn from what is common in homes and offices. */
struct Furniture {
  Body body;
  /** \brief Extent on the floor along x and y [m]. */
  Eigen::Vector2d footprint = Eigen::Vector2d::Zero();
};

Furniture
makeTable (internal::RandomGenerator& generator);

/** \brief A table with a monitor, an open laptop, books and a mug. */
Furniture
makeDesk (internal::RandomGenerator& generator);

Furniture
makeCupboard (internal::RandomGenerator& generator);

/** \brief Open shelves with books. */
Furniture
makeShelf (internal::RandomGenerator& generator);

Furniture
makeBed (internal::RandomGenerator& generator);

Furniture
makeSofa (internal::RandomGenerator& generator);

Furniture
makeChair (internal::RandomGenerator& generator);

/** \brief A cardboard box or two, one turned on the other. */
Furniture
makeCartons (internal::RandomGenerator& generator);

} // namespace pcl_ops::simulation
