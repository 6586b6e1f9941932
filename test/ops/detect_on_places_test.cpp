// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/detect_on_places.h"
#include "voxel_scene.h"

#include <optional>
#include <set>

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

using OpsParameters = pcl_ops::OrientedPointSamplingParameters;

OpsParameters
usualParameters ()
{
  OpsParameters parameters;
  parameters.sampling = pcl_ops::Sampling::Neighborhoods;
  return parameters;
}

LabelledPlanes
detectIn (const Points& points, const OpsParameters& parameters = usualParameters())
{
  pcl_ops::StageDurations durations;
  return detectOnPlaces (points, parameters, durations);
}

/** \brief Adds points drawn uniformly on a surface with a mean spacing [m]. */
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

/** \brief 38,000 points of a floor, a wall and a table. */
Points
smallRoom ()
{
  return drawnPoints ({floor_of_room, wall_of_room, table}, 2.5e-2, 3_mm);
}

/** \brief The most frequent label of a range of points, and the share that has it. */
std::pair<std::int32_t, double>
usualLabel (const LabelledPlanes& found, std::size_t begin, std::size_t end)
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
 * The points of a surface are consecutive. */
void
expectEachHasItsPlane (const LabelledPlanes& found,
                       const std::vector<std::size_t>& ends,
                       double min_share = 0.9)
{
  std::set<std::int32_t> planes;
  std::size_t begin = 0;
  for (const std::size_t end : ends) {
    const auto [plane, share] = usualLabel (found, begin, end);
    EXPECT_GE (share, min_share) << "the surface up to point " << end;
    planes.insert (plane);
    begin = end;
  }
  EXPECT_EQ (planes.size(), ends.size());
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
  const LabelledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 3u);
  expectEachHasItsPlane (found, {19200, 19200 + 16000, points.size()});
}

TEST (DetectOnPlaces, LabelsPointsTheSameInAnyOrder)
{
  const Points points = smallRoom();
  const LabelledPlanes found = detectIn (points);
  ASSERT_EQ (found.planes.fits.size(), 3u);
  RandomGenerator generator (seedOfTest());
  Indices order = upTo (points.size());
  for (int shuffle = 0; shuffle < 3; ++shuffle) {
    std::shuffle (order.begin(), order.end(), generator);
    const LabelledPlanes again = detectIn (inOrder (points, order));
    ASSERT_EQ (again.planes.fits.size(), found.planes.fits.size());
    for (std::size_t i = 0; i < order.size(); ++i)
      ASSERT_EQ (again.labels[i], found.labels[order[i]]);
  }
}

TEST (DetectOnPlaces, FindsTheSameWithAnyNumberOfThreads)
{
  const Points points = smallRoom();
  const LabelledPlanes found = detectIn (points);
  for (const unsigned threads : {2u, 3u}) {
    OpsParameters parameters = usualParameters();
    parameters.threads = threads;
    const LabelledPlanes again = detectIn (points, parameters);
    EXPECT_EQ (again.labels, found.labels);
    ASSERT_EQ (again.planes.fits.size(), found.planes.fits.size());
    for (std::size_t p = 0; p < found.planes.fits.size(); ++p)
      EXPECT_EQ (again.planes.fits[p].plane.normal, found.planes.fits[p].plane.normal);
  }
}

TEST (DetectOnPlaces, FindsTheFacesOfARoofAndNoPlaneInTheHillBelow)
{
  // A hill 4 m high and some 20 m wide; above its top a roof of two faces.
  Points points;
  const Surface site = {{-12, -12, 0}, {24, 0, 0}, {0, 24, 0}};
  addDrawn (points, site, 15_cm, 0.0);
  const std::size_t of_hill = points.size();
  RandomGenerator generator (seedOfTest());
  for (std::size_t i = 0; i < of_hill; ++i) {
    const double squared = points.x[i] * points.x[i] + points.y[i] * points.y[i];
    points.z[i] = static_cast<float> (4.0 * std::exp (-squared / 50.0) +
                                      1_cm * drawNormal (generator));
  }
  addDrawn (points, {{-4, -5, 6}, {4, 0, 2}, {0, 10, 0}}, 15_cm, 1_cm);
  const std::size_t half = points.size();
  addDrawn (points, {{0, -5, 8}, {4, 0, -2}, {0, 10, 0}}, 15_cm, 1_cm);
  const LabelledPlanes found = detectIn (points);
  ASSERT_GE (found.planes.fits.size(), 2u);
  std::size_t on_hill = 0;
  for (std::size_t i = 0; i < of_hill; ++i)
    on_hill += found.labels[i] != no_plane;
  EXPECT_LT (static_cast<double> (on_hill), 0.3 * static_cast<double> (of_hill));
  const auto [first, share_of_first] = usualLabel (found, of_hill, half);
  const auto [second, share_of_second] = usualLabel (found, half, points.size());
  EXPECT_NE (first, second);
  EXPECT_GT (share_of_first, 0.9);
  EXPECT_GT (share_of_second, 0.9);
}

TEST (DetectOnPlaces, FindsTheFacesOfARoofInSinglePrecisionOfMapCoordinates)
{
  // A roof above a ground, 4 points a square meter, at a northing where single
  // precision has steps of half a meter.
  Points points;
  addDrawn (points, {{-20, -20, 0}, {40, 0, 0}, {0, 40, 0}}, 50_cm, 5_cm);
  const std::size_t ground_end = points.size();
  addDrawn (points, {{-6, -10, 4}, {6, 0, 3}, {0, 20, 0}}, 50_cm, 5_cm);
  const std::size_t half = points.size();
  addDrawn (points, {{0, -10, 7}, {6, 0, -3}, {0, 20, 0}}, 50_cm, 5_cm);
  points.origin = {0.0, 5e6, 0.0};
  for (float& y : points.y)
    y = 0.5f * std::round (2.0f * y);
  expectEachHasItsPlane (detectIn (points), {ground_end, half, points.size()}, 0.8);
}

TEST (DetectOnPlaces, TellsTheSidesOfAWallApart)
{
  // A wall 10 cm thick: some neighborhoods of one side reach the other side.
  const Points points = drawnPoints (
      {{{0, 0, 0}, {4, 0, 0}, {0, 0, 2.5}}, {{0, 0.1, 0}, {4, 0, 0}, {0, 0, 2.5}}},
      2_cm,
      3_mm);
  const LabelledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 2u);
  expectEachHasItsPlane (found, {points.size() / 2, points.size()});
}

TEST (DetectOnPlaces, MakesOnePlaneOfAFloorWhoseHeightsAreRounded)
{
  // Half of the heights are rounded up to 2.94 m, half down to 2.93 m.
  Points points = drawnPoints ({{{0, 0, 2.935}, {4, 0, 0}, {0, 3, 0}}}, 3_cm, 3_mm);
  for (std::vector<float>* const coordinates : {&points.x, &points.y, &points.z})
    for (float& coordinate : *coordinates)
      coordinate = 0.01f * std::round (100.0f * coordinate);
  EXPECT_EQ (detectIn (points).planes.fits.size(), 1u);
}

TEST (DetectOnPlaces, MakesOnePlaneOfWhatAGapDivides)
{
  const Points points = drawnPoints (
      {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{3, 0, 0}, {2, 0, 0}, {0, 2, 0}}},
      2_cm,
      3_mm);
  EXPECT_EQ (detectIn (points).planes.fits.size(), 1u);
  OpsParameters parameters = usualParameters();
  parameters.merging.enabled = false;
  EXPECT_EQ (detectIn (points, parameters).planes.fits.size(), 2u);
}

TEST (DetectOnPlaces, KeepsApartWhatNoiseDoesNotExplain)
{
  for (const double noise : {2_mm, 3_cm}) {
    const Points points = drawnPoints (
        {{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}, {{2.5, 0, 0.03}, {2, 0, 0}, {0, 2, 0}}},
        2_cm,
        noise);
    EXPECT_EQ (detectIn (points).planes.fits.size(), noise < 1_cm ? 2u : 1u);
  }
}

TEST (DetectOnPlaces, TellsTheNoiseAroundEachPlane)
{
  // A floor, and far sparser a wall that is ten times as noisy.
  Points points = drawnPoints ({floor_of_room}, 2_cm, 2_mm);
  addDrawn (points, {{-10, 5, 0}, {20, 0, 0}, {0, 0, 15}}, 15_cm, 2_cm);
  const LabelledPlanes found = detectIn (points);
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
  const LabelledPlanes found =
      detectIn (drawnPoints ({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}, 2_cm, 0.0));
  ASSERT_EQ (found.planes.fits.size(), 1u);
  EXPECT_EQ (found.noises, std::vector<std::optional<double>> (1));
}

TEST (DetectOnPlaces, KeepsEachPlaneAsThinAsItsNoiseSays)
{
  // Hills in which a plane becomes too thick after it was split: with a wave number
  // [1/m], a height and a spacing of points [m].
  const double hills[][3] = {{0.6, 1.8, 8_cm}, {0.7, 2.2, 10_cm}, {0.8, 1.6, 10_cm}};
  for (const auto& [wave, height, spacing] : hills) {
    Points points;
    addDrawn (points, {{-10, -10, 0}, {20, 0, 0}, {0, 20, 0}}, spacing, 3_mm);
    for (std::size_t i = 0; i < points.size(); ++i)
      points.z[i] += static_cast<float> (height * std::sin (wave * points.x[i]) *
                                         std::cos (wave * points.y[i]));
    const LabelledPlanes found = detectIn (points);
    EXPECT_GE (found.planes.fits.size(), 4u);
    for (std::size_t p = 0; p < found.planes.fits.size(); ++p)
      EXPECT_LE (std::sqrt (found.planes.fits[p].variances[0]),
                 8.0 * found.noises.at (p).value_or (0.0));
  }
}

TEST (DetectOnPlaces, SaysHowFarPointsMayBeFromTheirPlanes)
{
  // Three times a noise of 3 mm.
  const LabelledPlanes found = detectIn (smallRoom());
  EXPECT_NEAR (found.used.distance_threshold.value_or (0.0), 9_mm, 2_mm);
  EXPECT_EQ (found.used.voxel_size, std::nullopt);
}

TEST (DetectOnPlaces, LabelsPointsWithinAGivenDistanceAlone)
{
  const Points points = drawnPoints ({floor_of_room}, 2_cm, 1_cm);
  OpsParameters parameters = usualParameters();
  parameters.distance_threshold = 1_cm;
  const LabelledPlanes found = detectIn (points, parameters);
  ASSERT_EQ (found.planes.fits.size(), 1u);
  EXPECT_EQ (found.used.distance_threshold, 1_cm);
  std::size_t labelled = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (found.labels[i] != no_plane) {
      ++labelled;
      EXPECT_LT (std::abs (points.z[i]), 1.05e-2);
    }
  EXPECT_NEAR (static_cast<double> (labelled) / points.size(), 0.68, 0.03);
}

TEST (DetectOnPlaces, CountsEachPointOnce)
{
  const LabelledPlanes found = detectIn (smallRoom());
  for (std::size_t p = 0; p < found.planes.fits.size(); ++p)
    EXPECT_EQ (found.planes.moments[p].count,
               static_cast<double> (std::count (found.labels.begin(),
                                                found.labels.end(),
                                                static_cast<std::int32_t> (p))));
}

TEST (DetectOnPlaces, LabelsEqualPointsAlike)
{
  const Points points = smallRoom();
  Indices twice = upTo (points.size());
  for (std::uint32_t i = 0; i < points.size(); i += 2)
    twice.push_back (i);
  const LabelledPlanes found = detectIn (inOrder (points, twice));
  EXPECT_EQ (found.planes.fits.size(), 3u);
  for (std::size_t i = points.size(); i < twice.size(); ++i)
    ASSERT_EQ (found.labels[i], found.labels[twice[i]]);
}

TEST (DetectOnPlaces, IsNotDisturbedByMissingReadingsAtZero)
{
  // A room around the origin with so few zeros that no earlier stage takes them for
  // missing readings.
  Points points = smallRoom();
  const std::size_t of_room = points.size();
  for (float& z : points.z)
    z -= 1.5f;
  for (std::size_t i = 0; i < of_room / 50; ++i)
    points.add (0.0f, 0.0f, 0.0f);
  const LabelledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 3u);
  expectEachHasItsPlane (found, {19200, 19200 + 16000, of_room});
}

TEST (DetectOnPlaces, FindsNothingWhereThereIsNoSurface)
{
  Points line, same;
  for (int i = 0; i < 5000; ++i) {
    line.add (0.01f * static_cast<float> (i), 1.0f, 2.0f);
    same.add (1.1f, 2.2f, 3.3f);
  }
  Points few;
  for (int number = 0; number < 4; ++number) {
    EXPECT_EQ (detectIn (few).planes.fits.size(), 0u) << number << " points";
    few.add (static_cast<float> (number), static_cast<float> (number * number), 0.0f);
  }
  for (const Points& points : {line, same}) {
    const LabelledPlanes found = detectIn (points);
    EXPECT_EQ (found.planes.fits.size(), 0u);
    EXPECT_EQ (found.labels, pcl_ops::Labels (points.size(), no_plane));
    EXPECT_EQ (found.used.distance_threshold, std::nullopt);
  }
}

TEST (DetectOnPlaces, FindsASurfaceThatIsFarDenserInAPlace)
{
  // Denser by far at one end, as where an instrument stood.
  Points points = drawnPoints ({floor_of_room}, 3_cm, 3_mm);
  addDrawn (points, {{0, 0, 0}, {0.6, 0, 0}, {0, 0.6, 0}}, 3_mm, 3_mm);
  const LabelledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 1u);
  expectEachHasItsPlane (found, {points.size()}, 0.97);
}

TEST (DetectOnPlaces, PartsTheSidesOfAWallThatNeighborhoodsMix)
{
  // A board seen from both sides. Its sides are 3 cm apart, as far as the points of one
  // side.
  const Points points = drawnPoints (
      {{{0, 0, 0.01}, {2, 0, 0}, {0, 2, 0}}, {{0, 0, 0.04}, {2, 0, 0}, {0, 2, 0}}},
      3_cm,
      1_mm);
  const LabelledPlanes found = detectIn (points);
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
      const Surface other = {{-1.1, -1.5, -1.5}, {0, 3, 0}, {0, 0, 4}};
      SCOPED_TRACE (testing::Message() << spacing << ' ' << thickness);
      const auto side =
          static_cast<std::size_t> (std::lround (front.area() / (spacing * spacing)));
      expectEachHasItsPlane (
          detectIn (drawnPoints ({front, back, ground, other}, spacing, 2_mm)),
          {side, 2 * side});
    }
}

TEST (DetectOnPlaces, FindsTheSameWhereTheCloudIsMoved)
{
  const Points points = smallRoom();
  Points moved = points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    moved.x[i] += 0.371f;
    moved.y[i] += 0.613f;
    moved.z[i] += 0.829f;
  }
  const LabelledPlanes found = detectIn (points);
  const LabelledPlanes again = detectIn (moved);
  std::size_t same = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    same += found.labels[i] == again.labels[i];
  EXPECT_GT (same, 0.999 * static_cast<double> (points.size()));
}

TEST (DetectOnPlaces, FindsNearlyTheSameWithoutSomeOfThePoints)
{
  const Points points = smallRoom();
  Indices most;
  for (std::uint32_t i = 0; i < points.size(); ++i)
    if (i % 100 != 7)
      most.push_back (i);
  const LabelledPlanes found = detectIn (points);
  const LabelledPlanes again = detectIn (inOrder (points, most));
  std::size_t same = 0;
  for (std::size_t i = 0; i < most.size(); ++i)
    same += found.labels[most[i]] == again.labels[i];
  EXPECT_GT (same, 0.99 * static_cast<double> (most.size()));
}

TEST (DetectOnPlaces, FindsAWallWhoseNeighboringPointsErrAlike)
{
  // Correlated errors of up to 2 cm, 20 cm wide, as in a smoothed depth image far away.
  // Their rms is 1 cm; neighboring points scatter by a tenth of that.
  Points points = drawnPoints ({{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, 2_cm, 1_mm);
  const auto wave = [] (float along) { return std::sin (2.0 * M_PI * along / 0.4); };
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] += static_cast<float> (2_cm * wave (points.x[i]) * wave (points.y[i]));
  const LabelledPlanes found = detectIn (points);
  EXPECT_EQ (found.planes.fits.size(), 1u);
  expectEachHasItsPlane (found, {points.size()}, 0.9);
}

TEST (DetectOnPlaces, FindsAWallOfDepthOnLevelsOfAnyDirection)
{
  // A wall 5 m away that a depth camera sees at a slant, with steps of 2 cm and as much
  // noise, and the same rounded to millimeters and turned.
  const auto onLevels = [] (bool is_turned) {
    Points points = drawnPoints ({{{-1, -1, 4.5}, {2, 0, 0.4}, {0, 2, 0}}}, 1_cm, 5_mm);
    for (std::size_t i = 0; i < points.size(); ++i) {
      points.z[i] = static_cast<float> (2_cm * std::round (points.z[i] / 2_cm));
      if (!is_turned)
        continue;
      const float x = 0.8f * points.x[i] - 0.6f * points.z[i];
      const float z = 0.6f * points.x[i] + 0.8f * points.z[i];
      points.x[i] = 1e-3f * std::round (1e3f * x);
      points.z[i] = 1e-3f * std::round (1e3f * z);
    }
    return points;
  };
  for (const bool is_turned : {false, true}) {
    const LabelledPlanes found = detectIn (onLevels (is_turned));
    EXPECT_EQ (found.planes.fits.size(), 1u) << is_turned;
    expectEachHasItsPlane (found, {onLevels (is_turned).size()}, 0.9);
  }
}

TEST (DetectOnPlaces, FindsPlanesAsThinAsTheNoiseOnAHill)
{
  // A point a square meter, and so little slope that planes of neighboring parts touch
  // and agree: joined they have an rms of 60 cm.
  constexpr double noise = 3_cm;
  Points points = drawnPoints ({{{0, 0, 0}, {200, 0, 0}, {0, 200, 0}}}, 1.0, noise);
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] += static_cast<float> (2.5 * std::sin (points.x[i] / 60.0) *
                                       std::cos (points.y[i] / 80.0));
  const LabelledPlanes found = detectIn (points);
  EXPECT_GT (found.planes.fits.size(), 2u);
  for (const pcl_ops::PlaneFit& fit : found.planes.fits)
    EXPECT_LT (std::sqrt (fit.variances[0]), 9.0 * noise);
}

TEST (DetectOnPlaces, FindsInAPartWhatIsAPlaneOfTheWhole)
{
  // The 43 points of a table are a plane among 2,000 points, and few among a billion.
  const Points points = drawnPoints ({table}, 15_cm, 3_mm);
  OpsParameters parameters = usualParameters();
  parameters.noise_of_whole = noiseOfCloud (points, parameters, 2'000);
  EXPECT_EQ (detectIn (points, parameters).planes.fits.size(), 1u);
  parameters.noise_of_whole = noiseOfCloud (points, parameters, 1'000'000'000);
  EXPECT_EQ (detectIn (points, parameters).planes.fits.size(), 0u);
}

TEST (DetectOnPlaces, FindsTheSameWhereAWholeIsGivenItsOwnNoise)
{
  const Points points = smallRoom();
  OpsParameters parameters = usualParameters();
  parameters.noise_of_whole = noiseOfCloud (points, parameters, 0);
  EXPECT_EQ (detectIn (points, parameters).labels, detectIn (points).labels);
}
