// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "presets.h"
#include "scene.h"
#include <pcl_ops/detect_planes.h>

#include <stdexcept>

namespace {

class BadInputFor : public EachPreset {};

INSTANTIATE_TEST_SUITE_P (Presets,
                          BadInputFor,
                          ::testing::Values ("default", "paper"),
                          presetName);

/** \brief Misuse: false and empty outputs of every overload, and one message that names
 * the fix. */
void
expectRefused (Ops& ops, const std::string& message)
{
  std::vector<pcl_ops::PlaneSegment> planes (9);
  std::vector<pcl::ModelCoefficients> coefficients (9);
  std::vector<pcl::PointIndices> inliers (9), clusters (9);
  Ops::PlanarRegions regions (9);
  pcl::PointIndices of_largest;
  pcl::ModelCoefficients largest;
  of_largest.indices = {1, 2, 3};
  largest.values = {1, 2, 3, 4};
  ::testing::internal::CaptureStderr();
  EXPECT_FALSE (ops.segment (coefficients, inliers));
  const std::string said = ::testing::internal::GetCapturedStderr();
  EXPECT_NE (said.find ("[pcl_ops::OrientedPointSampling::segment]"),
             std::string::npos);
  EXPECT_NE (said.find (message), std::string::npos) << said;
  EXPECT_FALSE (ops.segment (planes));
  EXPECT_FALSE (ops.extract (clusters));
  EXPECT_FALSE (ops.segment (of_largest, largest));
  EXPECT_FALSE (ops.segment (regions));
  EXPECT_TRUE (coefficients.empty() && inliers.empty() && planes.empty());
  EXPECT_TRUE (clusters.empty() && regions.empty());
  EXPECT_TRUE (of_largest.indices.empty() && largest.values.empty());
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

TEST_P (BadInputFor, ParallelPlanesAreTwoIfFartherApartThanTheThreshold)
{
  for (const double apart : {1_cm, 15_cm}) {
    Ops ops = detectorFor (Scene().floor (3, 3).floor (3, 2.5, apart).build().cloud);
    ops.setDistanceThreshold (5_cm);
    EXPECT_EQ (planesOf (ops).size(), apart < 5_cm ? 1u : 2u);
  }
}

TEST_P (BadInputFor, ASamplingRateThatDrawsNoPoint)
{
  Ops ops = detectorFor (room().build().cloud);
  ops.setSamplingRate (1e-9);
  EXPECT_TRUE (planesOf (ops).empty());
}

TEST_P (BadInputFor, CoordinatesOfAThousandKilometers)
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

TEST_P (BadInputFor, CoordinatesOfAThousandKilometersInvokeNoPlaneThatIsNotThere)
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

TEST (BadInput, OfABufferIsThrown)
{
  using Parameters = pcl_ops::OrientedPointSamplingParameters;
  const std::vector<float> buffer (100);
  const pcl_ops::CloudView points (buffer.data(), 4, 16, 6);
  Parameters wrong;
  wrong.sampling_rate = 0.0;
  EXPECT_THROW (detectPlanes (pcl_ops::CloudView(), Parameters()),
                std::invalid_argument);
  EXPECT_THROW (detectPlanes (points, wrong), std::invalid_argument);
  for (const auto& [offset, step] : {std::pair (5, 16), {4, 18}})
    EXPECT_THROW (pcl_ops::CloudView (buffer.data(), offset, step, 6),
                  std::invalid_argument)
        << "no aligned floats";
}
