// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/leaf_labels.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief A ground that lies higher by 3 cm from x = 95 cm on: where the leaves of its
 * second plane begin 5 cm farther. */
Coordinates
groundWithAStep ()
{
  Coordinates points = gridsOf ({ground}, 120);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.x[i] > 0.95f)
      points.z[i] += 0.03f;
  return points;
}

const pcl_ops::Plane lower = {Eigen::Vector3d::UnitZ(), -0.05};
const pcl_ops::Plane upper = {Eigen::Vector3d::UnitZ(), -0.08};

std::size_t
withLabel (const pcl_ops::Labels& labels, std::int32_t label)
{
  return static_cast<std::size_t> (std::count (labels.begin(), labels.end(), label));
}

} // namespace

TEST (LeafLabels, AreThoseOfTheNearerOfTwoEquallyNoisyPlanes)
{
  LeafScene scene (groundWithAStep());
  scene.addPlane (lower, 1_cm, before (1.0));
  scene.addPlane (upper, 1_cm, behind (1.0));
  const pcl_ops::Labels labels =
      labelPoints (scene.cloud, scene.planes, 3.45, std::nullopt, 1);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    ASSERT_EQ (labels[i], scene.points.x[i] < 0.95f ? 0 : 1);
}

TEST (LeafLabels, WeighDistancesByTheNoise)
{
  // Halfway between both planes: likelier on the one of more noise, which still has a
  // larger distance to it.
  Coordinates points = gridsOf ({ground}, 120);
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] += 0.015f;
  LeafScene scene (points);
  scene.addPlane (lower, 5_mm, before (1.0));
  scene.addPlane (upper, 2_cm, behind (1.0));
  const pcl_ops::Labels labels =
      labelPoints (scene.cloud, scene.planes, 3.45, std::nullopt, 1);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    if (scene.points.x[i] > 0.9f) {
      ASSERT_EQ (labels[i], 1) << "of a leaf that touches both";
    }
  EXPECT_EQ (withLabel (labels, 0), 120 * 54u);
}

TEST (LeafLabels, AreThoseOfTheLessNoisyOfTwoPlanesThatAreNear)
{
  LeafScene scene ({ground});
  scene.addPlane (lower, 2_cm, before (1.0));
  scene.addPlane (lower, 5_mm, behind (1.0));
  const pcl_ops::Labels labels =
      labelPoints (scene.cloud, scene.planes, 3.45, std::nullopt, 1);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    ASSERT_EQ (labels[i], scene.points.x[i] < 0.9f ? 0 : 1);
}

TEST (LeafLabels, AreOfPointsWithinSomeTimesTheNoise)
{
  // Points from -6 cm to 6 cm, of a plane with a noise of 1 cm.
  for (const double factor : {2.0, 4.0}) {
    LeafScene scene ({ground}, 6_cm);
    scene.addPlane (lower, 1_cm, anywhere);
    const pcl_ops::Labels labels =
        labelPoints (scene.cloud, scene.planes, factor, std::nullopt, 1);
    for (std::size_t i = 0; i < scene.points.size(); ++i) {
      const double distance = std::abs (lower.distance (scene.points[i]));
      if (distance > factor * 1_cm + 1e-6) {
        ASSERT_EQ (labels[i], no_plane);
      }
    }
    EXPECT_NEAR (withLabel (labels, 0), 14400 * factor / 6.0, 300);
  }
}

TEST (LeafLabels, KeepThePromiseOfADistanceThreshold)
{
  // A leaf of which nearly all points are on the plane is no exception.
  LeafScene scene ({ground}, 1_cm);
  scene.addPlane (lower, 6_mm, anywhere);
  const pcl_ops::Labels labels = labelPoints (scene.cloud, scene.planes, 3.45, 4_mm, 1);
  for (std::size_t i = 0; i < scene.points.size(); ++i) {
    const double distance = std::abs (lower.distance (scene.points[i]));
    ASSERT_EQ (labels[i], distance < 4_mm ? 0 : no_plane);
  }
  EXPECT_NEAR (withLabel (labels, 0), 0.4 * 14400, 300);
}

TEST (LeafLabels, OfWholeLeavesAreThoseOfTheirPlane)
{
  LeafScene scene ({ground}, 1_cm);
  scene.addPlane (lower, 6_mm, anywhere);
  EXPECT_EQ (
      withLabel (labelPoints (scene.cloud, scene.planes, 3.45, std::nullopt, 1), 0),
      14400u);
}

TEST (LeafLabels, AreOfThePlanesOfTheLeafAndThoseThatTouchIt)
{
  LeafScene scene ({ground});
  scene.addPlane (lower, 1_cm, before (1.0));
  const pcl_ops::Labels labels =
      labelPoints (scene.cloud, scene.planes, 3.45, std::nullopt, 1);
  for (std::size_t i = 0; i < scene.points.size(); ++i)
    ASSERT_EQ (labels[i], scene.points.x[i] < 1.1f ? 0 : no_plane);
}

TEST (LeafLabels, AreTheSameForAnyNumberOfThreads)
{
  LeafScene scene (groundWithAStep());
  scene.addPlane (lower, 1_cm, before (1.0));
  scene.addPlane (upper, 2_cm, behind (1.0));
  const auto by = [&] (unsigned threads) {
    return labelPoints (scene.cloud, scene.planes, 3.45, std::nullopt, threads);
  };
  EXPECT_EQ (by (2), by (1));
  EXPECT_EQ (by (3), by (1));
}

TEST (LeafLabels, AreCounted)
{
  EXPECT_EQ (countLabels ({0, 2, no_plane, 2}, 4),
             (std::vector<std::size_t>{1, 0, 2, 0}));
}
