// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "paper/ball_directions.h"
#include "presets.h"
#include "scene.h"
#include <pcl_ops/kernel_hough_transform.h>

#include <set>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::internal;
using Detector = KernelHoughTransform<pcl::PointXYZ>;
using KhtParameters = KernelHoughTransformParameters;

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
planesOf (const LabelledScene& scene, const KhtParameters& parameters)
{
  Detector kht;
  kht.setInputCloud (scene.cloud);
  kht.setParameters (parameters);
  return ::planesOf (kht);
}

/** Index of the surface that a plane is near, or -1. */
int
surfaceOf (const PlaneSegment& plane,
           const LabelledScene& scene,
           double max_angle,
           double max_distance)
{
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
    if (isNear (plane.plane(), scene.surfaces[s], max_angle, max_distance))
      return static_cast<int> (s);
  return -1;
}

/** The parameters of the paper with an accumulator of phi_num rows and rho_num bins of
 * rho, and with nodes from level 3 on, as the box is small. */
KhtParameters
published (int phi_num, int rho_num)
{
  KhtParameters parameters = KhtParameters::paper();
  parameters.phi_num = phi_num;
  parameters.rho_num = rho_num;
  parameters.clusters.first_level = 3;
  return parameters;
}

} // namespace

TEST (KernelHoughTransform,
      FindsTheSixFacesOfABoxAtBinCentersWithTheirPointsAsPublished)
{
  const LabelledScene scene = box();
  for (const auto& [phi_num, rho_num] : {std::pair (30, 300), {80, 800}}) {
    const BallDirections directions (phi_num);
    std::set<int> faces;
    std::size_t points = 0;
    for (const PlaneSegment& plane : planesOf (scene, published (phi_num, rho_num))) {
      faces.insert (surfaceOf (plane, scene, pi / phi_num, 2_m / rho_num + 2_cm));
      points += plane.inliers.size();
      double cosine_to_nearest = 0.0;
      for (std::uint32_t d = 0; d < directions.size(); ++d)
        cosine_to_nearest = std::max (
            cosine_to_nearest, std::abs (directions.vectorOf (d).dot (plane.normal)));
      EXPECT_GT (cosine_to_nearest, 1.0 - 1e-12) << "the normal is that of a bin";
    }
    for (int face = 0; face < 6; ++face)
      EXPECT_EQ (faces.count (face), 1u) << "face " << face << ", " << phi_num;
    EXPECT_GT (points, 95_percent * scene.cloud->size());
  }
}

TEST (KernelHoughTransform, FindsTheSixFacesOfANoisyBoxExactlyWithTheirPoints)
{
  const LabelledScene scene = box (5_mm);
  std::multiset<int> faces;
  std::size_t points_on_their_face = 0;
  for (const PlaneSegment& plane : planesOf (scene, KhtParameters())) {
    const int face = surfaceOf (plane, scene, 0.3_deg, 3_mm);
    faces.insert (face);
    for (const pcl::index_t i : plane.inliers)
      points_on_their_face += scene.labels[i] == face;
  }
  EXPECT_EQ (faces, (std::multiset<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_GT (points_on_their_face, 97_percent * scene.cloud->size());
}

TEST (KernelHoughTransform, CountsPlanesBeforeAnyWereMerged)
{
  const LabelledScene scene = box();
  for (const KhtParameters& parameters : {KhtParameters(), published (30, 300)}) {
    KhtParameters merging = parameters;
    merging.merging.enabled = true;
    merging.merging.distance_threshold = 1.6_m; // top and bottom are 1.5 m apart
    Detector kht;
    kht.setInputCloud (scene.cloud);
    kht.setParameters (merging);
    const std::size_t planes = ::planesOf (kht).size();
    EXPECT_LT (planes, kht.getNumberOfPlanesBeforeMerging());
    EXPECT_GE (kht.getNumberOfPlanesBeforeMerging(), 6u);
  }
}

TEST (KernelHoughTransform, EndsPlanesWhereTheirClustersEnd)
{
  // A table, a shelf far away at the same height, and one point of dust between them.
  LabelledScene scene = Scene()
                            .surface ({0, 0, 1}, {1, 0, 0}, {0, 1, 0})
                            .surface ({4, 0, 1}, {1, 0, 0}, {0, 1, 0})
                            .floor (5_m, 2_m)
                            .spacing (1_cm)
                            .build();
  scene.cloud->push_back ({2.5f, 0.5f, 1.0f});
  const auto dust = static_cast<pcl::index_t> (scene.cloud->size() - 1);
  for (const PlaneSegment& plane : planesOf (scene, KhtParameters()))
    EXPECT_NE (plane.inliers.back(), dust);
}

TEST (KernelHoughTransform, GrowsPlanesOverPlacesWithoutACluster)
{
  LabelledScene scene = Scene().floor (2_m, 2_m).spacing (1_cm).noise (2_mm).build();
  Scene sparse = Scene().surface ({2, 0, 0}, {1, 0, 0}, {0, 2, 0});
  *scene.cloud += *sparse.spacing (2_cm).noise (2_mm).build().cloud;
  KhtParameters parameters;
  parameters.clusters.min_samples = 400; // which no node of the sparse part has
  EXPECT_GT (planesOf (scene, parameters).at (0).inliers.size(),
             97_percent * scene.cloud->size());
}
