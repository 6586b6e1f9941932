// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dense_places.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_ops::apps {

namespace {

using Eigen::Vector3d;

/** \brief Half the edge of a cube with some thousand points of the survey [m].
 * \param[in] share of the survey's points that are in the sample */
double
reachAround (const Vector3d& middle, const PlaneSample& sample, double share)
{
  constexpr double points_of_place = 3000.0;
  constexpr std::size_t fewest = 8; // sampled points: fewer tell little of density
  std::vector<double> distances;
  for (const SampledPoints& group : sample.points)
    for (const Vector3d& place : group.places)
      distances.push_back ((place - middle).squaredNorm());
  const std::size_t wanted =
      std::max (fewest, static_cast<std::size_t> (share * points_of_place));
  const std::size_t last = std::min (wanted, distances.size() - 1);
  std::nth_element (distances.begin(),
                    distances.begin() + static_cast<std::ptrdiff_t> (last),
                    distances.end());
  return std::sqrt (distances[last]);
}

/** \brief Chooses the boxes, which have no points yet. */
std::vector<DensePlace>
chosenPlaces (const PlaneSample& sample)
{
  constexpr std::size_t largest_planes = 8;
  constexpr std::size_t on_plane = 2;
  constexpr std::size_t on_none = 3;
  const std::size_t planes = sample.planes.size();
  std::size_t all = 0;
  for (const SampledPoints& group : sample.points)
    all += group.all;
  const double share =
      static_cast<double> (sample.shifted.cloud->size()) / static_cast<double> (all);
  std::vector<DensePlace> chosen;
  for (std::size_t group = 0; group <= planes; ++group) {
    if (group >= largest_planes && group < planes)
      continue;
    const std::vector<Vector3d>& places = sample.points[group].places;
    const std::size_t number = group == planes ? on_none : on_plane;
    for (std::size_t k = 0; k < std::min (number, places.size()); ++k) {
      const double reach = reachAround (places[k], sample, share);
      chosen.push_back ({group,
                         {places[k] - Vector3d::Constant (reach),
                          places[k] + Vector3d::Constant (reach)},
                         {}});
    }
  }
  return chosen;
}

} // namespace

std::vector<DensePlace>
densePlaces (const nlohmann::ordered_json& list,
             const PlaneSample& sample,
             const LabelledPoints& points)
{
  constexpr std::size_t max_points = 20'000;
  std::vector<std::uint32_t> ids;
  for (const auto& plane : list.at ("planes"))
    ids.push_back (plane.at ("id").get<std::uint32_t>());
  std::sort (ids.begin(), ids.end());
  std::vector<DensePlace> places = chosenPlaces (sample);
  if (places.empty())
    return places;
  points ([&] (const Vector3d& point, std::uint32_t label) {
    for (DensePlace& place : places)
      if (place.box.contains (point) && place.points.size() < max_points &&
          (place.group < ids.size() ||
           !std::binary_search (ids.begin(), ids.end(), label)))
        place.points.push_back ((point - place.box.center()).cast<float>());
  });
  return places;
}

} // namespace pcl_ops::apps
