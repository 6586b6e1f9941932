// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/leaf_noise.h"
#include "leaves/plane_evidence.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Which planes of a scene are kept, of as many points as their leaves hold. */
std::vector<char>
keptIn (LeafScene& scene)
{
  refitPlanes (scene.cloud, scene.planes);
  measureNoise (scene.cloud, 1, scene.planes);
  std::vector<std::size_t> points;
  for (const pcl_ops::Moments& moments : momentsOfPlanes (scene.cloud, scene.planes))
    points.push_back (static_cast<std::size_t> (moments.count));
  const auto surfels = orientLeaves (scene.cloud, scene.planes, {30.0, 4}, 1);
  return keptPlanes (scene.cloud, scene.planes, surfels, points);
}

} // namespace

TEST (PlaneEvidence, KeepsPlanesThatEndAtACorner)
{
  LeafScene scene ({ground, wall}, 5_mm);
  scene.addPlane (ground, 0.0, [] (const auto& at) { return at.z() < 0.1; });
  scene.addPlane (wall, 0.0, [] (const auto& at) { return at.z() >= 0.1; });
  EXPECT_EQ (keptIn (scene), (std::vector<char>{1, 1}));
}

TEST (PlaneEvidence, KeepsTheFacesOfARoofThatMeetAtACrease)
{
  LeafScene scene (pointsOver (
      1_m, 1_cm, [] (double x, double) { return 1.0 - 0.5 * std::abs (x); }));
  scene.addPlane (ground, 0.0, before (0.0));
  scene.addPlane (ground, 0.0, behind (0.0));
  EXPECT_EQ (keptIn (scene), (std::vector<char>{1, 1}));
}

TEST (PlaneEvidence, DropsTheFacetsOfASmoothCylinder)
{
  // A barrel in five strips of 40 cm, which bend by 2 cm: visible by itself, or hidden
  // by noise, so that only what lies beyond tells.
  for (const double noise : {2_mm, 2_cm}) {
    LeafScene scene (pointsOver (
        1_m, noise, [] (double x, double) { return std::sqrt (1.1 * 1.1 - x * x); }));
    for (const double x : {-1.0, -0.6, -0.2, 0.2, 0.6})
      scene.addPlane (ground, 0.0, [x] (const auto& at) {
        return at.x() >= x && at.x() < x + 0.4;
      });
    const std::vector<char> kept = keptIn (scene);
    EXPECT_EQ (kept, std::vector<char> (5, 0)) << noise;
  }
}

TEST (PlaneEvidence, DropsAFacetWhoseSurroundingsHaveNoPlane)
{
  LeafScene scene (pointsOver (
      1_m, 2_mm, [] (double x, double) { return std::sqrt (1.1 * 1.1 - x * x); }));
  scene.addPlane (ground, 0.0, [] (const auto& at) { return std::abs (at.x()) < 0.2; });
  EXPECT_EQ (keptIn (scene), std::vector<char>{0});
}

TEST (PlaneEvidence, DropsAPatchAroundWhichNothingHasASurface)
{
  // A patch of 24 cm that ends at a step of 6 cm, to a ground or to leaves without
  // normals, as in the crown of a tree.
  const auto isPatch = [] (double x, double y) {
    return std::abs (x) < 0.12 && std::abs (y) < 0.12;
  };
  LeafScene scene (pointsOver (
      1_m, 2_mm, [&] (double x, double y) { return isPatch (x, y) ? 6_cm : 0.0; }));
  scene.addPlane (
      ground, 0.0, [&] (const auto& at) { return isPatch (at.x(), at.y()); });
  EXPECT_EQ (keptIn (scene), std::vector<char>{1});
  const std::vector<LeafSurfel> none (scene.cloud.size());
  EXPECT_EQ (keptPlanes (scene.cloud, scene.planes, none, {1000}),
             std::vector<char>{0});
}

TEST (PlaneEvidence, KeepsAShelfBelowClutter)
{
  // What lies 6 cm above is near, and turned by 8 degrees: a continuation, were it
  // beside the shelf.
  Coordinates points = pointsOver (40_cm, 2_cm, [] (double, double) { return 5_cm; });
  const Coordinates above =
      pointsOver (40_cm, 2_cm, [] (double x, double) { return 15_cm + 0.14 * x; });
  for (std::size_t i = 0; i < above.size(); ++i)
    points.add (above.x[i], above.y[i], above.z[i]);
  LeafScene scene (points);
  scene.addPlane (ground, 0.0, [] (const auto& at) { return at.z() < 0.1; });
  EXPECT_EQ (keptIn (scene), std::vector<char>{1});
}

TEST (PlaneEvidence, DropsTinyPlanesAmongOthers)
{
  LeafScene scene ({ground}, 5_mm);
  scene.addPlane (ground, 0.0, anywhere);
  scene.addPlane (ground, 0.0, [] (const auto& at) {
    return std::abs (at.x() - 1.1) < 0.1 && std::abs (at.y() - 1.1) < 0.1;
  });
  EXPECT_EQ (scene.leavesOn (1), 4u);
  EXPECT_EQ (keptIn (scene), (std::vector<char>{1, 0}));
}

TEST (PlaneEvidence, KeepsANarrowStripWhereItEndsAtSteps)
{
  // Two leaves wide, 8 cm above the ground on both sides or at its height.
  for (const double height : {8_cm, 0_cm}) {
    const auto isStrip = [] (const auto& at) { return at.x() > 1.0 && at.x() < 1.2; };
    RandomGenerator generator (seedOfTest());
    Coordinates points;
    for (int i = 0; i < 14400; ++i) {
      const Eigen::Vector3d at = drawPointOf (ground, 3_mm, generator);
      const pcl::PointXYZ point =
          toPoint (at + Eigen::Vector3d (0, 0, isStrip (at) ? height : 0.0));
      points.add (point.x, point.y, point.z);
    }
    LeafScene scene (points);
    scene.addPlane (ground, 0.0, anywhere);
    scene.addPlane (ground, 0.0, isStrip);
    EXPECT_EQ (keptIn (scene), (std::vector<char>{1, height > 0.0}));
  }
}

TEST (PlaneEvidence, DropsPlanesOfAFewPointsAndOfNoLeaves)
{
  LeafScene scene ({ground}, 5_mm);
  scene.addPlane (ground, 5_mm, anywhere);
  scene.addPlane (ground, 5_mm, [] (const auto&) { return false; });
  const std::vector<LeafSurfel> surfels (scene.cloud.size());
  EXPECT_EQ (keptPlanes (scene.cloud, scene.planes, surfels, {14400, 14400}),
             (std::vector<char>{1, 0}));
  EXPECT_EQ (keptPlanes (scene.cloud, scene.planes, surfels, {5, 0}),
             (std::vector<char>{0, 0}));
}

TEST (PlaneEvidence, OfALongBorderIsToldBySomeOfItsLeaves)
{
  // Strips, two leaves wide, of a ground: nearly all leaves are border. Eight times as
  // many are worth 2.8 for a decade of leaves, and nothing else.
  std::vector<double> evidence;
  for (const double end : {-3.0, 4.0}) {
    LeafScene scene (pointsOver (4_m, 1_cm, [] (double, double) { return 0.05; }));
    scene.addPlane ({Eigen::Vector3d::UnitZ(), -0.05}, 1_mm, [end] (const auto& at) {
      return at.x() < end && static_cast<int> (std::floor (at.y() / 0.2)) % 2 == 0;
    });
    const std::vector<LeafSurfel> none (scene.cloud.size());
    const PlaneParts parts = partsOfPlanes (scene.cloud, scene.planes).at (0);
    EXPECT_EQ (parts.border_leaves.size() > 500, end > 0.0);
    evidence.push_back (evidenceOf (scene.cloud, scene.planes, none, parts));
  }
  EXPECT_NEAR (evidence[1] - evidence[0], 2.8 * std::log10 (8.0), 0.2);
}

TEST (PlaneEvidence, KeepsAWallBentByAnInstrument)
{
  // 5 mm in 2 m, with 3 mm of noise.
  LeafScene scene (
      pointsOver (1_m, 5_mm, [] (double x, double) { return 0.05 + 5_mm * x * x; }));
  scene.addPlane (ground, 0.0, anywhere);
  EXPECT_EQ (keptIn (scene), std::vector<char>{1});
}
