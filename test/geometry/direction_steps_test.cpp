// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/direction_steps.h"
#include "scene.h"

#include <cmath>

using namespace pcl_ops::internal;

namespace {

const Eigen::Vector3d place_of_lidar (1, 2, 1.5);

/** \brief What a lidar sees of a room of 8 m x 8 m x 3 m from its middle: 33 beams,
 * one degree apart, every other one with steps of its own [degrees]. */
Coordinates
roomSeenInSteps (double step, double other_step)
{
  Coordinates points;
  for (int beam = -16; beam <= 16; ++beam) {
    const double elevation = 1_deg * beam;
    const double azimuth_step = (beam % 2 == 0 ? step : other_step) * 1_deg;
    for (double azimuth = 0.0; azimuth < 2.0 * pi; azimuth += azimuth_step) {
      const Eigen::Vector3d ray (std::cos (elevation) * std::cos (azimuth),
                                 std::cos (elevation) * std::sin (azimuth),
                                 std::sin (elevation));
      const Eigen::Array3d walls = Eigen::Array3d (4, 4, 1.5) / ray.array().abs();
      const pcl::PointXYZ point = toPoint (place_of_lidar + walls.minCoeff() * ray);
      points.add (point.x, point.y, point.z);
    }
  }
  return points;
}

Coordinates
drawnOnABall (const Eigen::Vector3d& place, int number)
{
  Coordinates points;
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < number; ++i) {
    const pcl::PointXYZ point = toPoint (place + drawNormals (generator).normalized());
    points.add (point.x, point.y, point.z);
  }
  return points;
}

} // namespace

TEST (ShareOfCommonSteps, IsOneOfALidarWithStepsOfOneOrTwoKinds)
{
  for (const double other_step : {0.2, 0.3})
    EXPECT_NEAR (shareOfCommonSteps (roomSeenInSteps (0.2, other_step), place_of_lidar),
                 1.0,
                 2_percent)
        << other_step;
}

TEST (ShareOfCommonSteps, IsLowAwayFromTheLidarAndOfPointsAnywhere)
{
  const Eigen::Vector3d beside = place_of_lidar + Eigen::Vector3d (2, 1, 0);
  EXPECT_LT (shareOfCommonSteps (roomSeenInSteps (0.2, 0.2), beside), 50_percent);
  EXPECT_LT (shareOfCommonSteps (drawnOnABall (place_of_lidar, 20000), place_of_lidar),
             30_percent);
}

TEST (ShareOfCommonSteps, IsNoneOfPointsTooFewToTell)
{
  EXPECT_EQ (shareOfCommonSteps (drawnOnABall (place_of_lidar, 50), place_of_lidar),
             0.0);
  EXPECT_EQ (shareOfCommonSteps (Coordinates(), place_of_lidar), 0.0);
}

TEST (ShareOfCommonSteps, IsNoneOfMoreThanFourPointsBehindEachOther)
{
  const auto share = [] (int layers) {
    const Coordinates room = roomSeenInSteps (0.2, 0.2);
    Coordinates points;
    for (int layer = 1; layer <= layers; ++layer)
      for (std::size_t i = 0; i < room.size(); ++i) {
        const Eigen::Vector3d point =
            place_of_lidar + layer * (room[i] - place_of_lidar);
        points.add (static_cast<float> (point.x()),
                    static_cast<float> (point.y()),
                    static_cast<float> (point.z()));
      }
    return shareOfCommonSteps (points, place_of_lidar);
  };
  EXPECT_GT (share (3), 90_percent);
  EXPECT_EQ (share (6), 0.0);
}

TEST (SeenByItsSteps, IsALidarAtItsPlaceAloneAndNothingAnywhere)
{
  const Coordinates room = roomSeenInSteps (0.2, 0.2);
  EXPECT_EQ (seenByItsSteps (room, place_of_lidar), StepsSay::Yes);
  EXPECT_NE (seenByItsSteps (room, place_of_lidar + Eigen::Vector3d (2, 1, 0)),
             StepsSay::Yes);
  EXPECT_EQ (seenByItsSteps (drawnOnABall (place_of_lidar, 20000), place_of_lidar),
             StepsSay::CannotTell);
}
