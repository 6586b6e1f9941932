// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

namespace pcl_ops::simulation {

/** Returns the share of readings that are missing: 0.01, 0.03, 0.05, 0.1, 0.2, 0.4 and
 * 0.5 for the seeds 1 to 7; later seeds repeat them. */
double
missingShare (Seed seed);

/** Moves a share of the readings, rounded to a whole number, to the sensor's origin and
 * gives them no_surface. Some drivers write missing readings this way. */
void
zeroReadings (Scan& scan, double share, Seed seed);

} // namespace pcl_ops::simulation
