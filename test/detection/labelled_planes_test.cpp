// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/labelled_planes.h"
#include "grid_scene.h"

using pcl_ops::Labels;
using pcl_ops::MergingParameters;
using pcl_ops::no_plane;
using pcl_ops::Orientation;
using pcl_ops::PlaneDetectorParameters;
using pcl_ops::PlaneSegment;
using namespace pcl_ops::internal;

namespace {

MergingParameters
mergingWithin (double distance)
{
  MergingParameters merging;
  merging.distance_threshold = distance;
  return merging;
}

/** \brief A floor of 100 points in two halves, and ten points of a line far above. */
struct LineAndFloor {
  LineAndFloor()
  {
    for (int i = 0; i < 10; ++i)
      add (static_cast<float> (i), 7.0f, 7.0f, 0);
    for (int i = 0; i < 100; ++i)
      add (static_cast<float> (i % 10),
           static_cast<float> (i / 10),
           0.0f,
           i < 50 ? 1 : 2);
  }

  void
  add (float x, float y, float z, std::int32_t label)
  {
    points.add (x, y, z);
    labels.push_back (label);
  }

  LabelledPlanes
  merged (const MergingParameters& merging) const
  {
    return mergeAssigned ({labels, momentsOfLabels (points, labels, 3, 1)}, merging, 2);
  }

  Points points;
  Labels labels;
};

/** \brief The segments of a floor of 100 points at z = 0 that are all its points. */
std::vector<PlaneSegment>
segmentsOfAFloor (Points points, const Eigen::Vector3d& viewpoint)
{
  addGrid (points, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 10);
  const Labels labels (points.size(), 0);
  return toSegments (points,
                     mergeAssigned ({labels, momentsOfLabels (points, labels, 1, 1)},
                                    MergingParameters(),
                                    1),
                     viewpoint);
}

} // namespace

TEST (MergeAssigned, RelabelsThePoints)
{
  // Plane 0 is a line, 1 and 2 are two halves of one floor.
  LineAndFloor scene;
  scene.labels.back() = no_plane;
  Labels expected (109, 0);
  std::fill_n (expected.begin(), 10, no_plane);
  expected.push_back (no_plane);
  EXPECT_EQ (scene.merged (mergingWithin (5_cm)).labels, expected);
}

TEST (MergeAssigned, FitsThePlanesToTheirPoints)
{
  const LabelledPlanes found = LineAndFloor().merged (mergingWithin (5_cm));
  ASSERT_EQ (found.planes.fits.size(), 1u);
  EXPECT_NEAR (std::abs (found.planes.fits[0].plane.normal.z()), 1.0, 1e-9);
  EXPECT_EQ (found.planes.moments[0].count, 100.0);
}

TEST (MergeAssigned, CountsThePlanesBefore)
{
  EXPECT_EQ (LineAndFloor().merged (mergingWithin (5_cm)).planes_before_merging, 3u);
}

TEST (MergeAssigned, LeavesHalvesApartWhereMergingIsOff)
{
  MergingParameters off;
  off.enabled = false;
  EXPECT_EQ (LineAndFloor().merged (off).planes.fits.size(), 2u) << "a line is none";
}

TEST (ToSegments, PointNormalsTowardsTheViewpoint)
{
  for (const double side : {3.0, -3.0}) {
    const auto segments = segmentsOfAFloor (Points(), {0.5, 0.5, side});
    ASSERT_EQ (segments.size(), 1u);
    EXPECT_GT (segments[0].normal.z() * side, 2.9);
  }
}

TEST (ToSegments, AreInTheFrameOfTheInputCloud)
{
  Points points;
  points.origin << 100, 200, 300;
  const auto segments = segmentsOfAFloor (points, {100, 200, 400});
  ASSERT_EQ (segments.size(), 1u);
  EXPECT_LT ((segments[0].centroid - Eigen::Vector3d (100.5, 200.5, 300)).norm(), 1e-6);
  EXPECT_EQ (segments[0].moments.origin, segments[0].centroid);
  EXPECT_GT (segments[0].normal.z(), 0.99) << "seen from above in that frame";
}

TEST (ToSegments, HaveTheIndicesOfTheInputCloud)
{
  LineAndFloor scene;
  for (pcl::index_t i = 0; i < 110; ++i)
    scene.points.index.push_back (2 * i); // every second point of the cloud
  const auto segments = toSegments (
      scene.points, scene.merged (mergingWithin (5_cm)), Eigen::Vector3d::Zero());
  ASSERT_EQ (segments.size(), 1u);
  ASSERT_EQ (segments[0].inliers.size(), 100u);
  EXPECT_EQ (segments[0].inliers.front(), 20) << "after the ten of the line";
  EXPECT_EQ (segments[0].inliers.back(), 218);
}

namespace {

Detection
detectIn (const pcl::PointCloud<pcl::PointXYZ>& cloud,
          const std::function<LabelledPlanes (const Points&)>& detect)
{
  pcl::Indices all (cloud.size());
  std::iota (all.begin(), all.end(), 0);
  const DetectorInput input{
      pcl_ops::CloudView (cloud), all, Eigen::Vector3d (0, 0, 5), nullptr};
  return detectInFinitePoints (
      input, PlaneDetectorParameters(), [&] (const Points& points, auto&) {
        return detect (points);
      });
}

/** \brief All points are on one plane. */
LabelledPlanes
onePlane (const Points& points)
{
  const Labels labels (points.size(), 0);
  return mergeAssigned (
      {labels, momentsOfLabels (points, labels, 1, 1)}, MergingParameters(), 1);
}

} // namespace

TEST (DetectInFinitePoints, DropsNanBeforeAnyStage)
{
  const auto cloud = roomSeenByCamera (40, 30);
  std::size_t seen = 0;
  detectIn (*cloud, [&] (const Points& points) {
    seen = points.size();
    return LabelledPlanes();
  });
  EXPECT_EQ (seen, 1080u) << "every tenth of 1200 pixels is lost";
}

TEST (DetectInFinitePoints, NamesTheOrientationOfWhatIsFound)
{
  const Detection found = detectIn (*Scene().floor (1, 1).build().cloud, onePlane);
  ASSERT_EQ (found.planes.size(), 1u);
  EXPECT_EQ (found.planes[0].orientation, Orientation::Horizontal);
}

TEST (DetectInFinitePoints, TellsTheNumberBeforeMergingAndTheTime)
{
  const Detection found =
      detectIn (*Scene().floor (1, 1).build().cloud, [] (const Points& points) {
        LabelledPlanes labelled = onePlane (points);
        labelled.planes_before_merging = 7;
        return labelled;
      });
  EXPECT_EQ (found.planes_before_merging, 7u);
  EXPECT_GT (found.durations.detection, 0.0);
}

TEST (DetectInFinitePoints, RunsNoStageWithoutAFinitePoint)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.push_back ({std::numeric_limits<float>::quiet_NaN(), 0, 0});
  detectIn (cloud, [] (const Points&) {
    ADD_FAILURE() << "called";
    return LabelledPlanes();
  });
}
