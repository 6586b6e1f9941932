// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "dense_boxes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace pcl_ops::apps {

namespace {

using Eigen::Vector3d;

/** \brief Number of points of the ball inside a box. Chosen by hand: enough for the
 * detector to find planes in the box, few enough to take little time. */
constexpr double points_of_ball = 3000.0;

/** \brief Returns half the edge of a cube with some thousand points of the survey [m]:
 * the radius of a ball around the center that has \ref points_of_ball, as the sample
 * tells.
 * \param[in] sampled_share share of the survey's points that are in the sample */
double
halfEdgeAround (const Vector3d& center, const PlaneSample& sample, double sampled_share)
{
  constexpr std::size_t min_sampled = 8; // fewer tell little of the density
  std::vector<double> squared_distances;
  for (const SampledPoints& group : sample.groups)
    for (const Vector3d& position : group.positions)
      squared_distances.push_back ((position - center).squaredNorm());
  const std::size_t sampled_of_ball =
      std::max (min_sampled, static_cast<std::size_t> (sampled_share * points_of_ball));
  // Index of the farthest point of the ball, among the points by their distances.
  const std::size_t farthest = std::min (sampled_of_ball, squared_distances.size() - 1);
  std::nth_element (squared_distances.begin(),
                    squared_distances.begin() + static_cast<std::ptrdiff_t> (farthest),
                    squared_distances.end());
  return std::sqrt (squared_distances[farthest]);
}

/** \brief Chooses the boxes, which have no points yet: at most 19. Their numbers are
 * chosen by hand, as a detection runs in each box. */
std::vector<DenseBox>
emptyBoxes (const PlaneSample& sample)
{
  constexpr std::size_t planes_with_boxes = 8; // the largest ones
  constexpr std::size_t boxes_of_plane = 2;
  constexpr std::size_t boxes_on_none = 3;
  const std::size_t planes = sample.planes.size();
  std::size_t survey_points = 0;
  for (const SampledPoints& group : sample.groups)
    survey_points += group.all_points;
  const double sampled_share = static_cast<double> (sample.shifted.cloud->size()) /
                               static_cast<double> (survey_points);
  std::vector<DenseBox> boxes;
  for (std::size_t group = 0; group <= planes; ++group) {
    const bool is_on_none = group == planes;
    if (group >= planes_with_boxes && !is_on_none)
      continue;
    const std::vector<Vector3d>& positions = sample.groups[group].positions;
    const std::size_t max_boxes = is_on_none ? boxes_on_none : boxes_of_plane;
    for (std::size_t i = 0; i < std::min (max_boxes, positions.size()); ++i) {
      const Vector3d& center = positions[i]; // the first ones are an even sample
      const Vector3d to_corner =
          Vector3d::Constant (halfEdgeAround (center, sample, sampled_share));
      boxes.push_back ({group, {center - to_corner, center + to_corner}, {}});
    }
  }
  return boxes;
}

} // namespace

std::vector<DenseBox>
denseBoxes (const nlohmann::ordered_json& list,
            const PlaneSample& sample,
            const ForEachLabeledPoint& for_each_point)
{
  // A cube has up to twice (6 / pi times) the points of the ball in it. More points
  // than this bound are only where the sample tells too low a density.
  constexpr std::size_t max_points = 20'000; // of a box
  std::vector<std::uint32_t> ids;
  for (const auto& plane : list.at ("planes"))
    ids.push_back (plane.at ("id").get<std::uint32_t>());
  std::sort (ids.begin(), ids.end());
  std::vector<DenseBox> boxes = emptyBoxes (sample);
  if (boxes.empty())
    return boxes;
  for_each_point ([&] (const Vector3d& point, std::uint32_t label) {
    for (DenseBox& dense : boxes) {
      if (!dense.box.contains (point) || dense.points.size() >= max_points)
        continue;
      const bool is_on_plane = dense.group < ids.size();
      // Around a point on no plane, a warning asks whether smaller voxels put points
      // that are on no plane on one: points of planes must not count.
      if (is_on_plane || !std::binary_search (ids.begin(), ids.end(), label))
        dense.points.push_back ((point - dense.box.center()).cast<float>());
    }
  });
  return boxes;
}

} // namespace pcl_ops::apps
