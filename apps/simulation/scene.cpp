// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace pcl_ops::simulation {

namespace {

/** \brief Closer hits are the ray's own start [multiples of the direction]. */
constexpr double smallest_distance = 1e-9;

Eigen::Vector3d
cornerOf (const Rectangle& rectangle, double sign_u, double sign_v)
{
  return rectangle.center + sign_u * rectangle.half_u * rectangle.axis_u +
         sign_v * rectangle.half_v * rectangle.axis_v;
}

void
extendAround (Eigen::AlignedBox3d& box, const Eigen::Vector3d& point, double radius)
{
  box.extend (point - Eigen::Vector3d::Constant (radius));
  box.extend (point + Eigen::Vector3d::Constant (radius));
}

BoundingSphere
boundingSphere (const Body& body)
{
  Eigen::AlignedBox3d box;
  for (const Rectangle& rectangle : body.rectangles)
    for (const double sign_u : {-1.0, 1.0})
      for (const double sign_v : {-1.0, 1.0})
        box.extend (cornerOf (rectangle, sign_u, sign_v));
  for (const Sphere& sphere : body.spheres)
    extendAround (box, sphere.center, sphere.radius);
  for (const Cylinder& cylinder : body.cylinders)
    for (const double sign : {-1.0, 1.0})
      extendAround (box,
                    cylinder.center + sign * cylinder.half_length * cylinder.axis,
                    cylinder.radius);
  return {box.center(), 0.5 * box.diagonal().norm()};
}

bool
rayMayMeet (const BoundingSphere& bound,
            const Eigen::Vector3d& origin,
            const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d to_center = bound.center - origin;
  const double squared_radius = bound.radius * bound.radius;
  const bool is_behind =
      to_center.dot (direction) < 0.0 && to_center.squaredNorm() > squared_radius;
  return !is_behind && to_center.cross (direction).squaredNorm() <=
                           squared_radius * direction.squaredNorm();
}

double
meetRectangle (const Rectangle& rectangle,
               const Eigen::Vector3d& origin,
               const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d normal = rectangle.normal();
  const Eigen::Vector3d to_center = rectangle.center - origin;
  const double distance = normal.dot (to_center) / normal.dot (direction);
  const Eigen::Vector3d offset = distance * direction - to_center;
  const bool inside = std::abs (offset.dot (rectangle.axis_u)) <= rectangle.half_u &&
                      std::abs (offset.dot (rectangle.axis_v)) <= rectangle.half_v;
  return inside ? distance : std::numeric_limits<double>::infinity();
}

/** \brief The two roots of a x^2 - 2 b x + c = 0 in ascending order, for a > 0. */
std::optional<std::pair<double, double>>
solveQuadratic (double a, double b, double c)
{
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || a <= 0.0)
    return std::nullopt;
  const double root = std::sqrt (discriminant);
  return std::make_pair ((b - root) / a, (b + root) / a);
}

double
meetSphere (const Sphere& sphere,
            const Eigen::Vector3d& origin,
            const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d to_center = sphere.center - origin;
  const auto roots =
      solveQuadratic (direction.squaredNorm(),
                      direction.dot (to_center),
                      to_center.squaredNorm() - sphere.radius * sphere.radius);
  return roots ? roots->first : std::numeric_limits<double>::infinity();
}

/** \brief A closed cylinder is the part of an endless one between two planes. */
double
meetCylinder (const Cylinder& cylinder,
              const Eigen::Vector3d& origin,
              const Eigen::Vector3d& direction)
{
  const Eigen::Vector3d to_center = cylinder.center - origin;
  const double along = direction.dot (cylinder.axis);
  const double center_along = to_center.dot (cylinder.axis);
  const Eigen::Vector3d across = direction - along * cylinder.axis;
  const Eigen::Vector3d center_across = to_center - center_along * cylinder.axis;
  const auto side =
      solveQuadratic (across.squaredNorm(),
                      across.dot (center_across),
                      center_across.squaredNorm() - cylinder.radius * cylinder.radius);
  if (!side)
    return std::numeric_limits<double>::infinity();
  const double end_a = (center_along - cylinder.half_length) / along;
  const double end_b = (center_along + cylinder.half_length) / along;
  const double enter = std::max (side->first, std::min (end_a, end_b));
  const double leave = std::min (side->second, std::max (end_a, end_b));
  return enter <= leave ? enter : std::numeric_limits<double>::infinity();
}

void
keepCloser (Hit& closest, double distance, SurfaceId surface)
{
  if (distance > smallest_distance && distance < closest.distance)
    closest = Hit{distance, surface};
}

/** \brief Whether they are so but for rounding. */
bool
areCoplanar (const Rectangle& a, const Rectangle& b)
{
  constexpr double rounding = 1e-9;
  const Eigen::Vector3d normal = a.normal();
  return normal.cross (b.normal()).norm() < rounding &&
         std::abs (normal.dot (b.center - a.center)) < rounding;
}

/** \brief The cube of the given edge that holds a point. */
using Cell = std::array<std::int64_t, 3>;

Cell
cellOf (const Eigen::Vector3d& point, double edge)
{
  Cell cell{};
  for (int axis = 0; axis < 3; ++axis)
    cell[axis] = std::int64_t (std::floor (point[axis] / edge));
  return cell;
}

bool
isHidden (bool is_bottom, HiddenFace hidden)
{
  return hidden == HiddenFace::BottomAndTop ||
         (hidden == HiddenFace::Bottom && is_bottom);
}

Rectangle
moved (Rectangle rectangle, const Eigen::Isometry3d& pose)
{
  rectangle.center = pose * rectangle.center;
  rectangle.axis_u = pose.linear() * rectangle.axis_u;
  rectangle.axis_v = pose.linear() * rectangle.axis_v;
  return rectangle;
}

} // namespace

void
addSurface (Body& body, const Rectangle& rectangle)
{
  body.rectangles.push_back (rectangle);
  const double width = 2.0 * std::min (rectangle.half_u, rectangle.half_v);
  body.rectangles.back().surface =
      width < body.narrowest_surface ? no_surface : ++body.surface_count;
}

void
addBox (Body& body,
        const Eigen::Isometry3d& pose,
        const Eigen::Vector3d& size,
        HiddenFace hidden)
{
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-0.5, 0.5}) {
      if (axis == 2 && isHidden (side < 0.0, hidden))
        continue;
      const int u = (axis + 1) % 3;
      const int v = (axis + 2) % 3;
      const Rectangle face{side * size[axis] * Eigen::Vector3d::Unit (axis),
                           Eigen::Vector3d::Unit (u),
                           Eigen::Vector3d::Unit (v),
                           0.5 * size[u],
                           0.5 * size[v]};
      addSurface (body, moved (face, pose));
    }
}

void
joinCoplanar (Body& body)
{
  std::vector<Rectangle> firsts;
  for (Rectangle& rectangle : body.rectangles) {
    if (rectangle.surface == no_surface)
      continue;
    const auto first =
        std::find_if (firsts.begin(), firsts.end(), [&rectangle] (const auto& other) {
          return areCoplanar (other, rectangle);
        });
    if (first == firsts.end())
      firsts.push_back (rectangle);
    else
      rectangle.surface = first->surface;
  }
}

void
addPart (Body& body, const Body& part, const Eigen::Isometry3d& pose)
{
  for (const Rectangle& rectangle : part.rectangles) {
    body.rectangles.push_back (moved (rectangle, pose));
    if (rectangle.surface != no_surface)
      body.rectangles.back().surface += body.surface_count;
  }
  for (const Sphere& sphere : part.spheres)
    body.spheres.push_back ({pose * sphere.center, sphere.radius});
  for (const Cylinder& cylinder : part.cylinders)
    body.cylinders.push_back ({pose * cylinder.center,
                               pose.linear() * cylinder.axis,
                               cylinder.half_length,
                               cylinder.radius});
  body.surface_count += part.surface_count;
}

void
addBody (Scene& scene, const Body& body, const Eigen::Isometry3d& pose)
{
  Body placed;
  placed.surface_count = scene.surface_count;
  addPart (placed, body, pose);
  scene.surface_count = placed.surface_count;
  scene.bounds.push_back (boundingSphere (placed));
  scene.bodies.push_back (std::move (placed));
}

Scene
divided (const Scene& scene, double edge)
{
  std::map<Cell, Body> parts;
  Scene result;
  result.surface_count = scene.surface_count;
  const auto keep = [&result] (const Body& body) {
    result.bounds.push_back (boundingSphere (body));
    result.bodies.push_back (body);
  };
  for (const Body& body : scene.bodies) {
    for (const Rectangle& rectangle : body.rectangles)
      if (std::max (rectangle.half_u, rectangle.half_v) > edge) {
        Body alone;
        alone.rectangles.push_back (rectangle);
        keep (alone);
      }
      else
        parts[cellOf (rectangle.center, edge)].rectangles.push_back (rectangle);
    for (const Sphere& sphere : body.spheres)
      parts[cellOf (sphere.center, edge)].spheres.push_back (sphere);
    for (const Cylinder& cylinder : body.cylinders)
      parts[cellOf (cylinder.center, edge)].cylinders.push_back (cylinder);
  }
  for (const auto& part : parts)
    keep (part.second);
  return result;
}

std::vector<Plane>
surfacePlanes (const Scene& scene)
{
  std::vector<Plane> planes (scene.surface_count);
  for (const Body& body : scene.bodies)
    for (const Rectangle& rectangle : body.rectangles)
      if (rectangle.surface != no_surface)
        planes[rectangle.surface - 1] =
            planeThrough (rectangle.center, rectangle.normal());
  return planes;
}

Hit
castRay (const Scene& scene,
         const Eigen::Vector3d& origin,
         const Eigen::Vector3d& direction)
{
  Hit closest;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!rayMayMeet (scene.bounds[i], origin, direction))
      continue;
    const Body& body = scene.bodies[i];
    for (const Rectangle& rectangle : body.rectangles)
      keepCloser (
          closest, meetRectangle (rectangle, origin, direction), rectangle.surface);
    for (const Sphere& sphere : body.spheres)
      keepCloser (closest, meetSphere (sphere, origin, direction), no_surface);
    for (const Cylinder& cylinder : body.cylinders)
      keepCloser (closest, meetCylinder (cylinder, origin, direction), no_surface);
  }
  return closest;
}

} // namespace pcl_ops::simulation
