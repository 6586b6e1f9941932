// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fspf/spheres.h"

#include "search/fixed_radius_search.h"

#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace pcl_ops::internal {

namespace {

Spheres
spheresInVoxels (const Points& points, double radius, unsigned threads)
{
  const auto search =
      std::make_shared<const FixedRadiusSearch> (points, radius, threads);
  return {search->points(), [search] (std::uint32_t center, Indices& sphere) {
            return search->find (center, sphere);
          }};
}

Spheres
spheresByUsersSearch (const DetectorInput& input, const Points& points, double radius)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  Indices place_of (input.cloud.size, none);
  for (std::size_t i = 0; i < points.size(); ++i)
    place_of[static_cast<std::size_t> (points.indexOf (i))] =
        static_cast<std::uint32_t> (i);
  return {points,
          [&points,
           radius,
           search = input.search_over (points.index),
           place_of = std::move (place_of)] (std::uint32_t center, Indices& sphere) {
            pcl::Indices neighbors;
            std::vector<float> squared_distances;
            search.within (
                points.indexOf (center), radius, neighbors, squared_distances);
            sphere.clear();
            for (const pcl::index_t neighbor : neighbors)
              if (place_of[static_cast<std::size_t> (neighbor)] != none)
                sphere.push_back (place_of[static_cast<std::size_t> (neighbor)]);
            return sphere.size();
          }};
}

} // namespace

Spheres
spheresAround (const DetectorInput& input,
               const Points& points,
               double radius,
               unsigned threads)
{
  return input.search_over && points.size() > 0
             ? spheresByUsersSearch (input, points, radius)
             : spheresInVoxels (points, radius, threads);
}

} // namespace pcl_ops::internal
