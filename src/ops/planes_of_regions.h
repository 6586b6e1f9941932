// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/distinct_places.h"
#include "detection/labelled_planes.h"
#include "ops/place_noise.h"
#include "ops/places.h"
#include "ops/regions.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief Gives every point to a plane or to none, tells layers apart, drops planes
 * that are thicker than their noise, and says what the noise of each is.
 * \param[in] points the cloud, and \param[in] distinct its places
 * \param[in] is_plane which regions are planes */
LabelledPlanes
planesOfRegions (const Points& points,
                 const DistinctPlaces& distinct,
                 const Places& places,
                 const PlaceNoise& noise,
                 const Regions& regions,
                 std::vector<char> is_plane,
                 const OrientedPointSamplingParameters& parameters);

} // namespace pcl_ops::internal
