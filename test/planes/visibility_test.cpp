// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/detect_planes.h>
#include <pcl_ops/visibility.h>

#include <random>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Eigen::Vector3d;
using namespace pcl_ops;
using pcl_ops::detail::occludedFraction;

namespace {

const Vector3d camera (1, 2, 1.5); // its position [m]

/** \brief What the camera sees, which looks along z and has a ray every 0.3 degrees: a
 * wall 4 m ahead, and a board of 1 m x 1 m, 2 m ahead, that hides a part of the wall.
 */
Cloud
wallBehindABoard ()
{
  Cloud cloud;
  for (int row = -100; row < 100; ++row)
    for (int column = -100; column < 100; ++column) {
      const Vector3d ray (std::tan (0.3_deg * column), std::tan (0.3_deg * row), 1.0);
      const Vector3d on_board = 2.0 * ray;
      const bool hits_board =
          std::abs (on_board.x()) < 0.5 && std::abs (on_board.y()) < 0.5;
      cloud.push_back (toPoint (camera + (hits_board ? 2.0 : 4.0) * ray));
    }
  return cloud;
}

/** \brief What a lidar 1.7 m above a street along x sees: 64 beams, 0.6 degrees apart,
 * which turn in steps of 0.2 degrees. On both sides there are houses, 8 m from the
 * lidar, and before them, 4 m from the lidar, hedges 2.5 m high through which every
 * other ray passes.
 * \param[in] lidar its position */
Cloud
streetSeenBy (const Vector3d& lidar)
{
  constexpr double lidar_height = 1.7; // [m]
  constexpr double max_range = 80.0;   // [m]
  constexpr double nothing_hit = 1e9;  // far beyond the range [m]
  Cloud cloud;
  for (int beam = 0; beam < 64; ++beam)
    for (int step = 0; step < 1800; ++step) {
      const double elevation = -26_deg + 0.6_deg * beam;
      const double azimuth = 0.2_deg * step;
      const Vector3d ray (std::cos (elevation) * std::cos (azimuth),
                          std::cos (elevation) * std::sin (azimuth),
                          std::sin (elevation));
      // Above 0, so that a ray along the street has a distance to the houses.
      const double sideways = std::max (1e-9, std::abs (ray.y()));
      const double to_house = 8.0 / sideways;
      const double to_hedge = 4.0 / sideways;
      const double to_ground = ray.z() < 0.0 ? -lidar_height / ray.z() : nothing_hit;
      const bool is_below_top = lidar_height + to_hedge * ray.z() < 2.5;
      const bool hits_hedge = step % 2 == 0 && is_below_top;
      const double range =
          std::min ({to_house, to_ground, hits_hedge ? to_hedge : nothing_hit});
      if (range < max_range)
        cloud.push_back (toPoint (lidar + range * ray));
    }
  return cloud;
}

constexpr int room_steps = 100; // along each edge of a surface
constexpr std::size_t points_of_room_surface = (room_steps + 1) * (room_steps + 1);

/** \brief A floor of 4 m x 4 m, a wall on it and a table in the middle, each a grid of
 * points. The points of the floor come first.
 * \param[in] corner of the floor with the least x and y */
Cloud
roomAt (const Vector3d& corner)
{
  Cloud cloud;
  const auto addSurface =
      [&] (const Vector3d& from, const Vector3d& first, const Vector3d& second) {
        constexpr double share_of_step = 1.0 / room_steps;
        for (int i = 0; i <= room_steps; ++i)
          for (int j = 0; j <= room_steps; ++j)
            cloud.push_back (
                toPoint (corner + from + share_of_step * (i * first + j * second)));
      };
  addSurface ({0, 0, 0}, {4, 0, 0}, {0, 4, 0});
  addSurface ({0, 0, 0}, {4, 0, 0}, {0, 0, 3});
  addSurface ({1, 1, 0.8}, {2, 0, 0}, {0, 2, 0});
  return cloud;
}

/** \brief Detects planes and returns the normals of those that are not vertical.
 * \param[in] sensor its position; zero if it is not known */
std::vector<Vector3d>
normalsOf (const Cloud& cloud, const Vector3d& sensor = Vector3d::Zero())
{
  std::vector<Vector3d> normals;
  for (const PlaneSegment& plane :
       detectPlanes (CloudView (cloud), OrientedPointSamplingParameters(), sensor))
    if (plane.orientation != Orientation::Vertical)
      normals.push_back (plane.normal);
  return normals;
}

/** \brief Fails unless there are so many normals and all of them point up. */
void
expectAllUp (const std::vector<Vector3d>& normals, std::size_t number)
{
  EXPECT_EQ (normals.size(), number);
  for (const Vector3d& normal : normals)
    EXPECT_GT (normal.z(), 0.9);
}

} // namespace

TEST (NormalsWithoutASensor, OfAFloorJustAboveZeroAndJustBelowPointUp)
{
  for (const double height : {0.01, -0.01}) {
    Cloud floor = roomAt ({-1, -1, height});
    floor.resize (points_of_room_surface);
    expectAllUp (normalsOf (floor), 1);
  }
}

TEST (NormalsWithoutASensor, OfARoomAboveZeroPointUp)
{
  expectAllUp (normalsOf (roomAt ({-1.5, -1.5, 0.5})), 2);
}

TEST (NormalsWithoutASensor, OfAMapFarFromZeroPointUp)
{
  expectAllUp (normalsOf (roomAt ({-50000, 20000, 300})), 2);
}

TEST (NormalsWithoutASensor, PointToZeroIfThePlanesWereSeenFromThere)
{
  Cloud ceiling = roomAt ({-2, -2, 1.5}); // of the room its floor, 1.5 m above zero
  ceiling.resize (points_of_room_surface);
  const std::vector<Vector3d> normals = normalsOf (ceiling);
  ASSERT_EQ (normals.size(), 1u);
  EXPECT_LT (normals[0].z(), -0.9);
}

TEST (NormalsWithoutASensor, PointToZeroFromACeilingTwoDegreesAboveIt)
{
  Cloud ceiling = roomAt ({1, -2, 0.1}); // its middle is 3 m from zero and 0.1 m higher
  ceiling.resize (points_of_room_surface);
  const std::vector<Vector3d> normals = normalsOf (ceiling);
  ASSERT_EQ (normals.size(), 1u);
  EXPECT_LT (normals[0].z(), -0.9);
}

TEST (NormalsWithASensor, PointDownToASensorBelowThePlanes)
{
  const std::vector<Vector3d> normals =
      normalsOf (roomAt ({-1.5, -1.5, 0.5}), {0.0, 0.0, -1.0});
  ASSERT_EQ (normals.size(), 2u);
  for (const Vector3d& normal : normals)
    EXPECT_LT (normal.z(), -0.9);
}

TEST (Visibility, IsGivenFromTheCameraAloneInAnyOrderOfPoints)
{
  // From 2 m beside, the board stands before another part of the wall.
  const Vector3d beside = camera + Vector3d (2, 0, 0);
  for (const Vector3d& viewpoint : {camera, beside}) {
    Cloud cloud = wallBehindABoard();
    cloud.sensor_origin_.head<3>() = viewpoint.cast<float>();
    const double hidden = occludedFraction (CloudView (cloud), viewpoint);
    EXPECT_EQ (hidden < 5_percent, viewpoint == camera);
    EXPECT_EQ (isSeenFrom (viewpoint, CloudView (cloud)), viewpoint == camera);
    EXPECT_EQ (isSeenFromItsOrigin (cloud), viewpoint == camera);
    std::reverse (cloud.begin(), cloud.end());
    EXPECT_EQ (occludedFraction (CloudView (cloud), viewpoint), hidden);
  }
}

TEST (Visibility, IsGivenFromALidarThoughAHedgeHidesThings)
{
  const Vector3d lidar (3, 2, 1); // its position [m]
  const Cloud street = streetSeenBy (lidar);
  const CloudView cloud (street);
  EXPECT_GT (occludedFraction (cloud, lidar), 5_percent);
  EXPECT_TRUE (isSeenFrom (lidar, cloud));
  for (const Vector3d& move : {Vector3d (3, 0, 0), Vector3d (0, 3, 0)})
    for (const double sign : {-1.0, 1.0})
      EXPECT_FALSE (isSeenFrom (lidar + sign * move, cloud)) << sign * move.transpose();
  EXPECT_FALSE (isSeenFrom (lidar + Vector3d (0, 9, 0), cloud)) << "behind a house";
  EXPECT_FALSE (isSeenFrom (lidar - Vector3d (0, 0, 3), cloud)) << "below the ground";
}

TEST (Visibility, OfHalfTheRaysOfALidarIsGivenFromTheLidarAlone)
{
  const Vector3d lidar (3, 2, 1);
  const Cloud street = streetSeenBy (lidar);
  Cloud half;
  std::minstd_rand random (1);
  for (const pcl::PointXYZ& point : street)
    if (random() % 2 == 0)
      half.push_back (point);
  EXPECT_TRUE (isSeenFrom (lidar, CloudView (half)));
  EXPECT_FALSE (isSeenFrom (lidar + Vector3d (0, 3, 0), CloudView (half)));
}

TEST (Visibility, IsNotGivenFromFarAwayUnlessTheSensorWasThere)
{
  // From some viewpoints the table hides the floor, from others the wall hides both.
  const Cloud room = roomAt ({0, 0, 0});
  for (const double distance : {10.0, 20.0, 100.0, 2000.0, 5e6})
    for (const Vector3d& direction : {Vector3d (1, 1, 1), {-1, -2, 1}})
      EXPECT_FALSE (isSeenFrom (distance * direction, CloudView (room))) << distance;
  // A floor and a wall behind it, some 100 m from the camera.
  Cloud corner;
  for (int row = -50; row < 50; ++row)
    for (int column = -50; column < 50; ++column) {
      const Vector3d ray (1e-4 * column, 1.0, -0.01 + 1e-4 * row); // down by 0.01 or so
      const double to_floor = -1.0 / ray.z(); // the floor is 1 m below the camera
      const double to_wall = 102.0;
      corner.push_back (toPoint (std::min (to_floor, to_wall) * ray));
    }
  EXPECT_TRUE (isSeenFrom (Vector3d::Zero(), CloudView (corner)));
}

TEST (Visibility, IsGivenForTooFewPoints)
{
  Cloud few;
  EXPECT_TRUE (isSeenFrom (camera, CloudView (few)));
  few.push_back ({1, 2, 3});
  few.push_back ({1, 2, 6});
  EXPECT_TRUE (isSeenFrom (camera, CloudView (few)));
}

TEST (Visibility, IsTheSameFor4000EqualPointsAsFor300)
{
  const Vector3d beside = camera + Vector3d (2, 0, 0);
  const auto hiddenWithEqualPoints = [&] (std::size_t number) {
    Cloud cloud = wallBehindABoard();
    cloud.insert (cloud.end(), number, toPoint (camera));
    return occludedFraction (CloudView (cloud), beside);
  };
  EXPECT_GT (hiddenWithEqualPoints (0), 0.0);
  EXPECT_EQ (hiddenWithEqualPoints (4000), hiddenWithEqualPoints (300));
}

TEST (Visibility, IsGivenForEqualPointsAlone)
{
  Cloud cloud;
  cloud.insert (cloud.end(), 7, pcl::PointXYZ (0.1f, 0.2f, 0.3f));
  EXPECT_TRUE (isSeenFrom (camera, CloudView (cloud)));
}

TEST (Visibility, IsNotGivenFromAPositionThatIsNotFinite)
{
  const pcl::PointCloud<pcl::PointXYZ> cloud;
  EXPECT_FALSE (isSeenFrom ({NAN, 0.0, 0.0}, CloudView (cloud)));
}

TEST (Visibility, LeavesOutWhatIsNotFinite)
{
  Cloud cloud = wallBehindABoard();
  const Vector3d beside = camera + Vector3d (2, 0, 0);
  const double before = occludedFraction (CloudView (cloud), beside);
  ASSERT_GT (before, 0.0);
  cloud.insert (cloud.end(), 1000, pcl::PointXYZ (NAN, NAN, NAN));
  EXPECT_EQ (occludedFraction (CloudView (cloud), beside), before);
  EXPECT_EQ (occludedFraction (CloudView (cloud), Vector3d::Constant (NAN)), 0.0);
}
