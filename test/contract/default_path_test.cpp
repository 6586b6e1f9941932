// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "presets.h"
#include "scene.h"

using pcl_ops::MergingParameters;
using pcl_ops::PlaneSegment;

// OPS with default parameters, or with the sampling rate of opsOn, tested through the
// public interface.

namespace {

/** \brief A cloud of \p size points. Each is what \p point_from returns for a vector of
 * three random numbers, drawn uniformly from -1 to 1. */
template <typename PointFrom>
Cloud::Ptr
cloudFromRandom (std::size_t size, PointFrom&& point_from)
{
  RandomGenerator generator (seedOfTest());
  const auto draw = [&] { return 2.0 * drawUnit (generator) - 1.0; };
  return cloudOf (size, [&] (float) {
    return toPoint (point_from (Eigen::Vector3d{draw(), draw(), draw()}));
  });
}

std::vector<PlaneSegment>
planesAmong (const Cloud::ConstPtr& cloud)
{
  Ops ops;
  ops.setInputCloud (cloud);
  return planesOf (ops);
}

/** \brief Share of 60,000 points of \ref cloudFromRandom that are on planes. */
template <typename PointFrom>
double
shareOnPlanes (PointFrom&& point_from)
{
  const Cloud::Ptr cloud = cloudFromRandom (60'000, point_from);
  double on_planes = 0.0;
  for (const PlaneSegment& plane : planesAmong (cloud))
    on_planes += static_cast<double> (plane.inliers.size());
  return on_planes / static_cast<double> (cloud->size());
}

/** \brief Points on one surface.
 * \param[in] spacing mean distance between neighboring points [m]
 * \param[in] noise standard deviation along the normal [m] */
LabeledScene
pointsOn (const Surface& surface, double spacing, double noise)
{
  return Scene()
      .surface (surface.corner, surface.first, surface.second)
      .spacing (spacing)
      .noise (noise)
      .build();
}

/** \brief Whether a plane near the only surface of a scene has more inliers than nine
 * tenths of the scene's points.
 * \param[in] max_distance as in \ref isNear [m] */
bool
hasSurfaceOf (const LabeledScene& scene,
              const std::vector<PlaneSegment>& planes,
              double max_distance)
{
  return std::any_of (planes.begin(), planes.end(), [&] (const PlaneSegment& plane) {
    return isNear (plane.plane(), scene.surfaces[0], 3_deg, max_distance) &&
           plane.inliers.size() > 0.9 * scene.cloud->size();
  });
}

/** \brief Fails unless the surfaces of both scenes are found in a cloud of the points
 * of both: the center of the noisy surface at most 3 cm from its plane, that of the
 * precise one at most 1 cm. */
void
expectFindsBoth (const LabeledScene& noisy, const LabeledScene& precise)
{
  const std::vector<PlaneSegment> planes =
      planesAmong (pcl::make_shared<Cloud> (*noisy.cloud + *precise.cloud));
  EXPECT_TRUE (hasSurfaceOf (noisy, planes, 3_cm));
  EXPECT_TRUE (hasSurfaceOf (precise, planes, 1_cm));
}

const Surface ground = {{0, 0, 0}, {20, 0, 0}, {0, 20, 0}};

} // namespace

TEST (DefaultPath, MergesTwoHalvesOfAFloorIfTheNoiseOrTheMergingDistanceAllowsIt)
{
  // A floor continues 1 cm higher beyond a gap of 1 m. Its halves are not connected and
  // become two planes. Merging joins them, as the noise of 2 cm explains the step.
  Scene halves = Scene().floor (2, 3).surface ({3, 0, 1_cm}, {2, 0, 0}, {0, 3, 0});
  Ops ops = opsOn (halves.noise (2_cm).build().cloud);
  const std::vector<PlaneSegment> planes = planesOf (ops);
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

TEST (DefaultPath, LeavesOutAnObjectThatCrossesTheHeightOfTheFloorBeyondItsEdge)
{
  // Surface 0 is the floor. Surface 1 is a chair leg, which stands a meter beyond the
  // edge of the floor and reaches from 0.4 m below the height of the floor to 0.4 m
  // above it.
  const LabeledScene scene =
      Scene().floor (2, 2).surface ({3, 0, -0.4}, {0.04, 0, 0}, {0, 0, 0.8}).build();
  Ops ops = opsOn (scene.cloud);
  const std::vector<PlaneSegment> planes = planesOf (ops);
  ASSERT_GE (planes.size(), 1u);
  ASSERT_FALSE (planes[0].inliers.empty());
  for (const pcl::index_t i : planes[0].inliers)
    EXPECT_EQ (scene.labels[i], 0);
}

TEST (DefaultPath, HasNoInlierFartherFromItsPlaneThanAGivenThreshold)
{
  const LabeledScene scene = Scene().floor (3, 3).noise (1_cm).build();
  Ops ops = opsOn (scene.cloud);
  const std::size_t inliers_without_threshold = planesOf (ops).at (0).inliers.size();
  ops.setDistanceThreshold (1_cm);
  const PlaneSegment plane = planesOf (ops).at (0);
  EXPECT_LT (plane.inliers.size(), inliers_without_threshold);
  for (const pcl::index_t i : plane.inliers)
    EXPECT_LT (std::abs ((*scene.cloud)[i].z), 12_mm)
        << "1 cm, and 2 mm for the tilt of the plane";
}

TEST (DefaultPath, PutsHardlyAnyPointOfASphereACylinderOrAWireOnAPlane)
{
  const struct {
    const char* name;
    Eigen::Vector3d (*point_from) (const Eigen::Vector3d&);
    double max_share; // of points on planes
  } shapes[] = {
      {"sphere", [] (const auto& p) { return Eigen::Vector3d (p.normalized()); }, 0.0},
      // Radius 1 m, height 4 m. No flat strips are found along the axis.
      {"cylinder",
       [] (const auto& p) {
         return Eigen::Vector3d (
             std::cos (pi * p.x()), std::sin (pi * p.x()), 2.0 * p.y());
       },
       0.02},
      // A wire with five turns around a cylinder: two directions along it span a plane,
      // and so do neighboring turns.
      {"helix",
       [] (const auto& p) {
         return Eigen::Vector3d (
             std::cos (5.0 * pi * p.x()), std::sin (5.0 * pi * p.x()), p.x());
       },
       0.05}};
  for (const auto& [name, point_from, max_share] : shapes)
    EXPECT_LE (shareOnPlanes (point_from), max_share) << name;
}

TEST (DefaultPath, PutsFewPointsOfANoisySphereOnPlanes)
{
  // A radius of 1 m; points are up to 1 cm off the sphere. This noise is larger than
  // the bend of a small patch.
  const auto nearSphere = [] (const Eigen::Vector3d& p) {
    return ((1.0 + 1_cm * (p.norm() - 1.0)) * p.normalized()).eval();
  };
  EXPECT_LT (shareOnPlanes (nearSphere), 5_percent);
}

// The parts of the following clouds differ in density or noise.

TEST (DefaultPath, FindsASparseGroundBesideADenseBoard)
{
  const Surface board = {{-2, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr double density_of_ground = 10.0, density_of_board = 1e5; // [1/m^2]
  expectFindsBoth (pointsOn (ground, 1.0 / std::sqrt (density_of_ground), 1_cm),
                   pointsOn (board, 1.0 / std::sqrt (density_of_board), 1_mm));
}

TEST (DefaultPath, ExtendsAFloorByLinesOfPointsBesideIt)
{
  // Beside a floor are two lines of points, as rings of a lidar are, 10 cm and 20 cm
  // beyond its edge: too few points for a plane of their own. Heights of 2 mm and -2 mm
  // alternate.
  LabeledScene scene = Scene().floor (2, 2).spacing (2_cm).noise (2_mm).build();
  const std::size_t on_floor = scene.cloud->size();
  for (const float x : {2.1f, 2.2f})
    for (int i = 0; i < 80; ++i)
      scene.cloud->push_back ({x, 0.025f * i, i % 2 == 0 ? 0.002f : -0.002f});
  const std::vector<PlaneSegment> planes = planesAmong (scene.cloud);
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_GT (planes[0].inliers.size(), on_floor + 130) << "of the 160 of both lines";
}

TEST (DefaultPath, FindsAPlaneWithAThousandTimesTheNoiseOfAnother)
{
  const Surface wall = {{-3, 0, 0}, {0, 20, 0}, {0, 0, 20}};
  constexpr double noise_of_ground = 10_cm;
  constexpr double noise_of_wall = 1e-4; // [m]
  expectFindsBoth (pointsOn (ground, 10_cm, noise_of_ground),
                   pointsOn (wall, 10_cm, noise_of_wall));
}

TEST (DefaultPath, FindsAtMostOnePlaneIfOneVoxelHoldsTheCloud)
{
  Ops ops;
  Ops::Parameters parameters = ops.getParameters();
  parameters.surfels.voxel_size = 1000_m;
  ops.setParameters (parameters);
  ops.setInputCloud (room().build().cloud);
  EXPECT_LE (planesOf (ops).size(), 1u);
}
