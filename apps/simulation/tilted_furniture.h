// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "furniture.h"

namespace pcl_ops::simulation {

/** \brief A board that leans on the wall behind it. */
Furniture
makeLeaningBoard (internal::RandomGenerator& generator);

/** \brief A wide board with one edge on the floor, the other raised. */
Furniture
makeRamp (internal::RandomGenerator& generator);

/** \brief A panel of any tilt and roll on a round post. */
Furniture
makeTiltedPanel (internal::RandomGenerator& generator);

} // namespace pcl_ops::simulation
