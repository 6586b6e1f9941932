// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/plane_extent.h>

#include <numeric>

using pcl_ops::PlanarPoints;
using pcl_ops::PlaneExtent;
using pcl_ops::PlaneFrame;
using pcl_ops::PlaneSegment;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double board_length = 1.0;
constexpr double board_width = 0.6;

/** \brief All points of a cloud as one plane. */
PlaneSegment
planeOf (const Cloud& cloud, const Eigen::Vector3d& normal)
{
  PlaneSegment plane;
  plane.normal = normal;
  plane.moments.origin = cloud[0].getVector3fMap().cast<double>();
  for (const pcl::PointXYZ& point : cloud) {
    const Eigen::Vector3d p =
        point.getVector3fMap().cast<double>() - plane.moments.origin;
    plane.moments.add (p.x(), p.y(), p.z());
  }
  plane.centroid = plane.moments.centroid();
  plane.inliers.resize (cloud.size());
  std::iota (plane.inliers.begin(), plane.inliers.end(), 0);
  return plane;
}

PlaneExtent
extentOf (const Cloud& cloud, const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ())
{
  return pcl_ops::planeExtent (cloud, planeOf (cloud, normal));
}

/** \brief Two corners of a grid of points 1 cm apart, and all between. */
Cloud
gridOf (double length, double width, double height = 0.0)
{
  Cloud cloud;
  for (int x = 0; x <= std::lround (length / 1_cm); ++x)
    for (int y = 0; y <= std::lround (width / 1_cm); ++y)
      cloud.push_back (pcl::PointXYZ (
          0.01f * static_cast<float> (x), 0.01f * static_cast<float> (y), height));
  return cloud;
}

/** \brief Points of the board anywhere on it, with noise in all directions. */
Cloud
scatteredBoard (int points, double noise)
{
  pcl_ops::RandomGenerator generator (seedOfTest());
  Cloud cloud;
  for (int i = 0; i < points; ++i) {
    const double x = board_length * pcl_ops::drawUnit (generator);
    const double y = board_width * pcl_ops::drawUnit (generator);
    const Eigen::Vector3d off (
        drawNormal (generator), drawNormal (generator), drawNormal (generator));
    const Eigen::Vector3f p = (Eigen::Vector3d (x, y, 0.0) + noise * off).cast<float>();
    cloud.push_back ({p.x(), p.y(), p.z()});
  }
  return cloud;
}

void
expectBoard (const PlaneExtent& extent, double tolerance)
{
  EXPECT_NEAR (extent.area / (board_length * board_width), 1.0, tolerance);
  EXPECT_NEAR (extent.length / board_length, 1.0, tolerance);
  EXPECT_NEAR (extent.width / board_width, 1.0, tolerance);
}

void
expectRightHanded (const PlaneExtent& extent, const Eigen::Vector3d& normal)
{
  EXPECT_TRUE (extent.long_axis.cross (extent.short_axis).isApprox (normal, 1e-9));
}

/** \brief Share of a cloud's points inside a hull, or nearer than 1 um to it. */
double
shareInside (const Cloud& cloud,
             const PlaneExtent& extent,
             const Eigen::Vector3d& normal)
{
  const auto inside = [&] (const pcl::PointXYZ& point) {
    for (std::size_t i = 0; i < extent.hull.size(); ++i) {
      const Eigen::Vector3d edge =
          extent.hull[(i + 1) % extent.hull.size()] - extent.hull[i];
      const Eigen::Vector3d inwards = normal.cross (edge).normalized();
      const Eigen::Vector3d p = point.getVector3fMap().cast<double>();
      if (inwards.dot (p - extent.hull[i]) < -1e-6)
        return false;
    }
    return true;
  };
  return static_cast<double> (std::count_if (cloud.begin(), cloud.end(), inside)) /
         static_cast<double> (cloud.size());
}

} // namespace

TEST (PlaneExtent, OfAGridIsExact)
{
  const PlaneExtent extent = extentOf (gridOf (1_m, 0.6_m));
  expectBoard (extent, 1e-6);
  EXPECT_EQ (extent.hull.size(), 4u);
  EXPECT_TRUE (extent.center.isApprox (Eigen::Vector3d (0.5, 0.3, 0.0), 1e-6));
  EXPECT_NEAR (std::abs (extent.long_axis.x()), 1.0, 1e-6);
  EXPECT_NEAR (std::abs (extent.short_axis.y()), 1.0, 1e-6);
}

TEST (PlaneExtent, OfScatteredPointsIsWithinOnePerCent)
{
  expectBoard (extentOf (scatteredBoard (6000, 0.0)), 1_percent);
}

TEST (PlaneExtent, OfNoisyPointsIsWithinFivePerCent)
{
  for (const int points : {3000, 30000, 100000})
    expectBoard (extentOf (scatteredBoard (points, 5_mm)), 5_percent);
}

TEST (PlaneExtent, HasNineHundredNinetyOfAThousandPointsInside)
{
  for (const double noise : {0.0, 5_mm, 2_cm}) {
    const Cloud cloud = scatteredBoard (20000, noise);
    EXPECT_GE (shareInside (cloud, extentOf (cloud), Eigen::Vector3d::UnitZ()),
               99_percent)
        << noise << " m of noise";
  }
}

TEST (PlaneExtent, RunsCounterClockwiseSeenFromTheSideOfTheNormal)
{
  const Cloud grid = gridOf (1_m, 0.6_m);
  for (const double side : {1.0, -1.0}) {
    const Eigen::Vector3d normal = side * Eigen::Vector3d::UnitZ();
    const PlaneExtent extent = extentOf (grid, normal);
    EXPECT_GT (extent.area, 0.0);
    EXPECT_EQ (shareInside (grid, extent, normal), 1.0);
    expectRightHanded (extent, normal);
  }
}

TEST (PlaneExtent, TurnsAndMovesWithThePoints)
{
  const Eigen::Quaterniond turn (
      Eigen::AngleAxisd (0.7, Eigen::Vector3d (1, 2, 3).normalized()));
  const Eigen::Vector3d shift (3.0, -2.0, 5.0);
  Cloud cloud = gridOf (1_m, 0.6_m);
  for (pcl::PointXYZ& point : cloud)
    point.getVector3fMap() =
        (turn * point.getVector3fMap().cast<double>() + shift).cast<float>();
  const Eigen::Vector3d normal = turn * Eigen::Vector3d::UnitZ();
  const PlaneExtent extent = extentOf (cloud, normal);
  expectBoard (extent, 1e-4);
  expectRightHanded (extent, normal);
  EXPECT_LT ((extent.center - (turn * Eigen::Vector3d (0.5, 0.3, 0.0) + shift)).norm(),
             1e-4);
  EXPECT_LT (angleBetween (extent.long_axis, turn * Eigen::Vector3d::UnitX()), 0.1_deg);
}
