// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "scene.h"
#include <pcl_ops/plane_filter.h>

#include <stdexcept>

using Eigen::Vector3d;
using pcl_ops::DroppedPlanes;
using pcl_ops::filterPlanes;
using pcl_ops::Orientation;
using pcl_ops::PlaneExtent;
using pcl_ops::PlaneFilter;
using pcl_ops::PlaneSegment;

namespace {

PlaneSegment
planeOf (const Vector3d& normal, Orientation orientation, std::size_t points)
{
  PlaneSegment plane;
  plane.normal = normal.normalized();
  plane.orientation = orientation;
  plane.inliers.resize (points);
  return plane;
}

/** \brief A floor of 400 points, a wall of 300, a roof tilted by 30 degrees of 200. */
std::vector<PlaneSegment>
house ()
{
  return {planeOf (Vector3d::UnitZ(), Orientation::Horizontal, 400),
          planeOf (-Vector3d::UnitX(), Orientation::Vertical, 300),
          planeOf ({std::sin (30_deg), 0, std::cos (30_deg)}, Orientation::Other, 200)};
}

/** \brief So wide as a plane has hundreds of points, and 10 m long. */
PlaneExtent
extentByPoints (const PlaneSegment& plane)
{
  PlaneExtent extent;
  extent.length = 10.0;
  extent.width = static_cast<double> (plane.inliers.size()) / 100.0;
  extent.area = extent.length * extent.width;
  return extent;
}

PlaneExtent
neverAsked (const PlaneSegment& /*plane*/)
{
  ADD_FAILURE() << "an extent takes time";
  return {};
}

/** \brief The number of points of each plane that is left. */
std::vector<std::size_t>
left (const PlaneFilter& filter, std::size_t DroppedPlanes::*reason)
{
  std::vector<PlaneSegment> planes = house();
  const DroppedPlanes dropped = filterPlanes (planes, filter, extentByPoints);
  EXPECT_EQ (dropped.*reason, house().size() - planes.size());
  EXPECT_EQ (dropped.total(), dropped.*reason) << "for one reason each";
  std::vector<std::size_t> points;
  for (const PlaneSegment& plane : planes)
    points.push_back (plane.inliers.size());
  return points;
}

using Sizes = std::vector<std::size_t>;

} // namespace

TEST (PlaneFilter, KeepsAllByDefault)
{
  std::vector<PlaneSegment> planes = house();
  EXPECT_EQ (filterPlanes (planes, {}, neverAsked).total(), 0u);
  EXPECT_EQ (planes.size(), 3u);
}

TEST (PlaneFilter, KeepsAnOrientation)
{
  PlaneFilter filter;
  filter.orientation = Orientation::Vertical;
  EXPECT_EQ (left (filter, &DroppedPlanes::by_orientation), Sizes{300});
}

TEST (PlaneFilter, KeepsNormalsWithinTheAngleOfADirectionOrItsOpposite)
{
  PlaneFilter filter;
  filter.direction = Vector3d (0, 0, -7);
  EXPECT_EQ (left (filter, &DroppedPlanes::by_direction), Sizes{400});
  filter.direction_tolerance = 29.9_deg;
  EXPECT_EQ (left (filter, &DroppedPlanes::by_direction), Sizes{400});
  filter.direction_tolerance = 30.1_deg;
  EXPECT_EQ (left (filter, &DroppedPlanes::by_direction), (Sizes{400, 200}));
  filter.direction_tolerance = 90_deg;
  EXPECT_EQ (left (filter, &DroppedPlanes::by_direction), (Sizes{400, 300, 200}));
}

TEST (PlaneFilter, KeepsPlanesOfEnoughPointsAreaAndWidth)
{
  PlaneFilter points, area, width;
  points.min_points = 300;
  area.min_area = 25.0;
  width.min_width = 3.5;
  EXPECT_EQ (left (points, &DroppedPlanes::by_points), (Sizes{400, 300}));
  EXPECT_EQ (left (area, &DroppedPlanes::by_area), (Sizes{400, 300}));
  EXPECT_EQ (left (width, &DroppedPlanes::by_width), Sizes{400});
}

TEST (PlaneFilter, KeepsPlanesUpToAnAreaAndAWidth)
{
  PlaneFilter area, width;
  area.max_area = 30.0;
  width.max_width = 2.5;
  EXPECT_EQ (left (area, &DroppedPlanes::by_max_area), (Sizes{300, 200}));
  EXPECT_EQ (left (width, &DroppedPlanes::by_max_width), Sizes{200});
  area.min_area = 30.0;
  std::vector<PlaneSegment> planes = house();
  EXPECT_EQ (filterPlanes (planes, area, extentByPoints).total(), 2u);
  EXPECT_EQ (planes.front().inliers.size(), 300u);
}

TEST (PlaneFilter, KeepsSlopes)
{
  PlaneFilter filter;
  filter.slope = {5_deg, 29.9_deg};
  EXPECT_EQ (left (filter, &DroppedPlanes::by_slope), Sizes{});
  filter.slope = {5_deg, 30.1_deg};
  EXPECT_EQ (left (filter, &DroppedPlanes::by_slope), Sizes{200});
  filter.up_axis = Vector3d (3, 0, 0);
  filter.slope = {0.0, 60.1_deg};
  EXPECT_EQ (left (filter, &DroppedPlanes::by_slope), (Sizes{300, 200}));
}

TEST (PlaneFilter, KeepsRectanglesOfASizeEitherWayRound)
{
  PlaneFilter filter;
  filter.size = {10.0, 3.0, 0.01};
  EXPECT_EQ (left (filter, &DroppedPlanes::by_size), Sizes{300});
  filter.size = {2.5, 10.4, 0.51};
  EXPECT_EQ (left (filter, &DroppedPlanes::by_size), (Sizes{300, 200}));
  filter.size = {2.5, 11.0, 0.51};
  EXPECT_EQ (left (filter, &DroppedPlanes::by_size), Sizes{});
}

TEST (PlaneFilter, CountsThePointsOfMomentsWhereThereAreNoInliers)
{
  PlaneFilter filter;
  filter.min_points = 5;
  std::vector<PlaneSegment> planes (2);
  planes[1].moments.count = 5.0;
  EXPECT_EQ (filterPlanes (planes, filter, neverAsked).by_points, 1u);
  EXPECT_EQ (planes.at (0).moments.count, 5.0);
}

TEST (PlaneFilter, KeepsTheFirstOfThoseLeft)
{
  PlaneFilter filter;
  filter.max_planes = 2;
  EXPECT_EQ (left (filter, &DroppedPlanes::by_number), (Sizes{400, 300}));
  filter.min_points = 201;
  EXPECT_EQ (left (filter, &DroppedPlanes::by_points), (Sizes{400, 300}));
}

TEST (PlaneFilter, AsksForTheExtentsOfNoneThatIsDroppedAnyway)
{
  PlaneFilter filter;
  filter.min_area = 1.0;
  filter.min_points = 1000;
  std::vector<PlaneSegment> planes = house();
  EXPECT_EQ (filterPlanes (planes, filter, neverAsked).by_points, 3u);
}

TEST (PlaneFilter, TakesExtentsOfTheCloud)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < 50; ++i)
    for (int j = 0; j < 50; ++j)
      cloud.emplace_back (
          0.02f * static_cast<float> (i), 0.04f * static_cast<float> (j), 0.0f);
  PlaneSegment board = planeOf (Vector3d::UnitZ(), Orientation::Horizontal, 2500);
  board.inliers = upTo<pcl::Indices> (2500);
  PlaneFilter filter;
  std::vector<PlaneSegment> planes = {board};
  filter.min_area = 1.9;
  filter.min_width = 0.97;
  EXPECT_EQ (filterPlanes (planes, filter, cloud).total(), 0u);
  filter.min_width = 1.01;
  EXPECT_EQ (filterPlanes (planes, filter, cloud).by_width, 1u);
  EXPECT_TRUE (planes.empty());
}

TEST (PlaneFilter, RefusesWhatNoPlaneCanBeMeasuredBy)
{
  PlaneFilter filter;
  filter.min_area = -1.0;
  std::vector<PlaneSegment> planes = house();
  EXPECT_THROW (filterPlanes (planes, filter, neverAsked), std::invalid_argument);
  EXPECT_EQ (planes.size(), 3u);
}
