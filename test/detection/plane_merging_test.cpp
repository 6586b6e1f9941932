// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/plane_merging.h>

using namespace pcl_ops::internal;
using namespace pcl_ops;

namespace {

constexpr double max_angle = 7_deg;
constexpr double max_distance = 5_cm;

/** \brief The parameters of the paper: no noise factor. */
constexpr MergingParameters as_in_paper{true, max_angle, max_distance, {}};

/** \brief A square about a center.
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
 * \param[in] noise how far points lie, by turns, before the square and behind it [m] */
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
  return {true, max_angle, 0.0, noise_factor};
}

PlaneFit
fitOf (const Eigen::Vector3d& center, double tilt = 0.0)
{
  return fitPlane (exactSquare (center, tilt)).value();
}

} // namespace

TEST (AreCoplanar, ByTheAngleAndBothDistancesWhateverTheSignOfTheNormals)
{
  const PlaneFit floor = fitOf ({0, 0, 0});
  const struct {
    const char* plane;
    PlaneFit fit;
    bool are_coplanar;
  } rows[] = {{"another part of the floor", fitOf ({5, 3, 0}), true},
              {"one through its centroid", fitOf ({0, 0, 0}, 6_deg), true},
              {"a steeper one", fitOf ({0, 0, 0}, 8_deg), false},
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
  // Points lie 3 cm off both sides of each square. Their rms distance to the plane of
  // the other square, 5 cm away, is 5.8 cm.
  const Moments noisy = noisySquare ({0, 0, 0}, 3_cm);
  const Moments above = noisySquare ({2, 0, 5_cm}, 3_cm);
  const Moments tilted = noisySquare ({0.5, 0, 0}, 3_cm, 30_cm, 8_deg);
  // With a plane of 1 cm of noise, only 6 cm of another plane's 9 cm of noise count.
  const Moments thick = noisySquare ({0, 0, 0}, 9_cm);
  const Moments clean = noisySquare ({2, 0, 15_cm}, 1_cm);
  const Moments rough = noisySquare ({2, 0, 15_cm}, 2_cm);
  const Moments flat = exactSquare ({0, 0, 0});
  const Moments beside = exactSquare ({5, 3, 0});
  const struct {
    Moments first, second;
    double noise_factor;
    std::size_t merged_planes;
  } rows[] = {{noisy, above, 1.8, 2},
              {noisy, above, 2.1, 1},
              {noisy, tilted, 2.0, 2},
              {thick, clean, 2.0, 2},
              {thick, rough, 2.0, 1},
              {flat, beside, 1.5, 1}};
  for (std::size_t row = 0; row < std::size (rows); ++row) {
    const auto& [first, second, noise_factor, merged_planes] = rows[row];
    EXPECT_EQ (mergePlanes ({first, second}, byNoise (noise_factor)).fits.size(),
               merged_planes)
        << row;
  }
}

TEST (Merge, ByNoiseCarriesNoSmallPlaneOnToTheCentroidOfALargeOne)
{
  // A small piece 10 m from a wall: noise tilts it by 2 degrees, 35 cm over 10 m.
  const Moments wall = noisySquare ({0, 0, 0}, 1_cm, 8_m);
  const Moments piece = noisySquare ({10, 0, 0}, 1_cm, 30_cm, 2_deg);
  EXPECT_FALSE (pcl_ops::detail::areCoplanar (
      *fitPlane (wall), *fitPlane (piece), max_angle, max_distance));
  EXPECT_EQ (mergePlanes ({wall, piece}, byNoise (1.5)).fits.size(), 1u);
}

TEST (Merge, IsTheFitOfAllPoints)
{
  const Moments first = exactSquare ({0, 0, 0});
  Moments all = exactSquare ({0.5, 1, 2_cm}, 3_deg);
  const auto merged = mergePlanes ({first, all}, as_in_paper);
  all += first;
  ASSERT_EQ (merged.fits.size(), 1u);
  EXPECT_EQ (merged.moments[0].count, 200.0);
  EXPECT_LT (angleBetween (merged.fits[0].plane.normal, fitPlane (all)->plane.normal),
             1e-12);
}

TEST (Merge, JoinsAChainOfPlanesWhoseEndsAloneWouldNotPass)
{
  // The first and the last lean by 8 degrees to each other, which is too much;
  // neighbors by 5 and by 3 degrees.
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
  const auto merged = mergePlanes (planes, as_in_paper);
  EXPECT_LT (merged.fits.size(), planes.size());
  for (std::size_t i = 0; i < merged.fits.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE (pcl_ops::detail::areCoplanar (
          merged.fits[i], merged.fits[j], max_angle, max_distance));
}

TEST (Merge, LeavesPlanesAloneWhereDisabled)
{
  MergingParameters off = as_in_paper;
  off.enabled = false;
  const auto merged = mergePlanes (
      {exactSquare ({0, 0, 0}, 0_deg, 5), exactSquare ({5, 3, 0}, 0_deg, 9)}, off);
  EXPECT_EQ (merged.fits.size(), 2u);
  EXPECT_EQ (merged.merged_into, (Labels{1, 0}))
      << "sorted by falling size all the same";
}

TEST (Merge, SortsPlanesByFallingSizeAndDropsPointsThatSpanNoPlane)
{
  const Surface line = {{0, 0, 0}, {10, 20, 30}, {0, 0, 0}};
  const auto merged = mergePlanes ({exactSquare ({0, 0, 0}, 0_deg, 5),
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
