// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/plane_filter.h>

#include <stdexcept>

using Eigen::Vector3d;
using namespace pcl_ops;

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

/** \brief A floor of 400 points, a wall of 300 points and a roof of 200 points, which
 * is tilted by 30 degrees. */
std::vector<PlaneSegment>
house ()
{
  return {planeOf (Vector3d::UnitZ(), Orientation::Horizontal, 400),
          planeOf (-Vector3d::UnitX(), Orientation::Vertical, 300),
          planeOf ({std::sin (30_deg), 0, std::cos (30_deg)}, Orientation::Other, 200)};
}

/** \brief An extent 10 m long; its width is 1 m per hundred points of the plane. */
PlaneExtent
extentByPoints (const PlaneSegment& plane)
{
  PlaneExtent extent;
  extent.length = 10.0;
  extent.width = static_cast<double> (plane.inliers.size()) / 100.0;
  extent.area = extent.length * extent.width;
  return extent;
}

/** \brief For filters that need no extent. */
PlaneExtent
neverAsked (const PlaneSegment& /*plane*/)
{
  ADD_FAILURE() << "the extent was asked for without need";
  return {};
}

/** \brief The number of points of each plane of the house that is kept; fails if the
 * others are not all dropped for the same reason. */
std::vector<std::size_t>
leftOfHouse (const PlaneFilter& filter, std::size_t DroppedPlanes::*reason)
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

TEST (PlaneFilter, KeepsWhatItIsAskedFor)
{
  using F = PlaneFilter;
  using D = DroppedPlanes;
  using Slopes = std::array<double, 2>;
  using Size = std::array<double, 3>;
  const auto with = [] (auto member, auto value, F others = F()) {
    others.*member = value;
    return others;
  };
  const auto towards = [&] (const Vector3d& direction, double tolerance) {
    return with (&F::direction, direction, with (&F::direction_tolerance, tolerance));
  };
  const F up_along_x = with (&F::up_axis, Vector3d (3, 0, 0));
  const F without_roof = with (&F::min_points, 201);
  const struct {
    F filter;
    std::size_t D::*reason;
    Sizes left;
  } rows[] = {
      {with (&F::orientation, Orientation::Vertical), &D::by_orientation, {300}},
      {with (&F::direction, Vector3d (0, 0, -7)), &D::by_direction, {400}},
      {towards ({0, 0, -7}, 29.9_deg), &D::by_direction, {400}},
      {towards ({0, 0, -7}, 30.1_deg), &D::by_direction, {400, 200}},
      {towards ({0, 0, 1}, 90_deg), &D::by_direction, {400, 300, 200}},
      {with (&F::min_points, 300), &D::by_points, {400, 300}},
      {with (&F::min_area, 25.0), &D::by_area, {400, 300}},
      {with (&F::min_width, 3.5), &D::by_width, {400}},
      {with (&F::max_area, 30.0), &D::by_max_area, {300, 200}},
      {with (&F::max_width, 2.5), &D::by_max_width, {200}},
      {with (&F::slope, Slopes{5_deg, 29.9_deg}), &D::by_slope, {}},
      {with (&F::slope, Slopes{5_deg, 30.1_deg}), &D::by_slope, {200}},
      {with (&F::slope, Slopes{0, 60.1_deg}, up_along_x), &D::by_slope, {300, 200}},
      {with (&F::size, Size{10.0, 3.0, 0.01}), &D::by_size, {300}},
      {with (&F::size, Size{2.5, 10.4, 0.51}), &D::by_size, {300, 200}},
      {with (&F::size, Size{2.5, 11.0, 0.51}), &D::by_size, {}},
      {with (&F::max_planes, 2), &D::by_number, {400, 300}},
      {with (&F::max_planes, 2, without_roof), &D::by_points, {400, 300}}};
  for (std::size_t row = 0; row < std::size (rows); ++row) {
    SCOPED_TRACE (row);
    EXPECT_EQ (leftOfHouse (rows[row].filter, rows[row].reason), rows[row].left);
  }
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

TEST (PlaneFilter, KeepsAllByDefaultAndAsksForNoExtentItCanDoWithout)
{
  std::vector<PlaneSegment> planes = house();
  EXPECT_EQ (filterPlanes (planes, {}, neverAsked).total(), 0u);
  EXPECT_EQ (planes.size(), 3u);
  PlaneFilter filter;
  filter.min_area = 1.0;
  filter.min_points = 1000;
  EXPECT_EQ (filterPlanes (planes, filter, neverAsked).by_points, 3u);
}

TEST (PlaneFilter, CountsWhatItDropsAnewEachTime)
{
  PlaneFilter filter;
  filter.orientation = Orientation::Vertical;
  DroppedPlanes dropped;
  for (int i = 0; i < 2; ++i) {
    const auto kept = keptPlanes (house(), filter, neverAsked, dropped);
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
  EXPECT_THROW (filterPlanes (planes, filter, neverAsked), std::invalid_argument);
  EXPECT_EQ (planes.size(), 3u);
}
