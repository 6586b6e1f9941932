// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "simulated_scenes.h"
#include <simulation/airborne.h>
#include <simulation/scenes.h>
#include <simulation/slabs.h>

using namespace pcl_ops::simulation;

namespace {

/** A scene, how it is simulated, and what its clouds are expected to have. */
struct Kind {
  const char* scene;
  std::optional<double> points; // Simulation::points
  /** Largest rounding error of points; grows with the distance to the origin [m]. */
  double largest_rounding;
  /** Standard deviation of the noise [m], from which the largest distance to a plane
   * follows. If each coordinate has an error of its own: this times the root of 3.
   * 0: the noise is not constant, and the distance has no bound. */
  double sigma;
  std::size_t min_planes;
  const char* sensor = "lidar-16";
  std::size_t min_points = min_points_of_plane;

  SimulatedCloud
  simulated (std::uint32_t seed, double noise = 1.0, bool organized = false) const
  {
    constexpr bool has_raw_depth = false;
    return simulate (
        {scene, seed, {160, 120}, has_raw_depth, sensor, noise, points, organized});
  }
};

const Kind room{"room", std::nullopt, rounding, 0.0, 5};
const std::vector<Kind> kinds = {
    room,
    {"furniture", std::nullopt, rounding, 0.0, 3},
    {"room", 50000, rounding, laser_sigma, 10},
    {"furniture", 5000, rounding, laser_sigma, 3},
    {"shapes", 5000, rounding, shapes_sigma, 2},
    // 36 houses of 6 faces, and the ground: 217 planes.
    {"survey", 90000, 50.0 * rounding, std::sqrt (3.0) * survey_sigma, 217},
    {"street", std::nullopt, 50.0 * rounding, lidar_sigma, 10},
    {"street", std::nullopt, 50.0 * rounding, lidar_sigma, 10, "livox"},
    {"airborne", 20000, 500.0 * rounding, airborne_sigma, 5, "", min_points_of_roof},
    {"street-hills", std::nullopt, 65.0 * rounding, lidar_sigma, 3},
    {"table", std::nullopt, rounding, 0.0, 1},
    {"plaster", 5000, rounding, 0.0, 6},
    {"slabs", 5000, rounding, slabs_sigma, 6},
    {"missing", std::nullopt, rounding, 0.0, 5},
    {"room-kinect", std::nullopt, rounding, 0.0, 5}};

bool
haveSamePoints (const LabeledCloud& a, const LabeledCloud& b)
{
  const auto areSame = [] (const auto& p, const auto& q) {
    return p.getVector3fMap() == q.getVector3fMap() && p.label == q.label;
  };
  return std::equal (a.begin(), a.end(), b.begin(), b.end(), areSame);
}

double
largestDistanceToTruth (const SimulatedCloud& simulated)
{
  double largest = 0.0;
  for (const auto& point : simulated.cloud)
    if (point.label > 0) {
      const auto& plane = simulated.planes.at (point.label - 1);
      const Vector3d position = point.getVector3fMap().cast<double>();
      largest = std::max (largest, std::abs (plane.distance (position)));
    }
  return largest;
}

std::vector<std::size_t>
countsOf (const SimulatedCloud& simulated)
{
  std::vector<std::size_t> counts (simulated.planes.size() + 1, 0);
  for (const auto& point : simulated.cloud)
    ++counts.at (point.label);
  return counts;
}

} // namespace

TEST (Clouds, AreReproducibleSortedBySizeAndNoisyAsAsked)
{
  for (const Kind& kind : kinds) {
    SCOPED_TRACE (kind.scene);
    const SimulatedCloud cloud = kind.simulated (7), exact = kind.simulated (7, 0.0);
    EXPECT_TRUE (haveSamePoints (cloud.cloud, kind.simulated (7).cloud));
    EXPECT_FALSE (haveSamePoints (cloud.cloud, kind.simulated (8).cloud));
    EXPECT_GE (cloud.planes.size(), kind.min_planes);
    const auto counts = countsOf (cloud);
    EXPECT_TRUE (std::is_sorted (counts.rbegin(), counts.rend() - 1));
    EXPECT_GE (counts.back(), kind.min_points);
    EXPECT_LT (largestDistanceToTruth (exact), kind.largest_rounding);
    const double largest = largestDistanceToTruth (kind.simulated (7, 2.0));
    EXPECT_GT (largest, 2.0 * kind.sigma);
    const double bound = 2.0 * largest_gaussian * kind.sigma + kind.largest_rounding;
    EXPECT_TRUE (kind.sigma == 0.0 || largest < bound) << largest;
  }
}

TEST (Clouds, OrganizedOnesKeepEveryPixelAndOnlyAddNan)
{
  constexpr bool organized = true;
  const auto cloud = room.simulated (7, 1.0, organized).cloud;
  EXPECT_EQ (cloud.width, 160u);
  EXPECT_EQ (cloud.height, 120u);
  EXPECT_FALSE (cloud.is_dense);
  const Eigen::Matrix3f to_camera = cloud.sensor_orientation_.conjugate().matrix();
  LabeledCloud finite;
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!std::isfinite (cloud[i].x))
      continue;
    finite.push_back (cloud[i]);
    const Eigen::Vector3f seen = // in the camera's frame, to find the pixel
        to_camera * (cloud[i].getVector3fMap() - cloud.sensor_origin_.head<3>());
    // 160 columns are a quarter of a Kinect's; so is the focal length [px].
    const double column = 0.5 * 159 + 525.0 / 4.0 * seen.x() / seen.z();
    ASSERT_NEAR (column, double (i % 160), 1e-3);
  }
  EXPECT_TRUE (haveSamePoints (finite, room.simulated (7).cloud));
}

TEST (Clouds, DenseScansCoverSurfacesByArea)
{
  Scene scene = wallsAt ({{0, 0, 1}}); // 40 m x 40 m
  Body half;
  half.addSurface (makeRectangle ({0, 0, 0}, {20, 0, 0}, {0, 40, 0}));
  scene.add (half, origin);
  EXPECT_EQ (countsOf (scanDensely (scene, 30000, 1.0, 1)),
             (std::vector<std::size_t>{0, 20000, 10000}));
}
