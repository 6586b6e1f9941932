// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "presets.h"
#include "scene.h"

namespace {

class BadInputFor : public EachPreset {};

INSTANTIATE_TEST_SUITE_P (Presets,
                          BadInputFor,
                          ::testing::Values ("default", "paper"),
                          presetName);

/** \brief Misuse: false, empty outputs, and one message that names the fix. */
void
expectRefused (Ops& ops, const std::string& message)
{
  std::vector<pcl::ModelCoefficients> coefficients (9);
  std::vector<pcl::PointIndices> inliers (9);
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE (ops.segment (coefficients, inliers));
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_NE (said.find ("[pcl_ops::OrientedPointSampling::segment]"),
             std::string::npos);
  EXPECT_NE (said.find (message), std::string::npos) << said;
  EXPECT_TRUE (coefficients.empty());
  EXPECT_TRUE (inliers.empty());
}

} // namespace

TEST_P (BadInputFor, IsRefusedInWords)
{
  const auto cloud = room().build().cloud;
  const auto end = static_cast<pcl::index_t> (cloud->size());
  Ops without_cloud = detectorFor (nullptr),
      empty = detectorFor (pcl::make_shared<Cloud>());
  expectRefused (without_cloud, "no input cloud; call setInputCloud");
  expectRefused (empty, "the input cloud is empty");
  for (const auto& [indices, message] :
       std::vector<std::pair<pcl::Indices, std::string>>{
           {{}, "the indices are empty"},
           {{0, -1, 1}, "an index lies outside the input cloud"},
           {{0, end, 1}, "an index lies outside the input cloud"}}) {
    Ops ops = detectorFor (cloud);
    ops.setIndices (pcl::make_shared<pcl::Indices> (indices));
    expectRefused (ops, message);
  }
  Ops wrong = detectorFor (cloud);
  wrong.setDistanceThreshold (-0.05);
  expectRefused (wrong, "the distance threshold must be a length above 0");
}

TEST_P (BadInputFor, RefusalByEveryOverload)
{
  Ops ops = detectorFor (nullptr);
  std::vector<pcl_ops::PlaneSegment> planes (9);
  std::vector<pcl::PointIndices> clusters (9);
  pcl::PointIndices inliers;
  pcl::ModelCoefficients coefficients;
  inliers.indices = {1, 2, 3};
  coefficients.values = {1, 2, 3, 4};
  EXPECT_FALSE (ops.segment (planes));
  EXPECT_FALSE (ops.extract (clusters));
  EXPECT_FALSE (ops.segment (inliers, coefficients));
  Ops::PlanarRegions regions (9);
  EXPECT_FALSE (ops.segment (regions));
  EXPECT_TRUE (planes.empty() && clusters.empty() && regions.empty());
  EXPECT_TRUE (inliers.indices.empty() && coefficients.values.empty());
}

TEST_P (BadInputFor, AfterARefusalTheObjectWorks)
{
  const auto scene = room().build();
  Ops ops = detectorFor (nullptr);
  expectRefused (ops, "no input cloud");
  ops.setInputCloud (scene.cloud);
  expectFindsEverySurface (planesOf (ops), scene);
}

TEST_P (BadInputFor, OneTwoAndThreePoints)
{
  for (const std::size_t size : {1u, 2u, 3u}) {
    Ops ops = detectorFor (
        cloudOf (size, [] (float i) { return pcl::PointXYZ (i, i * i, 0); }));
    ops.setSamplingRate (1.0);
    EXPECT_TRUE (planesOf (ops).empty()) << size << " points";
    ops.setMinInliers (0);
    EXPECT_LE (planesOf (ops).size(), size == 3 ? 1u : 0u) << size << " points";
  }
}

TEST_P (BadInputFor, AnExactPlaneWithoutNoise)
{
  const auto scene = Scene().surface ({1, 2, 3}, {3, 0, 1}, {0, 3, -0.5}).build();
  Ops ops = detectorFor (scene.cloud);
  const auto planes = planesOf (ops);
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_EQ (planes[0].inliers.size(), scene.cloud->size());
  expectPlaneNear (planes[0].plane(), scene.surfaces[0], 1e-5, 1e-5);
}

TEST_P (BadInputFor, AnExactPlaneOnAGrid)
{
  Ops ops = detectorFor (cloudOf (10000, [] (float i) {
    return pcl::PointXYZ (
        0.03f * std::fmod (i, 100.0f), 0.03f * std::floor (i / 100), 1);
  }));
  const auto planes = planesOf (ops);
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_EQ (planes[0].inliers.size(), 10000u);
}

TEST_P (BadInputFor, ParallelPlanesFartherApartThanTheThreshold)
{
  const auto scene =
      Scene().floor (3, 3).floor (3, 2.5, 15_cm).spacing (15_mm).noise (2_mm).build();
  Ops ops = detectorFor (scene.cloud);
  ops.setDistanceThreshold (5_cm);
  expectFindsEverySurface (planesOf (ops), scene);
}

TEST_P (BadInputFor, ParallelPlanesCloserThanTheThresholdAreOne)
{
  Ops ops = detectorFor (Scene().floor (3, 3).floor (3, 3, 1_cm).build().cloud);
  ops.setDistanceThreshold (5_cm);
  EXPECT_EQ (planesOf (ops).size(), 1u);
}

TEST (BadInput, KLargerThanTheCloud)
{
  const auto scene = Scene().floor (2, 2).spacing (10_cm).build();
  Ops ops = paperOn (scene.cloud);
  ops.setSamplingRate (1.0);
  for (const int k : {1000, std::numeric_limits<int>::max()}) {
    ops.setKSearch (k);
    expectFindsEverySurface (planesOf (ops), scene);
  }
}

TEST_P (BadInputFor, ASamplingRateThatDrawsNoPoint)
{
  Ops ops = detectorFor (room().build().cloud);
  ops.setSamplingRate (1e-9);
  EXPECT_TRUE (planesOf (ops).empty());
}

TEST_P (BadInputFor, CoordinatesOfAThousandKilometres)
{
  // Single precision leaves steps of 6 cm there: a hall feels only that.
  const auto scene = Scene()
                         .floor (40_m, 30_m)
                         .wall ({0, 0}, {40, 0}, 25_m)
                         .wall ({0, 0}, {0, 30}, 25_m)
                         .spacing (20_cm)
                         .movedBy ({1e6, -1e6, 1e6})
                         .build();
  Ops ops = detectorFor (scene.cloud);
  const auto planes = planesOf (ops);
  EXPECT_EQ (planes.size(), 3u);
  for (const Surface& surface : scene.surfaces)
    EXPECT_TRUE (std::any_of (planes.begin(), planes.end(), [&] (const auto& plane) {
      return isNear (plane.plane(), surface, 1_deg, 4_cm);
    }));
}

TEST_P (BadInputFor, CoordinatesOfAThousandKilometresInvokeNoPlaneThatIsNotThere)
{
  // A room feels the steps: what is found at all is one of its surfaces.
  const auto scene = room().movedBy ({1e6, -1e6, 1e6}).spacing (2_cm).build();
  Ops ops = detectorFor (scene.cloud);
  const auto planes = planesOf (ops);
  EXPECT_LE (planes.size(), 3u);
  EXPECT_TRUE (planes.size() == 3 || GetParam() != "paper");
  for (const auto& plane : planes)
    EXPECT_TRUE (std::any_of (
        scene.surfaces.begin(), scene.surfaces.end(), [&] (const Surface& surface) {
          return isNear (plane.plane(), surface, 1_deg, 4_cm);
        }));
}

TEST_P (BadInputFor, CoordinatesNearTheLargestNumber)
{
  constexpr float huge = 3e38f;
  Ops ops = detectorFor (cloudOf (1000, [] (float i) {
    return pcl::PointXYZ (std::fmod (i, 2.0f) ? huge : -huge, i * 1e35f, -i * 1e35f);
  }));
  planesOf (ops); // anything but a crash
}
