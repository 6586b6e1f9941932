// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/depth_levels.h"
#include "place_scene.h"

#include <cmath>

using namespace pcl_ops::internal;

namespace {

/** \brief A wall of some 2 m x 2 m, 4.8 m to 5.6 m from a camera that looks along z. */
const Surface slanted_wall = {{-1, -1, 4.8}, {2, 0, 0.6}, {0, 2, 0.2}};

/** \brief Points of the slanted wall whose depths z are rounded to a step [m].
 * \param[in] jitter width of the interval from which an error of each rounded depth is
 * drawn [m] */
Coordinates
slantedWallInSteps (double step, double jitter = 0.0)
{
  Coordinates points = drawnOn ({slanted_wall}, 1_cm, 1_mm);
  RandomGenerator generator (seedOfTest());
  for (float& z : points.z)
    z = static_cast<float> (step * std::round (z / step) +
                            jitter * (drawUnit (generator) - 0.5));
  return points;
}

/** \brief The z axis after a turn about the y axis: a point (x, y, z) goes to
 * (0.8 x - 0.6 z, y, 0.6 x + 0.8 z). */
const Eigen::Vector3d turned_z (-0.6, 0, 0.8);

/** \brief The levels that findDepthLevels sees; without steps if it sees none. */
DepthLevels
levelsOf (const Coordinates& points)
{
  return findDepthLevels (points, PointTree (points));
}

} // namespace

TEST (DepthLevels, AreAsFarApartAsTheSteps)
{
  const DepthLevels levels = levelsOf (slantedWallInSteps (4_cm));
  ASSERT_FALSE (levels.step.empty());
  EXPECT_NEAR (std::abs (levels.direction.z()), 1.0, 1e-6);
  for (const float step : levels.step)
    ASSERT_NEAR (step, 4_cm, 1_mm);
}

TEST (DepthLevels, AreSeenInAnyDirection)
{
  Coordinates points = slantedWallInSteps (4_cm);
  for (std::size_t i = 0; i < points.size(); ++i) { // as in turned_z
    const float x = points.x[i];
    points.x[i] = 0.8f * x - 0.6f * points.z[i];
    points.z[i] = 0.6f * x + 0.8f * points.z[i];
  }
  const DepthLevels levels = levelsOf (points);
  ASSERT_FALSE (levels.step.empty());
  EXPECT_NEAR (std::abs (levels.direction.dot (turned_z)), 1.0, 1e-4);
}

TEST (DepthLevels, MayBeRoundedOrJittered)
{
  constexpr double rounding = 2e-5; // as after a turn to another frame and back [m]
  for (const double jitter : {rounding, 1_mm}) {
    const DepthLevels levels = levelsOf (slantedWallInSteps (4_cm, jitter));
    ASSERT_FALSE (levels.step.empty()) << jitter;
    EXPECT_NEAR (levels.step[0], 4_cm, 2_mm);
  }
}

TEST (DepthLevels, MayBeRoundedInATurnedFrame)
{
  Coordinates points = drawnOn ({slanted_wall}, 5_mm, 0.0);
  const auto roundedToMillimeters = [] (double value) {
    return static_cast<float> (1_mm * std::round (value / 1_mm));
  };
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double x = points.x[i]; // as in turned_z
    const double z = 1_cm * std::round (points.z[i] / 1_cm);
    points.x[i] = roundedToMillimeters (0.8 * x - 0.6 * z);
    points.y[i] = roundedToMillimeters (points.y[i]);
    points.z[i] = roundedToMillimeters (0.6 * x + 0.8 * z);
  }
  const DepthLevels levels = levelsOf (points);
  ASSERT_FALSE (levels.step.empty());
  EXPECT_NEAR (std::abs (levels.direction.dot (turned_z)), 1.0, 1e-6);
  std::size_t steps_near_1_cm = 0;
  for (const float step : levels.step)
    steps_near_1_cm += std::abs (step - 1_cm) < 1_mm ? 1 : 0;
  EXPECT_GT (steps_near_1_cm, points.size() * 9 / 10);
}

TEST (DepthLevels, MayBeRoundedInAnyFrameThoughTheyAre8MetersLong)
{
  // A wall of 2 m x 8 m. At an end of its levels a direction that is off by a tenth of
  // a degree is off by 7 mm, the step from one level to the next.
  Coordinates points = drawnOn ({{{-1, -4, 4.8}, {2, 0, 0.2}, {0, 8, 0.2}}}, 12_mm, 0);
  for (float& z : points.z)
    z = static_cast<float> (7_mm * std::round (z / 7_mm));
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 6; ++i) {
    const Eigen::Quaterniond turn = drawTurn (generator);
    Coordinates rounded;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Eigen::Vector3d point = turn * points[k];
      const auto coordinate = [&point] (int axis) {
        return static_cast<float> (1_mm * std::round (point[axis] / 1_mm));
      };
      rounded.add (coordinate (0), coordinate (1), coordinate (2));
    }
    const DepthLevels levels = levelsOf (rounded);
    ASSERT_FALSE (levels.step.empty()) << turn.coeffs().transpose();
    EXPECT_NEAR (levels.step[0], 7_mm, 1_mm);
  }
}

TEST (DepthLevels, AreNotSeenInNoiseFacesFewPointsGridsOrAFloor)
{
  // White noise.
  EXPECT_TRUE (levelsOf (drawnOn ({slanted_wall}, 1_cm, 1_cm)).step.empty());
  // Three faces of a box without noise: three directions.
  EXPECT_TRUE (levelsOf (drawnOn ({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
                                   {{0, 0, 0}, {2, 0, 0}, {0, 0, 2}},
                                   {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}}},
                                  3_cm,
                                  0.0))
                   .step.empty());
  // 1600 points, all of one plane.
  EXPECT_TRUE (levelsOf (drawnOn ({square_of_ground}, 5_cm, 0.0)).step.empty());
  // A wall, and a floor at three heights, both on grids of 4 cm. The rows of the grids
  // are no levels of depth.
  Coordinates grid;
  for (int i = 0; i < 2500; ++i) {
    const float first = 4e-2f * static_cast<float> (i / 50);
    const float second = 4e-2f * static_cast<float> (i % 50);
    grid.add (first, second, 2e-3f * static_cast<float> (i % 3));
    grid.add (3.0f, first, second);
  }
  EXPECT_TRUE (levelsOf (grid).step.empty());
  // A floor, and a few points of a table leg above it, each at a height of its own.
  Coordinates floor = drawnOn ({square_of_ground}, 3_cm, 0.0);
  for (int i = 0; i < 20; ++i)
    floor.add (1.0f, 1.0f, 0.03f * static_cast<float> (i * i));
  EXPECT_TRUE (levelsOf (floor).step.empty());
}

TEST (DepthLevels, AreNotSearchedInFewerThan2000Points)
{
  // Exact rectangles on twelve levels 1 m apart.
  const auto areSeen = [] (double width) {
    std::vector<Surface> levels;
    for (int level = 0; level < 12; ++level)
      levels.push_back ({{0, 0, level * 1_m}, {width, 0, 0}, {0, 1, 0}});
    return !levelsOf (drawnOn (levels, 10_cm, 0.0)).step.empty();
  };
  EXPECT_FALSE (areSeen (1.6)) << "160 points on each level, 1920 in all";
  EXPECT_TRUE (areSeen (1.8)) << "180 points on each level, 2160 in all";
}

TEST (DepthLevels, FarBehindAllOthersGetNoLargerStepThanTheOthers)
{
  Coordinates points = slantedWallInSteps (4_cm);
  // All points of a wall 1.4 m and more behind the slanted one are on one level.
  const Coordinates far_wall =
      drawnOn ({{{-1, -1, 7.0}, {2, 0, 0}, {0, 2, 0}}}, 2_cm, 0.0);
  for (std::size_t i = 0; i < far_wall.size(); ++i)
    points.add (far_wall.x[i], far_wall.y[i], far_wall.z[i]);
  const DepthLevels levels = levelsOf (points);
  ASSERT_FALSE (levels.step.empty());
  for (const float step : levels.step)
    ASSERT_NEAR (step, 4_cm, 1_mm);
}
