// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "detection/merging_defaults.h"
#include "detection/neighbour_search.h"
#include "scene.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

/** \brief Five points of a line, 1 m apart; the one in the middle is nowhere. */
struct Line {
  Line()
  {
    for (int i = 0; i < 5; ++i)
      cloud.push_back ({static_cast<float> (i), 0, 0});
    cloud[2].x = std::numeric_limits<float>::quiet_NaN();
    input.cloud = CloudView (cloud);
    points = finitePoints (input.cloud, all, 1);
  }

  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::Indices all{0, 1, 2, 3, 4};
  DetectorInput input{{}, all, Eigen::Vector3d::Zero(), nullptr};
  Points points;
};

} // namespace

TEST (SearchOver, FindsTheNearestAmongTheFinitePoints)
{
  const Line line;
  pcl::Indices neighbours;
  std::vector<float> squared_distances;
  const NeighborSearch search = searchOver (line.input, line.points, 3);
  search.nearest (3, 3, neighbours, squared_distances);
  std::sort (neighbours.begin(), neighbours.end());
  EXPECT_EQ (neighbours, (pcl::Indices{1, 3, 4}));
  EXPECT_EQ (search.threads, 3u) << "may ask it";
}

TEST (SearchOver, IsTheUsersOverTheFinitePointsWhereThereIsOne)
{
  Line line;
  pcl::Indices searched;
  line.input.search_over = [&] (const pcl::Indices& finite) {
    searched = finite;
    NeighborSearch search;
    search.threads = 77;
    return search;
  };
  EXPECT_EQ (searchOver (line.input, line.points, 1).threads, 77u);
  EXPECT_EQ (searched, (pcl::Indices{0, 1, 3, 4}));
}

TEST (MergingOf, TakesThetaHWhereMergingHasNoDistanceOfItsOwn)
{
  PlaneDetectorParameters parameters;
  parameters.distance_threshold = 7_cm;
  EXPECT_EQ (mergingOf (parameters).distance_threshold, 7_cm);
  parameters.merging.distance_threshold = 1_cm;
  EXPECT_EQ (mergingOf (parameters).distance_threshold, 1_cm);
}
