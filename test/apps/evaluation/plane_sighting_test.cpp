// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/metrics/confusion.h>
#include <evaluation/report/plane_sighting.h>
#include <numbers/quantile.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <simulation/depth_camera.h>
#include <simulation/poses.h>

#include <map>

using namespace pcl_ops;
using namespace pcl_ops::evaluation;

namespace {

/** \brief A frame of a walk with true labels, those of NaN points left out. */
pcl::PointCloud<pcl::PointXYZL>
frameOf (const simulation::Room& room,
         const Eigen::Isometry3d& pose,
         std::uint32_t seed)
{
  simulation::DepthCamera camera;
  camera.width = 320;
  camera.height = 240;
  const simulation::Scan scan =
      simulation::scanByCamera (room.scene, camera, pose, {}, seed);
  return simulation::toSurfaceCloud (
      scan, Eigen::Isometry3d::Identity(), simulation::CloudLayout::Readings);
}

/** \brief The true planes that are found, by label: by a plane with more than half of
 * their common points in common. */
std::map<std::uint32_t, PlaneSighting>
sightingsIn (const pcl::PointCloud<pcl::PointXYZL>& frame,
             const Eigen::Isometry3d& pose)
{
  constexpr std::size_t min_points = 3000;
  const pcl::PointCloud<pcl::PointXYZ>::Ptr cloud (new pcl::PointCloud<pcl::PointXYZ>);
  PlaneLabels truth;
  for (const auto& point : frame) {
    cloud->push_back ({point.x, point.y, point.z});
    truth.push_back (point.label);
  }
  OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (cloud);
  std::vector<pcl::PointIndices> planes;
  EXPECT_TRUE (ops.extract (planes));
  const Confusion confusion = confusionOf (truth, labelsOf (planes, cloud->size()));
  std::map<std::uint32_t, PlaneSighting> sightings;
  for (const Overlap& overlap : confusion.overlaps) {
    const pcl::Indices& inliers = planes[overlap.result].indices;
    if (confusion.iou (overlap) <= 0.5 || inliers.size() < min_points)
      continue;
    if (const auto sighting = sightingOf (*cloud, inliers, pose))
      sightings.emplace (confusion.truth.label[overlap.truth], *sighting);
  }
  return sightings;
}

} // namespace

TEST (PlaneSighting, DiffersFromTheNextByWhatCovariancesOfCorrelatedNoiseAllow)
{
  NormalizedErrors errors;
  std::uint32_t frame = 0; // each with noise of its own
  for (const std::uint32_t seed : {1u, 2u}) {
    const simulation::Room room = simulation::makeRoom (seed);
    std::map<std::uint32_t, PlaneSighting> before;
    simulation::Poses walk = simulation::drawWalk (room, 50, seed);
    walk.resize (12);
    for (const Eigen::Isometry3d& pose : walk) {
      const auto now = sightingsIn (frameOf (room, pose, ++frame), pose);
      for (const auto& [label, sighting] : now)
        if (const auto last = before.find (label); last != before.end())
          errors.add (last->second, sighting);
      before = now;
    }
  }
  ASSERT_GE (errors.offsets.size(), 60u);
  for (const auto& of_all : {errors.offsets, errors.tilts}) {
    EXPECT_GE (apps::quantile (of_all, 0.5), 0.5);
    EXPECT_LE (apps::quantile (of_all, 0.5), 0.9);
    EXPECT_LE (apps::quantile (of_all, 0.9), 2.2);
  }
}
