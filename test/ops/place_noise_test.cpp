// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/place_noise.h"
#include "place_scene.h"

#include <cmath>

using namespace pcl_ops::internal;

namespace {

/** \brief A wall with correlated errors of neighboring points: waves of 40 cm with an
 * amplitude of 2 cm and an rms of 1 cm. */
Coordinates
wavyWall ()
{
  Coordinates points = drawnOn ({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, 2_cm, 1_mm);
  constexpr double wavelength = 0.4; // [m]
  const auto wave = [] (float along) {
    return std::sin (2.0 * pi * along / wavelength);
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] += static_cast<float> (2_cm * wave (points.x[i]) * wave (points.y[i]));
  return points;
}

/** \brief The median over all places [m]. */
double
medianNoise (const PlaceScene& scene)
{
  std::vector<float> noise (scene.noise.of_place);
  return medianOf (noise);
}

} // namespace

TEST (PlaceNoise, IsThatOfWhiteNoise)
{
  const PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 3_mm));
  EXPECT_NEAR (medianNoise (scene), 3_mm, 0.2 * 3_mm);
  EXPECT_LT (scene.noise.cloud.common_errors, 3.0);
  ASSERT_FALSE (scene.noise.cloud.growth.empty());
  for (const double growth : scene.noise.cloud.growth) {
    EXPECT_GE (growth, 1.0);
    EXPECT_LT (growth, 1.2);
  }
}

TEST (PlaceNoise, IsThatOfLargeSupportsWhereNeighborsErrAlike)
{
  const PlaceScene scene (wavyWall());
  EXPECT_GT (medianNoise (scene), 6_mm);
  EXPECT_GT (scene.noise.cloud.growth[0], 1.5);
  EXPECT_GT (scene.noise.cloud.common_errors, 5.0);
}

TEST (PlaceNoise, IsHardlyLessThanUsualInTheWholeCloud)
{
  const PlaceScene whole (drawnOn ({square_of_ground}, 2_cm, 1_cm));
  const PlaceScene part (drawnOn ({square_of_ground}, 2_cm, 1_mm));
  EXPECT_NEAR (medianNoise (part), 1_mm, 0.2 * 1_mm);
  std::vector<float> noise_in_whole =
      noiseOfPlaces (part.places, whole.noise.cloud, one_thread).of_place;
  constexpr double least_share_of_usual = 0.7;
  EXPECT_NEAR (medianOf (noise_in_whole), least_share_of_usual * 1_cm, 2_mm);
}

TEST (PlaceNoise, OfThePlacesOfAWholeIsTheSameWhereTheWholeIsGiven)
{
  const PlaceScene whole (wavyWall());
  ASSERT_GT (medianNoise (whole), 6_mm);
  EXPECT_EQ (noiseOfPlaces (whole.places, whole.noise.cloud, one_thread).of_place,
             whole.noise.of_place);
}

TEST (PlaceNoise, OfABarrelIsThatOfItsPointsAndNotItsBend)
{
  // A barrel along y. Supports wider than some 13 cm bend by an rms of more than the
  // noise, 1 mm.
  constexpr float radius = 0.6f; // of curvature at the top of the barrel [m]
  Coordinates barrel = drawnOn ({square_of_ground}, 2_cm, 1_mm);
  for (std::size_t i = 0; i < barrel.size(); ++i) {
    const float from_top = barrel.x[i] - 1.0f;
    barrel.z[i] -= 0.5f * from_top * from_top / radius;
  }
  const double noise_of_flat_ground =
      medianNoise (PlaceScene (drawnOn ({square_of_ground}, 2_cm, 1_mm)));
  EXPECT_LT (medianNoise (PlaceScene (barrel)), 2.0 * noise_of_flat_ground);
}

TEST (PlaceNoise, IsNoneOfExactPoints)
{
  EXPECT_LT (medianNoise (PlaceScene (drawnOn ({square_of_ground}, 2_cm, 0.0))), 1e-6);
}

TEST (ChooseSupports, TakesTheFlattestIfAFewOfTheNearestAreInASecondLayer)
{
  // Whether the support chosen for the first of 24 points is the larger one. The points
  // are on a wall, but for so many that are 1 cm behind it. The noise explains neither
  // support; the larger one is flat.
  const auto takesFlattest = [] (std::size_t points_behind) {
    Places places;
    constexpr std::size_t points = 24;
    for (std::size_t i = 0; i < points; ++i) {
      const bool is_behind = i >= points - points_behind;
      places.position.emplace_back (
          1_cm * (i % 6), 1_cm * (i / 6), is_behind ? 1_cm : 0);
      for (std::uint32_t other = 0; other < points; ++other)
        if (other != i)
          places.nearest.push_back (other);
    }
    places.neighbors_per_place = points - 1;
    const Support small{Eigen::Vector3f::UnitX(), 1e-2f, 5e-2f, false};
    const Support large{Eigen::Vector3f::UnitZ(), 1e-2f, 50e-2f, true};
    places.supports = {std::vector<Support> (points, small),
                       std::vector<Support> (points, large)};
    PlaceNoise noise;
    noise.of_place.assign (points, 1e-3f);
    return chooseSupports (places, noise, one_thread).normal[0].z() == 1.0;
  };
  EXPECT_FALSE (takesFlattest (0));
  EXPECT_FALSE (takesFlattest (2)) << "apart from the others by chance";
  EXPECT_TRUE (takesFlattest (4));
  EXPECT_TRUE (takesFlattest (12));
}

TEST (ChooseSupports, TakesTheLargestThatTheNoiseExplains)
{
  // Beside the edge of two walls supports are smaller than in the middle of one.
  const PlaceScene scene (
      drawnOn ({square_of_ground, {{0, 0, 0}, {2, 0, 0}, {0, 0, 2}}}, 2_cm, 2_mm));
  double sum_of_widths_beside_edge = 0.0;
  double sum_of_widths_in_middle = 0.0;
  double places_beside_edge = 0.0;
  double places_in_middle = 0.0;
  for (std::size_t i = 0; i < scene.places.size(); ++i) {
    const Eigen::Vector3d& position = scene.places.position[i];
    const double from_edge = std::max (position.y(), position.z()); // one is near 0
    if (from_edge < 0.1) {
      sum_of_widths_beside_edge += scene.chosen.width[i];
      ++places_beside_edge;
    }
    else if (std::abs (from_edge - 1.0) < 0.2) {
      sum_of_widths_in_middle += scene.chosen.width[i];
      ++places_in_middle;
    }
  }
  EXPECT_LT (sum_of_widths_beside_edge / places_beside_edge,
             0.6 * sum_of_widths_in_middle / places_in_middle);
}
