// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "furniture.h"

namespace pcl_ops::simulation {

/** \brief A ball, a bin, a lamp or a rolled carpet: nothing planar. */
Furniture
makeRoundClutter (internal::RandomGenerator& generator);

} // namespace pcl_ops::simulation
