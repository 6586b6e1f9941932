// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace pcl_ops::apps {

/** \brief Whether x and y of a projected reference system are in international feet or
 * in US survey feet, as in many states of the US.
 * \param[in] epsg number of a projected system in the EPSG Geodetic Parameter Dataset;
 * for any other number the answer has no meaning */
bool
isInFeet (unsigned epsg);

} // namespace pcl_ops::apps
