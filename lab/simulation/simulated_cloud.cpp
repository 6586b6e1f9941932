// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_cloud.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace pcl_ops::simulation {

namespace {

using Kind = Shape::Kind;

/** Draws a horizontal unit vector. */
Vector3d
drawHorizontal (Random& random)
{
  const double around = random.between (0, 2.0 * pi);
  return {std::cos (around), std::sin (around), 0.0};
}

SurfacePoint
drawOnCone (const Shape& cone, Random& random)
{
  const double radius = cone.half_v;
  const double height = cone.half_u;
  const Vector3d outwards = drawHorizontal (random);
  const Vector3d up = Vector3d::UnitZ();
  // The area between the apex and a height grows with the square of the distance from
  // the apex.
  const double share_from_apex = std::sqrt (random.unit());
  return {cone.center + share_from_apex * (radius * outwards - height * up),
          (height * outwards + radius * up).normalized()};
}

SurfacePoint
drawOnTorus (const Shape& torus, Random& random)
{
  const double ring = torus.half_v; // radius [m]
  const double tube = torus.half_u; // radius [m]
  const Vector3d outwards = drawHorizontal (random);
  const Vector3d up = Vector3d::UnitZ();
  double around_tube = 0.0; // angle from the outer side of the ring [rad]
  // The outer side has more area than the inner one: angles are accepted with a chance
  // in proportion to the circumference of the ring there.
  do
    around_tube = random.between (0, 2.0 * pi);
  while (!random.chance ((ring + tube * std::cos (around_tube)) / (ring + tube)));
  const Vector3d normal =
      std::cos (around_tube) * outwards + std::sin (around_tube) * up;
  return {torus.center + ring * outwards + tube * normal, normal};
}

/** Draws a point of a shape as if its share were 1. */
SurfacePoint
drawOnWholeTurn (const Shape& shape, Random& random)
{
  if (shape.kind == Kind::Cone)
    return drawOnCone (shape, random);
  if (shape.kind == Kind::Torus)
    return drawOnTorus (shape, random);
  if (shape.kind == Kind::Rectangle) {
    const double u = random.between (-1, 1) * shape.half_u;
    const double v = random.between (-1, 1) * shape.half_v;
    return {shape.center + u * shape.u + v * shape.v, shape.normal()};
  }
  if (shape.kind == Kind::Cylinder) {
    const Vector3d across = shape.u.unitOrthogonal();
    const double around = random.between (0, 2.0 * pi);
    const Vector3d normal =
        std::cos (around) * across + std::sin (around) * shape.u.cross (across);
    const double along = random.between (-1, 1) * shape.half_u;
    return {shape.center + along * shape.u + shape.half_v * normal, normal};
  }
  // Slices of a sphere of equal height have equal area (Archimedes).
  const bool is_dome = shape.kind == Kind::Dome;
  // Heights over the center, in radii.
  const double lowest = is_dome ? 1.0 - shape.half_u / shape.half_v : -1;
  const double z = random.between (lowest, 1);
  const double horizontal = std::sqrt (1.0 - z * z);
  const Vector3d normal = horizontal * drawHorizontal (random) + z * Vector3d::UnitZ();
  return {shape.center + shape.half_v * normal, normal};
}

/** Gives points of \ref unknown_surface the label \ref no_surface.
 * \return SimulatedCloud::is_ignored for these points */
std::vector<char>
replaceUnknownSurface (LabeledCloud& cloud)
{
  std::vector<char> is_unknown;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (cloud[i].label != unknown_surface)
      continue;
    cloud[i].label = no_surface;
    is_unknown.resize (cloud.size(), 0);
    is_unknown[i] = 1;
  }
  return is_unknown;
}

} // namespace

SimulatedCloud
labeledBySize (LabeledCloud cloud,
               const std::vector<Plane>& surfaces,
               std::size_t min_points)
{
  SimulatedCloud result{std::move (cloud), {}};
  result.is_ignored = replaceUnknownSurface (result.cloud);
  std::vector<std::size_t> counts (surfaces.size() + 1, 0);
  for (const auto& point : result.cloud)
    ++counts[point.label];
  std::vector<SurfaceId> by_size (surfaces.size());
  std::iota (by_size.begin(), by_size.end(), SurfaceId (1));
  std::stable_sort (by_size.begin(), by_size.end(), [&counts] (auto a, auto b) {
    return counts[a] > counts[b];
  });
  std::vector<std::uint32_t> label_of (surfaces.size() + 1, 0);
  for (const SurfaceId surface : by_size)
    if (counts[surface] >= min_points) {
      result.planes.push_back (surfaces[surface - 1]);
      label_of[surface] = std::uint32_t (result.planes.size());
    }
  for (auto& point : result.cloud)
    point.label = label_of[point.label];
  return result;
}

pcl::PointXYZL
pointAt (const Vector3d& position, SurfaceId surface)
{
  pcl::PointXYZL point;
  point.getVector3fMap() = position.cast<float>();
  point.label = surface;
  return point;
}

LabeledCloud
toSurfaceCloud (const Scan& scan, const Isometry3d& pose, bool organized)
{
  LabeledCloud cloud;
  cloud.reserve (scan.points.size());
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const std::size_t row = i / scan.columns;
    const std::size_t column = i % scan.columns;
    const std::size_t ray =
        organized && scan.column_by_column ? column * scan.rows + row : i;
    if (std::isfinite (scan.points[ray].x()))
      cloud.push_back (pointAt (pose * scan.points[ray], scan.surfaces[ray]));
    else if (organized)
      cloud.push_back (pointAt (Vector3d::Constant (std::nan ("")), no_surface));
  }
  if (organized) {
    cloud.width = std::uint32_t (scan.columns);
    cloud.height = std::uint32_t (scan.rows);
    cloud.is_dense = false;
  }
  cloud.sensor_origin_.head<3>() = pose.translation().cast<float>();
  cloud.sensor_orientation_ = Eigen::Quaterniond (pose.linear()).cast<float>();
  return cloud;
}

SurfacePoint
drawPoint (const Shape& shape, Random& random)
{
  const SurfacePoint whole = drawOnWholeTurn (shape, random);
  if (!(shape.share < 1.0))
    return whole;
  // The shape exists on both sides of +y: the angle about the axis, from +y on, is
  // multiplied by the share.
  const Vector3d local = whole.position - shape.center;
  const double around = std::atan2 (-local.x(), local.y());
  const Eigen::AngleAxisd turn ((shape.share - 1.0) * around, Vector3d::UnitZ());
  return {shape.center + turn * local, turn * whole.normal};
}

LabeledCloud
drawPoints (const Shapes& shapes, std::size_t points, double sigma, Random& random)
{
  LabeledCloud cloud;
  double whole_area = 0.0;  // [m^2]
  double area_so_far = 0.0; // of the shapes that have their points [m^2]
  for (const Shape& shape : shapes)
    whole_area += shape.area();
  if (!(whole_area > 0.0))
    return cloud;
  cloud.reserve (points);
  for (const Shape& shape : shapes) {
    area_so_far += shape.area();
    // Rounding this sum instead of each shape's number makes the total exact.
    const double share = std::min (1.0, area_so_far / whole_area);
    const auto points_so_far = std::size_t (std::llround (share * double (points)));
    while (cloud.size() < points_so_far) {
      const SurfacePoint exact = drawPoint (shape, random);
      const double error = sigma * random.gaussian();
      cloud.push_back (pointAt (exact.position + error * exact.normal, shape.surface));
    }
  }
  return cloud;
}

SimulatedCloud
scanDensely (const Scene& scene, std::size_t points, double noise, Seed seed)
{
  Shapes shapes;
  for (const Body& body : scene.bodies)
    for (const Kind kind : {Kind::Rectangle, Kind::Sphere, Kind::Cylinder})
      for (const Shape& shape : body.shapes)
        if (shape.kind == kind)
          shapes.push_back (shape);
  Random random = randomFor (Purpose::DenseScan, seed);
  LabeledCloud cloud = drawPoints (shapes, points, noise * laser_sigma, random);
  if (!cloud.empty()) {
    Eigen::AlignedBox3d shell;
    for (const Shape& shape : scene.bodies.front().shapes)
      shell.extend (bounding_box (shape));
    cloud.sensor_origin_.head<3>() = shell.center().cast<float>();
  }
  return labeledBySize (cloud, surfacePlanes (scene));
}

} // namespace pcl_ops::simulation
