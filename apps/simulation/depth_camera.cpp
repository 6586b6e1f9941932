// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "depth_camera.h"

#include "poses.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

constexpr int candidate_poses = 32;

/** \brief A pose is judged by a small image [px]. */
constexpr int glance_width = 48;
constexpr int glance_height = 36;
constexpr int glance_pixels_of_surface = 5;
/** \brief Along the camera's axis [m]. */
constexpr double closest_object = 0.7;

/** \brief A surface whose depth differs more between a pixel's ray and the ray beside
 * it, relative to the depth, is seen edge-on. */
constexpr double largest_slope = 0.1;

/** \brief From anywhere in the room over its middle, somewhat downwards. */
Eigen::Isometry3d
drawPose (const Room& room, internal::RandomGenerator& generator)
{
  const double wall_distance = 0.4; // [m]
  const Vector3d reach = 0.5 * room.size - Vector3d::Constant (wall_distance);
  const Vector3d eye = drawInBox (generator, {-1, -1, 1.1}, {1, 1, 1.8})
                           .cwiseProduct (Vector3d (reach.x(), reach.y(), 1.0));
  Vector3d target = drawInBox (generator, {-0.4, -0.4, 0.0}, {0.4, 0.4, 0.0});
  target = target.cwiseProduct (reach) + eye.z() * Vector3d::UnitZ();
  const Vector3d level = (target - eye).normalized();
  const Vector3d right = level.cross (Vector3d::UnitZ());
  Eigen::Isometry3d pose = at (eye.x(), eye.y(), eye.z());
  pose.linear() << right, -Vector3d::UnitZ(), level;
  const double roll = drawAngle (generator, -4, 4);
  const double pitch = drawAngle (generator, -20, -5);
  return turned (room.yaw, Vector3d::UnitZ()) * pose *
         turned (pitch, Vector3d::UnitX()) * turned (roll, Vector3d::UnitZ());
}

Vector3d
rayOfPixel (const DepthCamera& camera,
            std::size_t pixel,
            double column_offset,
            double row_offset)
{
  const std::size_t row = pixel / camera.width;
  const std::size_t column = pixel % camera.width;
  return camera.pose.linear() *
         camera.ray (double (column) + column_offset, double (row) + row_offset);
}

/** \brief Where a pixel's own ray meets the plane that a ray beside it has hit. */
double
depthOnSurface (const Hit& hit,
                const std::vector<Plane>& planes,
                const Vector3d& eye,
                const Vector3d& ray)
{
  if (hit.surface == no_surface)
    return hit.distance;
  const Plane& plane = planes[hit.surface - 1];
  const double depth = -plane.distance (eye) / plane.normal.dot (ray);
  const bool is_grazing =
      !(std::abs (depth - hit.distance) < largest_slope * hit.distance);
  return is_grazing ? hit.distance : depth;
}

} // namespace

DepthImage
castDepthImage (const Scene& scene,
                const DepthCamera& camera,
                const PixelOffsets& offsets)
{
  const std::size_t pixels = std::size_t (camera.width) * camera.height;
  DepthImage image{camera.width,
                   camera.height,
                   std::vector<double> (pixels),
                   std::vector<SurfaceId> (pixels)};
  const std::vector<Plane> planes = surfacePlanes (scene);
  const Vector3d eye = camera.pose.translation();
  for (std::size_t i = 0; i < pixels; ++i) {
    const double column = offsets.column.empty() ? 0.0 : offsets.column[i];
    const double row = offsets.row.empty() ? 0.0 : offsets.row[i];
    const Hit hit = castRay (scene, eye, rayOfPixel (camera, i, column, row));
    image.depth[i] =
        depthOnSurface (hit, planes, eye, rayOfPixel (camera, i, 0.0, 0.0));
    image.surface[i] = hit.surface;
  }
  return image;
}

int
countVisibleSurfaces (const Scene& scene, DepthCamera camera)
{
  camera.width = glance_width;
  camera.height = glance_height;
  const DepthImage glance = castDepthImage (scene, camera);
  const double closest = *std::min_element (glance.depth.begin(), glance.depth.end());
  if (closest < closest_object)
    return 0;
  std::map<SurfaceId, int> pixels;
  for (const SurfaceId surface : glance.surface)
    ++pixels[surface];
  pixels.erase (no_surface);
  return int (std::count_if (pixels.begin(), pixels.end(), [] (const auto& surface) {
    return surface.second >= glance_pixels_of_surface;
  }));
}

Eigen::Isometry3d
drawCameraPose (const Room& room, const DepthCamera& camera, std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::CameraPose);
  Eigen::Isometry3d best = Eigen::Isometry3d::Identity();
  int most_surfaces = -1;
  for (int i = 0; i < candidate_poses; ++i) {
    DepthCamera candidate = camera;
    candidate.pose = drawPose (room, generator);
    const int surfaces = countVisibleSurfaces (room.scene, candidate);
    if (surfaces > most_surfaces) {
      most_surfaces = surfaces;
      best = candidate.pose;
    }
  }
  return best;
}

} // namespace pcl_ops::simulation
