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

/** \brief A plane with the centroid and covariance of all its points, but the count of
 * its sampled ones, so that the spacing of points is that of the sample. */
PlaneSegment
sampledSegment (const Json& plane, std::size_t count)
{
  PlaneSegment segment = segmentIn (plane);
  const Json& known = plane.at ("moments");
  Moments moments;
  known.at ("origin").get_to (moments.origin);
  known.at ("count").get_to (moments.count);
  known.at ("sum").get_to (moments.sum);
  known.at ("products").get_to (moments.products);
  segment.moments = Moments::of (
      static_cast<double> (count), moments.centroid(), moments.covariance());
  return segment;
}

/** \brief The group of each plane, its position in the list, by its label. */
std::map<std::uint32_t, std::size_t>
groupsIn (const Json& planes)
{
  std::map<std::uint32_t, std::size_t> groups;
  for (const Json& plane : planes)
    groups.emplace (plane.at ("id").get<std::uint32_t>(), groups.size());
  return groups;
}

std::vector<SampledPoints>
sampledPoints (const Json& list, const LabelledPoints& points, std::size_t max_points)
{
  const Json& planes = list.at ("planes");
  const std::map<std::uint32_t, std::size_t> groups = groupsIn (planes);
  std::vector<std::size_t> sizes;
  auto rest = list.at ("points").get<std::size_t>();
  for (const Json& plane : planes) {
    sizes.push_back (plane.at ("points").get<std::size_t>());
    rest -= std::min (rest, sizes.back());
  }
  sizes.push_back (rest);
  PointSample sample (sizes, max_points);
  points ([&] (const Eigen::Vector3d& place, std::uint32_t label) {
    const auto group = groups.find (label);
    sample.add (group == groups.end() ? groups.size() : group->second, place);
  });
  return sample.take();
}

/** \brief A place near the points: relative to it floats keep their digits. */
Eigen::Vector3d
originOf (const std::vector<SampledPoints>& samples)
{
  std::vector<Eigen::Vector3d> places;
  for (const SampledPoints& sample : samples)
    places.insert (places.end(), sample.places.begin(), sample.places.end());
  return localOrigin (places.size(), [&] (std::size_t i) { return places[i]; });
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
samplePlanes (const Json& list, const LabelledPoints& points, std::size_t max_points)
{
  PlaneSample sample;
  sample.points = sampledPoints (list, points, max_points);
  const Eigen::Vector3d shift = originOf (sample.points);
  sample.shifted = {XyzCloud::Ptr (new XyzCloud), shift};
  XyzCloud& cloud = *sample.shifted.cloud;
  // A survey has no single sensor: with one far above, pictures are views from above.
  constexpr float far_above = 1e9f;
  cloud.sensor_origin_.z() = far_above;
  const Json& planes = list.at ("planes");
  for (std::size_t i = 0; i < sample.points.size(); ++i) {
    const std::size_t first = cloud.size();
    for (const Eigen::Vector3d& place : sample.points[i].places) {
      const Eigen::Vector3f local = (place - shift).cast<float>();
      cloud.push_back (pcl::PointXYZ (local.x(), local.y(), local.z()));
    }
    if (i == planes.size())
      break;
    PlaneSegment& segment =
        sample.planes.emplace_back (sampledSegment (planes[i], cloud.size() - first));
    for (std::size_t point = first; point < cloud.size(); ++point)
      segment.inliers.push_back (static_cast<pcl::index_t> (point));
  }
  return sample;
}

} // namespace pcl_ops::apps
