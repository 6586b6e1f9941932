// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"

namespace pcl_ops::apps {

/** \brief Oriented Point Sampling. */
Method
opsMethod ();

/** \brief Of what voxels of a given size begin at whole multiples; 0 where their size
 * is not given. */
double
voxelStepOf (const DetectorOptions& options);

} // namespace pcl_ops::apps
