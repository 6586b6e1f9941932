// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "depth_camera.h"

#include "poses.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

constexpr int candidate_poses = 24;

/** \brief Looks from near a point of the floor's edge region across the room. */
Eigen::Isometry3d
drawPose (const Room& room, RandomGenerator& generator)
{
  const double wall_distance = 0.4; // [m]
  const Vector3d reach = 0.5 * room.size - Vector3d::Constant (wall_distance);
  const Vector3d eye (drawBetween (generator, -1, 1) * reach.x(),
                      drawBetween (generator, -1, 1) * reach.y(),
                      drawBetween (generator, 1.1, 1.8));
  const Vector3d target (drawBetween (generator, -0.4, 0.4) * reach.x(),
                         drawBetween (generator, -0.4, 0.4) * reach.y(),
                         drawBetween (generator, 0.4, 1.0));
  const Vector3d forward = (target - eye).normalized();
  const Vector3d right = forward.cross (Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d pose = at (eye.x(), eye.y(), eye.z());
  pose.linear() << right, forward.cross (right), forward;
  return turned (room.yaw, Vector3d::UnitZ()) * pose *
         turned (drawAngle (generator, -5, 5), Vector3d::UnitZ());
}

/** \brief Number of surfaces in view, none if something stands before the camera. */
int
countVisibleSurfaces (const Scene& scene, DepthCamera camera)
{
  camera.width = 48;
  camera.height = 36;
  const DepthImage glance = castDepthImage (scene, camera);
  const double closest = *std::min_element (glance.depth.begin(), glance.depth.end());
  if (closest < camera.nearest)
    return 0;
  std::set<SurfaceId> seen (glance.surface.begin(), glance.surface.end());
  seen.erase (no_surface);
  return int (seen.size());
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
  const bool jittered = !offsets.column.empty();
  for (std::size_t i = 0; i < pixels; ++i) {
    const double column =
        double (i % camera.width) + (jittered ? offsets.column[i] : 0.0);
    const double row = double (i / camera.width) + (jittered ? offsets.row[i] : 0.0);
    const Hit hit = castRay (scene,
                             camera.pose.translation(),
                             camera.pose.linear() * camera.ray (column, row));
    image.depth[i] = hit.distance;
    image.surface[i] = hit.surface;
  }
  return image;
}

Eigen::Isometry3d
drawCameraPose (const Room& room, const DepthCamera& camera, std::uint32_t seed)
{
  RandomGenerator generator = makeGenerator (seed, Purpose::CameraPose);
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
