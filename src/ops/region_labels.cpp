// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/region_labels.h"

#include "base/parallel.h"
#include "ops/constants.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl_ops::internal {

namespace {

/** \brief The likeliest region found so far for a place. */
struct Likeliest {
  /** \brief d^2 / s^2 + 2 ln s of \ref labelPlaces. */
  double cost = std::numeric_limits<double>::infinity();
  std::int32_t region = no_plane; // its index
};

// Returns how far a place may be from the plane of its region [m].
// \param[in] noise of the plane around the place [m]
double
reachOf (const Region& region, double noise)
{
  // Joined parts tilt, as those of a cambered road, and lie beyond the noise of the
  // region that took them. So a region with parts reaches as far as its rms distance
  // allows. If all regions did, hills would become thick planes.
  const double rms = std::sqrt (region.fit.variances[0]);
  const double thickness =
      region.has_parts
          ? std::clamp (rms, noise, place_constants.max_rms_over_noise * noise)
          : noise;
  return place_constants.noises_of_point * thickness +
         place_constants.bend_of_width * region.width();
}

// Makes a region the likeliest one of a place if its plane is near enough and likelier
// than the likeliest so far. In case of a tie the lower index wins.
// \param[in] index of the region
// \param[in] position,noise_of_place those of the place [m]
void
offer (const Region& region,
       std::int32_t index,
       const Eigen::Vector3d& position,
       double noise_of_place,
       std::optional<double> distance_threshold,
       Likeliest& likeliest)
{
  constexpr double least_spread = 1e-9; // [m], keeps the logarithm finite
  const double distance = std::abs (region.fit.plane.distance (position));
  const double noise = std::max (
      region.scatter,
      std::min (noise_of_place, place_constants.max_noise_over_region * region.noise));
  const double reach =
      distance_threshold ? *distance_threshold : reachOf (region, noise);
  if (distance > reach)
    return;
  const double spread = noise + least_spread;
  const double cost = distance * distance / (spread * spread) + 2.0 * std::log (spread);
  if (cost < likeliest.cost || (cost == likeliest.cost && index < likeliest.region))
    likeliest = {cost, index};
}

} // namespace

Labels
labelPlaces (const Places& places,
             const PlaceNoise& noise,
             const Regions& regions,
             const std::vector<char>& is_plane,
             std::optional<double> distance_threshold,
             unsigned threads)
{
  Labels labels (places.size(), no_plane);
  forEach (threads, places.size(), [&] (std::size_t i) {
    Likeliest likeliest;
    // Most neighbors are in one region, which need not be offered again.
    std::int32_t last_offered = no_plane;
    const auto offerOnce = [&] (std::int32_t region) {
      if (region == no_plane || region == last_offered || is_plane[region] == 0)
        return;
      last_offered = region;
      offer (regions.list[region],
             region,
             places.position[i],
             noise.of_place[i],
             distance_threshold,
             likeliest);
    };
    offerOnce (regions.of_place[i]);
    for (std::size_t k = 0; k < places.neighbors_per_place; ++k)
      offerOnce (regions.of_place[places.nearestOf (i)[k]]);
    labels[i] = likeliest.region;
  });
  return labels;
}

} // namespace pcl_ops::internal
