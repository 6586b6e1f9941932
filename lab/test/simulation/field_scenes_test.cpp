// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/airborne.h>
#include <simulation/hilly_street.h>
#include <simulation/missing.h>
#include <simulation/plaster.h>
#include <simulation/scenes.h>
#include <simulation/slabs.h>
#include <simulation/table.h>

#include <set>

using namespace pcl_ops::simulation;

namespace {

Vector3d
positionOf (const pcl::PointXYZL& point)
{
  return point.getVector3fMap().cast<double>();
}

/** \param[in] amplitude of hills; 0: flat ground [m] */
AirborneSite
siteOf (double amplitude)
{
  AirborneSite site = makeAirborne (1);
  site.relief.amplitude = amplitude;
  return site;
}

/** Returns the rms distance of points to their least squares plane [m]. */
double
rmsOf (const LabeledCloud& cloud)
{
  pcl_ops::Moments moments;
  for (const auto& point : cloud)
    moments.add (point.x, point.y, point.z);
  return std::sqrt (pcl_ops::fitPlane (moments)->variances[0]);
}

} // namespace

TEST (Relief, IsAsHighAsItsAmplitudeAQuarterOfAWaveFromZero)
{
  Relief relief;
  relief.amplitude = 2.0;
  EXPECT_NEAR (relief.height (0.25 * relief.wave_length, 0.0), 2.0, 1e-9);
  EXPECT_NEAR (relief.height (0.0, 0.0), 0.0, 1e-9);
}

TEST (Airborne, RoofsErrInHeightByTheNoise)
{
  const SimulatedCloud survey = scanAirborne (makeAirborne (2), 50'000, 1.0, 7);
  double squares = 0.0, points = 0.0;
  for (const auto& point : survey.cloud) {
    if (point.label == 0)
      continue;
    const pcl_ops::Plane& roof = survey.planes[point.label - 1];
    const double error = roof.distance (positionOf (point)) / roof.normal.z();
    EXPECT_LT (std::abs (error), largest_gaussian * airborne_sigma + 1e-3);
    squares += error * error;
    points += 1.0;
  }
  EXPECT_GT (points, 1000);
  EXPECT_NEAR (std::sqrt (squares / points), 0.05, 0.002);
}

TEST (Airborne, HillyGroundIsIgnoredAndWoodsAreOnNoPlane)
{
  const AirborneSite site = siteOf (8.0);
  const SimulatedCloud survey = scanAirborne (site, 50'000, 0.0, 7);
  ASSERT_EQ (survey.is_ignored.size(), survey.cloud.size());
  std::size_t ignored = 0, leaves = 0;
  for (std::size_t i = 0; i < survey.cloud.size(); ++i) {
    const Vector3d point = positionOf (survey.cloud[i]);
    const double above = point.z() - site.relief.height (point.x(), point.y());
    const bool is_leaf = above > 1.9 && above < 16.1;
    EXPECT_TRUE (survey.is_ignored[i] != 0 ? std::abs (above) < 1e-4
                                           : is_leaf || survey.cloud[i].label > 0);
    ignored += survey.is_ignored[i] != 0;
    leaves += is_leaf;
  }
  EXPECT_GT (ignored, 500u);
  EXPECT_GT (leaves, 500u);
}

TEST (Airborne, FlatGroundIsAPlane)
{
  const SimulatedCloud survey = scanAirborne (siteOf (0.0), 50'000, 0.0, 7);
  EXPECT_TRUE (survey.is_ignored.empty());
  EXPECT_TRUE (survey.planes.at (0).normal.isApprox (Vector3d::UnitZ()));
  EXPECT_EQ (survey.planes[0].offset, 0.0);
}

TEST (Airborne, SeedsSpreadExtentDensityAndRelief)
{
  std::set<double> widths, densities, amplitudes;
  for (Seed seed = 1; seed <= 60; ++seed) {
    const AirborneSite site = makeAirborne (seed);
    EXPECT_LE (site.density * site.width() * site.width(), 600'001);
    widths.insert (site.width());
    densities.insert (site.density);
    amplitudes.insert (site.relief.amplitude);
  }
  const auto expectRange = [] (const std::set<double>& drawn, double low, double high) {
    EXPECT_GE (*drawn.begin(), low);
    EXPECT_LE (*drawn.rbegin(), high);
    EXPECT_LT (*drawn.begin(), low + 0.1 * (high - low));
    EXPECT_GT (*drawn.rbegin(), high - 0.2 * (high - low));
  };
  expectRange (widths, 90, 990); // 2 to 22 lots of 45 m
  expectRange (densities, 0.4, 4);
  expectRange (amplitudes, 0, 8);
}

TEST (HillyStreet, ReadingsAreOnTheGroundOrAWallOrInABush)
{
  const HillyStreet street = makeHillyStreet (2);
  const std::vector<pcl_ops::Plane> walls = surfacePlanes (street.walls);
  constexpr bool organized = false;
  const SimulatedCloud scan = scanHillyStreet (street, 0.0, 2, organized);
  ASSERT_EQ (scan.is_ignored.size(), scan.cloud.size());
  std::size_t of_ground = 0, of_walls = 0, of_bushes = 0;
  for (std::size_t i = 0; i < scan.cloud.size(); ++i) {
    const Vector3d point = positionOf (scan.cloud[i]);
    const double above = point.z() - street.groundHeight (point.x(), point.y());
    if (scan.is_ignored[i] != 0) {
      ++of_ground;
      EXPECT_NEAR (above, 0.0, 0.01);
      continue;
    }
    EXPECT_GT (above, -0.01);
    const auto isOn = [&point] (const pcl_ops::Plane& wall) {
      return std::abs (wall.distance (point)) < 100.0 * rounding;
    };
    const auto isIn = [&point] (const Bush& bush) {
      return (point - bush.center).norm() < bush.radius + 100.0 * rounding;
    };
    const bool is_wall = std::any_of (walls.begin(), walls.end(), isOn);
    of_walls += is_wall;
    of_bushes += !is_wall;
    EXPECT_TRUE (is_wall ||
                 std::any_of (street.bushes.begin(), street.bushes.end(), isIn));
  }
  for (const std::size_t readings : {of_ground, of_walls, of_bushes})
    EXPECT_GT (readings, 1000u);
}

TEST (Lidar, BeamsOfLidar64LevelAreDenseNearTheHorizontal)
{
  const Lidar lidar = lidarOf ("lidar-64-level");
  constexpr struct {
    int beam;
    double elevation; // [degree]
  } rows[] = {{0, 15.0},
              {1, 3.0},
              {2, 2.0},
              {50, -6.0},
              {51, -6.5},
              {57, -13.0},
              {58, -14.0},
              {63, -25.0}};
  for (const auto& row : rows)
    EXPECT_DOUBLE_EQ (lidar.elevation (row.beam), row.elevation) << row.beam;
  for (int beam = 1; beam < lidar.beams; ++beam)
    EXPECT_LT (lidar.elevation (beam), lidar.elevation (beam - 1));
}

TEST (Table, IsOnePlaneOfTheNoiseAndTheBend)
{
  const DepthCamera camera{180, 112};
  const Table bent;
  Table flat;
  flat.bend = 0.0;
  constexpr bool organized = true;
  const SimulatedCloud table = scanTable (bent, camera, 1.0, 1, organized);
  EXPECT_EQ (table.cloud.width, 180u);
  for (const auto& point : table.cloud)
    ASSERT_EQ (point.label, 1u);
  // Errors of depth count by the cosine of the tilt, 0.71: of the bend 1.3 mm rms (0.32
  // times 4 mm), of noise 0.6 mm, of steps of 1.8 mm 0.5 mm.
  EXPECT_NEAR (rmsOf (table.cloud), 0.0011, 0.0001);
  const SimulatedCloud flat_table = scanTable (flat, camera, 1.0, 1, organized);
  EXPECT_NEAR (rmsOf (flat_table.cloud), 0.0006, 0.0001);
}

TEST (Plaster, WavesByItsAmplitude)
{
  const Plaster plaster{0.015, 20'000};
  const SimulatedCloud room = scanPlaster (plaster, 1.0, 7);
  ASSERT_EQ (room.planes.size(), 6u);
  std::vector<double> largest (6, 0.0);
  for (const auto& point : room.cloud) {
    double& distance = largest[point.label - 1];
    const pcl_ops::Plane& side = room.planes[point.label - 1];
    distance = std::max (distance, std::abs (side.distance (positionOf (point))));
  }
  for (const double distance : largest)
    EXPECT_NEAR (distance, 0.015, 5.0 * plaster_sigma);
}

TEST (Plaster, HasTheNumberOfPointsOfItsSeedAndAnAmplitudeInRange)
{
  const std::size_t sizes[] = {
      20'000, 50'000, 100'000, 200'000, 500'000, 1'000'000, 2'000'000, 20'000};
  for (Seed seed = 1; seed <= 8; ++seed) {
    const Plaster plaster = drawPlaster (seed);
    EXPECT_EQ (plaster.points, sizes[seed - 1]);
    EXPECT_GE (plaster.amplitude, 0.002);
    EXPECT_LE (plaster.amplitude, 0.015);
  }
}

TEST (Slabs, HaveTwoSidesAFewCentimetersApart)
{
  for (Seed seed = 1; seed <= 20; ++seed) {
    const Scene scene = makeSlabs (seed);
    ASSERT_EQ (scene.surface_count, 6u);
    const Shapes& shapes = scene.bodies.front().shapes;
    for (const std::size_t front : {0, 2}) {
      const Shape &one = shapes[front], &other = shapes[front + 1];
      const double thickness = std::abs (one.plane().distance (other.center));
      EXPECT_GE (thickness, 0.04);
      EXPECT_LE (thickness, 0.15);
      EXPECT_NEAR (one.normal().cross (other.normal()).norm(), 0.0, 1e-12);
      EXPECT_NE (one.surface, other.surface);
    }
  }
}

TEST (Slabs, AreSeenFromBothSidesAlike)
{
  const SimulatedCloud slabs = scanSlabs (makeSlabs (1), 10'000, 1.0, 1);
  ASSERT_EQ (slabs.planes.size(), 6u);
  std::vector<double> points (6, 0.0);
  for (const auto& point : slabs.cloud)
    points.at (point.label - 1) += 1.0;
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector3d &one = slabs.planes[i - 1].normal, &other = slabs.planes[i].normal;
    pairs += one.cross (other).norm() < 1e-9 && points[i] > 0.99 * points[i - 1];
  }
  EXPECT_GE (pairs, 2u);
}

TEST (Missing, SharesAreThoseOfTheSeedToAPoint)
{
  const double shares[] = {0.01, 0.03, 0.05, 0.1, 0.2, 0.4, 0.5, 0.01};
  for (Seed seed = 1; seed <= 8; ++seed) {
    const SimulatedCloud room = simulate ({"missing", seed, {160, 120}});
    const auto zeros =
        std::count_if (room.cloud.begin(), room.cloud.end(), [] (const auto& point) {
          return point.getVector3fMap().isZero (0.0f) && point.label == 0;
        });
    EXPECT_EQ (double (zeros),
               std::round (shares[seed - 1] * double (room.cloud.size())));
    EXPECT_TRUE (room.cloud.sensor_origin_.head<3>().isZero (0.0f));
  }
}

TEST (Missing, OtherReadingsAreThoseOfTheRoomInTheCamerasFrame)
{
  const SimulatedCloud missing = simulate ({"missing", 6, {160, 120}});
  const SimulatedCloud room = simulate ({"room", 6, {160, 120}});
  ASSERT_EQ (missing.cloud.size(), room.cloud.size());
  const Eigen::Quaternionf& camera = room.cloud.sensor_orientation_;
  const Eigen::Vector3f eye = room.cloud.sensor_origin_.head<3>();
  for (std::size_t i = 0; i < room.cloud.size(); ++i) {
    const Eigen::Vector3f point = missing.cloud[i].getVector3fMap();
    const Eigen::Vector3f in_room = camera * point + eye;
    EXPECT_TRUE (point.isZero (0.0f) ||
                 (in_room - room.cloud[i].getVector3fMap()).norm() < 5.0 * rounding);
  }
  EXPECT_LT ((camera * missing.up.cast<float>() - Eigen::Vector3f::UnitZ()).norm(),
             1e-6);
}

TEST (RoomKinect, DepthsLieOnStepsOfSomeCentimetersAtFiveMeters)
{
  for (Seed seed = 1; seed <= 5; ++seed) {
    const double quantization = drawQuantization (seed); // z^2 over the step at z
    EXPECT_GE (5.0 * 5.0 / quantization, 0.065);
    EXPECT_LE (5.0 * 5.0 / quantization, 0.08);
    std::set<float> depths;
    for (const auto& point : simulate ({"room-kinect", seed, {160, 120}}).cloud) {
      const double number = quantization / point.z;
      EXPECT_NEAR (number, std::round (number), 1e-3);
      depths.insert (point.z);
    }
    EXPECT_GT (depths.size(), 50u);
  }
}
