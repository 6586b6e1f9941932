// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <algorithm>

namespace pcl_ops::simulation {

namespace {

using Kind = Shape::Kind;

constexpr double infinite = std::numeric_limits<double>::infinity();

/** Finds the nearest shape on a ray. Eigen::BVIntersect calls intersectVolume and
 * intersectObject. */
struct RayCast {
  const Vector3d &origin, &direction;
  Hit nearest = {};

  /** \return as Hit::distance; it may be below 0 */
  double
  distanceToRectangle (const Shape& rectangle) const
  {
    const Vector3d normal = rectangle.normal();
    const Vector3d to_center = rectangle.center - origin;
    // Not finite for a ray along the plane: a comparison below is then false.
    const double distance = normal.dot (to_center) / normal.dot (direction);
    const Vector3d from_center = distance * direction - to_center;
    const bool is_inside =
        std::abs (from_center.dot (rectangle.u)) <= rectangle.half_u &&
        std::abs (from_center.dot (rectangle.v)) <= rectangle.half_v;
    return is_inside ? distance : infinite;
  }

  /** A cylinder is the part of an infinite solid cylinder between two planes. A ray
   * exactly along its axis hits nothing.
   * \return as Hit::distance, where the ray enters the solid; below 0 if it begins
   * inside */
  double
  distanceToSphereOrCylinder (const Shape& shape) const
  {
    const bool is_sphere = shape.kind == Kind::Sphere;
    const Vector3d axis = is_sphere ? Vector3d::Zero() : shape.u;
    // Components along the axis, and vectors at right angles to it. A sphere has no
    // axis: the components are 0.
    const Vector3d to_center = shape.center - origin;
    const double direction_along = direction.dot (axis);
    const double center_along = to_center.dot (axis);
    const Vector3d direction_across = direction - direction_along * axis;
    const Vector3d center_across = to_center - center_along * axis;
    // The ray is on the round surface at the distances x with a x^2 - 2 b x + c = 0.
    const double a = direction_across.squaredNorm();
    const double b = direction_across.dot (center_across);
    const double c = center_across.squaredNorm() - shape.half_v * shape.half_v;
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0 || a <= 0.0)
      return infinite;
    const double root = std::sqrt (discriminant);
    double enter = (b - root) / a;
    double leave = (b + root) / a;
    if (!is_sphere) {
      const double one_end = (center_along - shape.half_u) / direction_along;
      const double other_end = (center_along + shape.half_u) / direction_along;
      enter = std::max (enter, std::min (one_end, other_end));
      leave = std::min (leave, std::max (one_end, other_end));
    }
    return enter <= leave ? enter : infinite;
  }

  /** \return whether a nearer hit may be in a box */
  bool
  intersectVolume (const Eigen::AlignedBox3d& box) const
  {
    constexpr double margin = 1e-6; // more than all rounding, also of flat boxes [m]
    const Eigen::Array3d low = (box.min() - origin).array() - margin;
    const Eigen::Array3d high = (box.max() - origin).array() + margin;
    // Distances along the ray to the low and the high sides, one per axis.
    const Eigen::Array3d to_low = low / direction.array();
    const Eigen::Array3d to_high = high / direction.array();
    const double enter = to_low.min (to_high).maxCoeff();
    const double leave = to_low.max (to_high).minCoeff();
    return enter <= leave && leave >= 0.0 && enter <= nearest.distance;
  }

  /** \return false, so that the search goes on to nearer shapes */
  bool
  intersectObject (const Shape& shape)
  {
    // Nearer hits are of the shape on which the ray begins.
    constexpr double smallest_distance = 1e-9;
    const double distance = shape.kind == Kind::Rectangle
                                ? distanceToRectangle (shape)
                                : distanceToSphereOrCylinder (shape);
    if (distance > smallest_distance && distance < nearest.distance)
      nearest = {distance, shape.surface};
    return false;
  }
};

} // namespace

Eigen::AlignedBox3d
bounding_box (const Shape& shape)
{
  Vector3d half_extent = Vector3d::Constant (shape.half_v);
  if (shape.kind == Kind::Rectangle)
    half_extent = shape.half_v * shape.v.cwiseAbs();
  if (shape.kind != Kind::Sphere)
    half_extent += shape.half_u * shape.u.cwiseAbs();
  return {shape.center - half_extent, shape.center + half_extent};
}

Shape
makeRectangle (const Vector3d& center, const Vector3d& edge_u, const Vector3d& edge_v)
{
  Shape rectangle{Kind::Rectangle, center, edge_u.normalized(), edge_v.normalized()};
  rectangle.half_u = 0.5 * edge_u.norm();
  rectangle.half_v = 0.5 * edge_v.norm();
  return rectangle;
}

void
Body::addSurface (const Shape& rectangle)
{
  shapes.push_back (rectangle);
  const double width = 2.0 * std::min (rectangle.half_u, rectangle.half_v);
  shapes.back().surface = width < narrowest_surface ? no_surface : ++surface_count;
}

void
Body::addBox (const Isometry3d& pose, const Vector3d& size, HiddenFace hidden)
{
  Body box;
  box.narrowest_surface = narrowest_surface;
  const Eigen::Matrix3d edges = size.asDiagonal();
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5}) {
      const bool is_bottom = axis == 2 && side < 0.0;
      const bool is_top = axis == 2 && side > 0.0;
      if ((is_bottom && hidden != HiddenFace::None) ||
          (is_top && hidden == HiddenFace::BottomAndTop))
        continue;
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      box.addSurface (
          makeRectangle (side * edges.col (axis), edges.col (u), edges.col (v)));
    }
  addPart (box, pose);
}

void
Body::addWallAround (const WallRange& wall, const WallRange& hole, double depth)
{
  const SurfaceId surface = ++surface_count;
  for (const WallRange& range :
       {WallRange{wall.left, hole.left, wall.bottom, wall.top},
        WallRange{hole.right, wall.right, wall.bottom, wall.top},
        WallRange{hole.left, hole.right, hole.top, wall.top},
        WallRange{hole.left, hole.right, wall.bottom, hole.bottom}}) {
    if (range.left >= range.right || range.bottom >= range.top)
      continue;
    shapes.push_back (range.rectangleAt (0.0));
    shapes.back().surface = surface;
  }
  const Shape back = hole.rectangleAt (-depth);
  const Vector3d middle (back.center.x(), -0.5 * depth, back.center.z());
  const Vector3d inwards = depth * Vector3d::UnitY();
  addSurface (back);
  for (const double x : {hole.left, hole.right})
    addSurface (makeRectangle (
        {x, middle.y(), middle.z()}, inwards, 2.0 * back.half_v * back.v));
  for (const double z : {hole.bottom, hole.top})
    addSurface (makeRectangle (
        {middle.x(), middle.y(), z}, 2.0 * back.half_u * back.u, inwards));
}

void
Body::addPart (const Body& part, const Isometry3d& pose)
{
  for (Shape shape : part.shapes) {
    shape.center = pose * shape.center;
    shape.u = pose.linear() * shape.u;
    shape.v = pose.linear() * shape.v;
    if (shape.surface != no_surface)
      shape.surface += surface_count;
    shapes.push_back (shape);
  }
  surface_count += part.surface_count;
}

void
Body::joinCoplanar()
{
  constexpr double tolerance =
      1e-9; // for rounding of unit vectors, and of positions [m]
  for (Shape& shape : shapes) {
    const auto isCoplanar = [&shape] (const Shape& other) {
      return other.surface != no_surface &&
             other.normal().cross (shape.normal()).norm() < tolerance &&
             std::abs (other.normal().dot (shape.center - other.center)) < tolerance;
    };
    if (shape.surface != no_surface)
      shape.surface = std::find_if (shapes.begin(), shapes.end(), isCoplanar)->surface;
  }
}

std::vector<Plane>
surfacePlanes (const Scene& scene)
{
  std::vector<Plane> planes (scene.surface_count);
  for (const Body& body : scene.bodies)
    for (const Shape& shape : body.shapes)
      if (shape.surface != no_surface)
        planes[shape.surface - 1] = shape.plane();
  return planes;
}

ShapeTree
treeOf (const Scene& scene)
{
  Shapes shapes;
  for (const Body& body : scene.bodies)
    shapes.insert (shapes.end(), body.shapes.begin(), body.shapes.end());
  return {shapes.begin(), shapes.end()};
}

Hit
castRay (const ShapeTree& shapes, const Vector3d& origin, const Vector3d& direction)
{
  RayCast cast{origin, direction};
  Eigen::BVIntersect (shapes, cast);
  return cast.nearest;
}

} // namespace pcl_ops::simulation
