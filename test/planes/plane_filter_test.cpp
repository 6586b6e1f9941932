// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/plane_filter.h>

#include <stdexcept>

using Eigen::Vector3d;
using namespace pcl_ops;

namespace {

/** \brief A plane with so many points, all with index 0. */
PlaneSegment
planeOf (const Vector3d& normal, Orientation orientation, std::size_t points)
{
  PlaneSegment plane;
  plane.normal = normal.normalized();
  plane.orientation = orientation;
  plane.inliers.resize (points);
  return plane;
}

/** \brief A floor of 400 points, a wall of 300 points and a roof of 200 points, which
 * is tilted by 30 degrees. */
std::vector<PlaneSegment>
house ()
{
  return {planeOf (Vector3d::UnitZ(), Orientation::Horizontal, 400),
          planeOf (-Vector3d::UnitX(), Orientation::Vertical, 300),
          planeOf ({std::sin (30_deg), 0, std::cos (30_deg)}, Orientation::Other, 200)};
}

/** \brief An extent 10 m long and 1 m wide per hundred points of the plane: floor, wall
 * and roof of the house are 4 m, 3 m and 2 m wide. */
PlaneExtent
extentByPoints (const PlaneSegment& plane)
{
  PlaneExtent extent;
  extent.length = 10.0;
  extent.width = static_cast<double> (plane.inliers.size()) / 100.0;
  extent.area = extent.length * extent.width;
  return extent;
}

/** \brief The extent for filters that need none: fails if it is called. */
PlaneExtent
failIfAsked (const PlaneSegment& /*plane*/)
{
  ADD_FAILURE() << "the extent was asked for without need";
  return {};
}

/** \brief The number of points of each plane of the house that the filter keeps; fails
 * unless all others are dropped for this reason. */
std::vector<std::size_t>
keptOfHouse (const PlaneFilter& filter, std::size_t DroppedPlanes::*reason)
{
  std::vector<PlaneSegment> planes = house();
  const DroppedPlanes dropped = filterPlanes (planes, filter, extentByPoints);
  EXPECT_EQ (dropped.*reason, house().size() - planes.size());
  EXPECT_EQ (dropped.total(), dropped.*reason) << "for this reason alone";
  std::vector<std::size_t> points;
  for (const PlaneSegment& plane : planes)
    points.push_back (plane.inliers.size());
  return points;
}

/** \brief Numbers of points of planes. */
using Sizes = std::vector<std::size_t>;
using Filter = PlaneFilter;
using Dropped = DroppedPlanes;
/** \brief PlaneFilter::slope: least and largest angle to the horizontal [rad]. */
using Slopes = std::array<double, 2>;
/** \brief PlaneFilter::size of a rectangle: both sides and the tolerance [m]. */
using Size = std::array<double, 3>;

/** \brief The given filter, but with this value of a member. */
template <typename Member, typename Value>
Filter
with (Member Filter::*member, const Value& value, Filter filter = Filter())
{
  filter.*member = value;
  return filter;
}

/** \brief A filter for normals within a tolerance [rad] of a direction. */
Filter
towards (const Vector3d& direction, double tolerance)
{
  return with (
      &Filter::direction, direction, with (&Filter::direction_tolerance, tolerance));
}

} // namespace

TEST (PlaneFilter, KeepsWhatItIsAskedFor)
{
  const Filter up_along_x = with (&Filter::up_axis, Vector3d (3, 0, 0));
  const Filter without_roof = with (&Filter::min_points, 201);
  const struct {
    Filter filter;
    std::size_t Dropped::*reason; // for which the other planes are dropped
    Sizes kept;                   // points of each plane
  } rows[] = {
      {with (&Filter::orientation, Orientation::Vertical),
       &Dropped::by_orientation,
       {300}},
      {with (&Filter::direction, Vector3d (0, 0, -7)), &Dropped::by_direction, {400}},
      {towards ({0, 0, -7}, 29.9_deg), &Dropped::by_direction, {400}},
      {towards ({0, 0, -7}, 30.1_deg), &Dropped::by_direction, {400, 200}},
      {towards ({0, 0, 1}, 90_deg), &Dropped::by_direction, {400, 300, 200}},
      {with (&Filter::min_points, 300), &Dropped::by_points, {400, 300}},
      {with (&Filter::min_area, 25.0), &Dropped::by_area, {400, 300}},
      {with (&Filter::min_width, 3.5), &Dropped::by_width, {400}},
      {with (&Filter::max_area, 30.0), &Dropped::by_max_area, {300, 200}},
      {with (&Filter::max_width, 2.5), &Dropped::by_max_width, {200}},
      {with (&Filter::slope, Slopes{5_deg, 29.9_deg}), &Dropped::by_slope, {}},
      {with (&Filter::slope, Slopes{5_deg, 30.1_deg}), &Dropped::by_slope, {200}},
      {with (&Filter::slope, Slopes{0, 60.1_deg}, up_along_x),
       &Dropped::by_slope,
       {300, 200}},
      {with (&Filter::size, Size{10.0, 3.0, 0.01}), &Dropped::by_size, {300}},
      {with (&Filter::size, Size{2.5, 10.4, 0.51}), &Dropped::by_size, {300, 200}},
      {with (&Filter::size, Size{2.5, 11.0, 0.51}), &Dropped::by_size, {}},
      {with (&Filter::max_planes, 2), &Dropped::by_number, {400, 300}},
      {with (&Filter::max_planes, 2, without_roof), &Dropped::by_points, {400, 300}}};
  for (std::size_t row = 0; row < std::size (rows); ++row) {
    SCOPED_TRACE (row);
    EXPECT_EQ (keptOfHouse (rows[row].filter, rows[row].reason), rows[row].kept);
  }
}

TEST (PlaneFilter, CountsThePointsOfMomentsWhereThereAreNoInliers)
{
  PlaneFilter filter;
  filter.min_points = 5;
  std::vector<PlaneSegment> planes (2);
  planes[1].moments.count = 5.0;
  EXPECT_EQ (filterPlanes (planes, filter, failIfAsked).by_points, 1u);
  EXPECT_EQ (planes.at (0).moments.count, 5.0);
}

TEST (PlaneFilter, KeepsAllByDefaultAndAsksForNoExtentWithoutNeed)
{
  std::vector<PlaneSegment> planes = house();
  EXPECT_EQ (filterPlanes (planes, {}, failIfAsked).total(), 0u);
  EXPECT_EQ (planes.size(), 3u);
  PlaneFilter filter;
  filter.min_area = 1.0;
  filter.min_points = 1000;
  EXPECT_EQ (filterPlanes (planes, filter, failIfAsked).by_points, 3u);
}

TEST (PlaneFilter, CountsOnlyThePlanesThatTheLastCallDropped)
{
  PlaneFilter filter;
  filter.orientation = Orientation::Vertical;
  DroppedPlanes dropped;
  for (int i = 0; i < 2; ++i) {
    const auto kept = keptPlanes (house(), filter, failIfAsked, dropped);
    EXPECT_EQ (kept, std::vector<std::size_t>{1});
    EXPECT_EQ (dropped.by_orientation, 2u);
  }
}

TEST (PlaneFilter, TakesExtentsOfTheCloud)
{
  const auto cloud = Scene().floor (1, 2).build().cloud;
  std::vector<PlaneSegment> planes = {
      planeOfPoints (*cloud, upTo<pcl::Indices> (cloud->size()), Vector3d::UnitZ())};
  PlaneFilter filter;
  filter.min_area = 1.9;
  filter.min_width = 0.97;
  EXPECT_EQ (filterPlanes (planes, filter, *cloud).total(), 0u);
  filter.min_width = 1.01;
  EXPECT_EQ (filterPlanes (planes, filter, *cloud).by_width, 1u);
  EXPECT_TRUE (planes.empty());
}

TEST (PlaneFilter, RefusesAnotherCloudThanThatOfThePlanes)
{
  const auto cloud = Scene().floor (1, 2).build().cloud;
  std::vector<PlaneSegment> planes = {
      planeOfPoints (*cloud, upTo<pcl::Indices> (cloud->size()), Vector3d::UnitZ())};
  PlaneFilter filter;
  filter.min_area = 1.0;
  cloud->resize (10);
  EXPECT_THROW (filterPlanes (planes, filter, *cloud), std::invalid_argument);
  EXPECT_EQ (planes.size(), 1u);
}

TEST (PlaneFilter, RefusesANegativeArea)
{
  PlaneFilter filter;
  filter.min_area = -1.0;
  std::vector<PlaneSegment> planes = house();
  EXPECT_THROW (filterPlanes (planes, filter, failIfAsked), std::invalid_argument);
  EXPECT_EQ (planes.size(), 3u);
}
