// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/search/brute_force.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>

#include "presets.h"
#include "scene.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;
using FspfParameters = FastSamplingPlaneFilteringParameters;

Fspf
fspfOn (const Cloud::ConstPtr& cloud)
{
  Fspf fspf;
  fspf.setInputCloud (cloud);
  return fspf;
}

} // namespace

TEST (Fspf, FindsEverySurfaceAsInThePaperAndFromTheTestedPointsAlone)
{
  const LabelledScene scene = denseRoom().build();
  FspfParameters paper = FspfParameters::paper(), tested_points_alone;
  paper.seed = 1; // one seed in six finds a plane across an edge, too
  tested_points_alone.local.inliers = FspfParameters::Local::Inliers::Samples;
  for (const FspfParameters& parameters : {paper, tested_points_alone}) {
    Fspf fspf = fspfOn (scene.cloud);
    fspf.setParameters (parameters);
    expectFindsEverySurface (planesOf (fspf), scene);
  }
}

TEST (Fspf, MergesHundredsOfPlanesIntoTheFewThereAre)
{
  Fspf fspf = fspfOn (denseRoom().build().cloud);
  EXPECT_EQ (planesOf (fspf).size(), 3u);
  EXPECT_GT (fspf.getNumberOfPlanesBeforeMerging(), 300u);
}

TEST (Fspf, LeavesNoPairOfPlanesThatAreOne)
{
  // With 3 cm of noise some planes are coplanar only after points were assigned to
  // them.
  const auto cloud = denseRoom().noise (3_cm).build().cloud;
  Fspf fspf = fspfOn (cloud);
  const auto planes = planesOf (fspf);
  EXPECT_GT (planes.size(), 3u);
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE (pcl_ops::detail::areCoplanar (
          *fitPlane (planes[i].moments), *fitPlane (planes[j].moments), 7_deg, 5_cm));
}

TEST (Fspf, AssignsThePointsOfNoSphere)
{
  // A row of points 1 m apart, too far for a sphere of their own, extends a dense
  // floor.
  auto scene = Scene().floor (1, 1).spacing (1_cm).build();
  const auto dense_points = static_cast<pcl::index_t> (scene.cloud->size());
  constexpr int sparse_points = 5;
  for (int i = 1; i <= sparse_points; ++i)
    scene.cloud->push_back ({1.0f + static_cast<float> (i), 0.5f, 0.0f});
  Fspf fspf = fspfOn (scene.cloud);
  const auto inliers = inliersOf (fspf);
  ASSERT_EQ (inliers.size(), 1u);
  EXPECT_EQ (inliers[0].back(), dense_points + sparse_points - 1);
}

TEST (Seed, GivesOtherPlanes)
{
  Fspf fspf = fspfOn (denseRoom().noise (2_cm).build().cloud);
  const auto first = inliersOf (fspf);
  fspf.setSeed (7);
  EXPECT_NE (inliersOf (fspf), first);
}

TEST (SearchMethod, OfTheUserFindsEverySurface)
{
  using Point = pcl::PointXYZ;
  const auto scene = room().spacing (3_cm).build();
  scene.cloud->at (0).x = NAN;
  for (const Fspf::SearchPtr& search :
       {Fspf::SearchPtr (new pcl::search::KdTree<Point>),
        Fspf::SearchPtr (new pcl::search::KdTree<Point> (false)),
        Fspf::SearchPtr (new pcl::search::Octree<Point> (0.1)),
        Fspf::SearchPtr (new pcl::search::BruteForce<Point>)}) {
    Fspf fspf = fspfOn (scene.cloud);
    fspf.setSearchMethod (search);
    const auto planes = inliersOf (fspf);
    EXPECT_EQ (planes.size(), 3u);
    EXPECT_EQ (inliersOf (fspf), planes) << "again";
  }
}

TEST (Degenerate, PointsFarApartHaveNoPlane)
{
  Fspf fspf = fspfOn (cloudOf (1000, [] (float i) {
    return pcl::PointXYZ (std::fmod (i, 30.0f), std::floor (i / 30), 0);
  }));
  EXPECT_TRUE (planesOf (fspf).empty());
}

TEST (Degenerate, RadiiTooLargeForTheThresholdEndInTime)
{
  // A ball seen as 20,000 points, all in every sphere, none on a plane of a millimeter.
  RandomGenerator generator (seedOfTest());
  Fspf fspf = fspfOn (cloudOf (20000, [&] (float) {
    return toPoint (5_cm * drawGaussians (generator).normalized());
  }));
  fspf.setDistanceThreshold (1_mm);
  EXPECT_TRUE (planesOf (fspf).empty());
  EXPECT_LT (fspf.getStageDurations().detection, 5000.0) << "[ms]";
}
