// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/region_evidence.h"
#include "ops/region_joining.h"
#include "ops/region_labels.h"
#include "place_scene.h"

#include <cmath>

using namespace pcl_ops::internal;
using pcl_ops::Labels;
using pcl_ops::no_plane;

namespace {

const Surface wall_on_ground = {{0, 0, 0}, {2, 0, 0}, {0, 0, 2}};
const Surface ground_beyond_gap = {{3, 0, 0}, {2, 0, 0}, {0, 2, 0}};

// A ground whose points are two regions, left and right of x = 1 m.
PlaceScene
groundInTwo ()
{
  PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 2_mm));
  Region& left = scene.regions.list[0];
  scene.regions.list.resize (1);
  Region right = left;
  left.moments = right.moments = pcl_ops::Moments();
  for (std::size_t i = 0; i < scene.places.size(); ++i) {
    const Eigen::Vector3d& place = scene.places.position[i];
    const bool is_right = place.x() > 0.9;
    scene.regions.of_place[i] = is_right ? 1 : 0;
    (is_right ? right : left).moments.add (place.x(), place.y(), place.z());
  }
  left.refit();
  right.refit();
  scene.regions.list.push_back (right);
  return scene;
}

std::vector<char>
arePlanes (const PlaceScene& scene)
{
  return planesAmong (scene.places, scene.noise, scene.chosen, scene.regions, 1.0, 1);
}

} // namespace

TEST (GrowRegions, GrowToTheEdgeOfTwoWalls)
{
  const Coordinates points = drawnOn ({square_of_ground, wall_on_ground}, 2_cm, 2_mm);
  const std::vector<std::size_t> sizes = PlaceScene (points).sizes();
  ASSERT_GE (sizes.size(), 2u);
  for (int wall = 0; wall < 2; ++wall)
    EXPECT_NEAR (static_cast<double> (sizes[wall]), 1e4, 300.0);
}

TEST (GrowRegions, EndAtAGivenDistance)
{
  const PlaceScene scene (drawnOn ({square_of_ground}, 2_cm, 1_cm));
  const Regions regions = growRegions (scene.places, scene.noise, scene.chosen, 1_cm);
  for (std::size_t i = 0; i < scene.places.size(); ++i)
    if (regions.of_place[i] == 0) {
      ASSERT_LT (std::abs (scene.places.position[i].z()), 1.5e-2);
    }
}

TEST (JoinTouching, MakesOneOfPiecesOfAPlane)
{
  PlaceScene scene = groundInTwo();
  joinTouching (scene.places, 1, scene.regions);
  EXPECT_EQ (scene.sizes(), std::vector<std::size_t>{scene.places.size()});
  // The larger one, on the right, took the other.
  EXPECT_EQ (scene.regions.of_place, pcl_ops::Labels (scene.places.size(), 1));
}

TEST (JoinTouching, LeavesWallsThatMeetAlone)
{
  PlaceScene scene (drawnOn ({square_of_ground, wall_on_ground}, 2_cm, 2_mm));
  joinTouching (scene.places, 1, scene.regions);
  EXPECT_LT (scene.sizes().at (0), 10500u);
}

TEST (JoinTouching, MakesOneOfARoadThatLeansToBothSidesButNotOfARoof)
{
  // 4 m wide with 2 mm of noise: a crown of 3.5 cm, and one of 17 cm.
  for (const double height : {3.5e-2, 17e-2}) {
    const Surface left = {{-2, 0, 0}, {2, 0, height}, {0, 4, 0}};
    const Surface right = {{0, 0, height}, {2, 0, -height}, {0, 4, 0}};
    PlaceScene scene (drawnOn ({left, right}, 3_cm, 2_mm));
    ASSERT_LT (scene.sizes().at (0), 16000u) << height;
    joinTouching (scene.places, 1, scene.regions);
    EXPECT_EQ (scene.sizes().at (0) > 17000u, height < 5_cm) << height;
  }
}

TEST (JoinTouching, LeavesAStepOfTenNoises)
{
  const Surface higher = {{2, 0, 2_cm}, {2, 0, 0}, {0, 2, 0}};
  PlaceScene scene (drawnOn ({square_of_ground, higher}, 2_cm, 2_mm));
  joinTouching (scene.places, 1, scene.regions);
  EXPECT_LT (scene.sizes().at (0), 10500u);
}

TEST (JoinOverGaps, MakesOneOfExactGroundsThatContinueEachOther)
{
  PlaceScene scene (drawnOn ({square_of_ground, ground_beyond_gap}, 2_cm, 0.0));
  joinOverGaps ({}, scene.regions);
  EXPECT_GT (scene.sizes().at (0), 19500u);
}

TEST (LabelPlaces, GivesARoadThatLeansToBothSidesItsEdges)
{
  const Surface left = {{-2, 0, 0}, {2, 0, 3.5e-2}, {0, 4, 0}};
  const Surface right = {{0, 0, 3.5e-2}, {2, 0, -3.5e-2}, {0, 4, 0}};
  PlaceScene scene (drawnOn ({left, right}, 3_cm, 2_mm));
  joinTouching (scene.places, 1, scene.regions);
  const Labels labels = labelPlaces (
      scene.places, scene.noise, scene.regions, arePlanes (scene), std::nullopt, 1);
  EXPECT_LT (std::count (labels.begin(), labels.end(), no_plane), 200);
}

TEST (JoinOverGaps, MakesOneOfGroundsThatContinueEachOther)
{
  PlaceScene scene (drawnOn ({square_of_ground, ground_beyond_gap}, 2_cm, 2_mm));
  joinTouching (scene.places, 1, scene.regions);
  ASSERT_LT (scene.sizes().at (0), 10500u);
  joinOverGaps ({}, scene.regions);
  EXPECT_GT (scene.sizes().at (0), 19500u);
}

TEST (JoinOverGaps, LeavesAStepThatNoiseDoesNotExplain)
{
  Surface step = ground_beyond_gap;
  step.corner.z() = 3_cm;
  PlaceScene scene (drawnOn ({square_of_ground, step}, 2_cm, 2_mm));
  joinTouching (scene.places, 1, scene.regions);
  joinOverGaps ({}, scene.regions);
  EXPECT_LT (scene.sizes().at (0), 10500u);
}

TEST (JoinOverGaps, LeavesGroundsThatAreTwiceAsFarApartAsTheyAreLong)
{
  // Centers 3 m apart, and 5 m.
  for (const double gap : {1.0, 3.0}) {
    const Surface beyond = {{2.0 + gap, 0, 0}, {2, 0, 0}, {0, 2, 0}};
    PlaceScene scene (drawnOn ({square_of_ground, beyond}, 3_cm, 2_mm));
    joinTouching (scene.places, 1, scene.regions);
    joinOverGaps ({}, scene.regions);
    EXPECT_EQ (scene.sizes().at (0) > 5000u, gap < 2.0) << gap;
  }
}

TEST (JoinOverGaps, LeavesAStepOfThreeNoises)
{
  for (const double step : {2_mm, 6_mm}) {
    Surface beyond = ground_beyond_gap;
    beyond.corner.z() = step;
    PlaceScene scene (drawnOn ({square_of_ground, beyond}, 3_cm, 2_mm));
    joinTouching (scene.places, 1, scene.regions);
    joinOverGaps ({}, scene.regions);
    EXPECT_EQ (scene.sizes().at (0) > 5000u, step < 4_mm) << step;
  }
}

TEST (JoinOverGaps, LeavesGroundsThatLeanByMoreThanTheGivenAngle)
{
  Surface beyond = ground_beyond_gap; // leans by a fifth of a degree about its middle
  beyond.first.z() = 2.0 * std::tan (0.2_deg);
  beyond.corner.z() = -std::tan (0.2_deg);
  for (const double degrees : {0.1, 1.0}) {
    PlaceScene scene (drawnOn ({square_of_ground, beyond}, 2_cm, 1_cm));
    joinTouching (scene.places, 1, scene.regions);
    pcl_ops::MergingParameters merging;
    merging.angle_threshold = degrees * 1_deg;
    joinOverGaps (merging, scene.regions);
    EXPECT_EQ (scene.sizes().at (0) > 12000u, degrees > 0.5) << degrees;
  }
}

TEST (RegionEvidence, IsForAPlaneAndAgainstFacetsOfABall)
{
  const PlaceScene ground (drawnOn ({square_of_ground}, 2_cm, 2_mm));
  const std::vector<char> planes = arePlanes (ground);
  ASSERT_FALSE (planes.empty());
  EXPECT_EQ (planes[0], 1);
  Coordinates ball;
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 20000; ++i) {
    const Eigen::Vector3d point =
        (1.0 + 1_mm * drawNormal (generator)) * drawNormals (generator).normalized();
    const pcl::PointXYZ p = toPoint (point);
    ball.add (p.x, p.y, p.z);
  }
  const PlaceScene facets (ball);
  const std::vector<char> none = arePlanes (facets);
  EXPECT_EQ (std::count (none.begin(), none.end(), 1), 0);
}

TEST (RegionEvidence, AddsUpWhatSpeaksForAndAgainst)
{
  RegionEvidence evidence;
  evidence.size = 1.0;
  const double usual = evidence.sum();
  EXPECT_GT (usual, 0.0);
  RegionEvidence bent = evidence;
  bent.bend = 2.0;
  EXPECT_LT (bent.sum(), usual);
  RegionEvidence goes_on = evidence;
  goes_on.smooth_border = 0.5;
  EXPECT_LT (goes_on.sum(), usual);
  RegionEvidence ends = evidence;
  ends.open_border = 0.5;
  EXPECT_GT (ends.sum(), usual);
  RegionEvidence small = evidence;
  small.size = 0.0;
  EXPECT_LT (small.sum(), usual);
}

TEST (LabelPlaces, GivesEachPlaceToTheLikeliestPlane)
{
  PlaceScene scene = groundInTwo();
  const Labels labels =
      labelPlaces (scene.places, scene.noise, scene.regions, {1, 1}, std::nullopt, 1);
  std::size_t labelled = 0;
  for (const std::int32_t label : labels)
    labelled += label != no_plane;
  EXPECT_GT (static_cast<double> (labelled), 0.99 * scene.places.size());
}

TEST (LabelPlaces, GivesNoneToWhatIsNoPlane)
{
  PlaceScene scene = groundInTwo();
  const Labels labels =
      labelPlaces (scene.places, scene.noise, scene.regions, {0, 1}, std::nullopt, 1);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (scene.places.position[i].x() < 0.5) {
      ASSERT_EQ (labels[i], no_plane);
    }
}

TEST (LabelPlaces, KeepsAGivenDistance)
{
  PlaceScene scene = groundInTwo();
  const Labels labels =
      labelPlaces (scene.places, scene.noise, scene.regions, {1, 1}, 1_mm, 1);
  for (std::size_t i = 0; i < labels.size(); ++i)
    if (labels[i] != no_plane) {
      ASSERT_LT (std::abs (scene.places.position[i].z()), 1.2e-3);
    }
}
