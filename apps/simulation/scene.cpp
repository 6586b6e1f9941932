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

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double infinite = std::numeric_limits<double>::infinity();
/** \brief Closer hits are the ray's own start [multiples of the direction]. */
constexpr double smallest_distance = 1e-9;

struct Ray {
  const Vector3d& origin;
  const Vector3d& direction;
};

void
extend (Eigen::AlignedBox3d& box, const Rectangle& rectangle)
{
  for (const double u : {-1.0, 1.0})
    for (const double v : {-1.0, 1.0})
      box.extend (rectangle.center + u * rectangle.half_u * rectangle.axis_u +
                  v * rectangle.half_v * rectangle.axis_v);
}

void
extend (Eigen::AlignedBox3d& box, const Sphere& sphere)
{
  box.extend (sphere.center - Vector3d::Constant (sphere.radius));
  box.extend (sphere.center + Vector3d::Constant (sphere.radius));
}

void
extend (Eigen::AlignedBox3d& box, const Cylinder& cylinder)
{
  for (const double side : {-1.0, 1.0})
    extend (box,
            Sphere{cylinder.center + side * cylinder.half_length * cylinder.axis,
                   cylinder.radius});
}

Sphere
boundOf (const Body& body)
{
  Eigen::AlignedBox3d box;
  forEachShape (body, [&box] (const auto& shape) { extend (box, shape); });
  return {box.center(), 0.5 * box.diagonal().norm()};
}

bool
mayMeet (const Sphere& bound, const Ray& ray)
{
  const Vector3d to_center = bound.center - ray.origin;
  const double squared_radius = bound.radius * bound.radius;
  const bool is_behind =
      to_center.dot (ray.direction) < 0.0 && to_center.squaredNorm() > squared_radius;
  return !is_behind && to_center.cross (ray.direction).squaredNorm() <=
                           squared_radius * ray.direction.squaredNorm();
}

double
distanceTo (const Rectangle& rectangle, const Ray& ray)
{
  const Vector3d normal = rectangle.normal();
  const Vector3d to_center = rectangle.center - ray.origin;
  const double distance = normal.dot (to_center) / normal.dot (ray.direction);
  const Vector3d offset = distance * ray.direction - to_center;
  const bool is_inside = std::abs (offset.dot (rectangle.axis_u)) <= rectangle.half_u &&
                         std::abs (offset.dot (rectangle.axis_v)) <= rectangle.half_v;
  return is_inside ? distance : infinite;
}

/** \brief The two roots of a x^2 - 2 b x + c = 0 in ascending order, for a > 0. */
std::optional<std::pair<double, double>>
solveQuadratic (double a, double b, double c)
{
  const double discriminant = b * b - a * c;
  if (discriminant < 0.0 || a <= 0.0)
    return std::nullopt;
  const double root = std::sqrt (discriminant);
  return std::pair ((b - root) / a, (b + root) / a);
}

double
distanceTo (const Sphere& sphere, const Ray& ray)
{
  const Vector3d to_center = sphere.center - ray.origin;
  const auto roots =
      solveQuadratic (ray.direction.squaredNorm(),
                      ray.direction.dot (to_center),
                      to_center.squaredNorm() - sphere.radius * sphere.radius);
  return roots ? roots->first : infinite;
}

/** \brief A closed cylinder is the part of an endless one between two planes. */
double
distanceTo (const Cylinder& cylinder, const Ray& ray)
{
  const Vector3d to_center = cylinder.center - ray.origin;
  const double along = ray.direction.dot (cylinder.axis);
  const double center_along = to_center.dot (cylinder.axis);
  const Vector3d across = ray.direction - along * cylinder.axis;
  const Vector3d center_across = to_center - center_along * cylinder.axis;
  const auto side =
      solveQuadratic (across.squaredNorm(),
                      across.dot (center_across),
                      center_across.squaredNorm() - cylinder.radius * cylinder.radius);
  if (!side)
    return infinite;
  const double end_a = (center_along - cylinder.half_length) / along;
  const double end_b = (center_along + cylinder.half_length) / along;
  const double enter = std::max (side->first, std::min (end_a, end_b));
  const double leave = std::min (side->second, std::max (end_a, end_b));
  return enter <= leave ? enter : infinite;
}

/** \brief Whether they are in one plane but for rounding. */
bool
areCoplanar (const Rectangle& a, const Rectangle& b)
{
  constexpr double rounding = 1e-9;
  const Vector3d normal = a.normal();
  return normal.cross (b.normal()).norm() < rounding &&
         std::abs (normal.dot (b.center - a.center)) < rounding;
}

/** \brief The cube of the given edge that holds a point. */
std::array<std::int64_t, 3>
cellOf (const Vector3d& point, double edge)
{
  std::array<std::int64_t, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell[axis] = std::int64_t (std::floor (point[Eigen::Index (axis)] / edge));
  return cell;
}

Rectangle
moved (Rectangle rectangle, const Isometry3d& pose)
{
  rectangle.center = pose * rectangle.center;
  rectangle.axis_u = pose.linear() * rectangle.axis_u;
  rectangle.axis_v = pose.linear() * rectangle.axis_v;
  return rectangle;
}

void
keep (Scene& scene, const Body& body)
{
  scene.bounds.push_back (boundOf (body));
  scene.bodies.push_back (body);
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
addPart (Body& body, const Body& part, const Isometry3d& pose)
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
addBody (Scene& scene, const Body& body, const Isometry3d& pose)
{
  Body placed;
  placed.surface_count = scene.surface_count;
  addPart (placed, body, pose);
  scene.surface_count = placed.surface_count;
  keep (scene, placed);
}

Scene
divided (const Scene& scene, double edge)
{
  std::map<std::array<std::int64_t, 3>, Body> parts;
  Scene result;
  result.surface_count = scene.surface_count;
  for (const Body& body : scene.bodies) {
    for (const Rectangle& rectangle : body.rectangles) {
      Body alone;
      const bool is_large = std::max (rectangle.half_u, rectangle.half_v) > edge;
      Body& part = is_large ? alone : parts[cellOf (rectangle.center, edge)];
      part.rectangles.push_back (rectangle);
      if (is_large)
        keep (result, alone);
    }
    for (const Sphere& sphere : body.spheres)
      parts[cellOf (sphere.center, edge)].spheres.push_back (sphere);
    for (const Cylinder& cylinder : body.cylinders)
      parts[cellOf (cylinder.center, edge)].cylinders.push_back (cylinder);
  }
  for (const auto& part : parts)
    keep (result, part.second);
  return result;
}

std::vector<Plane>
surfacePlanes (const Scene& scene)
{
  std::vector<Plane> planes (scene.surface_count);
  for (const Body& body : scene.bodies)
    for (const Rectangle& rectangle : body.rectangles)
      if (rectangle.surface != no_surface)
        planes[rectangle.surface - 1] = rectangle.plane();
  return planes;
}

Hit
castRay (const Scene& scene, const Vector3d& origin, const Vector3d& direction)
{
  const Ray ray{origin, direction};
  Hit closest;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (mayMeet (scene.bounds[i], ray))
      forEachShape (scene.bodies[i], [&] (const auto& shape) {
        const double distance = distanceTo (shape, ray);
        if (distance > smallest_distance && distance < closest.distance)
          closest = {distance, surfaceOf (shape)};
      });
  return closest;
}

} // namespace pcl_ops::simulation
