// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** Returns 1, 3, 5, 10, 20, 40 and 50 % for seeds 1 to 7; later seeds repeat them. */
double
missingShare (Seed seed);

/** Moves a share of the readings, rounded to a whole number, to the sensor's origin and
 * gives them no_surface. Some drivers write pixels without a reading this way. */
void
zeroReadings (Scan& scan, double share, Seed seed);

} // namespace pcl_ops::simulation
