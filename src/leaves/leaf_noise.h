// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"

#include <vector>

namespace pcl_ops::internal {

/** \brief Measures the noise of planes where they are: of each leaf, the rms distance
 * of the leaves of its plane around. At most a few times what is expected of as many
 * points there: noise measured from a plane's own misfit runs away, as a plane that
 * bends is noisy, so that it takes more and bends more.
 * \param[in] changed planes to be measured; null: all */
void
measureNoise (const LeafCloud& cloud,
              unsigned threads,
              LeafPlanes& planes,
              const std::vector<char>* changed = nullptr);

} // namespace pcl_ops::internal
