// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::apps {

/** \brief Whether x and y of a projected reference system are in feet, international or
 * US survey, as those of many US states are.
 * \param[in] epsg number of a projected system in the EPSG Geodetic Parameter Dataset;
 * of other numbers the answer has no meaning */
bool
isInFeet (unsigned epsg);

} // namespace pcl_ops::apps
