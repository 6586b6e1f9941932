// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/distinct_places.h"
#include "detection/labeled_planes.h"
#include "ops/place_noise.h"
#include "ops/places.h"
#include "ops/regions.h"
#include <pcl_ops/oriented_point_sampling.h>

#include <vector>

namespace pcl_ops::internal {

/** \brief Turns regions into labeled planes. Assigns each point to a plane or to
 * no_plane. Splits planes that are the two sides of a thin wall. Drops planes that are
 * much thicker than their noise, unless the user gave a distance threshold. Merges
 * planes if the user gave a merging distance. Sets the noise of each plane, and the
 * distance threshold of LabeledPlanes::used.
 * \param[in] points all points of the cloud
 * \param[in] distinct the coordinates of the places, and the place of each point
 * \param[in] places,noise,regions results of the earlier stages
 * \param[in] is_plane for each region, whether it is a plane */
LabeledPlanes
planesOfRegions (const Points& points,
                 const DistinctPlaces& distinct,
                 const Places& places,
                 const PlaceNoise& noise,
                 const Regions& regions,
                 std::vector<char> is_plane,
                 const OrientedPointSamplingParameters& parameters);

} // namespace pcl_ops::internal
