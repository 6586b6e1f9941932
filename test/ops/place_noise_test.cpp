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

/** \brief Supports of one place, from the smallest to the largest, all flat and 10 cm
 * wide.
 * \param[in] scatter of each [mm] */
std::vector<Support>
flatSupports (const std::vector<float>& scatter)
{
  std::vector<Support> supports;
  supports.reserve (scatter.size());
  for (const float millimeters : scatter)
    supports.push_back ({Eigen::Vector3f::UnitZ(), 1e-3f * millimeters, 0.1f, true});
  return supports;
}

/** \brief Places with these supports, as many for each. The places next in the list,
 * after the last one the first, are their neighbors, nearest first. */
Places
placesWith (const std::vector<std::vector<Support>>& supports_of_place,
            std::size_t neighbors = 8)
{
  Places places;
  const std::size_t number = supports_of_place.size();
  places.neighbors_per_place = neighbors;
  places.position.assign (number, Eigen::Vector3d::Zero());
  places.density.assign (number, 100.0f);
  places.supports.resize (supports_of_place[0].size());
  double points = 10.0; // of a support
  for (std::vector<Support>& of_level : places.supports) {
    for (const std::vector<Support>& supports : supports_of_place)
      of_level.push_back (supports[&of_level - places.supports.data()]);
    places.points_of_level.push_back (points);
    points *= 3.0;
  }
  for (std::size_t i = 0; i < number; ++i)
    for (std::size_t k = 1; k <= neighbors; ++k)
      places.nearest.push_back (static_cast<std::uint32_t> ((i + k) % number));
  return places;
}

/** \brief The noise of such places. */
PlaceNoise
noiseWith (const std::vector<std::vector<Support>>& supports_of_place,
           std::size_t neighbors = 8)
{
  return noiseOfPlaces (
      placesWith (supports_of_place, neighbors), no_whole_cloud, one_thread);
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

TEST (PlaceNoise, GrowsUpToTheFirstSupportThatScattersLikeTheOneBefore)
{
  const PlaceNoise noise =
      noiseWith (std::vector<std::vector<Support>> (20, flatSupports ({1, 3, 4, 4})));
  const double expected[] = {4.0, 4.0 / 3.0, 1.0, 1.0};
  ASSERT_EQ (noise.cloud.growth.size(), 4u);
  for (std::size_t level = 0; level < 4; ++level)
    EXPECT_NEAR (noise.cloud.growth[level], expected[level], 1e-3);
  for (const float of_place : noise.of_place)
    EXPECT_NEAR (of_place, 4_mm, 1e-6);
  // Supports of 30 points have 9/16 of the variance: by the three parameters of a plane
  // they lose nu / 10 of it, if nu points share an error.
  EXPECT_NEAR (noise.cloud.common_errors, 10.0 * 7.0 / 16.0, 1e-2);
}

TEST (PlaceNoise, IsThatOfTheLargestSupportBeforeTheSurfaceBends)
{
  // Supports of 4 mm are settled, and larger ones, too, but the last one bends.
  for (const float of_place : noiseWith (std::vector<std::vector<Support>> (
                                             20, flatSupports ({1, 4, 4, 5, 9})))
                                  .of_place)
    EXPECT_NEAR (of_place, 5_mm, 1e-5);
}

TEST (PlaceNoise, GrowsLittleWhereFewPlacesTellHowMuch)
{
  // Of 100 places so many have settled supports with four times the scatter of the
  // smallest ones; the others have none, as the scatter doubles with each level.
  const auto growthWith = [] (std::size_t settled_places) {
    std::vector<std::vector<Support>> supports (100, flatSupports ({1, 2, 4}));
    std::fill_n (supports.begin(), settled_places, flatSupports ({1, 4, 4}));
    return noiseWith (supports).cloud.growth.at (0);
  };
  EXPECT_EQ (growthWith (0), 1.0);
  EXPECT_GT (growthWith (4), 1.2);
  EXPECT_LT (growthWith (4), 3.0);
  EXPECT_NEAR (growthWith (30), 4.0, 1e-3);
}

TEST (PlaceNoise, IsTheGeometricMeanOfNearAndFarNeighbors)
{
  // 16 neighbors, of which every second one counts. Of these the nearer four have the
  // noise of the first place, 1 mm, the farther four 4 mm.
  std::vector<std::vector<Support>> supports (17, flatSupports ({1, 1}));
  std::fill (supports.begin() + 9, supports.end(), flatSupports ({4, 4}));
  EXPECT_NEAR (
      noiseWith (supports, 16).of_place[0], 1_mm * std::pow (4.0, 4.0 / 9.0), 3e-5);
}

TEST (PlaceNoise, IsUsuallyThatOfPlacesWhoseSmallestSupportIsFlatUnlessTheyAreFew)
{
  // Of 200 places so many have a noise of 1 mm, and flat supports of all sizes. On the
  // others, with 3 mm, only the larger support is flat.
  const auto usualWith = [] (std::size_t flat_places) {
    std::vector<Support> rough = flatSupports ({3, 3});
    rough[0].is_flat = false;
    std::vector<std::vector<Support>> supports (200, rough);
    std::fill_n (supports.begin(), flat_places, flatSupports ({1, 1}));
    return noiseWith (supports).cloud.usual;
  };
  EXPECT_NEAR (usualWith (40), 1_mm, 1e-4);
  EXPECT_NEAR (usualWith (2), 3_mm, 1e-4) << "1 % of all places";
}

TEST (PlaceNoise, IsNoneOfExactPoints)
{
  EXPECT_LT (medianNoise (PlaceScene (drawnOn ({square_of_ground}, 2_cm, 0.0))), 1e-6);
}

TEST (ChooseSupports, TakesTheFlattestIfAFewOfTheNearestAreInASecondLayer)
{
  // The width of the support chosen for the first of 24 points. They are on a wall, but
  // for so many that are 1 cm behind it. The noise explains no support; that of 50 cm
  // is the flattest.
  const auto widthWith = [] (std::size_t points_behind, bool is_any_flat) {
    Places places;
    constexpr std::size_t points = 24;
    for (std::size_t i = 0; i < points; ++i) {
      const bool is_behind = i >= points - points_behind;
      const std::size_t row = i / 6, column = i % 6;
      places.position.emplace_back (1_cm * column, 1_cm * row, is_behind ? 1_cm : 0.0);
      for (std::uint32_t other = 0; other < points; ++other)
        if (other != i)
          places.nearest.push_back (other);
    }
    places.neighbors_per_place = points - 1;
    for (const Support& support :
         {Support{Eigen::Vector3f::UnitZ(), 1e-2f, 5e-2f, false},
          Support{Eigen::Vector3f::UnitZ(), 1e-2f, 20e-2f, is_any_flat},
          Support{Eigen::Vector3f::UnitZ(), 1e-2f, 50e-2f, is_any_flat},
          Support{Eigen::Vector3f::UnitZ(), 3e-2f, 90e-2f, is_any_flat}})
      places.supports.emplace_back (points, support);
    PlaceNoise noise;
    noise.of_place.assign (points, 1e-3f);
    return chooseSupports (places, noise, one_thread).width[0];
  };
  const float of_smallest = 5e-2f;
  const float of_flattest = 50e-2f;
  EXPECT_EQ (widthWith (0, true), of_smallest);
  EXPECT_EQ (widthWith (2, true), of_smallest) << "apart from the others by chance";
  EXPECT_EQ (widthWith (4, true), of_flattest);
  EXPECT_EQ (widthWith (12, true), of_flattest);
  EXPECT_EQ (widthWith (12, false), of_smallest);
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

TEST (ChooseSupports, TakesNoneThatScattersTooMuchOnceItGrows)
{
  // The level of the support that is chosen for a place with a noise of 1 mm: its width
  // tells. The scatter of levels 0 and 1 is as given, growth is that of level 1.
  const auto chosenLevel = [] (float scatter, double growth) {
    std::vector<Support> supports = flatSupports ({1, scatter});
    supports[1].width = 2.0f;
    const std::vector<std::vector<Support>> of_places (9, supports);
    PlaceNoise noise;
    noise.of_place.assign (of_places.size(), 1e-3f);
    noise.cloud.growth = {1.0, growth};
    const ChosenSupports chosen =
        chooseSupports (placesWith (of_places), noise, one_thread);
    return chosen.width[0] == 2.0f ? 1 : 0;
  };
  EXPECT_EQ (chosenLevel (1.3f, 1.0), 1);
  EXPECT_EQ (chosenLevel (2.5f, 1.0), 0);
  EXPECT_EQ (chosenLevel (1.3f, 2.0), 0);
}

TEST (ChooseSupports, TakesWideOnesOfExactPointsThoughRoundingScattersThem)
{
  // A support 10 m wide that scatters by a tenth of a millimeter per meter.
  const auto chosenWidth = [] (float width) {
    std::vector<Support> supports = flatSupports ({0, 1});
    supports[1].width = width;
    const std::vector<std::vector<Support>> of_places (9, supports);
    PlaceNoise noise;
    noise.of_place.assign (of_places.size(), 0.0f);
    return chooseSupports (placesWith (of_places), noise, one_thread).width[0];
  };
  EXPECT_EQ (chosenWidth (10.0f), 10.0f);
  EXPECT_EQ (chosenWidth (2.0f), 0.1f) << "half a millimeter per meter";
}

TEST (ChooseSupports, SaysWhichAreFlat)
{
  std::vector<std::vector<Support>> supports (9, flatSupports ({1, 1}));
  supports[3][1].is_flat = false;
  PlaceNoise noise;
  noise.of_place.assign (supports.size(), 1e-3f);
  const ChosenSupports chosen =
      chooseSupports (placesWith (supports), noise, one_thread);
  EXPECT_EQ (chosen.is_flat, (std::vector<char>{1, 1, 1, 0, 1, 1, 1, 1, 1}));
}
