// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/voxel_surfels.h"
#include "voxel_scene.h"

using pcl_ops::DetectorInput;
using pcl_ops::no_plane;
using pcl_ops::OrientedPointSamplingParameters;
using namespace pcl_ops::internal;

namespace {

const Surface ground = {{0, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};
const Surface wall = {{0.05, 0, 0}, {0, 2, 0}, {0, 0, 2}};

Points
pointsOf (const std::vector<Surface>& surfaces, double noise = 0.0)
{
  Points points;
  for (const Surface& surface : surfaces)
    addGrid (points, surface, 120, noise);
  return points;
}

/** \brief The stages, with voxels of 10 cm, seen from 3 m above. */
struct Stages {
  explicit Stages (Points some_points) : points (std::move (some_points))
  {
    parameters.surfels.voxel_size = 10_cm;
  }

  VoxelizedPoints
  sample () const
  {
    return policy.sample (points);
  }

  BoundedPlanes
  extract (const VoxelizedPoints& voxelized) const
  {
    return policy.extract (points, voxelized, policy.orient (points, voxelized));
  }

  BoundedPlanes
  bound (const VoxelizedPoints& voxelized, BoundedPlanes planes) const
  {
    policy.bound (points, voxelized, planes);
    return planes;
  }

  Points points;
  pcl::Indices none;
  DetectorInput input{{}, none, Eigen::Vector3d (1, 1, 3), nullptr};
  OrientedPointSamplingParameters parameters;
  VoxelSurfels policy{input, parameters};
};

std::size_t
voxelsOn (std::int32_t plane, const BoundedPlanes& planes)
{
  return static_cast<std::size_t> (
      std::count (planes.plane_of_voxel.begin(), planes.plane_of_voxel.end(), plane));
}

} // namespace

TEST (VoxelSurfels, SampleVoxelsOfTheGivenSize)
{
  Stages stages (pointsOf ({ground}));
  EXPECT_EQ (stages.sample().grid.voxel_size, 10_cm);
  EXPECT_EQ (stages.sample().grid.size(), 400u);
}

TEST (VoxelSurfels, SampleMoreVoxelsAtALargerRate)
{
  Stages stages (pointsOf ({ground}));
  stages.parameters.surfels.voxel_size.reset();
  stages.parameters.sampling_rate = 0.003;
  const std::size_t few = stages.sample().grid.size();
  stages.parameters.sampling_rate = 0.03;
  EXPECT_GT (stages.sample().grid.size(), 5 * few);
}

TEST (VoxelSurfels, SampleNothingOfPointsThatSpanNothing)
{
  Points point;
  point.add (1, 2, 3);
  Stages stages (point);
  stages.parameters.surfels.voxel_size.reset();
  EXPECT_EQ (stages.sample().grid.size(), 0u);
}

TEST (VoxelSurfels, OrientVoxelsWithPointsEnough)
{
  // 36 points in each voxel, 9 voxels around: 324 points, at the corners 144.
  Stages stages (pointsOf ({ground}));
  const VoxelizedPoints voxelized = stages.sample();
  const auto with_k = [&] (int k) {
    stages.parameters.k = k;
    const auto surfels = stages.policy.orient (stages.points, voxelized);
    return std::count_if (
        surfels.begin(), surfels.end(), [] (const auto& s) { return s.has_value(); });
  };
  EXPECT_EQ (with_k (30), 400);
  stages.parameters.surfels.resolutions = 1;
  EXPECT_EQ (with_k (325), 0);
}

TEST (VoxelSurfels, AskForAsManyPointsAsSomeAverageVoxelsHold)
{
  Stages stages (pointsOf ({ground}));
  stages.parameters.surfels.resolutions = 1;
  stages.parameters.surfels.least_average_voxels = 9.1;
  for (const auto& surfel : stages.policy.orient (stages.points, stages.sample()))
    EXPECT_FALSE (surfel) << "nine voxels are never 9.1";
}

TEST (VoxelSurfels, ExtractAndGrowPlanesOverTheirEdges)
{
  const Stages stages (pointsOf ({ground, wall}, 5_mm));
  const BoundedPlanes planes = stages.extract (stages.sample());
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_LE (voxelsOn (no_plane, planes), 21u) << "where they meet";
}

TEST (VoxelSurfels, ExtractGrowsPlanesByTheGivenRounds)
{
  // Where there are no surfels there still are points of the ground.
  Stages stages (pointsOf ({ground}));
  const VoxelizedPoints voxelized = stages.sample();
  auto surfels = stages.policy.orient (stages.points, voxelized);
  for (std::size_t i = 0; i < surfels.size(); ++i)
    if (voxelized.grid.moments[i].centroid().x() > 1.5)
      surfels[i].reset();
  for (const int rounds : {0, 5}) {
    stages.parameters.surfels.growing_rounds = rounds;
    const auto planes = stages.policy.extract (stages.points, voxelized, surfels);
    EXPECT_EQ (voxelsOn (no_plane, planes), rounds == 0 ? 100u : 0u);
  }
}

TEST (VoxelSurfels, ExtractPlanesOfThickSurfelsAfterThoseOfSureOnes)
{
  // The wall is twice as large, but its surfels are thick.
  const Surface large_wall = {{0.05, 0, 0}, {0, 4, 0}, {0, 0, 2}};
  Stages stages (pointsOf ({ground, large_wall}));
  const VoxelizedPoints voxelized = stages.sample();
  auto surfels = stages.policy.orient (stages.points, voxelized);
  for (auto& surfel : surfels)
    surfel->thickness = std::abs (surfel->plane.normal.x()) > 0.5 ? 0.25 : 0.0;
  const auto planes = stages.policy.extract (stages.points, voxelized, surfels);
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_GT (std::abs (planes.planes[0].normal.z()), 0.9);
  EXPECT_GT (std::abs (planes.planes[1].normal.x()), 0.9);
}

TEST (VoxelSurfels, ExtractNoPlaneOfSurfelsThatAreTooThick)
{
  Stages stages (pointsOf ({ground}));
  const VoxelizedPoints voxelized = stages.sample();
  auto surfels = stages.policy.orient (stages.points, voxelized);
  for (auto& surfel : surfels)
    surfel->thickness = 0.31;
  EXPECT_EQ (stages.policy.extract (stages.points, voxelized, surfels).size(), 0u);
}

TEST (VoxelSurfels, BoundAbsorbsASplinter)
{
  // In a corner of 3 x 3 voxels, too few to say anything about where the plane is.
  VoxelScene scene ({{ground}}, 5_mm);
  scene.planes.planes.push_back (scene.planes.planes[0]);
  scene.label (1, [] (const auto& at) { return at.x() < 0.3 && at.y() < 0.3; });
  Stages stages (pointsOf ({ground}, 5_mm));
  stages.parameters.merging.enabled = false;
  EXPECT_EQ (stages.bound (scene.voxelized, scene.planes).size(), 1u);
}

TEST (VoxelSurfels, BoundMergesPlanesThatDoNotTouch)
{
  VoxelScene scene ({{ground}, {{{3, 0, 0.05}, {1, 0, 0}, {0, 2, 0}}}});
  const Stages stages (pointsOf ({ground}));
  const BoundedPlanes planes = stages.bound (scene.voxelized, scene.planes);
  EXPECT_EQ (planes.size(), 1u);
  EXPECT_EQ (voxelsOn (0, planes), scene.grid().size());
}

TEST (VoxelSurfels, BoundKeepsApartWhatNoiseDoesNotExplain)
{
  // 4 cm higher, and without any noise: nearer than theta_h of the paper all the same.
  VoxelScene scene ({{ground}, {{{3, 0, 0.09}, {1, 0, 0}, {0, 2, 0}}}});
  const Stages stages (pointsOf ({ground}));
  EXPECT_EQ (stages.bound (scene.voxelized, scene.planes).size(), 2u);
}

TEST (VoxelSurfels, BoundHandsVoxelsToTheNearerPlane)
{
  VoxelScene scene ({{ground}, {wall}});
  scene.label (1, [] (const auto& at) { return at.x() < 0.2 && at.z() < 0.1; });
  const Stages stages (pointsOf ({ground}));
  const BoundedPlanes planes = stages.bound (scene.voxelized, scene.planes);
  for (std::size_t i = 0; i < scene.grid().size(); ++i)
    if (scene.centroid (i).x() > 0.1) {
      const auto plane = static_cast<std::size_t> (planes.plane_of_voxel[i]);
      EXPECT_GT (std::abs (planes.planes[plane].normal.z()), 0.9);
    }
}

TEST (VoxelSurfels, BoundMeasuresTheNoiseOfWhatItSettled)
{
  VoxelScene scene ({{ground}}, 3_cm);
  const Stages stages (pointsOf ({ground}));
  for (const double noise : stages.bound (scene.voxelized, scene.planes).noise)
    EXPECT_NEAR (noise, 3_cm / std::sqrt (3.0), 3_mm);
}

TEST (VoxelSurfels, AssignNoPointWhereThereAreNoVoxels)
{
  const Stages stages (pointsOf ({ground}));
  EXPECT_EQ (
      stages.policy.assign (stages.points, VoxelizedPoints(), BoundedPlanes()).labels,
      pcl_ops::Labels (stages.points.size(), no_plane));
}

TEST (VoxelSurfels, MergeNothingThatBoundsKeptApart)
{
  const Points points = pointsOf ({ground, ground});
  pcl_ops::Labels labels (points.size(), 0);
  std::fill (labels.begin() + 14400, labels.end(), 1);
  const Stages stages (points);
  const LabelledPlanes found =
      stages.policy.merge ({labels, momentsOfLabels (points, labels, 2, 1)});
  EXPECT_EQ (found.planes.fits.size(), 2u) << "of one and the same ground";
}
