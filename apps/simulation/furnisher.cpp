// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "furnisher.h"

#include "poses.h"
#include "room_shell.h"

namespace pcl_ops::simulation {

namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/** \brief Room to walk between two pieces [m]. */
constexpr double clearance = 0.1;
constexpr int placement_attempts = 30;

/** \brief The part of the floor, parallel to the walls, that a placed piece covers. */
AlignedBox2d
coveredFloor (const Vector2d& footprint, const Eigen::Isometry3d& pose)
{
  AlignedBox2d covered;
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      const Vector3d corner (x * footprint.x(), y * footprint.y(), 0.0);
      covered.extend (Vector2d ((pose * corner).head<2>()));
    }
  return covered;
}

} // namespace

Furnisher::Furnisher (Room& room,
                      std::uint32_t walls,
                      internal::RandomGenerator& generator)
: room_ (room), walls_ (walls), generator_ (generator)
{}

void
Furnisher::placeAtWall (const Furniture& furniture)
{
  const Vector2d& footprint = furniture.footprint;
  place (furniture, [&] {
    const int wall = int (internal::drawBelow (generator_, walls_));
    const double reach = 0.5 * (wallLength (room_.size, wall) - footprint.x());
    const double along = drawBetween (generator_, -reach, reach);
    const double gap = drawBetween (generator_, 0.005, 0.05);
    return poseAtWall (room_.size, wall, along, gap + 0.5 * footprint.y());
  });
}

void
Furnisher::placeAnywhere (const Furniture& furniture)
{
  place (furniture, [&] {
    const double x = drawBetween (generator_, -0.5, 0.5) * room_.size.x();
    const double y = drawBetween (generator_, -0.5, 0.5) * room_.size.y();
    return at (x, y, 0.0) * turned (drawAngle (generator_, 0, 360), Vector3d::UnitZ());
  });
}

template <typename DrawPose>
void
Furnisher::place (const Furniture& furniture, DrawPose drawPose)
{
  for (int attempt = 0; attempt < placement_attempts; ++attempt) {
    const Eigen::Isometry3d pose = drawPose();
    const AlignedBox2d covered = coveredFloor (furniture.footprint, pose);
    if (!isFree (covered))
      continue;
    covered_.push_back (covered);
    addBody (room_.scene, furniture.body, turned (room_.yaw, Vector3d::UnitZ()) * pose);
    return;
  }
}

bool
Furnisher::isFree (const AlignedBox2d& covered) const
{
  const Vector2d half = 0.5 * room_.size.head<2>();
  if (!AlignedBox2d (-half, half).contains (covered))
    return false;
  for (const AlignedBox2d& other : covered_)
    if (other.exteriorDistance (covered) < clearance)
      return false;
  return true;
}

} // namespace pcl_ops::simulation
