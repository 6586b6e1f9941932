// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/search/brute_force.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>
#include <pcl/search/organized.h>

#include "presets.h"
#include "scene.h"
#include <pcl_ops/detect_planes.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/plane_extent.h>

#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <thread>

// What holds for the three detectors with their default parameters, and for OPS on
// voxels and with the parameters of the paper.

using pcl_ops::PlaneSegment;

namespace {

/** \brief A point in a memory layout that no point type of PCL has. */
struct TimedPoint {
  double seconds;
  float x, y, z;
};

/** \brief Clouds without a plane, by name. */
std::map<std::string, Cloud::Ptr>
cloudsWithoutAPlane ()
{
  RandomGenerator generator (seedOfTest());
  const auto curve = [] (float i) { return pcl::PointXYZ (i, i * i, 0); };
  const auto equal = [] (float) { return pcl::PointXYZ (1.1f, 2.2f, 3.3f); };
  const auto not_finite = [] (float i) { return pcl::PointXYZ (NAN, i, 2); };
  const auto line = [] (float i) {
    return pcl::PointXYZ (0.01f * i, 1 - 0.02f * i, 3 + 0.005f * i);
  };
  const auto clutter = [&] (float) {
    return toPoint (10.0 * drawGaussians (generator));
  };
  return {{"a point", cloudOf (1, curve)},
          {"two points", cloudOf (2, curve)},
          {"three points", cloudOf (3, curve)},
          {"equal points", cloudOf (1000, equal)},
          {"nothing finite", cloudOf (500, not_finite)},
          {"clutter", cloudOf (2000, clutter)},
          {"a line", cloudOf (5000, line)}};
}

/** \brief Fails unless the first planes, the largest, are near the surfaces of the
 * scene. More planes, of clutter, may follow. */
void
expectHasEverySurface (std::vector<PlaneSegment> planes, const LabeledScene& scene)
{
  ASSERT_GE (planes.size(), scene.surfaces.size());
  planes.resize (scene.surfaces.size());
  expectFindsEverySurface (planes, scene);
}

std::vector<pcl::Indices>
indicesOf (const std::vector<pcl::PointIndices>& clusters)
{
  std::vector<pcl::Indices> indices;
  for (const pcl::PointIndices& cluster : clusters)
    indices.push_back (cluster.indices);
  return indices;
}

Eigen::Vector4f
coefficientsOf (const PlaneSegment& plane)
{
  Eigen::Vector4d coefficients;
  coefficients << plane.normal, plane.plane().offset;
  return coefficients.cast<float>();
}

/** \brief Fails unless every function of a detector that finds planes returns false and
 * empties its outputs. The first call has to print \p message on the standard error. */
template <typename Detector>
void
expectRefused (Detector& detector, const std::string& message)
{
  constexpr std::size_t size_before = 9;
  std::vector<PlaneSegment> planes (size_before);
  std::vector<pcl::ModelCoefficients> coefficients (size_before);
  std::vector<pcl::PointIndices> inliers (size_before), clusters (size_before);
  typename Detector::PlanarRegions regions (size_before);
  pcl::PointIndices of_largest;
  pcl::ModelCoefficients largest;
  of_largest.indices = {1, 2, 3};
  largest.values = {1, 2, 3, 4};
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE (detector.segment (coefficients, inliers));
  const std::string printed = ::testing::internal::GetCapturedStderr();
  const std::string name = Detector::Parameters::class_name;
  EXPECT_NE (printed.find ("[pcl_ops::" + name + "::segment] " + message),
             std::string::npos)
      << printed;
  EXPECT_FALSE (detector.segment (planes));
  EXPECT_FALSE (detector.extract (clusters));
  EXPECT_FALSE (detector.segment (of_largest, largest));
  EXPECT_TRUE (of_largest.indices.empty() && largest.values.empty());
  of_largest.indices = {1, 2, 3};
  largest.values = {1, 2, 3, 4};
  EXPECT_FALSE (detector.segmentLargest (of_largest, largest));
  EXPECT_FALSE (detector.segment (regions));
  EXPECT_TRUE (coefficients.empty() && inliers.empty() && planes.empty());
  EXPECT_TRUE (clusters.empty() && regions.empty());
  EXPECT_TRUE (of_largest.indices.empty() && largest.values.empty());
}

} // namespace

/** \brief A detector whose input is a room. The room is so dense that each detector
 * finds all of its surfaces. */
template <typename Detector>
class PlaneDetector : public ::testing::Test {
protected:
  PlaneDetector() { setInputCloud (room.cloud); }

  void
  setInputCloud (const Cloud::ConstPtr& cloud)
  {
    // By the base class, as code that is written for any class of PCL calls it.
    static_cast<pcl::PCLBase<pcl::PointXYZ>&> (detector).setInputCloud (cloud);
  }

  LabeledScene room = denseRoom().build();
  Detector detector;
};

/** \brief OPS as in the paper, with enough samples for a small scene. */
struct OpsOfPaper : Ops {
  OpsOfPaper() : Ops (paperOn (nullptr)) {}
};

/** \brief OPS on voxels, with enough samples for a small scene. */
struct OpsOnVoxels : Ops {
  OpsOnVoxels() : Ops (voxelsOn (nullptr)) {}
};

using Detectors = ::testing::Types<Ops,
                                   OpsOfPaper,
                                   pcl_ops::FastSamplingPlaneFiltering<pcl::PointXYZ>,
                                   pcl_ops::KernelHoughTransform<pcl::PointXYZ>,
                                   OpsOnVoxels>;
TYPED_TEST_SUITE (PlaneDetector, Detectors);

TYPED_TEST (PlaneDetector, SucceedsWithoutPlanesWhereThereIsNone)
{
  for (const auto& [name, cloud] : cloudsWithoutAPlane()) {
    SCOPED_TRACE (name);
    this->setInputCloud (cloud);
    EXPECT_TRUE (planesOf (this->detector).empty());
    pcl::PointIndices inliers;
    pcl::ModelCoefficients coefficients;
    inliers.indices = {1, 2, 3};
    coefficients.values = {1, 2, 3, 4};
    EXPECT_TRUE (
        this->detector.segment (inliers, coefficients)); // of the largest plane
    EXPECT_TRUE (inliers.indices.empty() && coefficients.values.empty());
  }
}

TYPED_TEST (PlaneDetector, FindsTheSamePlanesInABufferOfTheUser)
{
  std::vector<TimedPoint> points;
  for (const pcl::PointXYZ& point : *this->room.cloud)
    points.push_back ({0.0, point.x, point.y, point.z});
  const pcl_ops::CloudView view (
      points.data(), offsetof (TimedPoint, x), sizeof (TimedPoint), points.size());
  std::vector<pcl::Indices> inliers;
  for (const PlaneSegment& plane : detectPlanes (view, this->detector.getParameters()))
    inliers.push_back (plane.inliers);
  ASSERT_GE (inliers.size(), 3u);
  EXPECT_EQ (inliers, inliersOf (this->detector));
}

TYPED_TEST (PlaneDetector, GivesTheSamePlanesByEveryOverload)
{
  this->room.cloud->header.frame_id = "camera";
  this->room.cloud->header.stamp = 1234;
  const std::vector<PlaneSegment> planes = planesOf (this->detector);
  const std::vector<pcl::Indices> expected = inliersOf (this->detector);
  constexpr std::size_t size_before = 99; // segment must replace what is there
  std::vector<pcl::ModelCoefficients> coefficients (size_before);
  std::vector<pcl::PointIndices> inliers (size_before);
  ASSERT_TRUE (this->detector.segment (coefficients, inliers));
  EXPECT_EQ (indicesOf (inliers), expected);
  ASSERT_EQ (coefficients.size(), planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    ASSERT_EQ (coefficients[i].values.size(), 4u);
    EXPECT_TRUE (coefficientsOf (planes[i]).isApprox (
        Eigen::Map<const Eigen::Vector4f> (coefficients[i].values.data())));
    EXPECT_EQ (inliers[i].header.frame_id, "camera");
    EXPECT_EQ (inliers[i].header.stamp, 1234u);
    EXPECT_EQ (coefficients[i].header.frame_id, "camera");
  }
  ASSERT_TRUE (this->detector.extract (inliers));
  EXPECT_EQ (indicesOf (inliers), expected);
  pcl::PointIndices of_largest;
  pcl::ModelCoefficients largest;
  ASSERT_TRUE (this->detector.segment (of_largest, largest)); // that of SACSegmentation
  EXPECT_EQ (of_largest.indices, planes.at (0).inliers);
  EXPECT_EQ (largest.values, coefficients[0].values);
  pcl::PointIndices of_segment_largest;
  pcl::ModelCoefficients segment_largest;
  ASSERT_TRUE (this->detector.segmentLargest (of_segment_largest, segment_largest));
  EXPECT_EQ (of_segment_largest.indices, of_largest.indices);
  EXPECT_EQ (segment_largest.values, largest.values);
  EXPECT_EQ (of_segment_largest.header.frame_id, "camera");
}

TYPED_TEST (PlaneDetector, ReturnsNoPlaneWithFewerPointsThanTheMinimum)
{
  const std::vector<pcl::Indices> all_planes = inliersOf (this->detector);
  ASSERT_GE (all_planes.size(), 3u);
  const std::size_t size_of_second = all_planes[1].size();
  ASSERT_GT (size_of_second, all_planes.back().size());
  for (const std::size_t min_points : {size_of_second, size_of_second + 1}) {
    this->detector.setMinPoints (min_points);
    std::vector<pcl::Indices> large_planes;
    for (const pcl::Indices& inliers : all_planes)
      if (inliers.size() >= min_points)
        large_planes.push_back (inliers);
    EXPECT_EQ (inliersOf (this->detector), large_planes) << min_points;
  }
}

TYPED_TEST (PlaneDetector, SucceedsWhereEveryPlaneHasFewerPointsThanTheMinimum)
{
  EXPECT_EQ (this->detector.getMinPoints(), 0u) << "by default";
  this->detector.setMinPoints (this->room.cloud->size() + 1);
  EXPECT_TRUE (planesOf (this->detector).empty());
}

TYPED_TEST (PlaneDetector, GivesPlanarRegionsWithHullsAsContours)
{
  const std::vector<PlaneSegment> planes = planesOf (this->detector);
  ASSERT_GE (planes.size(), 3u);
  typename TypeParam::PlanarRegions regions;
  ASSERT_TRUE (this->detector.segment (regions));
  ASSERT_EQ (regions.size(), planes.size());
  for (std::size_t i = 0; i < planes.size(); ++i) {
    EXPECT_TRUE (regions[i].getCoefficients().isApprox (coefficientsOf (planes[i])));
    EXPECT_TRUE (regions[i].getCentroid().isApprox (planes[i].centroid.cast<float>()));
    EXPECT_TRUE (regions[i].getCovariance().isApprox (
        planes[i].moments.covariance().cast<float>()));
    EXPECT_EQ (regions[i].getCount(), planes[i].inliers.size());
    const std::vector<Eigen::Vector3d> hull =
        pcl_ops::planeExtent (*this->room.cloud, planes[i]).hull;
    const auto& contour = regions[i].getContour();
    ASSERT_EQ (contour.size(), hull.size());
    for (std::size_t k = 0; k < hull.size(); ++k)
      EXPECT_TRUE (contour[k].getVector3fMap().isApprox (hull[k].cast<float>()));
  }
}

TYPED_TEST (PlaneDetector,
            SortsPlanesByFallingSizeAndTheIndicesOfEachWhichAreOnNoOtherPlane)
{
  // Four floors above each other, 1 m apart, of 1, 4, 1.5 and 3 square meters.
  const Cloud::ConstPtr cloud = Scene()
                                    .floor (1, 1, 0)
                                    .floor (2, 2, 1)
                                    .floor (1.5, 1, 2)
                                    .floor (3, 1, 3)
                                    .spacing (2_cm)
                                    .build()
                                    .cloud;
  this->setInputCloud (cloud);
  const std::vector<pcl::Indices> planes = inliersOf (this->detector);
  ASSERT_EQ (planes.size(), 4u);
  std::set<pcl::index_t> on_planes;
  std::size_t previous_size = cloud->size();
  for (const pcl::Indices& inliers : planes) {
    EXPECT_LE (inliers.size(), previous_size);
    previous_size = inliers.size();
    EXPECT_TRUE (std::is_sorted (inliers.begin(), inliers.end()));
    for (const pcl::index_t i : inliers)
      EXPECT_TRUE (on_planes.insert (i).second) << "point " << i << " is on two planes";
  }
}

TYPED_TEST (PlaneDetector, HasNormalsThatPointTowardsTheSensor)
{
  // A sensor near the middle of the room, then one behind both walls and below the
  // floor.
  for (const float side : {1.0f, -1.0f}) {
    Eigen::Vector4f& sensor = this->room.cloud->sensor_origin_;
    sensor << side * 2, side * 1.5f, side * 1.2f, 0;
    const std::vector<PlaneSegment> planes = planesOf (this->detector);
    ASSERT_GE (planes.size(), 3u);
    for (const PlaneSegment& plane : planes) {
      EXPECT_NEAR (plane.normal.norm(), 1.0, 1e-9);
      EXPECT_GT (plane.plane().distance (sensor.head<3>().cast<double>()), 0.0);
    }
  }
}

TYPED_TEST (PlaneDetector, GivesCentroidRmsAndMomentsOfThePointsOfEachPlane)
{
  const std::vector<PlaneSegment> planes = planesOf (this->detector);
  ASSERT_GE (planes.size(), 3u);
  for (const PlaneSegment& plane : planes) {
    const Cloud inliers (*this->room.cloud, plane.inliers);
    // Coordinates are the first three of the four floats of a point.
    const Eigen::MatrixXd points = inliers.getMatrixXfMap (3, 4, 0).cast<double>();
    const Eigen::RowVectorXd distances_from_plane =
        (plane.normal.transpose() * points).array() + plane.plane().offset;
    EXPECT_LT ((plane.centroid - points.rowwise().mean()).norm(), 1e-6);
    EXPECT_NEAR (
        plane.rms(), std::sqrt (distances_from_plane.array().square().mean()), 1e-6);
    EXPECT_LT (plane.rms(), 1_cm) << "1 mm of noise, but some clutter is on the plane";
    EXPECT_EQ (plane.moments.count, plane.inliers.size());
    const auto fit = fitPlane (plane.moments).value();
    EXPECT_LT (angleBetween (fit.plane.normal, plane.normal), 1e-6);
  }
}

TYPED_TEST (PlaneDetector, NamesTheOrientationOfEachPlane)
{
  this->setInputCloud (
      Scene()
          .floor (3, 3)
          .wall ({0, 0}, {2, 0}, 2.5)
          .surface ({5, 0, 0}, {1.4, 0, 1.4}, {0, 1.5, 0}) // 45 degrees
          .spacing (2_cm)
          .build()
          .cloud);
  const auto planes = planesOf (this->detector);
  ASSERT_EQ (planes.size(), 3u);
  EXPECT_EQ (planes[0].orientation, pcl_ops::Orientation::Horizontal);
  EXPECT_EQ (planes[1].orientation, pcl_ops::Orientation::Vertical);
  EXPECT_EQ (planes[2].orientation, pcl_ops::Orientation::Other);
}

TYPED_TEST (PlaneDetector, FindsEverySurfaceOfOneCloudAfterAnother)
{
  TypeParam detector;
  std::vector<PlaneSegment> planes;
  EXPECT_FALSE (detector.segment (planes)) << "there is no cloud yet";
  const LabeledScene small = Scene().floor (1.5, 1.5).spacing (2_cm).build();
  for (const LabeledScene& scene : {this->room, small, this->room}) {
    detector.setInputCloud (scene.cloud);
    expectHasEverySurface (planesOf (detector), scene);
  }
}

TYPED_TEST (PlaneDetector, GivesTheSamePlanesByTwoObjectsInTwoThreadsAtOnce)
{
  TypeParam first = this->detector;
  first.setNumberOfThreads (2);
  TypeParam& second = this->detector;
  std::vector<pcl::Indices> of_first, of_second;
  std::thread thread_of_second ([&] { of_second = inliersOf (second); });
  of_first = inliersOf (first);
  thread_of_second.join();
  EXPECT_EQ (of_first, of_second);
  EXPECT_GE (of_first.size(), 3u);
}

TYPED_TEST (PlaneDetector, GivesTheSamePlanesForAnyNumberOfThreadsAndByACopy)
{
  // 140,000 points: more than a thread takes at once in any stage.
  constexpr double spacing = 1.45e-2; // [m]
  const Cloud::Ptr cloud = room().spacing (spacing).noise (2_cm).build().cloud;
  (*cloud)[7].x = NAN;
  this->setInputCloud (cloud);
  const std::vector<pcl::Indices> planes = inliersOf (this->detector);
  ASSERT_FALSE (planes.empty());
  constexpr unsigned all_threads = 0;
  for (const unsigned threads : {2u, 5u, all_threads}) {
    TypeParam copy = this->detector;
    copy.setNumberOfThreads (threads);
    EXPECT_EQ (inliersOf (copy), planes) << threads << " threads";
  }
}

TYPED_TEST (PlaneDetector, HasStagesThatTakeTimeAndTogetherNoMoreThanTheDetection)
{
  planesOf (this->detector);
  const pcl_ops::StageDurations& durations = this->detector.getStageDurations(); // [ms]
  for (const double stage : {durations.search,
                             durations.extraction,
                             durations.assignment,
                             durations.merging})
    EXPECT_GT (stage, 0.0);
  const bool needs_normals = std::is_base_of_v<Ops, TypeParam>;
  EXPECT_EQ (durations.normals > 0.0, needs_normals);
  EXPECT_LE (durations.search + durations.normals + durations.extraction +
                 durations.assignment + durations.merging,
             durations.detection);
}

TYPED_TEST (PlaneDetector, PutsPointsThatAreNotFiniteOnNoPlane)
{
  LabeledScene& scene = this->room;
  scene.cloud->is_dense = true; // although points follow that are not finite
  for (std::size_t i = 0; i < scene.labels.size(); i += 3) {
    (*scene.cloud)[i].z = i % 2 ? NAN : HUGE_VALF;
    scene.labels[i] = -1;
  }
  const std::vector<PlaneSegment> planes = planesOf (this->detector);
  expectHasEverySurface (planes, scene);
  for (const PlaneSegment& plane : planes)
    for (const pcl::index_t i : plane.inliers)
      ASSERT_NE (i % 3, 0) << "point " << i << " is not finite";
}

TYPED_TEST (PlaneDetector,
            UsesTheGivenIndicesAloneInAnyOrderAndByEachTypeThatPclHasForThem)
{
  constexpr int label_of_floor = 0;
  pcl::Indices given;
  for (std::size_t i = 0; i < this->room.labels.size(); ++i)
    if (this->room.labels[i] == label_of_floor)
      given.push_back (i);
  const auto point_indices = pcl::make_shared<pcl::PointIndices>();
  point_indices->indices = given;
  TypeParam& detector = this->detector;
  detector.setIndices (pcl::make_shared<pcl::Indices> (given));
  const std::vector<pcl::Indices> floor = inliersOf (detector);
  ASSERT_EQ (floor.size(), 1u);
  EXPECT_TRUE (
      std::includes (given.begin(), given.end(), floor[0].begin(), floor[0].end()));
  // A few of some 30,000 points are farther from the plane than the noise allows.
  EXPECT_GE (static_cast<double> (floor[0].size()),
             0.999 * static_cast<double> (given.size()));
  detector.setIndices (pcl::IndicesConstPtr (new pcl::Indices (given)));
  EXPECT_EQ (inliersOf (detector), floor);
  detector.setIndices (pcl::PointIndicesConstPtr (point_indices));
  EXPECT_EQ (inliersOf (detector), floor);
  std::reverse (given.begin(), given.end());
  given.push_back (given.front()); // a repetition
  detector.setIndices (pcl::make_shared<pcl::Indices> (given));
  EXPECT_EQ (inliersOf (detector), floor);
}

TYPED_TEST (PlaneDetector, UsesOnlyTheGivenRowsAndColumnsOfAnOrganizedCloud)
{
  constexpr int width = 160;
  this->setInputCloud (roomSeenByCamera (width, 120));
  constexpr int first_row = 70, first_column = 10, rows = 50, columns = 140;
  this->detector.setIndices (first_row, first_column, rows, columns);
  const std::vector<pcl::Indices> planes = inliersOf (this->detector);
  ASSERT_FALSE (planes.empty());
  for (const pcl::Indices& inliers : planes)
    for (const pcl::index_t i : inliers) {
      ASSERT_GE (i / width, first_row); // the last row is that of the image
      ASSERT_GE (i % width, first_column);
      ASSERT_LT (i % width, first_column + columns);
    }
}

TYPED_TEST (PlaneDetector, UsesIndicesAsTheUserChangesThemAndAllPointsWithoutIndices)
{
  const auto given =
      pcl::make_shared<pcl::Indices> (upTo<pcl::Indices> (this->room.cloud->size()));
  this->detector.setIndices (given);
  EXPECT_FALSE (planesOf (this->detector).empty());
  given->resize (3); // too few points for a plane
  EXPECT_TRUE (planesOf (this->detector).empty());
  this->detector.setIndices (pcl::IndicesPtr());
  expectHasEverySurface (planesOf (this->detector), this->room);
}

TYPED_TEST (PlaneDetector, ChangesNeitherIndicesNorTheCloud)
{
  const auto given = pcl::make_shared<pcl::Indices> (pcl::Indices{9, 7, 8, 7});
  const Cloud before = *this->room.cloud;
  planesOf (this->detector);
  this->detector.setIndices (given);
  planesOf (this->detector);
  EXPECT_EQ (*given, (pcl::Indices{9, 7, 8, 7}));
  EXPECT_EQ (this->detector.getIndices(), given);
  for (std::size_t i = 0; i < before.size(); ++i)
    ASSERT_EQ ((*this->room.cloud)[i].getVector3fMap(), before[i].getVector3fMap());
}

TYPED_TEST (PlaneDetector,
            FailsWithAMessageForAMissingCloudWrongIndicesAndAWrongParameter)
{
  TypeParam without_cloud;
  expectRefused (without_cloud, "no input cloud; call setInputCloud");
  const pcl::index_t beyond_cloud = this->room.cloud->size();
  for (const auto& [indices, message] :
       std::vector<std::pair<pcl::Indices, std::string>>{
           {{}, "the indices are empty"},
           {{0, -1, 1}, "an index lies outside the input cloud"},
           {{0, beyond_cloud, 1}, "an index lies outside the input cloud"}}) {
    this->detector.setIndices (pcl::make_shared<pcl::Indices> (indices));
    expectRefused (this->detector, message);
  }
  this->detector.setIndices (pcl::IndicesPtr());
  this->setInputCloud (pcl::make_shared<Cloud>());
  expectRefused (this->detector, "the input cloud is empty");
  this->setInputCloud (this->room.cloud);
  this->detector.setDistanceThreshold (-0.05);
  expectRefused (this->detector, "the distance threshold must be a length above 0");
}

TYPED_TEST (PlaneDetector, FindsAnExactPlaneOnAGrid)
{
  constexpr float spacing = 0.03f; // [m]
  this->setInputCloud (cloudOf (10000, [] (float i) {
    return pcl::PointXYZ (
        spacing * std::fmod (i, 100.0f), spacing * std::floor (i / 100), 1);
  }));
  EXPECT_EQ (inliersOf (this->detector),
             std::vector<pcl::Indices>{upTo<pcl::Indices> (10000)});
}

TYPED_TEST (PlaneDetector, FindsTwoParallelPlanesIfTheyAreFartherApartThanTheThreshold)
{
  constexpr double threshold = 5_cm;
  for (const double height : {1_cm, 15_cm}) {
    Scene two_floors = Scene().floor (3, 3, 0).floor (3, 3, height);
    this->setInputCloud (two_floors.spacing (2_cm).build().cloud);
    this->detector.setDistanceThreshold (threshold);
    EXPECT_EQ (planesOf (this->detector).size(), height < threshold ? 1u : 2u);
  }
}

TYPED_TEST (PlaneDetector, ReportsTheGivenThresholdAsUsed)
{
  this->setInputCloud (Scene().floor (3, 3).spacing (2_cm).build().cloud);
  this->detector.setDistanceThreshold (1_mm);
  ASSERT_FALSE (planesOf (this->detector).empty());
  EXPECT_EQ (this->detector.getUsedLengths().distance_threshold, 1_mm);
}

TYPED_TEST (PlaneDetector, MergesTwoHalvesOfAFloorUnlessMergingIsOff)
{
  // The second half is 4 cm higher: more than the threshold, less than the merging
  // distance. On voxels a strip along the step may be on no plane.
  Scene halves = Scene().floor (2, 3).surface ({2, 0, 4_cm}, {2, 0, 0}, {0, 3, 0});
  const Cloud::ConstPtr cloud = halves.spacing (2_cm).build().cloud;
  this->setInputCloud (cloud);
  this->detector.setDistanceThreshold (1_cm);
  pcl_ops::MergingParameters merging;
  merging.distance_threshold = 5_cm;
  for (const bool is_on : {true, false}) {
    merging.enabled = is_on;
    this->detector.setMergingParameters (merging);
    const std::vector<PlaneSegment> planes = planesOf (this->detector);
    ASSERT_FALSE (planes.empty());
    const bool is_merged = planes[0].inliers.size() > 0.6 * cloud->size();
    EXPECT_EQ (is_merged, is_on);
    EXPECT_GE (this->detector.getNumberOfPlanesBeforeMerging(), 2u);
  }
}

TEST (Ops, FindsNoPlaneAtASamplingRateThatDrawsNoPoint)
{
  for (Ops ops : {opsOn (room().build().cloud),
                  voxelsOn (room().build().cloud),
                  paperOn (room().build().cloud)}) {
    ops.setSamplingRate (1e-9);
    EXPECT_TRUE (planesOf (ops).empty());
  }
}

TEST (Ops, HasNoInlierFartherFromItsPlaneThanTheThresholdOnNoisySurfaces)
{
  // The threshold is the noise, one standard deviation: a third of the points is
  // farther from the true surface.
  const auto cloud = room().noise (1_cm).spacing (2_cm).build().cloud;
  for (Ops ops : {opsOn (cloud), voxelsOn (cloud)}) {
    ops.setDistanceThreshold (1_cm);
    const std::vector<PlaneSegment> planes = planesOf (ops);
    ASSERT_GE (planes.size(), 3u);
    for (const PlaneSegment& plane : planes)
      for (const pcl::index_t i : plane.inliers)
        ASSERT_LT (std::abs (plane.plane().distance (
                       (*cloud)[i].getVector3fMap().cast<double>())),
                   1.1e-2)
            << "1 cm, and 1 mm as the last fit moves the plane";
  }
}

TEST (Ops, FindsOnlyTrueSurfacesAThousandKilometersFromZero)
{
  // A thousand kilometers from zero, coordinates in single precision have steps of 6
  // cm. In a hall OPS finds all surfaces, whatever its parameters. In a room it has to
  // with the parameters of the paper alone; with others it may find fewer surfaces.
  const Eigen::Vector3d shift (1e6, -1e6, 1e6);
  const LabeledScene hall = Scene()
                                .floor (40_m, 30_m)
                                .wall ({0, 0}, {40, 0}, 25_m)
                                .wall ({0, 0}, {0, 30}, 25_m)
                                .spacing (20_cm)
                                .movedBy (shift)
                                .build();
  const LabeledScene small = room().movedBy (shift).spacing (2_cm).build();
  const struct {
    Ops ops;
    LabeledScene scene;
    std::size_t min_planes;
  } rows[] = {{opsOn (hall.cloud), hall, 3},
              {voxelsOn (hall.cloud), hall, 3},
              {paperOn (hall.cloud), hall, 3},
              {opsOn (small.cloud), small, 0},
              {voxelsOn (small.cloud), small, 0},
              {paperOn (small.cloud), small, 3}};
  for (auto [ops, scene, min_planes] : rows) {
    const std::vector<PlaneSegment> planes = planesOf (ops);
    EXPECT_GE (planes.size(), min_planes);
    EXPECT_LE (planes.size(), 3u);
    std::set<const Surface*> found;
    for (const PlaneSegment& plane : planes) {
      const auto is_near_plane = [&] (const Surface& surface) {
        return isNear (plane.plane(), surface, 1_deg, 4_cm);
      };
      const auto surface =
          std::find_if (scene.surfaces.begin(), scene.surfaces.end(), is_near_plane);
      ASSERT_NE (surface, scene.surfaces.end());
      EXPECT_TRUE (found.insert (&*surface).second) << "a surface is found once";
    }
  }
}

TEST (SearchMethod, GivesTheSamePlanesForAnySearchAndAnyCloudThatWasSetInIt)
{
  using Search = pcl::search::Search<pcl::PointXYZ>;
  const Cloud::Ptr other_cloud = Scene().floor (1, 1).build().cloud;
  Ops ops = paperOn (room().spacing (8_cm).build().cloud);
  ops.setSamplingRate (0.2);
  ops.setNumberOfThreads (2);
  const std::vector<pcl::Indices> planes_by_default_search = inliersOf (ops);
  EXPECT_EQ (planes_by_default_search.size(), 3u);
  constexpr double octree_resolution = 10_cm;
  for (const Search::Ptr& search :
       {Search::Ptr (new pcl::search::KdTree<pcl::PointXYZ>),
        Search::Ptr (new pcl::search::Octree<pcl::PointXYZ> (octree_resolution)),
        Search::Ptr (new pcl::search::BruteForce<pcl::PointXYZ>)}) {
    search->setInputCloud (other_cloud,
                           pcl::make_shared<pcl::Indices> (pcl::Indices{1, 2, 3}));
    ops.setSearchMethod (search);
    EXPECT_EQ (inliersOf (ops), planes_by_default_search) << search->getName();
  }
}

/** \brief A search with a bug: it returns the index behind the last point of a cloud.
 */
class SearchBeyondTheCloud : public pcl::search::KdTree<pcl::PointXYZ> {
public:
  using KdTree::nearestKSearch;
  int
  nearestKSearch (const pcl::PointXYZ& point,
                  int k,
                  pcl::Indices& indices,
                  std::vector<float>& squared_distances) const override
  {
    const int found = KdTree::nearestKSearch (point, k, indices, squared_distances);
    indices.back() = static_cast<pcl::index_t> (getInputCloud()->size());
    return found;
  }
};

TEST (SearchMethod, ThatReturnsAnIndexOutsideTheCloudIsRefused)
{
  Ops ops = paperOn (room().build().cloud);
  ops.setSearchMethod (pcl::make_shared<SearchBeyondTheCloud>());
  std::vector<PlaneSegment> planes;
  EXPECT_FALSE (ops.segment (planes));
}

TEST (SearchMethod, MayBeOrganizedNeighborAndDoesNotCrashOnAnUnorganizedCloud)
{
  Ops ops = paperOn (roomSeenByCamera (160, 120));
  ops.setSearchMethod (
      pcl::make_shared<pcl::search::OrganizedNeighbor<pcl::PointXYZ>>());
  ops.setUpAxis (-Eigen::Vector3f::UnitY());
  std::vector<PlaneSegment> planes = planesOf (ops);
  ASSERT_EQ (planes.size(), 2u);
  const Surface wall{{0, 0, 3}, {1, 0, 0}, {0, 1, 0}};  // z = 3 m
  const Surface floor{{0, 1, 2}, {1, 0, 0}, {0, 0, 1}}; // y = 1 m
  EXPECT_TRUE (isNear (planes[0].plane(), wall, 2_deg, 3_cm));
  EXPECT_TRUE (isNear (planes[1].plane(), floor, 2_deg, 3_cm));
  ops.setInputCloud (room().build().cloud);
  ops.segment (planes); // PCL's search prints on stderr that the cloud is not organized
}

TEST (DetectPlanes, ThrowsForAnEmptyCloudAWrongParameterAndABufferThatIsNoCloud)
{
  using Parameters = pcl_ops::OrientedPointSamplingParameters;
  const std::vector<float> buffer (100);
  constexpr std::size_t offset = 4, stride = 16; // [bytes]
  constexpr std::size_t number = 6;              // of points
  const pcl_ops::CloudView points (buffer.data(), offset, stride, number);
  Parameters wrong;
  wrong.sampling_rate = 0.0;
  EXPECT_THROW (detectPlanes (pcl_ops::CloudView(), Parameters()),
                std::invalid_argument);
  EXPECT_THROW (detectPlanes (points, wrong), std::invalid_argument);
  EXPECT_THROW (pcl_ops::CloudView (buffer.data(), offset + 1, stride, number),
                std::invalid_argument)
      << "the floats are not aligned";
  EXPECT_THROW (pcl_ops::CloudView (buffer.data(), offset, stride + 2, number),
                std::invalid_argument)
      << "the floats are not aligned";
  EXPECT_THROW (pcl_ops::CloudView (buffer.data(), stride - 8, stride, number),
                std::invalid_argument)
      << "y and z would be in the next point";
  EXPECT_THROW (pcl_ops::CloudView (nullptr, 0, stride, number), std::invalid_argument);
  EXPECT_NO_THROW (pcl_ops::CloudView (nullptr, 0, stride, 0)) << "no points";
  constexpr std::size_t too_many_for_indices = std::size_t (1) << 31;
  pcl_ops::CloudView too_large = points;
  too_large.size = too_many_for_indices;
  EXPECT_THROW (detectPlanes (too_large, Parameters()), std::invalid_argument);
  EXPECT_THROW (pcl_ops::CloudView (buffer.data(), 0, stride, too_many_for_indices),
                std::invalid_argument);
}
