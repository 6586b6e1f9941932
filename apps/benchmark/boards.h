// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <simulation/scene.h>

namespace pcl_ops::benchmark {

/** \brief A scene with a known number of planes: square boards, each turned another
 * way, too far apart for two to be taken for one. */
simulation::Scene
makeBoards (unsigned number);

} // namespace pcl_ops::benchmark
