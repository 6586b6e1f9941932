// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_sample.h"

#include <detection/plane_list.h>

#include <algorithm>
#include <cstdint>
#include <map>

namespace pcl_ops::apps {

namespace {

using Json = nlohmann::ordered_json;

/** \brief Returns a plane with the centroid and covariance of all its points, but the
 * number of its sampled points as the count, so that the spacing of points is that of
 * the sample. */
PlaneSegment
sampledSegment (const Json& plane, std::size_t sampled_points)
{
  PlaneSegment segment = segmentIn (plane);
  const Json& object = plane.at ("moments");
  Moments of_all_points;
  object.at ("origin").get_to (of_all_points.origin);
  object.at ("count").get_to (of_all_points.count);
  object.at ("sum").get_to (of_all_points.sum);
  object.at ("products").get_to (of_all_points.products);
  segment.moments = Moments::of (static_cast<double> (sampled_points),
                                 of_all_points.centroid(),
                                 of_all_points.covariance());
  return segment;
}

/** \brief Returns a map from the label of each plane to its group: its position in the
 * list. */
std::map<std::uint32_t, std::size_t>
groupsIn (const Json& planes)
{
  std::map<std::uint32_t, std::size_t> groups;
  for (const Json& plane : planes)
    groups.emplace (plane.at ("id").get<std::uint32_t>(), groups.size());
  return groups;
}

/** \brief Returns the sampled points of each plane in a list, then those on no plane.
 */
std::vector<SampledPoints>
sampledGroups (const Json& list,
               const ForEachLabeledPoint& for_each_point,
               std::size_t max_points)
{
  const Json& planes = list.at ("planes");
  const std::map<std::uint32_t, std::size_t> groups = groupsIn (planes);
  std::vector<std::size_t> group_sizes;
  auto on_no_plane = list.at ("points").get<std::size_t>();
  for (const Json& plane : planes) {
    group_sizes.push_back (plane.at ("points").get<std::size_t>());
    on_no_plane -= std::min (on_no_plane, group_sizes.back());
  }
  group_sizes.push_back (on_no_plane);
  PointSample sample (group_sizes, max_points);
  for_each_point ([&] (const Eigen::Vector3d& point, std::uint32_t label) {
    const auto group = groups.find (label);
    sample.add (group == groups.end() ? groups.size() : group->second, point);
  });
  return sample.take();
}

/** \brief Returns a position near the points. Relative to it, coordinates keep their
 * digits in single precision. */
Eigen::Vector3d
originOf (const std::vector<SampledPoints>& groups)
{
  std::vector<Eigen::Vector3d> points;
  for (const SampledPoints& group : groups)
    points.insert (points.end(), group.positions.begin(), group.positions.end());
  return localOrigin (points.size(), [&] (std::size_t i) { return points[i]; });
}

} // namespace

PlaneSegment
segmentIn (const Json& plane)
{
  PlaneSegment segment;
  plane.at ("normal").get_to (segment.normal);
  plane.at ("centroid").get_to (segment.centroid);
  segment.moments.count = plane.at ("points").get<double>();
  if (const auto known = orientationCalled (plane.at ("orientation")))
    segment.orientation = *known;
  return segment;
}

PlaneSample
samplePlanes (const Json& list,
              const ForEachLabeledPoint& for_each_point,
              std::size_t max_points)
{
  PlaneSample sample;
  sample.groups = sampledGroups (list, for_each_point, max_points);
  const Eigen::Vector3d shift = originOf (sample.groups);
  sample.shifted = {XyzCloud::Ptr (new XyzCloud), shift};
  XyzCloud& cloud = *sample.shifted.cloud;
  // A survey has no single sensor: with one far above, pictures are views from above.
  constexpr float far_above = 1e9f; // [m]
  cloud.sensor_origin_.z() = far_above;
  const Json& planes = list.at ("planes");
  for (std::size_t group = 0; group < sample.groups.size(); ++group) {
    const std::size_t first_of_group = cloud.size();
    for (const Eigen::Vector3d& point : sample.groups[group].positions) {
      const Eigen::Vector3f local = (point - shift).cast<float>();
      cloud.push_back (pcl::PointXYZ (local.x(), local.y(), local.z()));
    }
    const bool is_on_no_plane = group == planes.size();
    if (is_on_no_plane)
      break;
    PlaneSegment& segment = sample.planes.emplace_back (
        sampledSegment (planes[group], cloud.size() - first_of_group));
    for (std::size_t inlier = first_of_group; inlier < cloud.size(); ++inlier)
      segment.inliers.push_back (static_cast<pcl::index_t> (inlier));
  }
  return sample;
}

} // namespace pcl_ops::apps
