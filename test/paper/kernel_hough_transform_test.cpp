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

/** The six faces of a box of 2 m x 3 m x 1.5 m that is parallel to no axis.
 * \param[in] noise standard deviation of the points along their face's normal [m] */
LabeledScene
turnedBox (double noise = 0.0)
{
  constexpr double angle = 0.4; // [rad]
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd (angle, Eigen::Vector3d (1, 2, 3).normalized())
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
detectPlanes (const LabeledScene& scene, const KhtParameters& parameters)
{
  Detector kht;
  kht.setInputCloud (scene.cloud);
  kht.setParameters (parameters);
  return planesOf (kht);
}

/** Index of the first surface of the scene that is near the plane, or -1.
 * \param[in] max_angle, max_distance as in \ref isNear [rad], [m] */
int
surfaceOf (const PlaneSegment& plane,
           const LabeledScene& scene,
           double max_angle,
           double max_distance)
{
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s)
    if (isNear (plane.plane(), scene.surfaces[s], max_angle, max_distance))
      return static_cast<int> (s);
  return -1;
}

/** The parameters of the paper, with phi_num steps from pole to pole and rho_num bins
 * of rho. Clusters begin at level 3: the box has too few points for those of level 5.
 */
KhtParameters
parametersOfPaper (int phi_num, int rho_num)
{
  KhtParameters parameters = KhtParameters::paper();
  parameters.phi_num = phi_num;
  parameters.rho_num = rho_num;
  parameters.clusters.first_level = 3;
  return parameters;
}

} // namespace

TEST (KernelHoughTransform, FindsTheSixFacesOfABoxAtBinCentersAsInThePaper)
{
  const LabeledScene scene = turnedBox();
  for (const auto& [phi_num, rho_num] : {std::pair (30, 300), {80, 800}}) {
    const BallDirections directions (phi_num);
    const double max_angle = pi / phi_num; // a step of the accumulator
    // A bin is at most 2 m / rho_num long, as no point of the box is 2 m from its
    // center; and 2 cm more, as normals are those of bins, too.
    const double max_distance = 2_m / rho_num + 2_cm;
    std::set<int> faces;
    std::size_t points_on_planes = 0;
    for (const PlaneSegment& plane :
         detectPlanes (scene, parametersOfPaper (phi_num, rho_num))) {
      faces.insert (surfaceOf (plane, scene, max_angle, max_distance));
      points_on_planes += plane.inliers.size();
      double cosine_to_nearest = 0.0;
      for (std::uint32_t d = 0; d < directions.size(); ++d)
        cosine_to_nearest = std::max (
            cosine_to_nearest, std::abs (directions.vectorOf (d).dot (plane.normal)));
      EXPECT_GT (cosine_to_nearest, 1.0 - 1e-12) << "the normal is that of a bin";
    }
    for (int face = 0; face < 6; ++face)
      EXPECT_EQ (faces.count (face), 1u) << "face " << face << ", phi_num " << phi_num;
    EXPECT_GT (points_on_planes, 95_percent * scene.cloud->size());
  }
}

TEST (KernelHoughTransform, FindsEachFaceOfANoisyBoxOnceWithNearlyAllOfItsPoints)
{
  const LabeledScene scene = turnedBox (5_mm);
  std::multiset<int> faces;
  std::size_t points_on_their_face = 0;
  for (const PlaneSegment& plane : detectPlanes (scene, KhtParameters())) {
    const int face = surfaceOf (plane, scene, 0.3_deg, 3_mm);
    faces.insert (face);
    for (const pcl::index_t i : plane.inliers)
      points_on_their_face += scene.labels[i] == face;
  }
  EXPECT_EQ (faces, (std::multiset<int>{0, 1, 2, 3, 4, 5}));
  EXPECT_GT (points_on_their_face, 97_percent * scene.cloud->size());
}

TEST (KernelHoughTransform, CountsPlanesBeforeMerging)
{
  const LabeledScene scene = turnedBox();
  for (const KhtParameters& parameters :
       {KhtParameters(), parametersOfPaper (30, 300)}) {
    KhtParameters with_merging = parameters;
    with_merging.merging.enabled = true;
    // Top and bottom of the box are 1.5 m apart: they are merged.
    with_merging.merging.distance_threshold = 1.6_m;
    Detector kht;
    kht.setInputCloud (scene.cloud);
    kht.setParameters (with_merging);
    const std::size_t planes = planesOf (kht).size();
    EXPECT_LT (planes, kht.getNumberOfPlanesBeforeMerging());
    EXPECT_GE (kht.getNumberOfPlanesBeforeMerging(), 6u);
  }
}

TEST (KernelHoughTransform, LeavesOutAPointOfThePlaneThatIsFarFromItsClusters)
{
  // A table and a shelf at the same height, 3 m apart, with a single point in between.
  LabeledScene scene = Scene()
                           .surface ({0, 0, 1}, {1, 0, 0}, {0, 1, 0})
                           .surface ({4, 0, 1}, {1, 0, 0}, {0, 1, 0})
                           .floor (5_m, 2_m)
                           .spacing (1_cm)
                           .build();
  scene.cloud->push_back ({2.5f, 0.5f, 1.0f});
  const auto point_between = static_cast<pcl::index_t> (scene.cloud->size() - 1);
  const std::vector<PlaneSegment> planes = detectPlanes (scene, KhtParameters());
  ASSERT_GE (planes.size(), 2u) << "the floor, and table and shelf";
  for (const PlaneSegment& plane : planes)
    EXPECT_NE (plane.inliers.back(), point_between);
}

TEST (KernelHoughTransform, GrowsAPlaneOverSparsePointsThatAreInNoCluster)
{
  LabeledScene scene = Scene().floor (2_m, 2_m).spacing (1_cm).noise (2_mm).build();
  Scene sparse_continuation = Scene().surface ({2, 0, 0}, {1, 0, 0}, {0, 2, 0});
  *scene.cloud += *sparse_continuation.spacing (2_cm).noise (2_mm).build().cloud;
  KhtParameters parameters;
  // The nodes of the first level have an edge of 46 cm: some 520 points in the sparse
  // part, and 2,100 in the dense one.
  parameters.clusters.min_samples = 800;
  EXPECT_GT (detectPlanes (scene, parameters).at (0).inliers.size(),
             97_percent * scene.cloud->size());
}
