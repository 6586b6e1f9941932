// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/direction_steps.h"
#include "scene.h"

#include <cmath>

using namespace pcl_ops::internal;

namespace {

/** \brief Adds a position in single precision. */
void
add (const Eigen::Vector3d& position, Coordinates& points)
{
  const pcl::PointXYZ point = toPoint (position);
  points.add (point.x, point.y, point.z);
}

const Eigen::Vector3d lidar_position (1, 2, 1.5); // [m]

/** \brief What a lidar at lidar_position, the middle of a room of 8 m x 8 m x 3 m, sees
 * of the room, with 33 beams one degree apart.
 * \param[in] even_step,odd_step azimuth steps of even and odd beams [degrees] */
Coordinates
roomSeenInSteps (double even_step, double odd_step)
{
  Coordinates points;
  for (int beam = -16; beam <= 16; ++beam) {
    const double elevation = 1_deg * beam;
    const double azimuth_step = (beam % 2 == 0 ? even_step : odd_step) * 1_deg;
    for (double azimuth = 0.0; azimuth < 2.0 * pi; azimuth += azimuth_step) {
      const Eigen::Vector3d ray (std::cos (elevation) * std::cos (azimuth),
                                 std::cos (elevation) * std::sin (azimuth),
                                 std::sin (elevation));
      const Eigen::Array3d half_size (4_m, 4_m, 1.5_m);
      // To the planes of the walls across x and y, and of floor and ceiling.
      const Eigen::Array3d ranges = half_size / ray.array().abs();
      add (lidar_position + ranges.minCoeff() * ray, points);
    }
  }
  return points;
}

/** \brief Points drawn uniformly on a sphere with a radius of 1 m: the steps between
 * their directions from its center differ. Steps longer than half a degree or so are
 * not measured: most of 60,000 directions have one, but fewer than half of 20,000. */
Coordinates
drawnOnSphere (const Eigen::Vector3d& center, int number)
{
  Coordinates points;
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < number; ++i)
    add (center + drawGaussians (generator).normalized(), points);
  return points;
}

} // namespace

TEST (ShareOfCommonSteps, IsNearly1ForALidarWithOneOrTwoSizesOfSteps)
{
  for (const double odd_step : {0.2, 0.3}) // [degrees]
    EXPECT_NEAR (shareOfCommonSteps (roomSeenInSteps (0.2, odd_step), lidar_position),
                 1.0,
                 2_percent)
        << odd_step;
}

TEST (ShareOfCommonSteps, IsLowBesideTheLidarAndForPointsWithoutCommonSteps)
{
  const Eigen::Vector3d beside = lidar_position + Eigen::Vector3d (2, 1, 0);
  EXPECT_LT (shareOfCommonSteps (roomSeenInSteps (0.2, 0.2), beside), 50_percent);
  const double share_of_drawn =
      shareOfCommonSteps (drawnOnSphere (lidar_position, 60000), lidar_position);
  EXPECT_GT (share_of_drawn, 0.0) << "as steps are measured";
  EXPECT_LT (share_of_drawn, 30_percent);
}

TEST (ShareOfCommonSteps, IsZeroForTooFewPoints)
{
  // Points of one beam: each has a neighbor one step beside it. The limit is 100
  // points.
  Coordinates beam = roomSeenInSteps (0.2, 0.2);
  beam.resize (101);
  EXPECT_NEAR (shareOfCommonSteps (beam, lidar_position), 1.0, 2_percent);
  beam.resize (99);
  EXPECT_EQ (shareOfCommonSteps (beam, lidar_position), 0.0);
  EXPECT_EQ (shareOfCommonSteps (Coordinates(), lidar_position), 0.0);
}

TEST (ShareOfCommonSteps, IsZeroForMoreThanFourPointsBehindEachOther)
{
  // Each point of a room, and others in its direction at 2, 3, ... times its distance.
  // The tested numbers of layers are well below and well above four.
  const auto shareOfLayers = [] (int layers) {
    const Coordinates room = roomSeenInSteps (0.2, 0.2);
    Coordinates points;
    for (int layer = 1; layer <= layers; ++layer)
      for (std::size_t i = 0; i < room.size(); ++i)
        add (lidar_position + layer * (room[i] - lidar_position), points);
    return shareOfCommonSteps (points, lidar_position);
  };
  EXPECT_GT (shareOfLayers (3), 90_percent);
  EXPECT_EQ (shareOfLayers (6), 0.0);
}

TEST (SeenByItsSteps, SaysYesOnlyAtTheLidarAndCannotTellOfDirectionsFarApart)
{
  const Coordinates room = roomSeenInSteps (0.2, 0.2);
  EXPECT_EQ (seenByItsSteps (room, lidar_position), StepsSay::Yes);
  EXPECT_NE (seenByItsSteps (room, lidar_position + Eigen::Vector3d (2, 1, 0)),
             StepsSay::Yes);
  EXPECT_EQ (seenByItsSteps (drawnOnSphere (lidar_position, 20000), lidar_position),
             StepsSay::CannotTell);
}
