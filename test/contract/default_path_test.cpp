// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "presets.h"
#include "scene.h"

#include <set>

using pcl_ops::MergingParameters;
using pcl_ops::PlaneSegment;

// The stages of OPS on surfels, seen from outside.

namespace {

/** \brief Beyond a ditch of a metre a floor goes on 1 cm higher: two planes, as nothing
 * connects them, but no two surfaces to merging, which allows 1.5 times the noise of
 * 2 cm. */
Ops
onTwoHalves ()
{
  return defaultsOn (Scene()
                         .floor (2, 3)
                         .surface ({3, 0, 1_cm}, {2, 0, 0}, {0, 3, 0})
                         .noise (2_cm)
                         .build()
                         .cloud);
}

MergingParameters
noMerging ()
{
  MergingParameters merging;
  merging.enabled = false;
  return merging;
}

/** \brief Two table tops of one height with the floor below. */
LabelledScene
twoTables ()
{
  return Scene()
      .surface ({-1.2, -0.4, 1}, {0.9, 0, 0}, {0, 0.9, 0})
      .surface ({0.3, -0.4, 1}, {0.9, 0, 0}, {0, 0.9, 0})
      .surface ({-2, -2, 0}, {4, 0, 0}, {0, 4, 0})
      .build();
}

/** \brief The parts of a scene that have points on a plane. */
std::set<int>
partsOf (const PlaneSegment& plane, const LabelledScene& scene)
{
  std::set<int> parts;
  for (const pcl::index_t i : plane.inliers)
    parts.insert (scene.labels[static_cast<std::size_t> (i)]);
  return parts;
}

} // namespace

TEST (DefaultPath, MergesHalvesOfOneFloorBeforePointsAreAssigned)
{
  Ops ops = onTwoHalves();
  const auto planes = planesOf (ops);
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_EQ (ops.getNumberOfPlanesBeforeMerging(), 2u);
  // Each half has its points on the one plane, which lies between them.
  EXPECT_GE (planes[0].inliers.size(), 0.9 * ops.getInputCloud()->size());
  EXPECT_NEAR (planes[0].centroid.z(), 10_mm, 5_mm);
  ops.setMergingParameters (noMerging());
  EXPECT_EQ (planesOf (ops).size(), 2u);
}

TEST (DefaultPath, MergesByADistanceThatIsGiven)
{
  Ops ops = onTwoHalves();
  const auto planes = inliersOf (ops);
  MergingParameters merging;
  ops.setMergingParameters (merging);
  EXPECT_EQ (inliersOf (ops), planes) << "nobody changed them";
  merging.noise_factor = 0.0;
  merging.distance_threshold = 1_mm;
  ops.setMergingParameters (merging);
  EXPECT_EQ (planesOf (ops).size(), 2u);
  merging.distance_threshold = 10_cm;
  ops.setMergingParameters (merging);
  EXPECT_EQ (planesOf (ops).size(), 1u);
}

TEST (DefaultPath, TakesSurfacesInOnePlaneForOne)
{
  const LabelledScene scene = twoTables();
  Ops ops = defaultsOn (scene.cloud);
  std::set<std::set<int>> parts;
  for (const PlaneSegment& plane : planesOf (ops))
    parts.insert (partsOf (plane, scene));
  EXPECT_EQ (parts, (std::set<std::set<int>>{{0, 1}, {2}}));
}

TEST (DefaultPath, EndsAPlaneWhereItsPointsEnd)
{
  // A chair leg ends at the floor's height, a metre beyond the floor.
  const auto scene =
      Scene().floor (2, 2).surface ({3, 0, -0.4}, {0.04, 0, 0}, {0, 0, 0.8}).build();
  Ops ops = defaultsOn (scene.cloud);
  const auto planes = planesOf (ops);
  ASSERT_GE (planes.size(), 1u);
  EXPECT_EQ (partsOf (planes[0], scene), std::set<int>{0});
}

TEST (DefaultPath, FollowsAThresholdForEveryPoint)
{
  const auto scene = Scene().floor (3, 3).noise (1_cm).build();
  Ops ops = defaultsOn (scene.cloud);
  const std::size_t without = planesOf (ops).at (0).inliers.size();
  ops.setDistanceThreshold (1_cm);
  const PlaneSegment held = planesOf (ops).at (0);
  EXPECT_LT (held.inliers.size(), without);
  for (const pcl::index_t i : held.inliers)
    EXPECT_LT (std::abs ((*scene.cloud)[i].z), 12_mm);
}
