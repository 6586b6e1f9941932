// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"

std::uint32_t
seedOfTest ()
{
  constexpr std::uint32_t fnv_offset_basis = 2166136261u;
  constexpr std::uint32_t fnv_prime = 16777619u;
  const ::testing::TestInfo* const test =
      ::testing::UnitTest::GetInstance()->current_test_info();
  std::uint32_t hash = fnv_offset_basis;
  for (const char letter : std::string (test->test_suite_name()) + "." + test->name())
    hash = (hash ^ static_cast<unsigned char> (letter)) * fnv_prime;
  return hash;
}

double
drawGaussian (RandomGenerator& generator)
{
  const double radius = std::sqrt (-2.0 * std::log (1.0 - drawUnit (generator)));
  return radius * std::cos (2.0 * pi * drawUnit (generator));
}

Eigen::Vector3d
drawGaussians (RandomGenerator& generator)
{
  // Drawn one by one: compilers evaluate arguments in different orders.
  Eigen::Vector3d drawn;
  for (double& number : drawn)
    number = drawGaussian (generator);
  return drawn;
}

Eigen::Quaterniond
drawTurn (RandomGenerator& generator)
{
  const Eigen::Vector3d axis = drawGaussians (generator);
  return Eigen::Quaterniond (drawGaussian (generator), axis.x(), axis.y(), axis.z())
      .normalized();
}

pcl::PointXYZ
toPoint (const Eigen::Vector3d& position)
{
  const Eigen::Vector3f rounded = position.cast<float>();
  return {rounded.x(), rounded.y(), rounded.z()};
}

Eigen::Vector3d
drawPointOf (const Surface& surface, double noise, RandomGenerator& generator)
{
  const double s = drawUnit (generator);
  const double t = drawUnit (generator);
  const double offset = noise > 0.0 ? noise * drawGaussian (generator) : 0.0;
  return surface.at (s, t) + offset * surface.normal();
}

LabeledScene
Scene::build()
{
  LabeledScene scene{pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(), {}, surfaces_};
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const long count = std::lround (surfaces_[i].area() / (spacing_ * spacing_));
    for (long k = 0; k < count; ++k)
      add (scene, drawPointOf (surfaces_[i], noise_, generator_), static_cast<int> (i));
  }
  addClutter (scene);
  for (Surface& surface : scene.surfaces)
    surface.corner += shift_;
  return scene;
}

void
Scene::addClutter (LabeledScene& scene)
{
  Eigen::AlignedBox3d box;
  for (const Surface& surface : surfaces_)
    for (const double s : {0.0, 1.0})
      for (const double t : {0.0, 1.0})
        box.extend (surface.at (s, t));
  // The share is one of all points, those of the clutter included.
  const long count = std::lround (share_of_clutter_ / (1.0 - share_of_clutter_) *
                                  static_cast<double> (scene.cloud->size()));
  for (long i = 0; i < count; ++i) {
    Eigen::Vector3d position_in_box; // along each axis, from 0 to 1
    // From z to x: another order would give all tests other clutter.
    for (double* coordinate :
         {&position_in_box.z(), &position_in_box.y(), &position_in_box.x()})
      *coordinate = drawUnit (generator_);
    constexpr int label_of_clutter = -1;
    add (scene,
         box.min() + position_in_box.cwiseProduct (box.sizes()),
         label_of_clutter);
  }
}

Scene
room (std::uint32_t seed)
{
  return Scene (seed)
      .floor (4_m, 3_m)
      .wall ({0, 0}, {4, 0}, 2.5_m)
      .wall ({0, 0}, {0, 3}, 2.5_m)
      .noise (1_mm)
      .clutter (2_percent);
}

Scene
denseRoom ()
{
  return room().spacing (2_cm);
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
roomSeenByCamera (std::uint32_t width, std::uint32_t height)
{
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (width, height);
  cloud->is_dense = false;
  constexpr float height_of_camera = 1.0f; // above the floor [m]
  constexpr float depth_of_wall = 3.0f;    // [m]
  // [pixels]; the image is 2 atan (0.5 / 0.8) = 64 degrees wide
  const float focal_length = 0.8f * static_cast<float> (width);
  for (std::uint32_t row = 0; row < height; ++row)
    for (std::uint32_t column = 0; column < width; ++column) {
      // The ray of the pixel goes along (x, y, 1).
      const float x = (static_cast<float> (column) - 0.5f * width) / focal_length;
      const float y = (static_cast<float> (row) - 0.5f * height) / focal_length;
      const float depth =
          y > 0.0f ? std::min (depth_of_wall, height_of_camera / y) : depth_of_wall;
      const bool is_lost = (row + column) % 10 == 0;
      cloud->at (column, row) = is_lost ? pcl::PointXYZ (NAN, NAN, NAN)
                                        : pcl::PointXYZ (x * depth, y * depth, depth);
    }
  return cloud;
}

pcl_ops::Moments
momentsOf (const Surface& surface, int columns, int rows, double noise)
{
  pcl_ops::Moments moments;
  moments.origin = surface.center();
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) {
      const double offset = (i + j) % 2 == 0 ? noise : -noise;
      const Eigen::Vector3d from_origin =
          surface.at ((i + 0.5) / columns, (j + 0.5) / rows) +
          offset * surface.normal() - moments.origin;
      moments.add (from_origin.x(), from_origin.y(), from_origin.z());
    }
  return moments;
}

pcl_ops::PlaneSegment
planeOfPoints (const pcl::PointCloud<pcl::PointXYZ>& cloud,
               const pcl::Indices& inliers,
               const Eigen::Vector3d& normal)
{
  pcl_ops::PlaneSegment plane;
  plane.normal = normal;
  plane.inliers = inliers;
  plane.moments.origin = cloud[inliers[0]].getVector3fMap().cast<double>();
  for (const pcl::index_t i : inliers) {
    const Eigen::Vector3d from_origin =
        cloud[i].getVector3fMap().cast<double>() - plane.moments.origin;
    plane.moments.add (from_origin.x(), from_origin.y(), from_origin.z());
  }
  plane.centroid = plane.moments.centroid();
  return plane;
}

double
angleBetween (const Eigen::Vector3d& first, const Eigen::Vector3d& second)
{
  return std::atan2 (first.cross (second).norm(), std::abs (first.dot (second)));
}

bool
isNear (const pcl_ops::Plane& plane,
        const Surface& truth,
        double max_angle,
        double max_distance)
{
  return angleBetween (plane.normal, truth.normal()) <= max_angle &&
         std::abs (plane.distance (truth.center())) <= max_distance;
}

void
expectFindsEverySurface (const std::vector<pcl_ops::PlaneSegment>& planes,
                         const LabeledScene& scene,
                         double max_angle,
                         double max_distance)
{
  EXPECT_EQ (planes.size(), scene.surfaces.size());
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const auto found =
        std::find_if (planes.begin(), planes.end(), [&] (const auto& plane) {
          return isNear (plane.plane(), scene.surfaces[s], max_angle, max_distance);
        });
    ASSERT_NE (found, planes.end()) << "surface " << s << " was not found";
    const int label = static_cast<int> (s);
    std::size_t points_found = 0;
    for (const pcl::index_t i : found->inliers)
      points_found += scene.labels[i] == label;
    const auto points_of_surface =
        std::count (scene.labels.begin(), scene.labels.end(), label);
    EXPECT_GE (points_found, 0.9 * points_of_surface) << "points of surface " << s;
  }
}
