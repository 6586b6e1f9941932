// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/leaf_spreading.h"

#include <set>

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

// 25 leaves.
const Surface tile_of_25 = {{3, 0, 0.05}, {0.5, 0, 0}, {0, 0.5, 0}};

LeafSpreadParameters
usualSpread (double min_leaves = 20.0)
{
  return {0.265, min_leaves, 1.73, 30_deg};
}

/** \brief Spreads planes from the surfels that leaves have. */
void
spreadIn (LeafScene& scene, const LeafSpreadParameters& parameters = usualSpread())
{
  const auto surfels = orientLeaves (scene.cloud, scene.planes, {30.0, 4}, 1);
  spreadPlanes (scene.cloud, surfels, parameters, scene.planes);
}

/** \brief Every leaf with a surfel through its centroid that a test may change.
 * \param[in] change (surfel, centroid) */
template <typename Change>
std::vector<LeafSurfel>
surfelsThrough (const LeafScene& scene, Change&& change)
{
  std::vector<LeafSurfel> surfels (scene.cloud.size());
  for (std::size_t leaf = 0; leaf < surfels.size(); ++leaf) {
    surfels[leaf].thickness = 0.0;
    change (surfels[leaf], scene.centroid (leaf));
    surfels[leaf].plane =
        pcl_ops::planeThrough (scene.centroid (leaf), surfels[leaf].plane.normal);
  }
  return surfels;
}

/** \brief Half a barrel of a radius, 2 m long. */
Coordinates
halfBarrel (double radius)
{
  Coordinates points;
  for (int i = 0; i < 400; ++i)
    for (int j = 0; j < 200; ++j)
      points.add (static_cast<float> (radius * std::cos (pi * i / 400)),
                  static_cast<float> (radius * std::sin (pi * i / 400)),
                  static_cast<float> (0.01 * j));
  return points;
}

/** \brief A normal that leans towards x. */
Eigen::Vector3d
leaningBy (double angle)
{
  return {std::sin (angle), 0, std::cos (angle)};
}

} // namespace

TEST (LeafSpreading, StopsAtACrease)
{
  LeafScene scene ({ground, wall}, 5_mm);
  spreadIn (scene);
  ASSERT_EQ (scene.planes.planes.size(), 2u);
  const bool is_ground_first = std::abs (scene.planes.planes[0].normal.z()) > 0.5;
  const std::int32_t of_ground = is_ground_first ? 0 : 1;
  EXPECT_GE (scene.leavesOn (0), 360u);
  EXPECT_GE (scene.leavesOn (1), 360u);
  for (std::size_t leaf = 0; leaf < scene.cloud.size(); ++leaf) {
    const std::int32_t plane = scene.planes.plane_of_leaf[leaf];
    EXPECT_FALSE (plane == of_ground && scene.centroid (leaf).z() > 0.1);
    EXPECT_FALSE (plane == 1 - of_ground && scene.centroid (leaf).x() > 0.1);
  }
}

TEST (LeafSpreading, TellsFloorAndCeilingApart)
{
  LeafScene scene ({ground, {{0, 0, 2.55}, {2, 0, 0}, {0, 2, 0}}}, 5_mm);
  spreadIn (scene);
  ASSERT_EQ (scene.planes.planes.size(), 2u);
  EXPECT_EQ (scene.leavesOn (0), 400u);
  EXPECT_EQ (scene.leavesOn (1), 400u);
}

TEST (LeafSpreading, StopsAtAStepOfManyTimesTheNoise)
{
  LeafScene scene ({ground, {{2, 0, 0.09}, {2, 0, 0}, {0, 2, 0}}}, 3_mm);
  spreadIn (scene);
  ASSERT_EQ (scene.planes.planes.size(), 2u);
  std::set<std::pair<std::int32_t, bool>> sides;
  for (std::size_t leaf = 0; leaf < scene.cloud.size(); ++leaf)
    if (scene.planes.plane_of_leaf[leaf] != no_plane)
      sides.emplace (scene.planes.plane_of_leaf[leaf], scene.centroid (leaf).x() < 2.0);
  EXPECT_EQ (sides.size(), 2u) << "each plane is on one side alone";
}

TEST (LeafSpreading, AsksForConnectedLeaves)
{
  // A tile, alone and a meter beyond the end of the ground, in its plane.
  for (const bool has_ground : {false, true})
    for (const double least : {25.0, 26.0}) {
      Coordinates points = gridsOf ({tile_of_25}, 30);
      if (has_ground)
        addGrid (points, ground, 120);
      LeafScene scene (points);
      spreadIn (scene, usualSpread (least));
      EXPECT_EQ (scene.leavesOn (no_plane), least > 25.0 ? 25u : 0u);
    }
}

TEST (LeafSpreading, FindsNoPlaneInABarrelAndSaysThatItIsCurved)
{
  LeafScene scene (halfBarrel (60_cm));
  spreadIn (scene);
  EXPECT_LT (scene.leavesOn (no_plane), scene.cloud.size() + 1);
  EXPECT_GT (scene.leavesOn (no_plane), 0.7 * scene.cloud.size());
  const auto curved = std::count (
      scene.planes.is_curved.begin(), scene.planes.is_curved.end(), char{1});
  EXPECT_GT (curved, 0.4 * scene.cloud.size());
  LeafScene flat ({ground}, 5_mm);
  spreadIn (flat);
  EXPECT_EQ (flat.planes.is_curved, std::vector<char> (400, 0));
}

TEST (LeafSpreading, BeginsWithTheFlattestSurfels)
{
  for (const double flat : {0.0, 0.1}) {
    LeafScene scene (gridsOf ({ground, tile_of_25}, 120));
    const auto surfels =
        surfelsThrough (scene, [flat] (LeafSurfel& surfel, const auto& at) {
          surfel.thickness = at.x() < 2.5 ? flat : 0.05;
        });
    spreadPlanes (scene.cloud, surfels, usualSpread(), scene.planes);
    EXPECT_EQ (scene.leavesOn (0), flat < 0.05 ? 400u : 25u);
    EXPECT_EQ (scene.leavesOn (1), flat < 0.05 ? 25u : 400u);
  }
}

TEST (LeafSpreading, AddsToPlanesFoundBefore)
{
  // The left half of the ground is on a plane already; the right one is found now.
  LeafScene scene ({ground});
  scene.addPlane ({Eigen::Vector3d::UnitX(), 7.0}, 1_cm, before (1.0));
  spreadIn (scene);
  ASSERT_EQ (scene.planes.planes.size(), 2u);
  EXPECT_EQ (scene.planes.planes[0].offset, 7.0);
  for (std::size_t leaf = 0; leaf < 400; ++leaf)
    EXPECT_EQ (scene.planes.plane_of_leaf[leaf],
               scene.centroid (leaf).x() < 1.0 ? 0 : 1);
}

TEST (LeafSpreading, LeavesOutSurfelsThatLean)
{
  // The right half of the ground with normals of 40 degrees, and later in turn.
  for (const double max_angle : {30_deg, 50_deg}) {
    LeafScene scene ({ground});
    const auto surfels =
        surfelsThrough (scene, [] (LeafSurfel& surfel, const auto& at) {
          surfel.plane.normal = leaningBy (at.x() < 1.0 ? 0.0 : 40_deg);
          surfel.thickness = at.x() < 1.0 ? 0.0 : 0.1;
        });
    LeafSpreadParameters parameters = usualSpread();
    parameters.max_angle = max_angle;
    spreadPlanes (scene.cloud, surfels, parameters, scene.planes);
    EXPECT_EQ (scene.leavesOn (0), max_angle < 40_deg ? 200u : 400u);
  }
}

TEST (LeafSpreading, LeavesOutThickSurfelsAndLeavesWithoutOne)
{
  for (const double thickness : {0.3, 1.0}) {
    LeafScene scene ({ground});
    const auto surfels =
        surfelsThrough (scene, [&] (LeafSurfel& surfel, const auto& at) {
          surfel.thickness = at.x() < 0.5 ? thickness : 0.2;
        });
    spreadPlanes (scene.cloud, surfels, usualSpread(), scene.planes);
    EXPECT_EQ (scene.leavesOn (0), 300u);
    EXPECT_EQ (scene.leavesOn (no_plane), 100u);
  }
}

TEST (LeafSpreading, RefitsAPlaneOnItsWay)
{
  // Every surfel leans by 1 degree: the plane of any leaves the ground after 20 cm.
  LeafScene scene ({ground});
  const auto surfels = surfelsThrough (scene, [] (LeafSurfel& surfel, const auto&) {
    surfel.plane.normal = leaningBy (1_deg);
  });
  spreadPlanes (scene.cloud, surfels, usualSpread (400), scene.planes);
  ASSERT_EQ (scene.planes.planes.size(), 1u);
  EXPECT_EQ (scene.leavesOn (0), 400u);
  EXPECT_TRUE (isNear (scene.planes.planes[0], ground, 1e-3, 1e-3));
}

TEST (LeafSpreading, TakesLittleMoreThanTheNoiseOfTheLeafBefore)
{
  // The last row has surfels of 10 cm of noise, as next to another surface, and lies
  // off the plane by 1.5 or 6 times the noise of 1 cm before it.
  for (const double off : {1.5e-2, 6e-2}) {
    Coordinates points = gridsOf ({ground}, 120);
    for (std::size_t i = 0; i < points.size(); ++i)
      if (points.x[i] > 1.9f)
        points.z[i] += static_cast<float> (off);
    LeafScene scene (points);
    const auto surfels =
        surfelsThrough (scene, [] (LeafSurfel& surfel, const auto& at) {
          surfel.noise = at.x() > 1.9 ? 10_cm : 1_cm;
          surfel.thickness = at.x() > 1.9 ? 0.1 : 0.0;
        });
    spreadPlanes (scene.cloud, surfels, usualSpread (21), scene.planes);
    EXPECT_EQ (scene.leavesOn (0), off < 3e-2 ? 400u : 380u);
  }
}

TEST (LeafSpreading, SaysTheNoiseOfTheLeaves)
{
  LeafScene scene ({ground}, 1_cm);
  spreadIn (scene);
  for (std::size_t leaf = 0; leaf < 400; ++leaf)
    if (scene.planes.plane_of_leaf[leaf] != no_plane) {
      EXPECT_NEAR (scene.planes.noise[leaf], 5.8e-3, 2e-3);
    }
}
