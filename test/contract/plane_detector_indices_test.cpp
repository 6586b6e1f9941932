// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/search/brute_force.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>
#include <pcl/search/organized.h>

#include <gtest/gtest.h>

#include "presets.h"
#include "scene.h"

namespace {

class GivenIndices : public EachPreset {};

INSTANTIATE_TEST_SUITE_P (Presets,
                          GivenIndices,
                          ::testing::Values ("default", "paper"),
                          presetName);

pcl::Indices
everySecond (const Cloud& cloud)
{
  pcl::Indices indices;
  for (std::size_t i = 0; i < cloud.size(); i += 2)
    indices.push_back (static_cast<pcl::index_t> (i));
  return indices;
}

} // namespace

TEST_P (GivenIndices, TakesThemInAllFormsOfPclAndAnyOrder)
{
  const auto cloud = room().build().cloud;
  pcl::Indices given = everySecond (*cloud);
  const auto point_indices = pcl::make_shared<pcl::PointIndices>();
  point_indices->indices = given;
  Ops ops = detectorFor (cloud);
  ops.setIndices (pcl::make_shared<pcl::Indices> (given));
  const auto planes = inliersOf (ops);
  ops.setIndices (pcl::IndicesConstPtr (new pcl::Indices (given)));
  EXPECT_EQ (inliersOf (ops), planes);
  ops.setIndices (pcl::PointIndicesConstPtr (point_indices));
  EXPECT_EQ (inliersOf (ops), planes);
  std::reverse (given.begin(), given.end());
  given.push_back (given.front()); // a repetition
  ops.setIndices (pcl::make_shared<pcl::Indices> (given));
  EXPECT_EQ (inliersOf (ops), planes);
}

TEST_P (GivenIndices, TakesRowsAndColumnsOfAnOrganizedCloud)
{
  const auto cloud = roomSeenByCamera (160, 120);
  Ops ops = detectorFor (cloud);
  ops.setIndices (70, 10, 50, 140); // rows 70 to 119, columns 10 to 149
  const auto planes = inliersOf (ops);
  ASSERT_FALSE (planes.empty());
  for (const pcl::Indices& inliers : planes)
    for (const pcl::index_t i : inliers) {
      ASSERT_GE (i / 160, 70);
      ASSERT_GE (i % 160, 10);
      ASSERT_LT (i % 160, 150);
    }
}

TEST_P (GivenIndices, SeesWhatTheUserChangesInThemUntilThereAreNone)
{
  const auto scene = room().build();
  const auto given = pcl::make_shared<pcl::Indices> (everySecond (*scene.cloud));
  Ops ops = detectorFor (scene.cloud);
  ops.setIndices (given);
  EXPECT_FALSE (planesOf (ops).empty());
  given->resize (3);
  EXPECT_TRUE (planesOf (ops).empty());
  ops.setIndices (pcl::IndicesPtr());
  expectFindsEverySurface (planesOf (ops), scene);
}

TEST_P (GivenIndices, LeavesThemAndTheCloudAlone)
{
  const auto cloud = room().build().cloud;
  const auto given = pcl::make_shared<pcl::Indices> (pcl::Indices{9, 7, 8, 7});
  const Cloud before = *cloud;
  Ops ops = detectorFor (cloud);
  planesOf (ops);
  ops.setIndices (given);
  planesOf (ops);
  EXPECT_EQ (*given, (pcl::Indices{9, 7, 8, 7}));
  EXPECT_EQ (ops.getIndices(), given);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    ASSERT_EQ ((*cloud)[i].getVector3fMap(), before[i].getVector3fMap());
}

TEST (GivenASearchMethod, FindsTheSamePlanesWhateverItIsAndSearchedBefore)
{
  using Search = pcl::search::Search<pcl::PointXYZ>;
  const auto other = Scene().floor (1, 1).build().cloud;
  Ops ops = paperOn (room().spacing (8_cm).build().cloud);
  ops.setSamplingRate (0.2);
  ops.setNumberOfThreads (2);
  const auto planes = inliersOf (ops);
  EXPECT_EQ (planes.size(), 3u);
  for (const Search::Ptr& search :
       {Search::Ptr (new pcl::search::KdTree<pcl::PointXYZ>),
        Search::Ptr (new pcl::search::Octree<pcl::PointXYZ> (0.1)),
        Search::Ptr (new pcl::search::BruteForce<pcl::PointXYZ>)}) {
    search->setInputCloud (other,
                           pcl::make_shared<pcl::Indices> (pcl::Indices{1, 2, 3}));
    ops.setSearchMethod (search);
    EXPECT_EQ (inliersOf (ops), planes) << search->getName();
  }
}

TEST (GivenASearchMethod, WorksWithOrganizedNeighbor)
{
  Ops ops = paperOn (roomSeenByCamera (160, 120));
  ops.setSearchMethod (
      pcl::make_shared<pcl::search::OrganizedNeighbor<pcl::PointXYZ>>());
  ops.setUpAxis (-Eigen::Vector3f::UnitY());
  const auto planes = planesOf (ops);
  ASSERT_EQ (planes.size(), 2u);
  const Surface wall{{0, 0, 3}, {1, 0, 0}, {0, 1, 0}},
      floor{{0, 1, 2}, {1, 0, 0}, {0, 0, 1}};
  EXPECT_TRUE (isNear (planes[0].plane(), wall, 2_deg, 3_cm));
  EXPECT_TRUE (isNear (planes[1].plane(), floor, 2_deg, 3_cm));
}

TEST (GivenASearchMethod, SurvivesOrganizedNeighborOnAnUnorganizedCloud)
{
  Ops ops = paperOn (room().build().cloud);
  ops.setSearchMethod (
      pcl::make_shared<pcl::search::OrganizedNeighbor<pcl::PointXYZ>>());
  std::vector<pcl_ops::PlaneSegment> planes;
  ops.segment (planes); // PCL's search says on stderr that the cloud is not organized
}
