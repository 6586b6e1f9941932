// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/leaf_halving.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

bool
isOpenLeaf (const Eigen::Vector3d& at)
{
  return std::abs (at.x() - 1.05) < 0.04 && std::abs (at.y() - 1.05) < 0.04;
}

/** \brief A ground on a plane but for one leaf in its middle. */
void
openInTheMiddle (LeafScene& scene)
{
  scene.addPlane (ground, 5_mm, anywhere);
  scene.label (no_plane, 0.0, isOpenLeaf);
}

std::size_t
leavesOfLevel (const HalvedLeaves& next, int level)
{
  return static_cast<std::size_t> (
      std::count_if (next.leaves.begin(), next.leaves.end(), [&] (const Leaf& leaf) {
        return leaf.level == level;
      }));
}

} // namespace

TEST (LeafHalving, DividesLeavesWithoutAPlaneAndThoseThatTouchThem)
{
  LeafScene scene ({ground});
  openInTheMiddle (scene);
  const HalvedLeaves next = halveOpenLeaves (scene.cloud, scene.planes);
  EXPECT_EQ (leavesOfLevel (next, level_of_10_cm), 391u);
  EXPECT_EQ (leavesOfLevel (next, level_of_10_cm - 1), 4 * 9u);
}

TEST (LeafHalving, LeavesAllAsTheyAreWhereEachIsOnAPlane)
{
  LeafScene scene ({ground});
  scene.addPlane (ground, 5_mm, anywhere);
  const HalvedLeaves next = halveOpenLeaves (scene.cloud, scene.planes);
  EXPECT_EQ (leavesOfLevel (next, level_of_10_cm), 400u);
  EXPECT_EQ (next.planes.plane_of_leaf, scene.planes.plane_of_leaf);
  EXPECT_EQ (next.planes.noise, scene.planes.noise);
  EXPECT_EQ (next.planes.planes.size(), 1u);
}

TEST (LeafHalving, HasHalvesKeepThePlaneThatTheirPointsLieOn)
{
  // Half of a leaf beside the open one lies 4 cm higher.
  Coordinates points = gridsOf ({ground}, 120);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.x[i] > 0.95f && points.x[i] < 1.0f && points.y[i] > 1.0f &&
        points.y[i] < 1.1f)
      points.z[i] += 0.04f;
  LeafScene scene (points);
  openInTheMiddle (scene);
  const HalvedLeaves next = halveOpenLeaves (scene.cloud, scene.planes);
  const LeafCloud halved = scene.measured (next.leaves);
  for (std::size_t leaf = 0; leaf < halved.size(); ++leaf) {
    const Eigen::Vector3d at = halved.moments[leaf].centroid();
    const bool is_off = at.z() > 0.06 || (std::abs (at.x() - 1.05) < 0.05 &&
                                          std::abs (at.y() - 1.05) < 0.05);
    EXPECT_EQ (next.planes.plane_of_leaf[leaf], is_off ? no_plane : 0);
    EXPECT_EQ (next.planes.noise[leaf], is_off ? 0.0 : 5_mm);
  }
  EXPECT_EQ (std::count (next.planes.plane_of_leaf.begin(),
                         next.planes.plane_of_leaf.end(),
                         no_plane),
             4 + 2);
}

TEST (LeafHalving, IsNotForWhatIsCurved)
{
  LeafScene scene ({ground});
  openInTheMiddle (scene);
  scene.planes.is_curved.assign (scene.cloud.size(), 1);
  const HalvedLeaves next = halveOpenLeaves (scene.cloud, scene.planes);
  EXPECT_EQ (next.leaves.size(), 400u);
  EXPECT_EQ (next.planes.is_curved, scene.planes.is_curved);
}

TEST (LeafHalving, IsNotForTheSmallestLeavesNorThoseOfAPoint)
{
  LeafScene smallest (gridsOf ({ground}, 360), 1_mm, {0, 0, 0.0});
  openInTheMiddle (smallest);
  EXPECT_EQ (halveOpenLeaves (smallest.cloud, smallest.planes).leaves.size(),
             smallest.cloud.size());
  LeafScene sparse (gridsOf ({ground}, 20));
  EXPECT_EQ (sparse.cloud.size(), 400u);
  EXPECT_EQ (halveOpenLeaves (sparse.cloud, sparse.planes).leaves.size(), 400u);
}
