// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/detect_on_places.h"
#include "scene.h"

#include <optional>
#include <set>

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

using OpsParameters = pcl_ops::OrientedPointSamplingParameters;

/** \brief Default parameters with the sampling that detectOnPlaces is for. */
OpsParameters
neighborhoodParameters ()
{
  OpsParameters parameters;
  parameters.sampling = pcl_ops::Sampling::Neighborhoods;
  return parameters;
}

/** \brief What detectOnPlaces finds, without the durations of its stages. */
LabeledPlanes
detectIn (const Points& points,
          const OpsParameters& parameters = neighborhoodParameters())
{
  pcl_ops::StageDurations durations;
  return detectOnPlaces (points, parameters, durations);
}

/** \brief Adds points drawn uniformly on a surface.
 * \param[in] spacing mean distance of neighboring points [m]
 * \param[in] noise standard deviation along the normal [m] */
void
addDrawn (Points& points, const Surface& surface, double spacing, double noise)
{
  RandomGenerator generator (seedOfTest() + static_cast<unsigned> (points.size()));
  const long number = std::lround (surface.area() / (spacing * spacing));
  for (long i = 0; i < number; ++i) {
    const pcl::PointXYZ point = toPoint (drawPointOf (surface, noise, generator));
    points.add (point.x, point.y, point.z);
  }
}

/** \brief The points of \ref addDrawn on each surface, one surface after the other. */
Points
drawnPoints (const std::vector<Surface>& surfaces, double spacing, double noise)
{
  Points points;
  for (const Surface& surface : surfaces)
    addDrawn (points, surface, spacing, noise);
  return points;
}

const Surface floor_of_room = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
const Surface wall_of_room = {{0, 0, 0}, {4, 0, 0}, {0, 0, 2.5}};
const Surface table = {{1.5, 1, 0.75}, {1.2, 0, 0}, {0, 0.8, 0}};

constexpr double spacing_in_room = 2.5e-2;          // of neighboring points [m]
constexpr std::size_t points_of_room_floor = 19200; // 4 m x 3 m / spacing^2
constexpr std::size_t points_of_room_wall = 16000;  // 4 m x 2.5 m / spacing^2

/** \brief Points of a floor, a wall and a table, in this order, with a noise of 3 mm.
 */
Points
smallRoom ()
{
  return drawnPoints ({floor_of_room, wall_of_room, table}, spacing_in_room, 3_mm);
}

struct FrequentLabel {
  std::int32_t label;
  double share_of_points;
};

/** \brief The most frequent label of the points begin to end - 1, apart from no_plane,
 * and the share of these points with that label; no_plane and 0 if there are no planes.
 */
FrequentLabel
mostFrequentLabel (const LabeledPlanes& found, std::size_t begin, std::size_t end)
{
  std::vector<std::size_t> counts (found.planes.fits.size() + 1);
  for (std::size_t i = begin; i < end; ++i)
    ++counts[static_cast<std::size_t> (found.labels[i] + 1)];
  const auto most = std::max_element (counts.begin() + 1, counts.end());
  if (most == counts.end())
    return {no_plane, 0.0};
  return {static_cast<std::int32_t> (most - counts.begin()) - 1,
          static_cast<double> (*most) / static_cast<double> (end - begin)};
}

/** \brief Fails unless each surface has a plane of its own with nearly all its points.
 * \param[in] surface_ends the points of the first surface come first and end before
 * surface_ends[0]; those of the second follow and end before surface_ends[1], and so on
 * \param[in] min_share least share of the points of a surface that are on its plane */
void
expectEachHasItsPlane (const LabeledPlanes& found,
                       const std::vector<std::size_t>& surface_ends,
                       double min_share = 0.9)
{
  std::set<std::int32_t> planes;
  std::size_t begin = 0;
  for (const std::size_t end : surface_ends) {
    const auto [plane, share] = mostFrequentLabel (found, begin, end);
    EXPECT_GE (share, min_share) << "the surface up to point " << end;
    planes.insert (plane);
    begin = end;
  }
  EXPECT_EQ (planes.size(), surface_ends.size());
}

/** \brief The points in the order of these indices. */
Points
inOrder (const Points& points, const Indices& order)
{
  Points ordered;
  for (const std::uint32_t i : order)
    ordered.add (points.x[i], points.y[i], points.z[i]);
  return ordered;
}

} // namespace

TEST (DetectOnPlaces, FindsTheSurfacesOfARoomAndNothingElse)
{
  const Points points = smallRoom();
  const LabeledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 3u);
  expectEachHasItsPlane (found,
                         {points_of_room_floor,
                          points_of_room_floor + points_of_room_wall,
                          points.size()});
}

TEST (DetectOnPlaces, LabelsPointsTheSameInAnyOrder)
{
  const Points points = smallRoom();
  const LabeledPlanes found = detectIn (points);
  ASSERT_EQ (found.planes.fits.size(), 3u);
  RandomGenerator generator (seedOfTest());
  Indices order = upTo (points.size());
  for (int shuffle = 0; shuffle < 3; ++shuffle) {
    std::shuffle (order.begin(), order.end(), generator);
    const LabeledPlanes again = detectIn (inOrder (points, order));
    ASSERT_EQ (again.planes.fits.size(), found.planes.fits.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      ASSERT_EQ (again.labels[i], found.labels[order[i]]);
  }
}

TEST (DetectOnPlaces, FindsTheSameWithAnyNumberOfThreads)
{
  const Points points = smallRoom();
  const LabeledPlanes found = detectIn (points);
  ASSERT_GE (found.planes.fits.size(), 3u);
  for (const unsigned threads : {2u, 3u}) {
    OpsParameters parameters = neighborhoodParameters();
    parameters.threads = threads;
    const LabeledPlanes again = detectIn (points, parameters);
    EXPECT_EQ (again.labels, found.labels);
    ASSERT_EQ (again.planes.fits.size(), found.planes.fits.size());
    for (std::size_t p = 0; p < found.planes.fits.size(); ++p)
      EXPECT_EQ (again.planes.fits[p].plane.normal, found.planes.fits[p].plane.normal);
  }
}

TEST (DetectOnPlaces, FindsTheFacesOfARoofAndNoPlaneInTheHillBelow)
{
  // A Gaussian hill, 4 m high, with a standard deviation of 5 m. Above its top a roof
  // of two faces.
  Points points;
  const Surface site = {{-12, -12, 0}, {24, 0, 0}, {0, 24, 0}};
  addDrawn (points, site, 15_cm, 0.0);
  const std::size_t hill_end = points.size();
  RandomGenerator generator (seedOfTest());
  for (std::size_t i = 0; i < hill_end; ++i) {
    const double squared_radius = points.x[i] * points.x[i] + points.y[i] * points.y[i];
    constexpr double twice_the_variance = 2.0 * 5_m * 5_m;
    points.z[i] =
        static_cast<float> (4_m * std::exp (-squared_radius / twice_the_variance) +
                            1_cm * drawGaussian (generator));
  }
  addDrawn (points, {{-4, -5, 6}, {4, 0, 2}, {0, 10, 0}}, 15_cm, 1_cm);
  const std::size_t left_face_end = points.size();
  addDrawn (points, {{0, -5, 8}, {4, 0, -2}, {0, 10, 0}}, 15_cm, 1_cm);
  const LabeledPlanes found = detectIn (points);
  ASSERT_GE (found.planes.fits.size(), 2u);
  std::size_t on_hill = 0, on_upper_part = 0, points_of_upper_part = 0;
  for (std::size_t i = 0; i < hill_end; ++i) {
    const bool is_on_plane = found.labels[i] != no_plane;
    const bool is_in_upper_part = std::hypot (points.x[i], points.y[i]) < 8_m;
    on_hill += is_on_plane;
    on_upper_part += is_on_plane && is_in_upper_part;
    points_of_upper_part += is_in_upper_part;
  }
  EXPECT_LT (on_upper_part, points_of_upper_part / 5);
  EXPECT_LT (on_hill, 0.3 * static_cast<double> (hill_end)) << "its foot bends little";
  const FrequentLabel left = mostFrequentLabel (found, hill_end, left_face_end);
  const FrequentLabel right = mostFrequentLabel (found, left_face_end, points.size());
  EXPECT_NE (left.label, right.label);
  EXPECT_GT (left.share_of_points, 0.9);
  EXPECT_GT (right.share_of_points, 0.9);
}

TEST (DetectOnPlaces, FindsTheFacesOfARoofInSinglePrecisionOfMapCoordinates)
{
  // A roof above a ground, 4 points a square meter, at a northing where single
  // precision has steps of half a meter.
  Points points;
  addDrawn (points, {{-20, -20, 0}, {40, 0, 0}, {0, 40, 0}}, 50_cm, 5_cm);
  const std::size_t ground_end = points.size();
  addDrawn (points, {{-6, -10, 4}, {6, 0, 3}, {0, 20, 0}}, 50_cm, 5_cm);
  const std::size_t left_face_end = points.size();
  addDrawn (points, {{0, -10, 7}, {6, 0, -3}, {0, 20, 0}}, 50_cm, 5_cm);
  points.origin = {0.0, 5e6, 0.0};
  for (float& y : points.y)
    y = 0.5f * std::round (2.0f * y);
  expectEachHasItsPlane (
      detectIn (points), {ground_end, left_face_end, points.size()}, 0.8);
}

TEST (DetectOnPlaces, TellsTheSidesOfAWallApart)
{
  // A wall 10 cm thick: some neighborhoods of one side have points of the other side.
  const Points points = drawnPoints (
      {{{0, 0, 0}, {4, 0, 0}, {0, 0, 2.5}}, {{0, 0.1, 0}, {4, 0, 0}, {0, 0, 2.5}}},
      2_cm,
      3_mm);
  const LabeledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 2u);
  expectEachHasItsPlane (found, {points.size() / 2, points.size()});
}

TEST (DetectOnPlaces, MakesOnePlaneOfAFloorWhoseHeightsAreRounded)
{
  // Nearly half of the heights are rounded up to 2.94 m, nearly half down to 2.93 m.
  Points points = drawnPoints ({{{0, 0, 2.935}, {4, 0, 0}, {0, 3, 0}}}, 3_cm, 3_mm);
  for (std::vector<float>* const coordinates : {&points.x, &points.y, &points.z})
    for (float& coordinate : *coordinates)
      coordinate = 0.01f * std::round (100.0f * coordinate);
  EXPECT_EQ (detectIn (points).planes.fits.size(), 1u);
}

TEST (DetectOnPlaces, TellsTheSidesOfABodyOnAnExactGridApart)
{
  // A slab as thick as the step of the grid.
  constexpr float step = 0.05F;
  Points points;
  for (const int layer : {0, 1})
    for (int x = 0; x < 60; ++x)
      for (int y = 0; y < 60; ++y)
        points.add (step * static_cast<float> (x),
                    step * static_cast<float> (y),
                    step * static_cast<float> (layer));
  const LabeledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 2u);
  expectEachHasItsPlane (found, {points.size() / 2, points.size()});
}

TEST (DetectOnPlaces, MakesOnePlaneOfWhatAGapDivides)
{
  // Two squares of one level, with a gap of 1 m between them.
  const Points points = drawnPoints (
      {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{3, 0, 0}, {2, 0, 0}, {0, 2, 0}}},
      2_cm,
      3_mm);
  EXPECT_EQ (detectIn (points).planes.fits.size(), 1u);
  OpsParameters parameters = neighborhoodParameters();
  parameters.merging.enabled = false;
  EXPECT_EQ (detectIn (points, parameters).planes.fits.size(), 2u);
}

TEST (DetectOnPlaces, KeepsApartWhatNoiseDoesNotExplain)
{
  // Two squares with a gap of 0.5 m between them; the second one is 3 cm higher.
  for (const double noise : {2_mm, 3_cm}) {
    const bool noise_explains_step = noise > 1_cm;
    const Points points = drawnPoints (
        {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{2.5, 0, 0.03}, {2, 0, 0}, {0, 2, 0}}},
        2_cm,
        noise);
    EXPECT_EQ (detectIn (points).planes.fits.size(), noise_explains_step ? 1u : 2u);
  }
}

TEST (DetectOnPlaces, TellsTheNoiseAroundEachPlane)
{
  // A floor, and far sparser a wall that is ten times as noisy.
  Points points = drawnPoints ({floor_of_room}, 2_cm, 2_mm);
  addDrawn (points, {{-10, 5, 0}, {20, 0, 0}, {0, 0, 15}}, 15_cm, 2_cm);
  const LabeledPlanes found = detectIn (points);
  ASSERT_EQ (found.planes.fits.size(), 2u);
  for (std::size_t p = 0; p < 2; ++p) {
    const bool is_floor = std::abs (found.planes.fits[p].plane.normal.z()) > 0.5;
    const double noise = is_floor ? 2_mm : 2_cm;
    EXPECT_NEAR (found.noises.at (p).value_or (0.0), noise, 0.3 * noise);
  }
}

TEST (DetectOnPlaces, SaysNoNoiseWhereNoPlaceTells)
{
  // An exact plane.
  const LabeledPlanes found =
      detectIn (drawnPoints ({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}, 2_cm, 0.0));
  ASSERT_EQ (found.planes.fits.size(), 1u);
  EXPECT_EQ (found.noises, std::vector<std::optional<double>> (1));
}

TEST (DetectOnPlaces, KeepsEachPlaneAsThinAsItsNoiseSays)
{
  // Hills in which a plane becomes too thick after it was split.
  const struct {
    double wave_number; // [rad/m]
    double height;      // [m]
    double spacing;     // of points [m]
  } hills[] = {{0.6, 1.8, 8_cm}, {0.7, 2.2, 10_cm}, {0.8, 1.6, 10_cm}};
  for (const auto& [wave_number, height, spacing] : hills) {
    Points points;
    addDrawn (points, {{-10, -10, 0}, {20, 0, 0}, {0, 20, 0}}, spacing, 3_mm);
    for (std::size_t i = 0; i < points.size(); ++i)
      points.z[i] += static_cast<float> (height * std::sin (wave_number * points.x[i]) *
                                         std::cos (wave_number * points.y[i]));
    const LabeledPlanes found = detectIn (points);
    EXPECT_GE (found.planes.fits.size(), 4u);
    // No plane may be thicker than 12 noises; these stay well below.
    for (std::size_t p = 0; p < found.planes.fits.size(); ++p)
      EXPECT_LE (std::sqrt (found.planes.fits[p].variances[0]),
                 8.0 * found.noises.at (p).value_or (0.0));
  }
}

TEST (DetectOnPlaces, SaysHowFarPointsMayBeFromTheirPlanes)
{
  const LabeledPlanes found = detectIn (smallRoom());
  constexpr double three_noises = 3 * 3_mm;
  EXPECT_NEAR (found.used.distance_threshold.value_or (0.0), three_noises, 2_mm);
  EXPECT_EQ (found.used.voxel_size, std::nullopt);
}

TEST (DetectOnPlaces, LabelsPointsWithinAGivenDistanceAlone)
{
  const Points points = drawnPoints ({floor_of_room}, 2_cm, 1_cm);
  OpsParameters parameters = neighborhoodParameters();
  parameters.distance_threshold = 1_cm;
  const LabeledPlanes found = detectIn (points, parameters);
  ASSERT_EQ (found.planes.fits.size(), 1u);
  EXPECT_EQ (found.used.distance_threshold, 1_cm);
  std::size_t labeled = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (found.labels[i] != no_plane) {
      ++labeled;
      EXPECT_LT (std::abs (points.z[i]), 1.05e-2)
          << "1 cm and half a millimeter of tilt";
    }
  // The threshold is the standard deviation of the noise.
  constexpr double normal_share_within_one_deviation = 0.68;
  EXPECT_NEAR (static_cast<double> (labeled) / points.size(),
               normal_share_within_one_deviation,
               0.03);
}

TEST (DetectOnPlaces, CountsEachPointOnce)
{
  const LabeledPlanes found = detectIn (smallRoom());
  ASSERT_GE (found.planes.fits.size(), 3u);
  for (std::size_t p = 0; p < found.planes.fits.size(); ++p)
    EXPECT_EQ (found.planes.moments[p].count,
               static_cast<double> (std::count (found.labels.begin(),
                                                found.labels.end(),
                                                static_cast<std::int32_t> (p))));
}

TEST (DetectOnPlaces, LabelsEqualPointsAlike)
{
  const Points points = smallRoom();
  Indices with_copies = upTo (points.size());
  for (std::uint32_t i = 0; i < points.size(); i += 2)
    with_copies.push_back (i);
  const LabeledPlanes found = detectIn (inOrder (points, with_copies));
  EXPECT_EQ (found.planes.fits.size(), 3u);
  for (std::size_t i = points.size(); i < with_copies.size(); ++i)
    ASSERT_EQ (found.labels[i], found.labels[with_copies[i]]);
}

TEST (DetectOnPlaces, IsNotDisturbedByMissingReadingsAtZero)
{
  // The origin lies on an upright edge of the wall. There are so few zeros that no
  // earlier stage takes them for missing readings.
  Points points = smallRoom();
  const std::size_t room_end = points.size();
  for (float& z : points.z)
    z -= 1.5f;
  for (std::size_t i = 0; i < room_end / 50; ++i)
    points.add (0.0f, 0.0f, 0.0f);
  const LabeledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 3u);
  expectEachHasItsPlane (
      found,
      {points_of_room_floor, points_of_room_floor + points_of_room_wall, room_end});
}

TEST (DetectOnPlaces, FindsNothingWhereThereIsNoSurface)
{
  Points line, equal;
  for (int i = 0; i < 5000; ++i) {
    line.add (0.01f * static_cast<float> (i), 1.0f, 2.0f);
    equal.add (1.1f, 2.2f, 3.3f);
  }
  Points few;
  for (int number = 0; number < 4; ++number) {
    EXPECT_EQ (detectIn (few).planes.fits.size(), 0u) << number << " points";
    few.add (static_cast<float> (number), static_cast<float> (number * number), 0.0f);
  }
  for (const Points& points : {line, equal}) {
    const LabeledPlanes found = detectIn (points);
    EXPECT_EQ (found.planes.fits.size(), 0u);
    EXPECT_EQ (found.labels, pcl_ops::Labels (points.size(), no_plane));
    EXPECT_EQ (found.used.distance_threshold, std::nullopt);
  }
}

TEST (DetectOnPlaces, FindsASurfaceThatIsFarDenserInAPlace)
{
  // At one corner 100 times as many points per area, as where an instrument stood.
  Points points = drawnPoints ({floor_of_room}, 3_cm, 3_mm);
  addDrawn (points, {{0, 0, 0}, {0.6, 0, 0}, {0, 0.6, 0}}, 3_mm, 3_mm);
  const LabeledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 1u);
  expectEachHasItsPlane (found, {points.size()}, 0.97);
}

TEST (DetectOnPlaces, PartsTheSidesOfAWallThatNeighborhoodsMix)
{
  // A board of which both sides were seen. The sides are 3 cm apart, and neighboring
  // points of one side, too.
  const Points points = drawnPoints (
      {{{0, 0, 0.01}, {2, 0, 0}, {0, 2, 0}}, {{0, 0, 0.04}, {2, 0, 0}, {0, 2, 0}}},
      3_cm,
      1_mm);
  const LabeledPlanes found = detectIn (points);
  expectEachHasItsPlane (found, {points.size() / 2, points.size()}, 0.95);
  EXPECT_EQ (found.planes.fits.size(), 2u);
}

TEST (DetectOnPlaces, FindsBothSidesOfWallsThinnerThanPointsAreApart)
{
  for (const double spacing : {4_cm, 7_cm, 12_cm})
    for (const double thickness : {6_cm, 8_cm, 10_cm}) {
      const Surface front = {{0, 0, 0}, {4, 0, 0}, {0, 0, 4}};
      const Surface back = {{0, thickness, 0}, {4, 0, 0}, {0, 0, 4}};
      const Surface ground = {{0, -1.5, -0.8}, {4, 0, 0}, {0, 3, 0}};
      const Surface wall_beside = {{-1.1, -1.5, -1.5}, {0, 3, 0}, {0, 0, 4}};
      SCOPED_TRACE (testing::Message() << spacing << ' ' << thickness);
      const auto points_of_side =
          static_cast<std::size_t> (std::lround (front.area() / (spacing * spacing)));
      expectEachHasItsPlane (
          detectIn (drawnPoints ({front, back, ground, wall_beside}, spacing, 2_mm)),
          {points_of_side, 2 * points_of_side});
    }
}

TEST (DetectOnPlaces, FindsTheSameWhereTheCloudIsMoved)
{
  const Points points = smallRoom();
  Points moved = points; // by no multiple of a length in the room
  for (std::size_t i = 0; i < points.size(); ++i) {
    moved.x[i] += 0.371f;
    moved.y[i] += 0.613f;
    moved.z[i] += 0.829f;
  }
  const LabeledPlanes found = detectIn (points);
  ASSERT_GE (found.planes.fits.size(), 3u);
  const LabeledPlanes again = detectIn (moved);
  std::size_t same_label = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    same_label += found.labels[i] == again.labels[i];
  EXPECT_GT (same_label, 0.999 * static_cast<double> (points.size()));
}

TEST (DetectOnPlaces, FindsNearlyTheSameWithoutSomeOfThePoints)
{
  const Points points = smallRoom();
  Indices kept; // 99 of each hundred points
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (i % 100 != 7)
      kept.push_back (i);
  const LabeledPlanes found = detectIn (points);
  ASSERT_GE (found.planes.fits.size(), 3u);
  const LabeledPlanes again = detectIn (inOrder (points, kept));
  std::size_t same_label = 0;
  for (std::size_t i = 0; i < kept.size(); ++i)
    same_label += found.labels[kept[i]] == again.labels[i];
  EXPECT_GT (same_label, 0.99 * static_cast<double> (kept.size()));
}

TEST (DetectOnPlaces, FindsAWallWhoseNeighboringPointsErrAlike)
{
  // Correlated errors as in a smoothed depth image: waves of 40 cm with an amplitude of
  // 2 cm and an rms of 1 cm. Each point has an error of its own of 1 mm, too.
  Points points = drawnPoints ({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, 2_cm, 1_mm);
  constexpr double wavelength = 0.4; // [m]
  const auto wave = [] (float along) {
    return std::sin (2.0 * M_PI * along / wavelength);
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] += static_cast<float> (2_cm * wave (points.x[i]) * wave (points.y[i]));
  const LabeledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 1u);
  expectEachHasItsPlane (found, {points.size()}, 0.9);
}

TEST (DetectOnPlaces, FindsAWallOfDepthOnLevelsOfAnyDirection)
{
  // A wall some 5 m away that a depth camera sees at a slant, depths z rounded to 2 cm;
  // then, if it is turned, the cloud of this wall turned about the y axis, with x and z
  // rounded to millimeters.
  const auto wallOnLevels = [] (bool is_turned) {
    Points points = drawnPoints ({{{-1, -1, 4.5}, {2, 0, 0.4}, {0, 2, 0}}}, 1_cm, 5_mm);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points.z[i] = static_cast<float> (2_cm * std::round (points.z[i] / 2_cm));
      if (!is_turned)
        continue;
      // The cosine of the angle is 0.8, its sine 0.6.
      const float x = 0.8f * points.x[i] - 0.6f * points.z[i];
      const float z = 0.6f * points.x[i] + 0.8f * points.z[i];
      points.x[i] = 1e-3f * std::round (1e3f * x);
      points.z[i] = 1e-3f * std::round (1e3f * z);
    }
    return points;
  };
  for (const bool is_turned : {false, true}) {
    const LabeledPlanes found = detectIn (wallOnLevels (is_turned));
    EXPECT_EQ (found.planes.fits.size(), 1u) << is_turned;
    expectEachHasItsPlane (found, {wallOnLevels (is_turned).size()}, 0.9);
  }
}

TEST (DetectOnPlaces, FindsPlanesAsThinAsTheNoiseOnAHill)
{
  // One point for each square meter. The hill is so flat that planes of neighboring
  // parts touch and agree; if all were joined, the plane would have an rms of 56 cm.
  constexpr double noise = 3_cm;
  Points points = drawnPoints ({{{0, 0, 0}, {200, 0, 0}, {0, 200, 0}}}, 1_m, noise);
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] += static_cast<float> (2.5 * std::sin (points.x[i] / 60.0) *
                                       std::cos (points.y[i] / 80.0));
  const LabeledPlanes found = detectIn (points);
  EXPECT_GT (found.planes.fits.size(), 2u);
  // No plane may be thicker than 12 noises; these stay below.
  for (const pcl_ops::PlaneFit& fit : found.planes.fits)
    EXPECT_LT (std::sqrt (fit.variances[0]), 9.0 * noise);
}

TEST (DetectOnPlaces, FindsInAPartWhatIsAPlaneOfTheWhole)
{
  // The 43 points of a table are a plane in a cloud of 2,000 points, but too few for
  // one in a cloud of a billion points.
  const Points points = drawnPoints ({table}, 15_cm, 3_mm);
  OpsParameters parameters = neighborhoodParameters();
  parameters.noise_of_whole = noiseOfCloud (points, parameters, 2'000);
  EXPECT_EQ (detectIn (points, parameters).planes.fits.size(), 1u);
  parameters.noise_of_whole = noiseOfCloud (points, parameters, 1'000'000'000);
  EXPECT_EQ (detectIn (points, parameters).planes.fits.size(), 0u);
}

TEST (DetectOnPlaces, FindsTheSameWhereAWholeIsGivenItsOwnNoise)
{
  const Points points = smallRoom();
  OpsParameters parameters = neighborhoodParameters();
  constexpr std::size_t points_are_the_whole = 0;
  parameters.noise_of_whole = noiseOfCloud (points, parameters, points_are_the_whole);
  const LabeledPlanes found = detectIn (points);
  ASSERT_GE (found.planes.fits.size(), 3u);
  EXPECT_EQ (detectIn (points, parameters).labels, found.labels);
}
