// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "presets.h"
#include "scene.h"

using pcl_ops::MergingParameters;
using pcl_ops::PlaneSegment;

// OPS with its default parameters, tested through the public interface.

namespace {

/** \brief A cloud of the points that \p make returns for positions drawn uniformly in
 * the cube from -1 to 1 along each axis. */
template <typename Make>
Cloud::Ptr
cloudFrom (std::size_t number, Make&& make)
{
  RandomGenerator generator (seedOfTest());
  const auto draw = [&] { return 2.0 * drawUnit (generator) - 1.0; };
  return cloudOf (number, [&] (float) {
    return toPoint (make (Eigen::Vector3d{draw(), draw(), draw()}));
  });
}

std::vector<PlaneSegment>
planesAmong (const Cloud::ConstPtr& cloud)
{
  Ops ops;
  ops.setInputCloud (cloud);
  return planesOf (ops);
}

LabelledScene
sampled (const Surface& surface, double spacing, double noise)
{
  return Scene()
      .surface (surface.corner, surface.first, surface.second)
      .spacing (spacing)
      .noise (noise)
      .build();
}

/** \brief Whether a plane near the only surface of a scene has more inliers than nine
 * tenths of the scene's points. */
bool
hasSurfaceOf (const LabelledScene& scene,
              const std::vector<PlaneSegment>& planes,
              double max_distance)
{
  return std::any_of (planes.begin(), planes.end(), [&] (const PlaneSegment& plane) {
    return isNear (plane.plane(), scene.surfaces[0], 3_deg, max_distance) &&
           plane.inliers.size() > 0.9 * scene.cloud->size();
  });
}

/** \brief Fails unless both surfaces are found in a cloud of both scenes: the noisy one
 * at most 3 cm off, the clean one at most 1 cm. */
void
expectFindsBoth (const LabelledScene& noisy, const LabelledScene& clean)
{
  const std::vector<PlaneSegment> planes =
      planesAmong (pcl::make_shared<Cloud> (*noisy.cloud + *clean.cloud));
  EXPECT_TRUE (hasSurfaceOf (noisy, planes, 3_cm));
  EXPECT_TRUE (hasSurfaceOf (clean, planes, 1_cm));
}

const Surface ground = {{0, 0, 0}, {20, 0, 0}, {0, 20, 0}};

} // namespace

TEST (DefaultPath, MergesHalvesOfOneFloorBeforePointsAreAssigned)
{
  // A floor continues 1 cm higher beyond a gap of 1 m. Its halves are not connected and
  // become two planes. Merging joins them, as the noise of 2 cm explains the step.
  Scene halves = Scene().floor (2, 3).surface ({3, 0, 1_cm}, {2, 0, 0}, {0, 3, 0});
  Ops ops = opsOn (halves.noise (2_cm).build().cloud);
  const auto planes = planesOf (ops);
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_GE (ops.getNumberOfPlanesBeforeMerging(), 2u);
  // The merged plane has the points of both halves and lies between them.
  EXPECT_GE (planes[0].inliers.size(), 0.9 * ops.getInputCloud()->size());
  EXPECT_NEAR (planes[0].centroid.z(), 5_mm, 2_mm);
  MergingParameters by_distance;
  by_distance.noise_factor = 0.0;
  for (const double distance : {1_mm, 10_cm}) {
    by_distance.distance_threshold = distance;
    ops.setMergingParameters (by_distance);
    EXPECT_EQ (planesOf (ops).size(), distance < 1_cm ? 2u : 1u);
  }
}

TEST (DefaultPath, EndsAPlaneWhereItsPointsEnd)
{
  // A chair leg crosses the height of the floor, a meter beyond the floor's edge.
  const auto scene =
      Scene().floor (2, 2).surface ({3, 0, -0.4}, {0.04, 0, 0}, {0, 0, 0.8}).build();
  Ops ops = opsOn (scene.cloud);
  const auto planes = planesOf (ops);
  ASSERT_GE (planes.size(), 1u);
  for (const pcl::index_t i : planes[0].inliers)
    EXPECT_EQ (scene.labels[i], 0);
}

TEST (DefaultPath, FollowsAThresholdForEveryPoint)
{
  const auto scene = Scene().floor (3, 3).noise (1_cm).build();
  Ops ops = opsOn (scene.cloud);
  const std::size_t inliers_without_threshold = planesOf (ops).at (0).inliers.size();
  ops.setDistanceThreshold (1_cm);
  const PlaneSegment plane = planesOf (ops).at (0);
  EXPECT_LT (plane.inliers.size(), inliers_without_threshold);
  for (const pcl::index_t i : plane.inliers)
    EXPECT_LT (std::abs ((*scene.cloud)[i].z), 12_mm) << "the plane may tilt a little";
}

TEST (DefaultPath, FindsHardlyAnyPlaneOnCurvedSurfacesAndWires)
{
  const struct {
    const char* name;
    Eigen::Vector3d (*make) (const Eigen::Vector3d&);
    double max_share; // of points on planes
  } shapes[] = {
      {"sphere", [] (const auto& p) { return Eigen::Vector3d (p.normalized()); }, 0.0},
      // A cylinder has no flat strips between its curved patches.
      {"cylinder",
       [] (const auto& p) {
         return Eigen::Vector3d (
             std::cos (pi * p.x()), std::sin (pi * p.x()), 2.0 * p.y());
       },
       0.02},
      // A wire, a helix of five turns: any two directions along a line span a plane,
      // and so do turns side by side.
      {"helix",
       [] (const auto& p) {
         return Eigen::Vector3d (
             std::cos (5.0 * pi * p.x()), std::sin (5.0 * pi * p.x()), p.x());
       },
       0.05}};
  for (const auto& [name, make, max_share] : shapes) {
    constexpr int points = 60000;
    std::size_t on_planes = 0;
    for (const PlaneSegment& plane : planesAmong (cloudFrom (points, make)))
      on_planes += plane.inliers.size();
    EXPECT_LE (static_cast<double> (on_planes), max_share * points) << name;
  }
}

TEST (DefaultPath, FindsNoPlaneOnMostOfANoisyBall)
{
  // A radius of 1 m; points are up to 1 cm off the sphere, which hides how little a
  // small patch bends.
  const auto nearSphere = [] (const Eigen::Vector3d& p) {
    return ((1.0 + 1_cm * (p.norm() - 1.0)) * p.normalized()).eval();
  };
  constexpr std::size_t points = 60000;
  std::size_t on_planes = 0;
  for (const PlaneSegment& plane : planesAmong (cloudFrom (points, nearSphere)))
    on_planes += plane.inliers.size();
  EXPECT_LT (on_planes, points / 20);
}

// Clouds whose parts differ in density and noise: each part needs its own scale.

TEST (DefaultPath, FindsASparseGroundBesideADenseBoard)
{
  // Ten points per square meter beside a hundred thousand per square meter.
  const Surface board = {{-2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  expectFindsBoth (sampled (ground, 1.0 / std::sqrt (10.0), 1_cm),
                   sampled (board, 1.0 / std::sqrt (1e5), 1_mm));
}

TEST (DefaultPath, LetsAGroundGoOnInTheRingsOfALidar)
{
  // Beside a floor are two lines of points, too few for a plane of their own.
  auto scene = Scene().floor (2, 2).spacing (2_cm).noise (2_mm).build();
  const std::size_t on_floor = scene.cloud->size();
  for (const float x : {2.1f, 2.2f})
    for (int i = 0; i < 80; ++i)
      scene.cloud->push_back ({x, 0.025f * i, i % 2 == 0 ? 0.002f : -0.002f});
  const auto planes = planesAmong (scene.cloud);
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_GT (planes[0].inliers.size(), on_floor + 130) << "of 2 x 80 points";
}

TEST (DefaultPath, FindsAPlaneWithAThousandTimesTheNoiseOfAnother)
{
  const Surface wall = {{-3, 0, 0}, {0, 20, 0}, {0, 0, 20}};
  expectFindsBoth (sampled (ground, 10_cm, 10_cm), sampled (wall, 10_cm, 1e-4));
}

TEST (DefaultPath, FindsAPlaneOrNoneInOneVoxel)
{
  Ops ops;
  auto parameters = ops.getParameters();
  parameters.surfels.voxel_size = 1000_m;
  ops.setParameters (parameters);
  ops.setInputCloud (room().build().cloud);
  EXPECT_LE (planesOf (ops).size(), 1u);
}
