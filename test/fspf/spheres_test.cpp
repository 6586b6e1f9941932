// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "fspf/spheres.h"
#include "scene.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

/** \brief Points of a line, 1 m apart. */
struct Line {
  Line()
  {
    for (int i = 0; i < 10; ++i)
      cloud.push_back ({static_cast<float> (i), 0, 0});
    input.cloud = CloudView (cloud);
    points = finitePoints (input.cloud, some, 1);
  }

  /** \brief Where the points around the one at x = 7 m lie. */
  std::vector<float>
  aroundSeven () const
  {
    const Spheres spheres = spheresAround (input, points, 1.5, 1);
    std::vector<float> around;
    Indices sphere;
    for (std::uint32_t i = 0; i < spheres.points.size(); ++i)
      if (spheres.points.x[i] + points.origin.x() == 7.0) {
        spheres.find (i, sphere);
        for (const std::uint32_t found : sphere)
          around.push_back (
              static_cast<float> (spheres.points.x[found] + points.origin.x()));
      }
    std::sort (around.begin(), around.end());
    return around;
  }

  pcl::PointCloud<pcl::PointXYZ> cloud;
  pcl::Indices some{0, 2, 4, 6, 7, 8};
  DetectorInput input{{}, some, Eigen::Vector3d::Zero(), nullptr};
  Points points;
};

} // namespace

TEST (Spheres, HoldThePointsWithinTheRadius)
{
  EXPECT_EQ (Line().aroundSeven(), (std::vector<float>{6, 7, 8}));
}

TEST (Spheres, AreThoseOfTheUsersSearchWhereThereIsOne)
{
  Line line;
  line.input.search_over = [] (const pcl::Indices&) {
    NeighborSearch search;
    search.within = [] (pcl::index_t point, double radius, auto& found, auto&) {
      EXPECT_EQ (point, 7);
      EXPECT_EQ (radius, 1.5);
      found = {4, 5, 7}; // 5 is none of ours
    };
    return search;
  };
  EXPECT_EQ (line.aroundSeven(), (std::vector<float>{4, 7}));
}
