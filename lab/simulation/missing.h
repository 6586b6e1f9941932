// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** 1, 3, 5, 10, 20, 40 and 50 % by the seeds 1 to 7, and so by all later ones. */
double
missingShare (Seed seed);

/** Sets a share of the readings, rounded to a whole number, to the sensor's origin, on
 * no surface: so drivers write a pixel without a reading. */
void
zeroReadings (Scan& scan, double share, Seed seed);

} // namespace pcl_ops::simulation
