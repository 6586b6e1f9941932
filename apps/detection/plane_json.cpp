// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_json.h"

#include <numbers/angles.h>

#include <cmath>

namespace pcl_ops::apps {

std::string
jsonText (const nlohmann::ordered_json& json)
{
  constexpr int indent = 2;
  return json.dump (indent) + "\n";
}

std::optional<Orientation>
orientationCalled (const std::string& name)
{
  for (const Orientation known :
       {Orientation::Horizontal, Orientation::Vertical, Orientation::Other})
    if (name == toString (known))
      return known;
  return {};
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
  object["centroid"] = segment.centroid;
  object["normal"] = segment.normal;
  object["rms"] = segment.rms();
  object["area"] = extent.area;
  object["slope"] = attitude.slope;
  object["aspect"] =
      attitude.aspect ? nlohmann::ordered_json (*attitude.aspect) : nullptr;
  object["height"] = attitude.height;
  object["extent"] = {{"length", extent.length},
                      {"width", extent.width},
                      {"center", extent.center},
                      {"axes", {extent.long_axis, extent.short_axis}}};
  object["hull"] = extent.hull;
  object["holes"] = extent.holes;
  if (!parts.empty())
    object["parts"] = parts;
  return object;
}

Polygons
polygonsIn (const nlohmann::ordered_json& plane)
{
  Rings largest = {plane.at ("hull").get<Ring>()};
  if (largest.front().empty())
    return {};
  for (const auto& hole : plane.at ("holes"))
    largest.push_back (hole.get<Ring>());
  Polygons polygons = plane.value ("parts", Polygons());
  polygons.insert (polygons.begin(), std::move (largest));
  return polygons;
}

} // namespace pcl_ops::apps
