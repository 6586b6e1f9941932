// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "extents.h"

#ifdef PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/concave_hull.h>
#endif

namespace pcl_ops::apps {

const std::vector<std::string> hulls = {"convex", "concave"};

namespace {

PlanarRings
outlineOf (const PlanarPoints& points, [[maybe_unused]] const std::string& hull)
{
#ifdef PCL_OPS_WITH_SURFACE
  if (hull == "concave")
    return concaveOutline (points);
#endif
  return {convexHull (points)};
}

} // namespace

bool
hasHull ([[maybe_unused]] const std::string& hull)
{
#ifdef PCL_OPS_WITH_SURFACE
  return true;
#else
  return hull == "convex";
#endif
}

PlaneExtent
extentInFile (const ShiftedCloud& shifted,
              const PlaneSegment& plane,
              const std::string& hull)
{
  const PlaneFrame in_cloud (plane.centroid - shifted.shift, plane.normal);
  const PlaneFrame in_file (plane.centroid, plane.normal);
  const PlanarPoints points = pointsOnPlane (*shifted.cloud, plane, in_cloud);
  return extentOf (outlineOf (points, hull), points, in_file);
}

std::vector<PlaneExtent>
extentsOf (const ShiftedCloud& shifted,
           const std::vector<PlaneSegment>& planes,
           const std::string& hull)
{
  std::vector<PlaneExtent> extents;
  extents.reserve (planes.size());
  for (const PlaneSegment& plane : planes)
    extents.push_back (extentInFile (shifted, plane, hull));
  return extents;
}

} // namespace pcl_ops::apps
