// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_json.h"

#include <numbers/angles.h>
#include <pcl_ops/orientation.h>

#include <cmath>

namespace pcl_ops::apps {

namespace {

nlohmann::ordered_json
toObject (const PlaneExtent& extent)
{
  nlohmann::ordered_json object;
  object["length"] = extent.length;
  object["width"] = extent.width;
  object["center"] = toArray (extent.center);
  object["axes"] = {toArray (extent.long_axis), toArray (extent.short_axis)};
  return object;
}

nlohmann::ordered_json
toArray (const Ring& ring)
{
  nlohmann::ordered_json corners = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& corner : ring)
    corners.push_back (apps::toArray (corner));
  return corners;
}

template <typename Iterator>
nlohmann::ordered_json
toArray (Iterator first, Iterator last)
{
  nlohmann::ordered_json rings = nlohmann::ordered_json::array();
  for (; first != last; ++first)
    rings.push_back (toArray (*first));
  return rings;
}

Ring
ringIn (const nlohmann::ordered_json& corners)
{
  Ring ring;
  for (const auto& corner : corners)
    ring.emplace_back (corner.at (0).get<double>(),
                       corner.at (1).get<double>(),
                       corner.at (2).get<double>());
  return ring;
}

} // namespace

nlohmann::ordered_json
toArray (const Eigen::Vector3d& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

Attitude
attitudeOf (const PlaneSegment& plane, const Eigen::Vector3d& up)
{
  Attitude attitude;
  attitude.slope = toDegrees (slopeOf (plane.normal, up));
  attitude.height = plane.centroid.dot (up);
  const bool is_downward =
      plane.orientation != Orientation::Vertical && plane.normal.dot (up) < 0.0;
  const Eigen::Vector3d normal = is_downward ? -plane.normal : plane.normal;
  if (up != Eigen::Vector3d::UnitZ() || normal.head<2>().isZero (0.0))
    return attitude;
  constexpr double full_turn = 360.0;
  const double angle = toDegrees (std::atan2 (normal.x(), normal.y()));
  attitude.aspect = angle < 0.0 ? angle + full_turn : angle;
  return attitude;
}

void
turnUp (std::vector<PlaneSegment>& planes, const Eigen::Vector3d& up)
{
  for (PlaneSegment& plane : planes)
    if (plane.orientation != Orientation::Vertical && plane.normal.dot (up) < 0.0)
      plane.normal = -plane.normal;
}

nlohmann::ordered_json
planeObject (std::size_t id,
             const PlaneSegment& segment,
             const PlaneExtent& extent,
             const Attitude& attitude,
             const Polygons& parts)
{
  const Plane plane = segment.plane();
  nlohmann::ordered_json object;
  object["id"] = id;
  object["orientation"] = toString (segment.orientation);
  object["points"] = static_cast<std::size_t> (segment.moments.count);
  object["coefficients"] = {
      plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset};
  object["centroid"] = toArray (segment.centroid);
  object["normal"] = toArray (segment.normal);
  object["rms"] = segment.rms();
  object["area"] = extent.area;
  object["slope"] = attitude.slope;
  object["aspect"] =
      attitude.aspect ? nlohmann::ordered_json (*attitude.aspect) : nullptr;
  object["height"] = attitude.height;
  object["extent"] = toObject (extent);
  object["hull"] = toArray (extent.hull);
  object["holes"] = toArray (extent.holes.begin(), extent.holes.end());
  for (const Rings& part : parts)
    object["parts"].push_back (toArray (part.begin(), part.end()));
  return object;
}

Polygons
polygonsIn (const nlohmann::ordered_json& plane)
{
  if (plane.at ("hull").empty())
    return {};
  Polygons polygons = {{ringIn (plane.at ("hull"))}};
  for (const auto& hole : plane.at ("holes"))
    polygons.front().push_back (ringIn (hole));
  if (plane.contains ("parts"))
    for (const auto& part : plane.at ("parts")) {
      polygons.emplace_back();
      for (const auto& ring : part)
        polygons.back().push_back (ringIn (ring));
    }
  return polygons;
}

} // namespace pcl_ops::apps
