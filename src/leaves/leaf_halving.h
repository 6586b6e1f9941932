// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief Leaves after a round, with what the next one keeps of them. */
struct HalvedLeaves {
  std::vector<Leaf> leaves;
  LeafPlanes planes;
};

/** \brief Halves leaves without a plane and those that touch them: there the next round
 * looks again. The halves of a leaf keep its plane if their points lie on it. */
HalvedLeaves
halveOpenLeaves (const LeafCloud& cloud, const LeafPlanes& planes);

} // namespace pcl_ops::internal
