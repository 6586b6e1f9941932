// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/planar_area.h"
#include "scene.h"
#include <pcl_ops/plane_extent.h>

using namespace pcl_ops::internal;
using namespace pcl_ops;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double board_length = 1.0; // [m]
constexpr double board_width = 0.6;  // [m]

/** \brief The extent of the plane with this normal through all points of a cloud. */
PlaneExtent
extentOf (const Cloud& cloud, const Eigen::Vector3d& normal = Eigen::Vector3d::UnitZ())
{
  return pcl_ops::planeExtent (
      cloud, planeOfPoints (cloud, upTo<pcl::Indices> (cloud.size()), normal));
}

/** \brief A level grid of points 1 cm apart, from (0, 0) to (length, width) [m]. */
Cloud
gridOf (double length, double width)
{
  Cloud cloud;
  for (int x = 0; x <= std::lround (length / 1_cm); ++x)
    for (int y = 0; y <= std::lround (width / 1_cm); ++y)
      cloud.push_back (toPoint ({0.01 * x, 0.01 * y, 0.0}));
  return cloud;
}

/** \brief Points drawn uniformly on a level board, from zero to (board_length,
 * board_width).
 * \param[in] noise standard deviation of each coordinate [m] */
Cloud
scatteredBoard (int points, double noise)
{
  RandomGenerator generator (seedOfTest());
  Cloud cloud;
  for (int i = 0; i < points; ++i) {
    const double x = board_length * drawUnit (generator);
    const double y = board_width * drawUnit (generator);
    cloud.push_back (
        toPoint (Eigen::Vector3d (x, y, 0.0) + noise * drawGaussians (generator)));
  }
  return cloud;
}

/** \brief Fails unless length, width and area of the extent are those of the board, up
 * to a relative tolerance. */
void
expectBoard (const PlaneExtent& extent, double tolerance)
{
  EXPECT_NEAR (extent.area / (board_length * board_width), 1.0, tolerance);
  EXPECT_NEAR (extent.length / board_length, 1.0, tolerance);
  EXPECT_NEAR (extent.width / board_width, 1.0, tolerance);
}

/** \brief Fails unless long axis, short axis and normal are a right-handed frame. */
void
expectRightHanded (const PlaneExtent& extent, const Eigen::Vector3d& normal)
{
  EXPECT_TRUE (extent.long_axis.cross (extent.short_axis).isApprox (normal, 1e-9));
}

/** \brief Share of a cloud's points that are inside the hull or nearer than 1 um to it.
 * The hull has to run counter-clockwise seen from the tip of the normal. */
double
shareInside (const Cloud& cloud,
             const PlaneExtent& extent,
             const Eigen::Vector3d& normal)
{
  EXPECT_GE (extent.hull.size(), 3u);
  const auto inside = [&] (const pcl::PointXYZ& point) {
    for (std::size_t i = 0; i < extent.hull.size(); ++i) {
      const Eigen::Vector3d edge =
          extent.hull[(i + 1) % extent.hull.size()] - extent.hull[i];
      const Eigen::Vector3d inwards = normal.cross (edge).normalized();
      const Eigen::Vector3d position = point.getVector3fMap().cast<double>();
      if (inwards.dot (position - extent.hull[i]) < -1e-6)
        return false;
    }
    return true;
  };
  return static_cast<double> (std::count_if (cloud.begin(), cloud.end(), inside)) /
         static_cast<double> (cloud.size());
}

const PlaneFrame ground (Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ());

/** \brief The extent of the convex hull of points of the ground. */
PlaneExtent
extentOnGround (const PlanarPoints& points)
{
  return pcl_ops::extentOf ({pcl_ops::convexHull (points)}, points, ground);
}

/** \brief The same; fails if the points span an area. */
PlaneExtent
flatExtent (const PlanarPoints& points)
{
  const PlaneExtent extent = extentOnGround (points);
  EXPECT_TRUE (extent.hull.empty());
  EXPECT_EQ (extent.area, 0.0);
  EXPECT_EQ (extent.width, 0.0);
  expectRightHanded (extent, Eigen::Vector3d::UnitZ());
  return extent;
}

/** \brief Positions whose three coordinates have any size from 1e-10 to 1e13, turned at
 * random, projected to a plane and moved so that their centroid is zero. */
PlanarPoints
pointsOverManyDecades (std::uint32_t seed)
{
  RandomGenerator generator (seed);
  const Eigen::Quaterniond turn = drawTurn (generator);
  PlanarPoints points (600);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (Eigen::Vector2d& point : points) {
    Eigen::Vector3d position;
    for (int axis = 0; axis < 3; ++axis) {
      const double sign = drawUnit (generator) < 0.5 ? -1.0 : 1.0;
      position[axis] = sign * std::pow (10.0, 23.0 * drawUnit (generator) - 10.0);
    }
    point = (turn * position).head<2>();
    sum += point;
  }
  for (Eigen::Vector2d& point : points)
    point -= sum / static_cast<double> (points.size());
  return points;
}

} // namespace

TEST (PlaneFrame, HasTheAxesOfTheCovarianceOfItsPlane)
{
  const Cloud cloud = gridOf (1_m, 0.6_m);
  const PlaneSegment plane = planeOfPoints (
      cloud, upTo<pcl::Indices> (cloud.size()), Eigen::Vector3d (1, 2, 3).normalized());
  const PlaneFrame frame (plane.centroid, plane.normal);
  const std::optional<PlaneCovariance> covariance = independentPlaneCovariance (plane);
  ASSERT_TRUE (covariance);
  EXPECT_EQ (frame.directionInSpace ({1, 0}), covariance->axes.col (0));
  EXPECT_EQ (frame.directionInSpace ({0, 1}), covariance->axes.col (1));
}

TEST (PlaneExtent, OfAGridIsExactAndTurnsAndMovesWithThePoints)
{
  const PlaneExtent exact = extentOf (gridOf (1_m, 0.6_m));
  expectBoard (exact, 1e-6);
  EXPECT_EQ (exact.hull.size(), 4u);
  Eigen::Isometry3d moved (
      Eigen::AngleAxisd (0.7, Eigen::Vector3d (1, 2, 3).normalized()));
  moved.translation() << 3.0, -2.0, 5.0;
  for (const Eigen::Isometry3d& pose : {Eigen::Isometry3d::Identity(), moved}) {
    Cloud cloud = gridOf (1_m, 0.6_m);
    for (pcl::PointXYZ& point : cloud)
      point = toPoint (pose * point.getVector3fMap().cast<double>());
    const Eigen::Matrix3d axes = pose.linear();
    const PlaneExtent extent = extentOf (cloud, axes.col (2));
    expectBoard (extent, 1e-5);
    expectRightHanded (extent, axes.col (2));
    EXPECT_TRUE (extent.center.isApprox (pose * Eigen::Vector3d (0.5, 0.3, 0), 1e-5));
    EXPECT_LT (angleBetween (extent.long_axis, axes.col (0)), 1e-5);
  }
}

TEST (PlaneExtent, OfScatteredPointsIsTheBoardWithNearlyAllOfThem)
{
  expectBoard (extentOf (scatteredBoard (6000, 0.0)), 1_percent);
  for (const int points : {3000, 30000, 100000})
    for (const double noise : {0.0, 5_mm}) {
      const Cloud cloud = scatteredBoard (points, noise);
      const PlaneExtent extent = extentOf (cloud);
      expectBoard (extent, 5_percent);
      EXPECT_GE (shareInside (cloud, extent, Eigen::Vector3d::UnitZ()), 99_percent)
          << points << ", " << noise << " m of noise";
    }
}

TEST (ConvexHull, OfPointsOnACircleHasThemAllAndEndsSoon)
{
  // Each point is a corner: in quadratic time this takes a minute.
  constexpr int number = 100'000;
  PlanarPoints circle;
  for (int i = 0; i < number; ++i) {
    const double angle = 2.0 * pi * i / number;
    circle.emplace_back (std::cos (angle), std::sin (angle));
  }
  EXPECT_NEAR (convexHull (circle).size(), number, 1_percent * number);
}

TEST (ConvexHull, TakesAShareOutsideThatIsNoneForZero)
{
  PlanarPoints square_and_stray = {{50.0, 1.0}};
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 900; ++i)
    square_and_stray.emplace_back (3.0 * drawUnit (generator),
                                   3.0 * drawUnit (generator));
  const auto largestX = [&] (double max_outside) {
    double largest = 0.0;
    for (const Eigen::Vector2d& corner : convexHull (square_and_stray, max_outside))
      largest = std::max (largest, corner.x());
    return largest;
  };
  EXPECT_LT (largestX (0.02), 3.0);
  for (const double no_share : {0.0, -0.01, double (NAN)})
    EXPECT_EQ (largestX (no_share), 50.0);
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

TEST (PlaneExtent, OfABoardFarAwayIsThatOfABoardNearBy)
{
  // At 10^6 m floats are 6 cm apart. That is little for this board of 100 m x 60 m.
  Cloud cloud = gridOf (1_m, 0.6_m);
  for (pcl::PointXYZ& point : cloud)
    point = toPoint ({1e6 + 100.0 * point.x, -1e6 + 100.0 * point.y, 1e6});
  const PlaneExtent extent = extentOf (cloud);
  EXPECT_NEAR (extent.area, 6000.0, 60.0);
  EXPECT_NEAR (extent.length, 100.0, 1.0);
  EXPECT_LT ((extent.center - Eigen::Vector3d (1000050.0, -999970.0, 1e6)).norm(), 0.1);
}

TEST (PlaneExtent, IgnoresAFewPointsThatStrayFarOutside)
{
  Cloud cloud = scatteredBoard (20000, 1_mm);
  for (int i = 1; i <= 20; ++i)
    cloud.push_back ({static_cast<float> (i), -0.5f * static_cast<float> (i), 0.0f});
  expectBoard (extentOf (cloud), 5_percent);
}

TEST (PlaneExtent, DoesNotDependOnTheOrderOfThePoints)
{
  Cloud cloud = scatteredBoard (1500, 5_mm);
  const PlaneExtent extent = extentOf (cloud);
  expectBoard (extent, 10_percent);
  std::reverse (cloud.begin(), cloud.end());
  const PlaneExtent reversed = extentOf (cloud);
  EXPECT_NEAR (reversed.area, extent.area, 1e-9);
  EXPECT_EQ (reversed.hull.size(), extent.hull.size());
}

TEST (ConvexHull, DoesNotDependOnTheOrderOfManyPointsOfWhichSomeStray)
{
  constexpr int all = 10'000;
  constexpr double share_of_strays = 0.012; // a little more than may be outside
  RandomGenerator generator;
  for (int scene = 0; scene < 20; ++scene) {
    PlanarPoints points;
    for (int i = 0; i < all; ++i) {
      const double side = i < share_of_strays * all ? 1.3 : 1.0;
      points.emplace_back (side * (drawUnit (generator) - 0.5),
                           side * (drawUnit (generator) - 0.5));
    }
    const double area = areaOf (convexHull (points));
    std::reverse (points.begin(), points.end());
    EXPECT_EQ (areaOf (convexHull (points)), area) << "scene " << scene;
  }
}

TEST (PlaneExtent, OfNoPointsIsNothingAndOfEqualOnesAPoint)
{
  EXPECT_EQ (flatExtent ({}).length, 0.0);
  for (const std::size_t number : {1u, 2u, 3u, 5000u}) {
    const Eigen::Vector2d point (3.0, 4.0);
    const PlaneExtent extent = flatExtent (PlanarPoints (number, point));
    EXPECT_EQ (extent.length, 0.0);
    EXPECT_TRUE (extent.center.isApprox (ground.toSpace (point)));
  }
}

TEST (PlaneExtent, OfTwoPointsOrManyOnOneLineIsThatLine)
{
  PlanarPoints line;
  for (int i = 0; i < 5000; ++i)
    line.emplace_back (1.0 + 0.3 * i, 2.0 - 0.7 * i);
  for (const auto& points : {line, {{1.0, 1.0}, {4.0, 5.0}}}) {
    const PlaneExtent extent = flatExtent (points);
    const Eigen::Vector3d from = ground.toSpace (points.front());
    const Eigen::Vector3d to = ground.toSpace (points.back());
    EXPECT_NEAR (extent.length, (to - from).norm(), 1e-6);
    EXPECT_TRUE (extent.center.isApprox (0.5 * (from + to)));
    EXPECT_LT (angleBetween (extent.long_axis, to - from), 1e-6);
  }
}

TEST (PlaneExtent, OfALineAndOnePointBesideItIsATriangleWithoutPointsThatAreNotFinite)
{
  PlanarPoints points = {{0.5, 1.0}, {NAN, 0.5}, {0.5, INFINITY}};
  for (int i = 0; i <= 1000; ++i) // a line from (0, 0) to (1, 0)
    points.emplace_back (0.001 * i, 0.0);
  const PlaneExtent extent = extentOnGround (points);
  EXPECT_NEAR (extent.area, 0.5, 1e-9);
  EXPECT_NEAR (extent.length * extent.width, 1.0, 1e-6);
}

TEST (PlaneExtent, HasTheSmallestOfTheRectanglesAlongTheOutline)
{
  // A square of 1 m with one corner cut off: each corner in turn. A rectangle along the
  // cut has a larger area than the square.
  for (const double x : {-0.5, 0.5})
    for (const double y : {-0.5, 0.5}) {
      const PlanarPoints points = {
          {-x, -y}, {x, -y}, {-x, y}, {0.4 * x, y}, {x, 0.4 * y}};
      const PlaneExtent extent = extentOnGround (points);
      EXPECT_NEAR (extent.length * extent.width, 1.0, 1e-9);
    }
}

TEST (PlaneExtent, RefusesInliersOutsideTheCloud)
{
  const auto cloud = Scene().floor (1, 2).build().cloud;
  for (const pcl::index_t outside : {-1, static_cast<int> (cloud->size())}) {
    pcl_ops::PlaneSegment plane;
    plane.inliers = {0, 1, 2, outside};
    EXPECT_THROW (planeExtent (*cloud, plane), std::invalid_argument);
    EXPECT_THROW (planeExtent (pcl_ops::CloudView(), plane), std::invalid_argument);
  }
}

TEST (ConvexHull, HasTheFourCornersOfALatticeAlone)
{
  for (const int edge : {10, 100}) { // of more than 2048 points most are left out early
    PlanarPoints lattice;
    for (int x = 0; x <= edge; ++x)
      for (int y = 0; y <= edge; ++y)
        lattice.emplace_back (x, y);
    const PlanarPoints hull = pcl_ops::convexHull (lattice, 0.0);
    EXPECT_EQ (hull.size(), 4u);
    EXPECT_EQ (areaOf (hull), 1.0 * edge * edge) << "counter-clockwise: above 0";
  }
}

TEST (ConvexHull, HasAllPointsOverManyDecadesInside)
{
  constexpr double largest_coordinate = 1e13;
  constexpr double rounding = 1e-9 * largest_coordinate;
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const PlanarPoints points = pointsOverManyDecades (seed);
    const PlanarPoints hull = pcl_ops::convexHull (points, 0.0);
    ASSERT_GE (hull.size(), 3u);
    for (std::size_t i = 0; i < hull.size(); ++i) {
      const Eigen::Vector2d along =
          (hull[(i + 1) % hull.size()] - hull[i]).normalized();
      for (const Eigen::Vector2d& point : points)
        EXPECT_LE (cross (point - hull[i], along), rounding) << "seed " << seed;
    }
  }
}
