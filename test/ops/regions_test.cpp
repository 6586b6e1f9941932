// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/region_evidence.h"
#include "ops/region_joining.h"
#include "ops/region_labels.h"
#include "place_scene.h"

#include <cmath>
#include <set>

using namespace pcl_ops::internal;
using pcl_ops::Labels;
using pcl_ops::no_plane;

namespace {

// Squares of 2 m x 2 m, as square_of_ground is one. The wall stands on an edge of the
// ground; the gap is 1 m wide.
const Surface wall_on_ground = {{0, 0, 0}, {2, 0, 0}, {0, 0, 2}};
const Surface ground_beyond_gap = {{3, 0, 0}, {2, 0, 0}, {0, 2, 0}};

/** \brief Number of points of one of these squares with a spacing of 2 cm. */
constexpr std::size_t points_of_square = 10'000;
/** \brief The size of a region may differ by this many points, e.g. where it takes some
 * of a wall that it meets. */
constexpr std::size_t points_at_rim = 500;
constexpr std::size_t max_points_of_one_square = points_of_square + points_at_rim;
constexpr std::size_t min_points_of_two_squares = 2 * points_of_square - points_at_rim;

/** \brief With a spacing of 3 cm one square has 4,444 points, and two have 8,889. */
constexpr std::size_t max_points_of_one_sparse_square = 5'000;

/** \brief For joinOverGaps: its default limits. */
const pcl_ops::MergingParameters default_joins;

/** \brief A road of 4 m x 4 m that rises from both sides to its middle by a height [m]:
 * 17,778 points with a noise of 2 mm. */
PlaceScene
crownedRoad (double height)
{
  const Surface left = {{-2, 0, 0}, {2, 0, height}, {0, 4, 0}};
  const Surface right = {{0, 0, height}, {2, 0, -height}, {0, 4, 0}};
  return PlaceScene (drawnOn ({left, right}, 3_cm, 2_mm));
}

constexpr double slight_crown = 3.5e-2;   // [m]; a slope of 1 degree
constexpr double crown_of_a_roof = 17e-2; // [m]; a slope of 5 degrees

/** \brief A ground whose points are several regions from left to right.
 * \param[in] ends where each region but the last one ends along x [m], ascending */
PlaceScene
groundDividedAt (const std::vector<double>& ends)
{
  PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 2_mm));
  Region empty = scene.regions.list[0];
  empty.moments = pcl_ops::Moments();
  scene.regions.list.assign (ends.size() + 1, empty);
  for (std::size_t i = 0; i < scene.places.size(); ++i) {
    const Eigen::Vector3d& position = scene.places.position[i];
    const auto region =
        std::lower_bound (ends.begin(), ends.end(), position.x()) - ends.begin();
    scene.regions.of_place[i] = static_cast<std::int32_t> (region);
    scene.regions.list[region].moments.add (position.x(), position.y(), position.z());
  }
  for (Region& region : scene.regions.list)
    region.refit();
  return scene;
}

/** \brief A ground whose points are two regions, left and right of x = 0.9 m. The right
 * one is larger. */
PlaceScene
groundInTwo ()
{
  return groundDividedAt ({0.9});
}

/** \brief For each region 1 if the evidence says that it is a plane, else 0. */
std::vector<char>
arePlanes (const PlaceScene& scene)
{
  constexpr double min_points_factor = 1.0;
  return planesAmong (scene.places,
                      scene.noise,
                      scene.chosen,
                      scene.regions,
                      min_points_factor,
                      one_thread);
}

/** \brief The label of each place: the index of its region, or no_plane.
 * \param[in] is_plane for each region, whether it is a plane
 * \param[in] distance_threshold largest distance of a place to its plane [m] */
Labels
labelsOf (const PlaceScene& scene,
          const std::vector<char>& is_plane,
          std::optional<double> distance_threshold = no_threshold)
{
  return labelPlaces (scene.places,
                      scene.noise,
                      scene.regions,
                      is_plane,
                      distance_threshold,
                      one_thread);
}

/** \brief The places that labelPlaces may give to either of two regions: each region
 * has the place or one of its neighbors. */
Indices
placesOfEither (const PlaceScene& scene)
{
  Indices of_either;
  for (std::uint32_t i = 0; i < scene.places.size(); ++i) {
    std::set<std::int32_t> candidates = {scene.regions.of_place[i]};
    for (std::size_t k = 0; k < scene.places.neighbors_per_place; ++k)
      candidates.insert (scene.regions.of_place[scene.places.nearestOf (i)[k]]);
    if (candidates.size() == 2)
      of_either.push_back (i);
  }
  return of_either;
}

/** \brief For \ref labelsOf and the two regions of \ref groundInTwo: which are planes.
 */
const std::vector<char> both_are_planes = {1, 1};
const std::vector<char> right_is_plane = {0, 1};

} // namespace

TEST (GrowRegions, GrowToTheEdgeOfTwoWalls)
{
  const Coordinates points = drawnOn ({square_of_ground, wall_on_ground}, 2_cm, 2_mm);
  const std::vector<std::size_t> sizes = PlaceScene (points).sizes();
  ASSERT_GE (sizes.size(), 2u);
  for (int region = 0; region < 2; ++region)
    EXPECT_NEAR (static_cast<double> (sizes[region]), points_of_square, 300.0);
}

TEST (GrowRegions, EndAtAGivenDistance)
{
  constexpr double threshold = 1_cm;
  const PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 1_cm));
  const Regions regions =
      growRegions (scene.places, scene.noise, scene.chosen, threshold);
  for (std::size_t i = 0; i < scene.places.size(); ++i)
    if (regions.of_place[i] == 0) {
      ASSERT_LT (std::abs (scene.places.position[i].z()), threshold + 5_mm)
          << "the plane may tilt while it grows";
    }
  EXPECT_GT (std::count (regions.of_place.begin(), regions.of_place.end(), 0), 2500)
      << "of 10,000";
}

TEST (GrowRegions, OfOnePlaceAreAsWideAsTheSupportOfThePlace)
{
  // Two places 1 m above each other, each on a level plane of its own.
  Places places;
  places.position = {{0, 0, 0}, {0, 0, 1}};
  places.nearest = {1, 0};
  places.neighbors_per_place = 1;
  PlaceNoise noise;
  noise.of_place = {1e-3f, 1e-3f};
  ChosenSupports chosen;
  chosen.normal = {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ()};
  chosen.scatter = {1e-3f, 1e-3f};
  chosen.width = {0.2f, 0.4f};
  chosen.is_flat = {1, 1};
  const Regions regions = growRegions (places, noise, chosen, no_threshold);
  ASSERT_EQ (regions.list.size(), 2u);
  for (std::size_t i = 0; i < places.size(); ++i)
    EXPECT_NEAR (regions.list[regions.of_place[i]].width(), chosen.width[i], 1e-6);
}

TEST (JoinTouching, MakesOneOfPiecesOfAPlane)
{
  PlaceScene scene = groundInTwo();
  joinTouching (scene.places, one_thread, scene.regions);
  EXPECT_EQ (scene.sizes(), std::vector<std::size_t>{scene.places.size()});
  // The right region took the left one.
  EXPECT_EQ (scene.regions.of_place, pcl_ops::Labels (scene.places.size(), 1));
}

TEST (JoinTouching, MakesOneOfPiecesOfWhichSomeTouchTheLargestOnlyThroughOthers)
{
  // From left to right the pieces are larger: the middle one joins the right one first.
  PlaceScene scene = groundDividedAt ({0.4, 1.0});
  joinTouching (scene.places, one_thread, scene.regions);
  EXPECT_EQ (scene.regions.of_place, Labels (scene.places.size(), 2));
}

TEST (JoinTouching, PicksTheRegionThatMostPlacesTouchHoweverManyNeighborsTheyHave)
{
  // Four places on the ridge of a roof, which are on both of its slopes. Two of them
  // have neighbors on the left slope, four in all; three have one on the right slope.
  constexpr std::int32_t ridge = 0, left = 1, right = 2;
  Regions regions;
  regions.list.resize (3);
  for (int i = 0; i < 10; ++i) {
    const double y = 0.1 * i;
    if (i < 4)
      regions.list[ridge].moments.add (0.0, y, 0.0);
    for (int j = 0; j < 10; ++j) {
      const double below = 0.1 * j + 5_cm;
      regions.list[left].moments.add (-below, y, -below);
      regions.list[right].moments.add (below, y, -below);
    }
  }
  for (Region& region : regions.list) {
    region.noise = region.scatter = 1_mm;
    region.refit();
  }
  Places places;
  places.position = {{0, 0, 0}, {0, 0.1, 0}, {0, 0.2, 0}, {0, 0.3, 0}}; // the ridge
  for (const double side : {-1.0, 1.0})
    for (int i = 0; i < 4; ++i)
      places.position.emplace_back (side * 5_cm, 0.1 * i, -5_cm);
  regions.of_place = {
      ridge, ridge, ridge, ridge, left, left, left, left, right, right, right, right};
  places.neighbors_per_place = 3;
  const std::vector<Indices> nearest_of_ridge = {
      {4, 5, 6}, {5, 9, 0}, {10, 1, 3}, {11, 2, 1}};
  const std::vector<Indices> nearest_of_left = {
      {5, 6, 7}, {4, 6, 7}, {5, 7, 4}, {6, 5, 4}};
  const std::vector<Indices> nearest_of_right = {
      {9, 10, 11}, {8, 10, 11}, {9, 11, 8}, {10, 9, 8}};
  for (const auto& nearest_of_places :
       {nearest_of_ridge, nearest_of_left, nearest_of_right})
    for (const Indices& nearest : nearest_of_places)
      places.nearest.insert (places.nearest.end(), nearest.begin(), nearest.end());
  joinTouching (places, one_thread, regions);
  EXPECT_EQ (regions.of_place[0], right);
  EXPECT_EQ (regions.of_place[4], left) << "a slope does not join the other one";
}

TEST (JoinTouching, LeavesWallsThatMeetAlone)
{
  PlaceScene scene (drawnOn ({square_of_ground, wall_on_ground}, 2_cm, 2_mm));
  joinTouching (scene.places, one_thread, scene.regions);
  EXPECT_LT (scene.sizes().at (0), max_points_of_one_square);
}

TEST (JoinTouching, MakesOneOfARoadThatLeansToBothSidesButNotOfARoof)
{
  for (const double height : {slight_crown, crown_of_a_roof}) {
    PlaceScene scene = crownedRoad (height);
    ASSERT_LT (scene.sizes().at (0), 16'000u) << height << " m: not yet one region";
    joinTouching (scene.places, one_thread, scene.regions);
    constexpr std::size_t nearly_all = 17'000; // of 17,778 points
    const bool is_one_region = scene.sizes().at (0) > nearly_all;
    EXPECT_EQ (is_one_region, height == slight_crown) << height;
  }
}

TEST (JoinTouching, LeavesAStepOfTenNoises)
{
  const Surface higher = {{2, 0, 2_cm}, {2, 0, 0}, {0, 2, 0}};
  PlaceScene scene (drawnOn ({square_of_ground, higher}, 2_cm, 2_mm));
  joinTouching (scene.places, one_thread, scene.regions);
  EXPECT_LT (scene.sizes().at (0), max_points_of_one_square);
}

TEST (JoinOverGaps, MakesOneOfExactGroundsThatContinueEachOther)
{
  PlaceScene scene (drawnOn ({square_of_ground, ground_beyond_gap}, 2_cm, 0.0));
  joinOverGaps (default_joins, scene.regions);
  EXPECT_GT (scene.sizes().at (0), min_points_of_two_squares);
}

TEST (JoinOverGaps, MakesOneOfGroundsThatContinueEachOther)
{
  PlaceScene scene (drawnOn ({square_of_ground, ground_beyond_gap}, 2_cm, 2_mm));
  joinTouching (scene.places, one_thread, scene.regions);
  ASSERT_LT (scene.sizes().at (0), max_points_of_one_square);
  joinOverGaps (default_joins, scene.regions);
  EXPECT_GT (scene.sizes().at (0), min_points_of_two_squares);
}

TEST (JoinOverGaps, LeavesAStepThatNoiseDoesNotExplain)
{
  Surface step = ground_beyond_gap;
  step.corner.z() = 3_cm;
  PlaceScene scene (drawnOn ({square_of_ground, step}, 2_cm, 2_mm));
  joinTouching (scene.places, one_thread, scene.regions);
  joinOverGaps (default_joins, scene.regions);
  EXPECT_LT (scene.sizes().at (0), max_points_of_one_square);
}

TEST (JoinOverGaps, LeavesGroundsThatAreTwiceAsFarApartAsTheyAreLong)
{
  // The centers are 3 m and 5 m apart, the squares 2 m long.
  for (const double gap : {1.0, 3.0}) {
    const Surface beyond = {{2.0 + gap, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    PlaceScene scene (drawnOn ({square_of_ground, beyond}, 3_cm, 2_mm));
    joinTouching (scene.places, one_thread, scene.regions);
    joinOverGaps (default_joins, scene.regions);
    const bool is_one_region = scene.sizes().at (0) > max_points_of_one_sparse_square;
    EXPECT_EQ (is_one_region, gap < 2.0) << gap;
  }
}

TEST (JoinOverGaps, LeavesAStepOfThreeNoises)
{
  for (const double step : {2_mm, 6_mm}) { // one noise, and three
    Surface beyond = ground_beyond_gap;
    beyond.corner.z() = step;
    PlaceScene scene (drawnOn ({square_of_ground, beyond}, 3_cm, 2_mm));
    joinTouching (scene.places, one_thread, scene.regions);
    joinOverGaps (default_joins, scene.regions);
    const bool is_one_region = scene.sizes().at (0) > max_points_of_one_sparse_square;
    EXPECT_EQ (is_one_region, step < 4_mm) << step;
  }
}

TEST (JoinOverGaps, MakesOneOfAGroundAndTheNearerOfTwoThatItContinues)
{
  // Three grounds from left to right, 6 mm, 0 and 3 mm high with a noise of 2 mm. The
  // right one continues both others, which do not continue each other.
  const auto regionOf = [] (const Surface& surface, int columns) {
    Region region;
    constexpr int rows = 60;
    for (int i = 0; i < columns; ++i)
      for (int j = 0; j < rows; ++j) {
        const double offset = (i + j) % 2 == 0 ? 2_mm : -2_mm;
        const Eigen::Vector3d point =
            surface.at ((i + 0.5) / columns, (j + 0.5) / rows);
        region.moments.add (point.x(), point.y(), point.z() + offset);
      }
    region.refit();
    region.scatter = region.noise = 2_mm;
    return region;
  };
  Regions regions;
  regions.list = {regionOf ({{-2.3, 0, 6_mm}, {2, 0, 0}, {0, 3, 0}}, 40),
                  regionOf ({{0, 0, 0}, {2, 0, 0}, {0, 3, 0}}, 60),
                  regionOf ({{2.3, 0, 3_mm}, {1, 0, 0}, {0, 3, 0}}, 20)};
  regions.of_place = {0, 1, 2};
  joinOverGaps (default_joins, regions);
  EXPECT_EQ (regions.of_place, (Labels{0, 1, 1}));
}

TEST (JoinOverGaps, LeavesRegionsOfOneOrTwoPoints)
{
  // A ground of 100 points, and so many points 2 m beside it, at the same height.
  const auto areJoined = [] (int points) {
    Region ground, beside;
    for (int i = 0; i < 10; ++i)
      for (int j = 0; j < 10; ++j)
        ground.moments.add (0.1 * i, 0.1 * j, 0.0);
    ground.refit();
    for (int i = 0; i < points; ++i)
      beside.moments.add (2.0 + 0.1 * (i % 2), 0.1 * i, 0.0);
    beside.fit = ground.fit;
    beside.fit.centroid = beside.moments.centroid();
    ground.noise = beside.noise = 1_mm;
    Regions regions{{ground, beside}, {0, 1}};
    joinOverGaps (default_joins, regions);
    return regions.of_place[1] == 0;
  };
  EXPECT_FALSE (areJoined (2));
  EXPECT_TRUE (areJoined (4));
}

TEST (JoinOverGaps, LeavesGroundsThatLeanByMoreThanTheGivenAngle)
{
  Surface beyond = ground_beyond_gap; // turned by 0.2 degrees about its middle
  beyond.first.z() = 2.0 * std::tan (0.2_deg);
  beyond.corner.z() = -std::tan (0.2_deg);
  for (const double max_angle : {0.1_deg, 1_deg}) {
    PlaceScene scene (drawnOn ({square_of_ground, beyond}, 2_cm, 1_cm));
    joinTouching (scene.places, one_thread, scene.regions);
    pcl_ops::MergingParameters merging;
    merging.angle_threshold = max_angle;
    joinOverGaps (merging, scene.regions);
    const bool is_one_region = scene.sizes().at (0) > max_points_of_one_square;
    EXPECT_EQ (is_one_region, max_angle > 0.2_deg) << max_angle;
  }
}

TEST (RegionEvidence, IsForAPlaneAndAgainstFacetsOfABall)
{
  const PlaceScene ground (drawnOn ({square_of_ground}, 2_cm, 2_mm));
  const std::vector<char> is_plane_of_ground = arePlanes (ground);
  ASSERT_FALSE (is_plane_of_ground.empty());
  EXPECT_EQ (is_plane_of_ground[0], 1);
  Coordinates ball; // with a radius of 1 m and a noise of 1 mm
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d position = (1.0 + 1_mm * drawGaussian (generator)) *
                                     drawGaussians (generator).normalized();
    const pcl::PointXYZ point = toPoint (position);
    ball.add (point.x, point.y, point.z);
  }
  const PlaceScene facets (ball);
  const std::vector<char> is_plane_of_ball = arePlanes (facets);
  ASSERT_FALSE (is_plane_of_ball.empty());
  EXPECT_EQ (std::count (is_plane_of_ball.begin(), is_plane_of_ball.end(), 1), 0);
}

TEST (RegionEvidence, GrowsWithSizeAndOpenBorderAndShrinksWithBendAndSmoothBorder)
{
  RegionEvidence evidence;
  evidence.size = 1.0;
  const double sum = evidence.sum();
  EXPECT_GT (sum, 0.0);
  RegionEvidence bent = evidence;
  bent.bend = 2.0;
  EXPECT_LT (bent.sum(), sum);
  RegionEvidence continued = evidence;
  continued.smooth_border = 0.5;
  EXPECT_LT (continued.sum(), sum);
  RegionEvidence ending = evidence;
  ending.open_border = 0.5;
  EXPECT_GT (ending.sum(), sum);
  RegionEvidence small = evidence;
  small.size = 0.0;
  EXPECT_LT (small.sum(), sum);
}

TEST (LabelPlaces, GivesARoadThatLeansToBothSidesItsEdges)
{
  PlaceScene scene = crownedRoad (slight_crown);
  joinTouching (scene.places, one_thread, scene.regions);
  const Labels labels = labelsOf (scene, arePlanes (scene));
  ASSERT_EQ (labels.size(), scene.places.size());
  EXPECT_LT (std::count (labels.begin(), labels.end(), no_plane), 200) << "of 17,778";
}

TEST (LabelPlaces, GivesNearlyEachPlaceOfTwoPlanesToOneOfThem)
{
  PlaceScene scene = groundInTwo();
  const Labels labels = labelsOf (scene, both_are_planes);
  std::size_t labeled = 0;
  for (const std::int32_t label : labels)
    labeled += label != no_plane;
  EXPECT_GT (static_cast<double> (labeled), 0.99 * scene.places.size());
}

TEST (LabelPlaces, GivesAPlaceToTheNearerOfTwoPlanesThatScatterAlike)
{
  PlaceScene scene = groundInTwo();
  Region& left = scene.regions.list[0];
  Region& right = scene.regions.list[1];
  left.fit.plane.offset += 4_mm;
  left.scatter = right.scatter = 1_cm; // more than the noise of any place
  const Labels labels = labelsOf (scene, both_are_planes);
  std::size_t on_left = 0;
  for (const std::uint32_t i : placesOfEither (scene)) {
    const Eigen::Vector3d& position = scene.places.position[i];
    const bool is_left_nearer = std::abs (left.fit.plane.distance (position)) <
                                std::abs (right.fit.plane.distance (position));
    on_left += is_left_nearer;
    EXPECT_EQ (labels[i], is_left_nearer ? 0 : 1);
  }
  EXPECT_GT (on_left, 10u);
}

TEST (LabelPlaces, GivesAPlaceOnTwoPlanesToTheOneThatScattersLess)
{
  PlaceScene scene = groundInTwo();
  scene.regions.list[0].fit = scene.regions.list[1].fit;
  scene.regions.list[0].scatter = 1_cm;
  scene.regions.list[1].scatter = 2_cm;
  const Labels labels = labelsOf (scene, both_are_planes);
  const Indices of_either = placesOfEither (scene);
  EXPECT_GT (of_either.size(), 100u);
  for (const std::uint32_t i : of_either)
    EXPECT_EQ (labels[i], 0);
}

TEST (LabelPlaces, GivesNoneToWhatIsNoPlane)
{
  PlaceScene scene = groundInTwo();
  const Labels labels = labelsOf (scene, right_is_plane);
  EXPECT_GT (std::count (labels.begin(), labels.end(), 1), 4000) << "of the right";
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (scene.places.position[i].x() < 0.5) {
      ASSERT_EQ (labels[i], no_plane);
    }
}

TEST (LabelPlaces, KeepsAGivenDistance)
{
  PlaceScene scene = groundInTwo();
  const Labels labels = labelsOf (scene, both_are_planes, 1_mm);
  EXPECT_LT (std::count (labels.begin(), labels.end(), no_plane), 9000)
      << "of 10,000, a third of which are within half of the noise";
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != no_plane) {
      ASSERT_LT (std::abs (scene.places.position[i].z()), 1.2e-3)
          << "1 mm and a little tilt";
    }
}
