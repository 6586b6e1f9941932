// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "walk.h"

#include "poses.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

namespace {

using Eigen::Vector3d;

constexpr int candidate_walks = 8;
/** \brief A walk is judged by so many of its frames. */
constexpr std::size_t glances = 12;
constexpr double whole_turn = 2.0 * pi;

/** \brief A path around the middle of a room. */
struct Path {
  /** \brief Where on it the walk begins, and how far it leads, signed [rad]. */
  double start, turn;
  /** \brief Of the way from the middle to the walls. */
  double radius;
  double height; // [m]
  /** \brief Downwards [rad]. */
  double pitch;
};

Path
drawPath (internal::RandomGenerator& generator)
{
  Path path{};
  path.start = drawBetween (generator, 0.0, whole_turn);
  path.turn = (drawChance (generator, 0.5) ? 0.75 : -0.75) * whole_turn;
  path.radius = drawBetween (generator, 0.35, 0.6);
  path.height = drawBetween (generator, 1.4, 1.8);
  path.pitch = drawAngle (generator, 8, 18);
  return path;
}

/** \param[in] share of the way */
Eigen::Isometry3d
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
  Eigen::Isometry3d pose = at (eye.x(), eye.y(), eye.z());
  pose.linear() << level.cross (Vector3d::UnitZ()), -Vector3d::UnitZ(), level;
  return turned (room.yaw, Vector3d::UnitZ()) * pose *
         turned (-path.pitch, Vector3d::UnitX()) *
         turned (sway * std::sin (0.5 * step), Vector3d::UnitZ());
}

Poses
posesOn (const Path& path, const Room& room, std::size_t frames)
{
  Poses poses;
  for (std::size_t i = 0; i < frames; ++i)
    poses.push_back (
        poseOn (path, room, frames == 1 ? 0.0 : double (i) / double (frames - 1)));
  return poses;
}

/** \brief The fewest surfaces that are well in view anywhere on the way. */
int
fewestSurfaces (const Path& path, const Room& room, DepthCamera camera)
{
  int fewest = std::numeric_limits<int>::max();
  for (const Eigen::Isometry3d& pose : posesOn (path, room, glances)) {
    camera.pose = pose;
    fewest = std::min (fewest, countVisibleSurfaces (room.scene, camera));
  }
  return fewest;
}

/** \brief A small motion of so many degrees and centimetres as root mean square. */
Eigen::Isometry3d
drawError (internal::RandomGenerator& generator, double size)
{
  const double of_each_axis = size / std::sqrt (3.0);
  const auto draw = [&] (double unit) {
    Vector3d drawn;
    for (double& number : drawn)
      number = unit * of_each_axis * drawGaussian (generator);
    return drawn;
  };
  const Vector3d rotation = draw (pi / 180.0), shift = draw (0.01);
  const double angle = rotation.norm();
  Eigen::Isometry3d error = at (shift.x(), shift.y(), shift.z());
  if (angle > 0.0)
    error.rotate (Eigen::AngleAxisd (angle, rotation / angle));
  return error;
}

} // namespace

Poses
drawWalk (const Room& room,
          const DepthCamera& camera,
          std::size_t frames,
          std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::Walk);
  Path best{};
  int most_surfaces = -1;
  for (int i = 0; i < candidate_walks; ++i) {
    const Path path = drawPath (generator);
    const int surfaces = fewestSurfaces (path, room, camera);
    if (surfaces > most_surfaces) {
      most_surfaces = surfaces;
      best = path;
    }
  }
  return posesOn (best, room, frames);
}

Poses
measured (const Poses& poses, const PoseErrors& errors, std::uint32_t seed)
{
  internal::RandomGenerator generator = makeGenerator (seed, Purpose::PoseError);
  Poses result;
  Eigen::Isometry3d drifting = Eigen::Isometry3d::Identity();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    drifting = i == 0 ? poses[0]
                      : drifting * poses[i - 1].inverse() * poses[i] *
                            drawError (generator, errors.drift);
    result.push_back (drifting * drawError (generator, errors.each));
  }
  return result;
}

} // namespace pcl_ops::simulation
