// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/plane_merging.h>

using namespace pcl_ops::internal;
using namespace pcl_ops;

namespace {

constexpr double max_angle = 7_deg;
constexpr double max_distance = 5_cm;

/** \brief MergingParameters::enabled. */
constexpr bool enabled = true;
/** \brief The parameters of the paper, which has no noise factor. */
constexpr MergingParameters as_in_paper{enabled, max_angle, max_distance, {}};

/** \brief A level square, or a tilted one.
 * \param[in] tilt about the y axis [rad]
 * \param[in] edge [m] */
Surface
square (const Eigen::Vector3d& center, double tilt = 0.0, double edge = 1_m)
{
  const Eigen::Vector3d first (edge * std::cos (tilt), 0, -edge * std::sin (tilt));
  const Eigen::Vector3d second (0, edge, 0);
  return {center - 0.5 * first - 0.5 * second, first, second};
}

/** \brief Moments of 10 x 10 points of a square.
 * \param[in] noise points lie by turns this far above the square and below it [m] */
Moments
noisySquare (const Eigen::Vector3d& center,
             double noise,
             double edge = 1_m,
             double tilt = 0.0)
{
  return momentsOf (square (center, tilt, edge), 10, 10, noise);
}

/** \brief Moments of steps x steps points of a square without noise. */
Moments
exactSquare (const Eigen::Vector3d& center, double tilt = 0.0, int steps = 10)
{
  return momentsOf (square (center, tilt), steps, steps);
}

/** \brief Parameters by which the noise alone limits the distance. */
MergingParameters
byNoise (double noise_factor)
{
  constexpr double no_distance = 0.0; // no plane is nearer
  return {enabled, max_angle, no_distance, noise_factor};
}

/** \brief The plane of a square of 1 m about a center. */
PlaneFit
fitOf (const Eigen::Vector3d& center, double tilt = 0.0)
{
  return fitPlane (exactSquare (center, tilt)).value();
}

} // namespace

TEST (AreCoplanar, DependsOnTheAngleAndBothDistancesNotOnTheSignOfTheNormals)
{
  const PlaneFit floor = fitOf ({0, 0, 0});
  const struct {
    const char* plane;
    PlaneFit fit;
    bool are_coplanar;
  } rows[] = {
      {"another part of the floor", fitOf ({5, 3, 0}), true},
      {"one through its centroid, tilted by 6 degrees", fitOf ({0, 0, 0}, 6_deg), true},
      {"one through its centroid, tilted by 8 degrees",
       fitOf ({0, 0, 0}, 8_deg),
       false},
      {"one 20 cm up after 10 m, which passes through the floor's centroid",
       fitOf ({10, 0, 0.2}, -std::atan (0.02)),
       false}};
  const PlaneFit& through_centroid_of_floor = rows[3].fit;
  EXPECT_LT (std::abs (through_centroid_of_floor.plane.distance (floor.centroid)),
             1_mm);
  for (const auto& [plane, fit, are_coplanar] : rows) {
    PlaneFit flipped = fit;
    flipped.plane = {-fit.plane.normal, -fit.plane.offset};
    EXPECT_EQ (pcl_ops::detail::areCoplanar (floor, fit, max_angle, max_distance),
               are_coplanar)
        << plane;
    EXPECT_EQ (pcl_ops::detail::areCoplanar (fit, floor, max_angle, max_distance),
               are_coplanar)
        << plane;
    EXPECT_EQ (pcl_ops::detail::areCoplanar (floor, flipped, max_angle, max_distance),
               are_coplanar)
        << plane;
  }
}

TEST (Merge, ByNoiseJoinsWhatTheNoiseExplainsWithinTheAngle)
{
  // Points lie 3 cm above and below each square. Their rms distance to the plane of the
  // other square, 5 cm away, is sqrt (5^2 + 3^2) = 5.8 cm, 1.94 times the noise.
  const Moments noisy = noisySquare ({0, 0, 0}, 3_cm);
  const Moments above = noisySquare ({2, 0, 5_cm}, 3_cm);
  const Moments tilted = noisySquare ({0.5, 0, 0}, 3_cm, 30_cm, 8_deg);
  // Of two noises the larger one counts, up to 6 times the smaller one: 6 cm for thick
  // and clean, and 9 cm for thick and rough, which are 15 cm apart.
  const Moments thick = noisySquare ({0, 0, 0}, 9_cm);
  const Moments clean = noisySquare ({2, 0, 15_cm}, 1_cm);
  const Moments rough = noisySquare ({2, 0, 15_cm}, 2_cm);
  const Moments flat = exactSquare ({0, 0, 0});
  const Moments beside = exactSquare ({5, 3, 0});
  const struct {
    const char* name;
    Moments first, second;
    double noise_factor;
    std::size_t merged_planes;
  } rows[] = {{"farther apart than 1.8 noises", noisy, above, 1.8, 2},
              {"nearer than 2.1 noises", noisy, above, 2.1, 1},
              {"steeper than the largest angle", noisy, tilted, 2.0, 2},
              {"farther apart than 2 * 6 cm", thick, clean, 2.0, 2},
              {"nearer than 2 * 9 cm", thick, rough, 2.0, 1},
              {"on one plane, without noise", flat, beside, 1.5, 1}};
  for (const auto& row : rows)
    EXPECT_EQ (
        mergePlanes ({row.first, row.second}, byNoise (row.noise_factor)).fits.size(),
        row.merged_planes)
        << row.name;
}

TEST (Merge, ByNoiseJoinsASmallPlaneThatMissesTheCentroidOfALargeOne)
{
  // A small piece 10 m from a wall: noise tilts it by 2 degrees, 35 cm over 10 m.
  const Moments wall = noisySquare ({0, 0, 0}, 1_cm, 8_m);
  const Moments piece = noisySquare ({10, 0, 0}, 1_cm, 30_cm, 2_deg);
  EXPECT_FALSE (pcl_ops::detail::areCoplanar (
      *fitPlane (wall), *fitPlane (piece), max_angle, max_distance));
  EXPECT_EQ (mergePlanes ({wall, piece}, byNoise (1.5)).fits.size(), 1u);
}

TEST (Merge, FitsOnePlaneToAllPoints)
{
  const Moments first = exactSquare ({0, 0, 0});
  Moments all = exactSquare ({0.5, 1, 2_cm}, 3_deg);
  const MergedPlanes merged = mergePlanes ({first, all}, as_in_paper);
  all += first;
  ASSERT_EQ (merged.fits.size(), 1u);
  EXPECT_EQ (merged.moments[0].count, 200.0);
  EXPECT_LT (angleBetween (merged.fits[0].plane.normal, fitPlane (all)->plane.normal),
             1e-12);
}

TEST (Merge, JoinsAChainOfPlanesWhoseEndsAloneWouldNotPass)
{
  // The angle between the first and the last plane is 8 degrees, which is too much;
  // between neighbors it is 5 and 3 degrees.
  const std::vector<Moments> bend{exactSquare ({0, 0, 0}, 0_deg, 20),
                                  exactSquare ({0, 0, 0}, 5_deg, 19),
                                  exactSquare ({0, 0, 0}, 8_deg, 5)};
  EXPECT_EQ (mergePlanes (bend, as_in_paper).merged_into, (Labels{0, 0, 0}));
}

TEST (Merge, GoesOnUntilNoPairPassesTheTest)
{
  RandomGenerator generator (seedOfTest());
  std::vector<Moments> planes;
  for (int i = 0; i < 60; ++i)
    planes.push_back (
        exactSquare ({5 * drawUnit (generator), 0, drawGaussian (generator)},
                     10_deg * drawGaussian (generator)));
  const MergedPlanes merged = mergePlanes (planes, as_in_paper);
  EXPECT_LT (merged.fits.size(), planes.size());
  ASSERT_GT (merged.fits.size(), 1u);
  double points = 0.0;
  for (const Moments& moments : merged.moments)
    points += moments.count;
  EXPECT_EQ (points, 100.0 * planes.size());
  for (std::size_t i = 0; i < merged.fits.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE (pcl_ops::detail::areCoplanar (
          merged.fits[i], merged.fits[j], max_angle, max_distance));
}

TEST (Merge, LeavesPlanesAloneWhereDisabled)
{
  MergingParameters off = as_in_paper;
  off.enabled = false;
  const MergedPlanes merged = mergePlanes (
      {exactSquare ({0, 0, 0}, 0_deg, 5), exactSquare ({5, 3, 0}, 0_deg, 9)}, off);
  EXPECT_EQ (merged.fits.size(), 2u);
  EXPECT_EQ (merged.merged_into, (Labels{1, 0}))
      << "but they are sorted by falling size";
}

TEST (Merge, SortsPlanesByFallingSizeAndDropsPointsThatSpanNoPlane)
{
  const Surface line = {{0, 0, 0}, {10, 20, 30}, {0, 0, 0}};
  const MergedPlanes merged = mergePlanes ({exactSquare ({0, 0, 0}, 0_deg, 5),
                                            momentsOf (line, 100, 1),
                                            exactSquare ({0, 0, 1}, 0_deg, 9),
                                            Moments(),
                                            exactSquare ({0, 0, 2}, 0_deg, 7)},
                                           as_in_paper);
  EXPECT_EQ (merged.merged_into, (Labels{2, no_plane, 0, no_plane, 1}));
  ASSERT_EQ (merged.fits.size(), 3u);
  EXPECT_EQ (merged.moments[0].count, 81.0);
  EXPECT_EQ (merged.moments[2].count, 25.0);
}
