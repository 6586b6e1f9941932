// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_json.h"

#include <pcl_ops/orientation.h>

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
toArray (const std::vector<Eigen::Vector3d>& ring)
{
  nlohmann::ordered_json corners = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& corner : ring)
    corners.push_back (apps::toArray (corner));
  return corners;
}

} // namespace

nlohmann::ordered_json
toArray (const Eigen::Vector3d& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

nlohmann::ordered_json
planeObject (std::size_t id, const PlaneSegment& segment, const PlaneExtent& extent)
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
  object["extent"] = toObject (extent);
  object["hull"] = toArray (extent.hull);
  object["holes"] = nlohmann::ordered_json::array();
  for (const std::vector<Eigen::Vector3d>& hole : extent.holes)
    object["holes"].push_back (toArray (hole));
  return object;
}

} // namespace pcl_ops::apps
