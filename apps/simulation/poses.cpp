// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "poses.h"

#include "sensors.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl_ops::simulation {

namespace {

constexpr double whole_turn = 2.0 * pi;

/** \brief Of a camera that looks in a level direction of length 1. */
Isometry3d
upright (const Vector3d& eye, const Vector3d& level)
{
  Isometry3d pose = at (eye);
  pose.linear() << level.cross (Vector3d::UnitZ()), -Vector3d::UnitZ(), level;
  return pose;
}

/** \brief From anywhere in the room over its middle, somewhat downwards. */
Isometry3d
drawPose (const Room& room, Random& random)
{
  constexpr double wall_distance = 0.4; // [m]
  Vector3d reach = 0.5 * room.size - Vector3d::Constant (wall_distance);
  reach.z() = 1.0;
  const Vector3d eye = random.inBox ({-1, -1, 1.1}, {1, 1, 1.8}).cwiseProduct (reach);
  Vector3d target = random.inBox ({-0.4, -0.4, 0}, {0.4, 0.4, 0}).cwiseProduct (reach);
  target.z() = eye.z();
  const double roll = random.angle (-4, 4), pitch = random.angle (-20, -5);
  return turnZ (room.yaw) * upright (eye, (target - eye).normalized()) * turnX (pitch) *
         turnZ (roll);
}

/** \brief A path around the middle of a room. */
struct Path {
  double start, turn; // where the walk begins, and how far it leads, signed [rad]
  double radius;      // of the way from the middle to the walls
  double height;      // [m]
  double pitch;       // downwards [rad]
};

/** \param[in] share of the way */
Isometry3d
poseOn (const Path& path, const Room& room, double share)
{
  constexpr double steps = 16.0, rise = 0.03; // rise [m]
  constexpr double sway = 2.0 * pi / 180.0;
  const double angle = path.start + share * path.turn;
  const double step = share * steps * whole_turn;
  const Vector3d eye (0.5 * path.radius * room.size.x() * std::cos (angle),
                      0.5 * path.radius * room.size.y() * std::sin (angle),
                      path.height + rise * std::sin (step));
  const Vector3d level = Vector3d (-eye.x(), -eye.y(), 0.0).normalized();
  return turnZ (room.yaw) * upright (eye, level) * turnX (-path.pitch) *
         turnZ (sway * std::sin (0.5 * step));
}

Poses
posesOn (const Path& path, const Room& room, std::size_t frames)
{
  Poses poses;
  for (std::size_t i = 0; i < frames; ++i)
    poses.push_back (poseOn (
        path, room, double (i) / double (std::max<std::size_t> (frames - 1, 1))));
  return poses;
}

/** \brief The first of the candidates that \p rate gives the most. */
template <typename Draw, typename Rate>
auto
bestOf (int candidates, const Draw& draw, const Rate& rate)
{
  auto best = draw();
  for (int i = 1, best_rate = rate (best); i < candidates; ++i) {
    const auto candidate = draw();
    if (const int its_rate = rate (candidate); its_rate > best_rate) {
      best = candidate;
      best_rate = its_rate;
    }
  }
  return best;
}

/** \brief A small motion of so many degrees and centimeters as root mean square. */
Isometry3d
drawError (Random& random, double size)
{
  const double of_each_axis = size / std::sqrt (3.0);
  const auto draw = [&] (double unit) {
    Vector3d drawn;
    for (double& number : drawn)
      number = unit * of_each_axis * random.gaussian();
    return drawn;
  };
  const Vector3d rotation = draw (pi / 180.0);
  Isometry3d error = at (draw (0.01));
  if (rotation.norm() > 0.0)
    error.rotate (Eigen::AngleAxisd (rotation.norm(), rotation.normalized()));
  return error;
}

} // namespace

int
countVisibleSurfaces (const Scene& scene, const Isometry3d& pose)
{
  constexpr int pixels_of_surface = 5;
  constexpr double closest_object = 0.7; // along the camera's axis [m]
  const DepthImage glance = castDepthImage (scene, {48, 36}, pose);
  if (glance.depth.minCoeff() < closest_object)
    return 0;
  std::map<SurfaceId, int> pixels;
  for (const SurfaceId surface : glance.surface)
    ++pixels[surface];
  int visible = 0;
  for (const auto& [surface, count] : pixels)
    visible += surface != no_surface && count >= pixels_of_surface;
  return visible;
}

Isometry3d
drawCameraPose (const Room& room, std::uint32_t seed)
{
  Random random = randomFor (Purpose::CameraPose, seed);
  return bestOf (
      32,
      [&] { return drawPose (room, random); },
      [&] (const Isometry3d& pose) { return countVisibleSurfaces (room.scene, pose); });
}

Poses
drawWalk (const Room& room, std::size_t frames, std::uint32_t seed)
{
  constexpr std::size_t glances = 12; // a walk is judged by so many of its frames
  Random random = randomFor (Purpose::Walk, seed);
  const Path best = bestOf (
      8,
      [&] () -> Path { // in the order of their names
        return {random.between (0.0, whole_turn),
                (random.chance (0.5) ? 0.75 : -0.75) * whole_turn,
                random.between (0.35, 0.6),
                random.between (1.4, 1.8),
                random.angle (8, 18)};
      },
      [&] (const Path& path) {
        int fewest = std::numeric_limits<int>::max();
        for (const Isometry3d& pose : posesOn (path, room, glances))
          fewest = std::min (fewest, countVisibleSurfaces (room.scene, pose));
        return fewest;
      });
  return posesOn (best, room, frames);
}

Poses
measured (const Poses& poses, const PoseErrors& errors, std::uint32_t seed)
{
  Random random = randomFor (Purpose::PoseError, seed);
  Poses result;
  Isometry3d drifting = Isometry3d::Identity();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    drifting = i == 0 ? poses[0]
                      : drifting * poses[i - 1].inverse() * poses[i] *
                            drawError (random, errors.drift);
    result.push_back (drifting * drawError (random, errors.each));
  }
  return result;
}

} // namespace pcl_ops::simulation
