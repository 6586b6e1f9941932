// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "kht/cluster_assignment.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

const Surface ground = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}};
const Surface step = {{2, 0, 0.2}, {2, 0, 0}, {0, 2, 0}};

Plane
atHeight (double z)
{
  return {Eigen::Vector3d::UnitZ(), -z};
}

/** \brief A floor with a step of 20 cm, its clusters, and both planes. */
struct Step {
  Step()
  {
    addGrid (points, ground, 150, 5_mm);
    addGrid (points, step, 150, 5_mm);
    findClusters (
        [] (double height, std::uint32_t /*cluster*/) { return height < 0.1 ? 0 : 1; });
  }

  /** \param[in] planeOf (height, cluster) */
  template <typename PlaneOf>
  void
  findClusters (PlaneOf&& planeOf)
  {
    clusters = findCoplanarClusters (points, parameters.clusters);
    planes = {{atHeight (0), {}}, {atHeight (0.2), {}}};
    for (std::uint32_t c = 0; c < clusters.clusters.size(); ++c)
      planes[planeOf (clusters.clusters[c].fit.centroid.z(), c)].clusters.push_back (c);
  }

  LabelledPlanes
  outlined ()
  {
    StageDurations durations;
    return assignToOutlinedPlanes (points, clusters, planes, parameters, durations);
  }

  LabelledPlanes
  endless ()
  {
    StageDurations durations;
    return assignToUnboundedPlanes (points, clusters, planes, parameters, durations);
  }

  Points points;
  KernelHoughTransformParameters parameters;
  OctreeClusters clusters;
  std::vector<HoughPlane> planes;
};

/** \brief Whether all points of the ground have one label and those of the step
 * another.
 */
double
shareOfOneLabelEach (const Labels& labels)
{
  const auto count = [&] (std::ptrdiff_t begin, std::int32_t label) {
    return std::count (labels.begin() + begin, labels.begin() + begin + 22500, label);
  };
  const std::int32_t of_ground = labels[11000], of_step = labels[22500 + 11000];
  return of_ground == of_step
             ? 0.0
             : static_cast<double> (count (0, of_ground) + count (22500, of_step)) /
                   45000.0;
}

} // namespace

TEST (ClusterAssignment, GivesEachPointToItsUnboundedPlane)
{
  Step scene;
  EXPECT_GT (shareOfOneLabelEach (scene.endless().labels), 99_percent);
}

TEST (ClusterAssignment, MergesPlanesThatAreOne)
{
  for (const bool merges : {true, false}) {
    Step scene;
    scene.parameters.merging.enabled = merges;
    scene.parameters.merging.distance_threshold = 30_cm;
    EXPECT_EQ (scene.outlined().planes.fits.size(), merges ? 1u : 2u);
    EXPECT_EQ (scene.endless().planes.fits.size(), merges ? 1u : 2u);
  }
}

TEST (ClusterAssignment, GrowsPlanesOverVoxelsWithoutAClusterOfTheirs)
{
  Step scene;
  for (HoughPlane& plane : scene.planes)
    plane.clusters.resize (plane.clusters.size() * 9 / 10);
  EXPECT_GT (shareOfOneLabelEach (scene.outlined().labels), 95_percent);
}

TEST (ClusterAssignment, HandsVoxelsOfWrongClustersToTheNearerPlane)
{
  // Every sixth cluster of the ground, each 6 cm wide, is said to be the step's.
  Step scene;
  scene.parameters.clusters.first_level = 6;
  scene.parameters.clusters.min_samples = 10;
  scene.parameters.merging.enabled = false;
  scene.findClusters ([] (double height, std::uint32_t c) {
    return height < 0.1 && c % 6 != 0 ? 0 : 1;
  });
  EXPECT_GT (shareOfOneLabelEach (scene.outlined().labels), 99_percent);
}
