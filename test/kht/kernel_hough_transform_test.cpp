// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>

#include "kht/ball_directions.h"
#include "scene.h"
#include <pcl_ops/kernel_hough_transform.h>

#include <set>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::internal;
using Detector = KernelHoughTransform<pcl::PointXYZ>;
using Parameters = KernelHoughTransformParameters;

/** The six faces of a turned box of 2 m x 3 m x 1.5 m. */
LabelledScene
box (double noise = 0.0)
{
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd (0.4, Eigen::Vector3d (1, 2, 3).normalized())
          .toRotationMatrix();
  const Eigen::Vector3d x = 2_m * turn.col (0), y = 3_m * turn.col (1),
                        z = 1.5_m * turn.col (2);
  const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  return Scene()
      .surface (zero, x, y)
      .surface (z, x, y)
      .surface (zero, y, z)
      .surface (x, y, z)
      .surface (zero, z, x)
      .surface (y, z, x)
      .spacing (2_cm)
      .noise (noise)
      .build();
}

std::vector<PlaneSegment>
planesOf (const LabelledScene& scene, const Parameters& parameters)
{
  Detector kht;
  kht.setInputCloud (scene.cloud);
  kht.setParameters (parameters);
  std::vector<PlaneSegment> planes;
  EXPECT_TRUE (kht.segment (planes));
  return planes;
}

std::vector<PlaneSegment>
planesOf (const pcl::PointCloud<pcl::PointXYZ>& cloud)
{
  return planesOf ({cloud.makeShared(), {}, {}}, Parameters());
}

/** Which surface a plane is: within an angle and a distance from its centre; or -1. */
int
surfaceOf (const PlaneSegment& plane,
           const LabelledScene& scene,
           double angle,
           double distance)
{
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const Surface& surface = scene.surfaces[s];
    if (std::abs (surface.normal().dot (plane.normal)) > std::cos (angle) &&
        std::abs (plane.plane().distance (surface.centre())) < distance)
      return static_cast<int> (s);
  }
  return -1;
}

/** How many points are on the plane of the face they were made on. */
std::size_t
pointsOnTheirFace (const LabelledScene& scene)
{
  std::size_t right = 0;
  for (const PlaneSegment& plane : planesOf (scene, Parameters())) {
    const int face = surfaceOf (plane, scene, 1_deg, 1_cm);
    for (const pcl::index_t i : plane.inliers)
      right += scene.labels[i] == face;
  }
  return right;
}

Parameters
published (int phi_num, int rho_num)
{
  Parameters parameters = Parameters::paper();
  parameters.phi_num = phi_num;
  parameters.rho_num = rho_num;
  parameters.clusters.first_level = 3;
  return parameters;
}

} // namespace

class PublishedKernelHoughTransform
: public testing::TestWithParam<std::pair<int, int>> {};

TEST_P (PublishedKernelHoughTransform, FindsTheSixFacesOfABoxWithinABin)
{
  const auto [phi_num, rho_num] = GetParam();
  const LabelledScene scene = box();
  const double angle = pi / phi_num;
  std::set<int> faces;
  for (const PlaneSegment& plane : planesOf (scene, published (phi_num, rho_num)))
    faces.insert (surfaceOf (plane, scene, angle, 2_m / rho_num + 2_cm));
  for (int face = 0; face < 6; ++face)
    EXPECT_EQ (faces.count (face), 1u) << "face " << face;
}

INSTANTIATE_TEST_SUITE_P (BothRows,
                          PublishedKernelHoughTransform,
                          testing::Values (std::make_pair (30, 300),
                                           std::make_pair (80, 800)));

TEST (KernelHoughTransform, FindsTheSixFacesOfANoisyBoxExactly)
{
  const LabelledScene scene = box (5_mm);
  std::multiset<int> faces;
  for (const PlaneSegment& plane : planesOf (scene, Parameters()))
    faces.insert (surfaceOf (plane, scene, 0.3_deg, 3_mm));
  EXPECT_EQ (faces, (std::multiset<int>{0, 1, 2, 3, 4, 5}));
}

TEST (KernelHoughTransform, GivesEachPointToItsPlane)
{
  const LabelledScene scene = box (5_mm);
  EXPECT_GT (pointsOnTheirFace (scene), 97_percent * scene.cloud->size());
}

TEST (KernelHoughTransform, EndsPlanesWhereTheirClustersEnd)
{
  // A table at the height of a shelf far away, and a ball of dust between them.
  LabelledScene scene = Scene()
                            .surface ({0, 0, 1}, {1, 0, 0}, {0, 1, 0})
                            .surface ({4, 0, 1}, {1, 0, 0}, {0, 1, 0})
                            .floor (5_m, 2_m)
                            .spacing (1_cm)
                            .build();
  scene.cloud->push_back ({2.5f, 0.5f, 1.0f});
  const auto dust = static_cast<pcl::index_t> (scene.cloud->size() - 1);
  Parameters parameters;
  for (const bool bounded : {true, false}) {
    parameters.bounded = bounded;
    bool is_on_a_plane = false;
    for (const PlaneSegment& plane : planesOf (scene, parameters))
      is_on_a_plane |= plane.inliers.back() == dust;
    EXPECT_NE (is_on_a_plane, bounded);
  }
}

TEST (KernelHoughTransform, CountsPlanesBeforeMerging)
{
  Detector kht;
  const LabelledScene scene = box (5_mm);
  kht.setInputCloud (scene.cloud);
  std::vector<PlaneSegment> planes;
  ASSERT_TRUE (kht.segment (planes));
  EXPECT_GE (kht.getNumberOfPlanesBeforeMerging(), planes.size());
}

TEST (KernelHoughTransform, CountsPlanesBeforeAnyWereMerged)
{
  Detector kht;
  const LabelledScene scene = box();
  kht.setInputCloud (scene.cloud);
  MergingParameters merging;
  merging.distance_threshold = 1.6_m; // top and bottom are 1.5 m apart
  kht.setMergingParameters (merging);
  std::vector<PlaneSegment> planes;
  ASSERT_TRUE (kht.segment (planes));
  EXPECT_LT (planes.size(), 6u);
  EXPECT_GE (kht.getNumberOfPlanesBeforeMerging(), 6u);
}

TEST (KernelHoughTransform, LeavesPublishedPlanesAtBinCentres)
{
  const BallDirections directions (30);
  for (const PlaneSegment& plane : planesOf (box(), published (30, 300))) {
    double nearest = -1.0;
    for (std::uint32_t d = 0; d < directions.size(); ++d)
      nearest =
          std::max (nearest, std::abs (directions.vectorOf (d).dot (plane.normal)));
    EXPECT_GT (nearest, 1.0 - 1e-12);
  }
}

TEST (KernelHoughTransform, PutsTheCentroidOnThePublishedPlane)
{
  const LabelledScene scene = box();
  for (const PlaneSegment& plane : planesOf (scene, published (30, 300)))
    for (const pcl::index_t i : plane.inliers)
      ASSERT_LT (std::abs (plane.plane().distance (
                     (*scene.cloud)[i].getVector3fMap().cast<double>())),
                 5_cm + 1e-5);
}

TEST (KernelHoughTransform, MeasuresDistancesToThePublishedPlane)
{
  const LabelledScene scene = box (5_mm);
  double farthest = 0.0;
  for (const PlaneSegment& plane : planesOf (scene, published (30, 300))) {
    double squares = 0.0;
    for (const pcl::index_t inlier : plane.inliers) {
      const auto point = (*scene.cloud)[inlier].getVector3fMap().cast<double>();
      squares += std::pow (plane.plane().distance (point), 2);
    }
    EXPECT_NEAR (plane.rms(), std::sqrt (squares / plane.moments.count), 1e-6);
    farthest = std::max (farthest, plane.rms());
  }
  EXPECT_GT (farthest, 1_cm) << "of surfaces that lie beside the centre of their bin";
}

TEST (KernelHoughTransform, HasThePapersBestRowAsPreset)
{
  const Parameters paper = Parameters::paper();
  EXPECT_EQ (paper.phi_num, 80);
  EXPECT_EQ (paper.rho_num, 800);
  EXPECT_EQ (paper.clusters.min_samples, 30u);
  EXPECT_EQ (paper.clusters.first_level, 5);
  EXPECT_EQ (paper.clusters.s_alpha, 25.0);
  EXPECT_EQ (paper.clusters.s_beta, 6.0);
  EXPECT_FALSE (paper.refit.enabled);
  EXPECT_FALSE (paper.bounded);
  EXPECT_FALSE (paper.merging.enabled);
  EXPECT_EQ (paper.assignment, AssignmentRule::First);
}

TEST (KernelHoughTransform, DoesNotDependOnThreads)
{
  const LabelledScene scene = box (1_cm);
  Parameters parameters;
  const std::vector<PlaneSegment> alone = planesOf (scene, parameters);
  parameters.threads = 4;
  const std::vector<PlaneSegment> shared = planesOf (scene, parameters);
  ASSERT_EQ (alone.size(), shared.size());
  for (std::size_t p = 0; p < alone.size(); ++p) {
    EXPECT_EQ (alone[p].normal, shared[p].normal);
    EXPECT_EQ (alone[p].inliers, shared[p].inliers);
  }
}

TEST (KernelHoughTransform, DoesNotDependOnTheSeed)
{
  const LabelledScene scene = box (1_cm);
  Parameters parameters;
  const std::vector<PlaneSegment> one = planesOf (scene, parameters);
  parameters.seed = 43;
  const std::vector<PlaneSegment> other = planesOf (scene, parameters);
  ASSERT_EQ (one.size(), other.size());
  for (std::size_t p = 0; p < one.size(); ++p)
    EXPECT_EQ (one[p].inliers, other[p].inliers);
}

TEST (KernelHoughTransform, FindsNoPlaneInAFewPoints)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < 29; ++i)
    cloud.push_back (
        {0.1f * static_cast<float> (i % 5), 0.1f * static_cast<float> (i), 0.0f});
  EXPECT_TRUE (planesOf (cloud).empty());
}

TEST (KernelHoughTransform, FindsNoPlaneInEqualPoints)
{
  EXPECT_TRUE (planesOf (pcl::PointCloud<pcl::PointXYZ> (1000, 1, {1, 2, 3})).empty());
}

TEST (KernelHoughTransform, FindsNoPlaneOnALine)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < 1000; ++i)
    cloud.push_back (
        {0.01f * static_cast<float> (i), 0.02f * static_cast<float> (i), 1.0f});
  EXPECT_TRUE (planesOf (cloud).empty());
}

TEST (KernelHoughTransform, IgnoresPointsThatAreNotFinite)
{
  LabelledScene scene = box();
  const std::size_t planes = planesOf (scene, Parameters()).size();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  scene.cloud->push_back ({nan, nan, nan});
  EXPECT_EQ (planesOf (scene, Parameters()).size(), planes);
}

class OneStrayReturn : public testing::TestWithParam<float> {};

TEST_P (OneStrayReturn, LeavesEachPointOnItsPlane)
{
  LabelledScene scene = box (5_mm);
  scene.cloud->push_back ({GetParam(), GetParam(), GetParam()});
  scene.labels.push_back (-2);
  EXPECT_GT (pointsOnTheirFace (scene), 97_percent * scene.cloud->size());
}

TEST_P (OneStrayReturn, LeavesTheSixFacesToThePublishedAlgorithm)
{
  LabelledScene scene = box();
  scene.cloud->push_back ({GetParam(), GetParam(), GetParam()});
  std::set<int> faces;
  for (const PlaneSegment& plane : planesOf (scene, published (80, 800)))
    faces.insert (surfaceOf (plane, scene, pi / 80, 2_cm));
  for (int face = 0; face < 6; ++face)
    EXPECT_EQ (faces.count (face), 1u) << "face " << face;
}

INSTANTIATE_TEST_SUITE_P (NearAndFar,
                          OneStrayReturn,
                          testing::Values (20.0f, -100.0f, 1e4f, -5e6f, 1e9f));

TEST (KernelHoughTransform, SurvivesCoordinatesAtTheEndsOfTheirRange)
{
  for (const float extreme : {1e-40f, 1e-20f, 1e15f, 1e30f, 3e38f}) {
    LabelledScene scene = box();
    scene.cloud->push_back ({extreme, -extreme, extreme});
    scene.cloud->push_back ({-extreme, extreme, extreme});
    for (const Parameters& parameters : {Parameters(), published (30, 300)})
      planesOf (scene, parameters);
    for (pcl::PointXYZ& point : *scene.cloud)
      point.getVector3fMap() *= extreme;
    planesOf (scene, Parameters());
  }
}

class WrongHoughParameters : public testing::TestWithParam<int> {};

TEST_P (WrongHoughParameters, AreRefused)
{
  Parameters parameters;
  switch (GetParam()) {
  case 0:
    parameters.phi_num = 1;
    break;
  case 1:
    parameters.rho_num = 0;
    break;
  case 2:
    parameters.clusters.min_samples = 2;
    break;
  case 3:
    parameters.clusters.first_level = -1;
    break;
  case 4:
    parameters.clusters.s_alpha = 0.0;
    break;
  case 5:
    parameters.clusters.deepest_level = 61;
    break;
  case 6:
    parameters.refit.min_share = 2.0;
    break;
  default:
    parameters.distance_threshold = 0.0;
  }
  EXPECT_FALSE (problemOf (parameters).empty());
}

INSTANTIATE_TEST_SUITE_P (One, WrongHoughParameters, testing::Range (0, 8));
