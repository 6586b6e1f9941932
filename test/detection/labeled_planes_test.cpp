// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/labeled_planes.h"
#include "grid_scene.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

constexpr unsigned two_threads = 2;

/** \brief All points of a cloud, seen from zero, without a search of the user. */
DetectorInput
inputOf (const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  const pcl::Indices* const all_points = nullptr;
  return {CloudView (cloud), all_points, Eigen::Vector3d::Zero(), nullptr};
}

/** \brief The planes of these labels, as a detector returns them that merges none.
 * \param[in] planes number of labels other than no_plane */
LabeledPlanes
unmerged (const Points& points, const Labels& labels, std::size_t planes)
{
  MergingParameters keep_apart;
  keep_apart.enabled = false;
  return mergePlanesOf ({labels, momentsOfLabels (points, labels, planes, one_thread)},
                        keep_apart,
                        one_thread);
}

} // namespace

TEST (MergePlanesOf, MakesNoPlaneOfALineAndOnePlaneOfTwoHalves)
{
  // The 10 points of plane 0 lie on a line. Planes 1 and 2 are two halves of a floor of
  // 100 points, of which the last point is on no plane.
  Points points;
  for (int i = 0; i < 10; ++i)
    points.add (static_cast<float> (i), 7.0f, 7.0f);
  for (int i = 0; i < 100; ++i)
    points.add (static_cast<float> (i % 10), static_cast<float> (i / 10), 0.0f);
  Labels labels (110, 2), expected (110, 0);
  std::fill_n (labels.begin(), 10, 0);
  std::fill_n (labels.begin() + 10, 50, 1);
  std::fill_n (expected.begin(), 10, no_plane);
  labels.back() = expected.back() = no_plane;
  MergingParameters merging;
  merging.distance_threshold = 5_cm;
  const LabeledPlanes found = mergePlanesOf (
      {labels, momentsOfLabels (points, labels, 3, one_thread)}, merging, two_threads);
  EXPECT_EQ (found.labels, expected);
  EXPECT_EQ (found.planes_before_merging, 3u);
  ASSERT_EQ (found.planes.fits.size(), 1u);
  EXPECT_NEAR (std::abs (found.planes.fits[0].plane.normal.z()), 1.0, 1e-9);
  EXPECT_EQ (found.planes.moments[0].count, 99.0);
}

TEST (DetectInFinitePoints, DoesNotCallTheDetectorWithoutAFinitePoint)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  cloud.push_back ({NAN, 0, 0});
  const auto detect = [] (const Points&, auto&) {
    ADD_FAILURE() << "called";
    return LabeledPlanes();
  };
  EXPECT_TRUE (detectInFinitePoints (inputOf (cloud), PlaneDetectorParameters(), detect)
                   .planes.empty());
}

TEST (DetectInFinitePoints, CountsEqualPointsOnceAndLeavesMissingReadingsOnNoPlane)
{
  // In this order: missing readings that a sensor wrote as zeros, a floor, and the
  // points of a ceiling, each of them five times.
  constexpr int missing = 200;
  constexpr int on_floor = 100;
  constexpr int on_ceiling = 50;
  constexpr int copies = 5;
  pcl::PointCloud<pcl::PointXYZ> cloud;
  const auto addPlane = [&] (int number, float z) {
    for (int i = 0; i < number; ++i)
      cloud.push_back ({static_cast<float> (i % 10), static_cast<float> (i / 10), z});
  };
  cloud.resize (missing, pcl::PointXYZ (0.0f, 0.0f, 0.0f));
  addPlane (on_floor, -1.0f);
  for (int copy = 0; copy < copies; ++copy)
    addPlane (on_ceiling, 2.0f);
  const auto detect = [] (const Points& points, auto&) {
    EXPECT_EQ (points.size(), static_cast<std::size_t> (on_floor + on_ceiling));
    Labels labels;
    for (std::size_t i = 0; i < points.size(); ++i)
      labels.push_back (points.origin.z() + points.z[i] < 0.0 ? 0 : 1);
    LabeledPlanes found = unmerged (points, labels, 2);
    found.noises = {1_mm, 2_cm}; // of floor and ceiling
    return found;
  };
  const std::vector<PlaneSegment> planes =
      detectInFinitePoints (inputOf (cloud), PlaneDetectorParameters(), detect).planes;
  ASSERT_EQ (planes.size(), 2u);
  EXPECT_NEAR (planes[0].centroid.z(), 2.0, 1e-9)
      << "the ceiling has more points with its copies";
  EXPECT_EQ (planes[0].moments.count, copies * on_ceiling);
  EXPECT_EQ (planes[1].moments.count, on_floor);
  EXPECT_EQ (planes[0].noise, 2_cm);
  EXPECT_EQ (planes[1].noise, 1_mm);
  const auto all = upTo<pcl::Indices> (cloud.size());
  const auto floor_begin = all.begin() + missing;
  EXPECT_EQ (planes[0].inliers, pcl::Indices (floor_begin + on_floor, all.end()));
  EXPECT_EQ (planes[1].inliers, pcl::Indices (floor_begin, floor_begin + on_floor));
}

TEST (DetectInFinitePoints, TellsByTheChosenPointsAloneWhetherZeroIsTheSensor)
{
  // A sensor at zero sees the ceiling and the floor of a room, but not the floors and
  // ceilings of other stories: for the whole building zero is no sensor, and normals
  // are turned up.
  pcl::PointCloud<pcl::PointXYZ> cloud;
  const auto addLevel = [&cloud] (float z, int half_width) {
    for (int x = -half_width; x <= half_width; ++x)
      for (int y = -half_width; y <= half_width; ++y)
        cloud.push_back (
            {0.1f * static_cast<float> (x), 0.1f * static_cast<float> (y), z});
  };
  addLevel (1.2f, 40); // the ceiling, 4 m to each side
  addLevel (-1.5f, 40);
  const auto of_room = upTo<pcl::Indices> (cloud.size());
  for (const float z : {-4.5f, -3.0f, 3.0f, 4.5f})
    addLevel (z, 100);
  const auto ceilingNormal = [] (const DetectorInput& input) {
    const auto detect = [] (const Points& points, auto&) {
      Labels labels;
      for (std::size_t i = 0; i < points.size(); ++i)
        labels.push_back (
            std::abs (points.origin.z() + points.z[i] - 1.2) < 0.1 ? 0 : no_plane);
      return unmerged (points, labels, 1);
    };
    return detectInFinitePoints (input, PlaneDetectorParameters(), detect)
        .planes.at (0)
        .normal;
  };
  DetectorInput input = inputOf (cloud);
  EXPECT_NEAR (ceilingNormal (input).z(), 1.0, 1e-9) << "of the building";
  input.indices = &of_room;
  EXPECT_NEAR (ceilingNormal (input).z(), -1.0, 1e-9) << "towards the sensor";
}

TEST (DetectInFinitePoints, TakesAViewpointOfNaNForAnUnknownOne)
{
  const auto detect = [] (const Points& points, auto&) {
    return unmerged (points, Labels (points.size(), 0), 1);
  };
  for (const float height : {-1.0f, 1.0f}) { // of a floor and of a ceiling
    pcl::PointCloud<pcl::PointXYZ> cloud;
    for (int i = 0; i < 100; ++i)
      cloud.push_back (
          {static_cast<float> (i % 10), static_cast<float> (i / 10), height});
    DetectorInput input = inputOf (cloud);
    for (const double z : {0.0, double (NAN)}) {
      input.viewpoint.z() = z;
      const auto planes =
          detectInFinitePoints (input, PlaneDetectorParameters(), detect).planes;
      ASSERT_EQ (planes.size(), 1u);
      EXPECT_NEAR (planes[0].normal.z(), -height, 1e-9) << "towards zero";
    }
  }
}

TEST (MergingOf, TakesTheDistanceThresholdOfTheDetectorWhereMergingHasNone)
{
  PlaneDetectorParameters parameters;
  parameters.distance_threshold = 7_cm;
  EXPECT_EQ (mergingOf (parameters).distance_threshold, 7_cm);
  parameters.merging.distance_threshold = 1_cm;
  EXPECT_EQ (mergingOf (parameters).distance_threshold, 1_cm);
}
