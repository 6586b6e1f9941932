// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/detectors/detectors.h>
#include <evaluation/metrics/confusion.h>
#include <evaluation/report/plane_sighting.h>
#include <numbers/quantile.h>
#include <simulation/simulate.h>

#include <map>

using namespace pcl_ops;
using namespace pcl_ops::evaluation;

namespace {

/** \brief The true planes that are found, by label: by a plane with more than half of
 * their common points in common. */
std::map<std::uint32_t, PlaneSighting>
sightingsIn (const simulation::LabeledCloud& frame, const Eigen::Isometry3d& pose)
{
  constexpr std::size_t min_points = 3000;
  const XyzCloud::Ptr cloud (new XyzCloud);
  PlaneLabels truth;
  for (const auto& point : frame) {
    cloud->push_back ({point.x, point.y, point.z});
    truth.push_back (point.label);
  }
  const PlaneLabels found =
      selectConfigurations ("ops").front().run (cloud, RunSettings()).labels;
  const Confusion confusion = confusionOf (truth, found);
  const std::vector<PlaneSegment> planes = planesOf (*cloud, confusion.result, {});
  std::map<std::uint32_t, PlaneSighting> sightings;
  for (const Overlap& overlap : confusion.overlaps) {
    const PlaneSegment& plane = planes[overlap.result];
    if (confusion.iou (overlap) <= 0.5 || plane.inliers.size() < min_points)
      continue;
    if (const auto sighting = sightingOf (*cloud, plane, pose))
      sightings.emplace (confusion.truth.label[overlap.truth], *sighting);
  }
  return sightings;
}

} // namespace

TEST (PlaneSighting, DiffersFromTheNextByWhatCovariancesOfCorrelatedNoiseAllow)
{
  NormalizedErrors errors;
  for (const std::uint32_t seed : {1u, 2u}) {
    const auto walk = simulation::simulateWay ({"walk", seed, {320, 240}}, 50);
    std::map<std::uint32_t, PlaneSighting> before;
    for (std::size_t frame = 0; frame < 12; ++frame) {
      const auto now = sightingsIn (walk.look (frame), walk.poses[frame]);
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
