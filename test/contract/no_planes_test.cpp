// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "presets.h"
#include "scene.h"

// Clouds without a plane: nothing found is the answer, not splinters.

namespace {

/** \brief Points of three coordinates drawn from -1 to 1 each, made into others. */
template <typename Make>
Cloud::Ptr
cloudFrom (std::size_t number, Make&& make)
{
  pcl_ops::internal::RandomGenerator generator (seedOfTest());
  const auto draw = [&] { return 2.0 * pcl_ops::internal::drawUnit (generator) - 1.0; };
  const auto cloud = pcl::make_shared<Cloud>();
  while (cloud->size() < number) {
    const double x = draw(), y = draw(), z = draw();
    const Eigen::Vector3f made =
        make (Eigen::Vector3d (x, y, z)).template cast<float>();
    cloud->push_back ({made.x(), made.y(), made.z()});
  }
  return cloud;
}

std::vector<pcl_ops::PlaneSegment>
planesAmong (const Cloud::ConstPtr& cloud)
{
  Ops ops;
  ops.setInputCloud (cloud);
  std::vector<pcl_ops::PlaneSegment> planes;
  EXPECT_TRUE (ops.segment (planes));
  return planes;
}

} // namespace

TEST (NoPlanes, AreOnCurvedSurfacesAndWires)
{
  using Make = Eigen::Vector3d (*) (const Eigen::Vector3d&);
  const std::pair<const char*, Make> shapes[] = {
      {"sphere", [] (const auto& p) { return Eigen::Vector3d (p.normalized()); }},
      // Between patches that are curved there are no strips that are flat.
      {"cylinder",
       [] (const auto& p) {
         return Eigen::Vector3d (
             std::cos (pi * p.x()), std::sin (pi * p.x()), 2.0 * p.y());
       }},
      // A wire, a helix of five turns: any two directions along a line span a plane.
      {"helix", [] (const auto& p) {
         return Eigen::Vector3d (
             std::cos (5.0 * pi * p.x()), std::sin (5.0 * pi * p.x()), p.x());
       }}};
  for (const auto& [name, make] : shapes)
    EXPECT_TRUE (planesAmong (cloudFrom (60000, make)).empty()) << name;
}

TEST (NoPlanes, AreOnMostOfANoisyBall)
{
  // Radius 1 m with a noise of up to 1 cm, which hides how little a small patch bends.
  const auto near_sphere = [] (const Eigen::Vector3d& p) {
    return ((1.0 + 1_cm * (p.norm() - 1.0)) * p.normalized()).eval();
  };
  std::size_t points = 0;
  for (const auto& plane : planesAmong (cloudFrom (60000, near_sphere)))
    points += plane.inliers.size();
  EXPECT_LT (points, 60000u / 20);
}
