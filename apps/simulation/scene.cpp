// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl_ops::simulation {

namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using Kind = Shape::Kind;

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Ray {
  const Vector3d &origin, &direction;
};

double
distanceToRectangle (const Shape& rectangle, const Ray& ray)
{
  const Vector3d normal = rectangle.normal();
  const Vector3d to_center = rectangle.center - ray.origin;
  const double distance = normal.dot (to_center) / normal.dot (ray.direction);
  const Vector3d offset = distance * ray.direction - to_center;
  const bool is_inside = std::abs (offset.dot (rectangle.u)) <= rectangle.half_u &&
                         std::abs (offset.dot (rectangle.v)) <= rectangle.half_v;
  return is_inside ? distance : infinite;
}

/** \brief The roots of a x^2 - 2 b x + c = 0 in ascending order, for a > 0. */
std::optional<std::pair<double, double>>
solveQuadratic (double a, double b, double c)
{
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || a <= 0.0)
    return std::nullopt;
  const double root = std::sqrt (discriminant);
  return std::pair ((b - root) / a, (b + root) / a);
}

/** \brief A closed cylinder is the part of an endless one between two planes. */
double
distanceToRound (const Shape& shape, const Ray& ray)
{
  const bool is_sphere = shape.kind == Kind::Sphere;
  const Vector3d axis = is_sphere ? Vector3d::Zero() : shape.u;
  const Vector3d to_center = shape.center - ray.origin;
  const double along = ray.direction.dot (axis), center_along = to_center.dot (axis);
  const Vector3d across = ray.direction - along * axis;
  const Vector3d center_across = to_center - center_along * axis;
  const auto side =
      solveQuadratic (across.squaredNorm(),
                      across.dot (center_across),
                      center_across.squaredNorm() - shape.half_v * shape.half_v);
  if (!side)
    return infinite;
  if (is_sphere)
    return side->first;
  const double end_a = (center_along - shape.half_u) / along;
  const double end_b = (center_along + shape.half_u) / along;
  const double enter = std::max (side->first, std::min (end_a, end_b));
  const double leave = std::min (side->second, std::max (end_a, end_b));
  return enter <= leave ? enter : infinite;
}

Shape
moved (Shape shape, const Isometry3d& pose)
{
  shape.center = pose * shape.center;
  shape.u = pose.linear() * shape.u;
  shape.v = pose.linear() * shape.v;
  return shape;
}

/** \brief What Eigen::BVIntersect asks on its way to the nearest shape. */
struct RayCast {
  Ray ray;
  Hit closest = {};

  /** \brief Whether something nearer may be in a box. */
  bool
  intersectVolume (const Eigen::AlignedBox3d& box) const
  {
    constexpr double margin = 1e-6; // more than all rounding, also of flat boxes [m]
    const Eigen::Array3d low = (box.min() - ray.origin).array() - margin;
    const Eigen::Array3d high = (box.max() - ray.origin).array() + margin;
    const Eigen::Array3d one = low / ray.direction.array();
    const Eigen::Array3d other = high / ray.direction.array();
    const double enter = one.min (other).maxCoeff(), leave = one.max (other).minCoeff();
    return enter <= leave && leave >= 0.0 && enter <= closest.distance;
  }

  /** \return false: nearer ones may come */
  bool
  intersectObject (const Shape& shape)
  {
    constexpr double smallest_distance = 1e-9; // closer hits are the ray's own start
    const double distance = shape.kind == Kind::Rectangle
                                ? distanceToRectangle (shape, ray)
                                : distanceToRound (shape, ray);
    if (distance > smallest_distance && distance < closest.distance)
      closest = {distance, shape.surface};
    return false;
  }
};

} // namespace

double
Shape::area() const
{
  return kind == Kind::Sphere     ? 4.0 * pi * half_v * half_v
         : kind == Kind::Cylinder ? 4.0 * pi * half_v * half_u
                                  : 4.0 * half_u * half_v;
}

Eigen::AlignedBox3d
bounding_box (const Shape& shape)
{
  Eigen::AlignedBox3d box;
  for (const double side : {-1.0, 1.0})
    if (shape.kind == Kind::Rectangle)
      for (const double v : {-1.0, 1.0})
        box.extend (shape.center + side * shape.half_u * shape.u +
                    v * shape.half_v * shape.v);
    else {
      const bool is_sphere = shape.kind == Kind::Sphere;
      const Vector3d end =
          shape.center + (is_sphere ? 0.0 : side * shape.half_u) * shape.u;
      box.extend (end - Vector3d::Constant (shape.half_v));
      box.extend (end + Vector3d::Constant (shape.half_v));
    }
  return box;
}

Shape
rectangleAlong (int u, int v, const Vector3d& center, double half_u, double half_v)
{
  return {
      Kind::Rectangle, center, Vector3d::Unit (u), Vector3d::Unit (v), half_u, half_v};
}

void
addSurface (Body& body, const Shape& rectangle)
{
  body.shapes.push_back (rectangle);
  const double width = 2.0 * std::min (rectangle.half_u, rectangle.half_v);
  body.shapes.back().surface =
      width < body.narrowest_surface ? no_surface : ++body.surface_count;
}

void
addSphere (Body& body, const Vector3d& center, double radius)
{
  body.shapes.push_back (
      {Kind::Sphere, center, Vector3d::UnitX(), Vector3d::UnitY(), radius, radius});
}

void
addCylinder (Body& body,
             const Vector3d& center,
             const Vector3d& axis,
             double half_length,
             double radius)
{
  body.shapes.push_back (
      {Kind::Cylinder, center, axis, Vector3d::UnitY(), half_length, radius});
}

void
addPole (Body& body, const Vector3d& foot, double height, double radius)
{
  const Vector3d up = Vector3d::UnitZ();
  addCylinder (body, foot + 0.5 * height * up, up, 0.5 * height, radius);
}

void
addBox (Body& body, const Isometry3d& pose, const Vector3d& size, HiddenFace hidden)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5}) {
      const bool is_hidden =
          side < 0.0 ? hidden != HiddenFace::None : hidden == HiddenFace::BottomAndTop;
      if (axis == 2 && is_hidden)
        continue;
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      const Vector3d center = side * size[axis] * Vector3d::Unit (axis);
      addSurface (
          body,
          moved (rectangleAlong (u, v, center, 0.5 * size[u], 0.5 * size[v]), pose));
    }
}

void
addWallAround (Body& body, const WallRange& wall, const WallRange& hole, double depth)
{
  const SurfaceId surface = ++body.surface_count;
  for (const WallRange& range :
       {WallRange{wall.left, hole.left, wall.bottom, wall.top},
        WallRange{hole.right, wall.right, wall.bottom, wall.top},
        WallRange{hole.left, hole.right, hole.top, wall.top},
        WallRange{hole.left, hole.right, wall.bottom, hole.bottom}}) {
    body.shapes.push_back (range.at (0.0));
    body.shapes.back().surface = surface;
    if (!(body.shapes.back().area() > 0.0))
      body.shapes.pop_back();
  }
  const Shape back = hole.at (-depth);
  const Vector3d& middle = back.center;
  addSurface (body, back);
  const double half = 0.5 * depth;
  for (const double x : {hole.left, hole.right})
    addSurface (body, rectangleAlong (1, 2, {x, -half, middle.z()}, half, back.half_v));
  for (const double z : {hole.bottom, hole.top})
    addSurface (body, rectangleAlong (0, 1, {middle.x(), -half, z}, back.half_u, half));
}

void
joinCoplanar (Body& body)
{
  constexpr double rounding = 1e-9;
  std::vector<Shape> firsts;
  for (Shape& shape : body.shapes) {
    if (shape.surface == no_surface)
      continue;
    const Vector3d normal = shape.normal();
    const auto first =
        std::find_if (firsts.begin(), firsts.end(), [&] (const Shape& a) {
          return a.normal().cross (normal).norm() < rounding &&
                 std::abs (a.normal().dot (shape.center - a.center)) < rounding;
        });
    if (first == firsts.end())
      firsts.push_back (shape);
    else
      shape.surface = first->surface;
  }
}

void
addPart (Body& body, const Body& part, const Isometry3d& pose)
{
  for (const Shape& shape : part.shapes) {
    body.shapes.push_back (moved (shape, pose));
    if (shape.surface != no_surface)
      body.shapes.back().surface += body.surface_count;
  }
  body.surface_count += part.surface_count;
}

void
addBody (Scene& scene, const Body& body, const Isometry3d& pose)
{
  Body placed;
  placed.surface_count = scene.surface_count;
  addPart (placed, body, pose);
  scene.surface_count = placed.surface_count;
  scene.bodies.push_back (placed);
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
  std::vector<Shape> shapes;
  for (const Body& body : scene.bodies)
    shapes.insert (shapes.end(), body.shapes.begin(), body.shapes.end());
  return {shapes.begin(), shapes.end()};
}

Hit
castRay (const ShapeTree& shapes, const Vector3d& origin, const Vector3d& direction)
{
  RayCast cast{{origin, direction}};
  Eigen::BVIntersect (shapes, cast);
  return cast.closest;
}

} // namespace pcl_ops::simulation
