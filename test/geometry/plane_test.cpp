// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/SVD>

#include "scene.h"

using namespace pcl_ops::internal;
using namespace pcl_ops;

namespace {

using PointList = std::vector<Eigen::Vector3d>;

/** \brief The moments of points, summed up relative to an origin. */
Moments
momentsOf (const PointList& points, const Eigen::Vector3d& origin)
{
  Moments moments;
  moments.origin = origin;
  for (const Eigen::Vector3d& point : points) {
    const Eigen::Vector3d local = point - origin;
    moments.add (local.x(), local.y(), local.z());
  }
  return moments;
}

/** \brief 200 points of a tilted, elongated patch with a noise of 1 cm.
 * \param[in] corner where both sides of the patch begin [m] */
PointList
noisyPatch (const Eigen::Vector3d& corner)
{
  const Surface patch{corner, {3, 0.2, 1}, {-0.1, 1, 0.4}};
  RandomGenerator generator (seedOfTest());
  PointList points;
  for (int i = 0; i < 200; ++i)
    points.push_back (drawPointOf (patch, 1_cm, generator));
  return points;
}

/** \brief The plane through points by an SVD of the centered points, the oracle. */
struct SvdPlane {
  Eigen::Vector3d centroid, normal;
  /** \brief Of the points along the principal axes, ascending [m^2]. */
  Eigen::Vector3d variances;
};

SvdPlane
planeBySvd (const PointList& points)
{
  Eigen::Matrix<double, Eigen::Dynamic, 3> rows (points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
    rows.row (static_cast<Eigen::Index> (i)) = points[i];
  const Eigen::RowVector3d mean = rows.colwise().mean();
  rows.rowwise() -= mean;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd (rows, Eigen::ComputeThinV);
  const Eigen::Vector3d variances =
      svd.singularValues().array().square() / static_cast<double> (points.size());
  return {mean, svd.matrixV().col (2), variances.reverse()};
}

} // namespace

TEST (FitPlane, AgreesWithAnSvdOfTheCenteredPoints)
{
  // Near zero, a thousand kilometers away, and in other units.
  const struct {
    Eigen::Vector3d corner;     // of the patch
    double unit;                // factor by which all coordinates are scaled
    double max_angle;           // of the normals [rad]
    double max_distance;        // of both centroids, before scaling [m]
    double max_variances_error; // relative
  } rows[] = {{{1, 2, 3}, 1.0, 1e-9, 1e-12, 1e-9},
              {{1e6, -1e6, 1e6}, 1.0, 1e-8, 1e-8, 1e-6},
              {{1, 2, 3}, 1e-6, 1e-8, 1e-12, 1e-9},
              {{1, 2, 3}, 1e3, 1e-8, 1e-12, 1e-9}};
  for (const auto& row : rows) {
    PointList points = noisyPatch (row.corner);
    for (Eigen::Vector3d& point : points)
      point *= row.unit;
    const PlaneFit fit = fitPlane (momentsOf (points, points.front())).value();
    const SvdPlane svd = planeBySvd (points);
    EXPECT_LT (angleBetween (fit.plane.normal, svd.normal), row.max_angle);
    EXPECT_LT ((fit.centroid - svd.centroid).norm(), row.max_distance * row.unit);
    EXPECT_TRUE (fit.variances.isApprox (svd.variances, row.max_variances_error));
    EXPECT_NEAR (fit.plane.distance (svd.centroid), 0.0, row.max_distance * row.unit);
    EXPECT_NEAR (fit.plane.normal.norm(), 1.0, 1e-12);
  }
}

TEST (FitPlane, OfANarrowStripIsThatOfAnSvdWhicheverWayItRuns)
{
  // 3 km long and 10 cm wide, as pieces of a rail far apart, with a noise of 2 mm.
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 50; ++i) {
    const Eigen::Quaterniond turn = drawTurn (generator);
    const Eigen::Vector3d length = turn * Eigen::Vector3d (3000, 0, 0);
    const Eigen::Vector3d width = turn * Eigen::Vector3d (0, 0.1, 0);
    PointList points;
    for (int n = 0; n < 500; ++n)
      points.push_back (drawPointOf ({{1, 2, 3}, length, width}, 2_mm, generator));
    const auto fit = fitPlane (momentsOf (points, points.front()));
    ASSERT_TRUE (fit);
    const SvdPlane svd = planeBySvd (points);
    EXPECT_LT (angleBetween (fit->plane.normal, svd.normal), 1e-4);
    EXPECT_NEAR (std::sqrt (fit->variances[0] / svd.variances[0]), 1.0, 1e-3);
  }
}

TEST (FitPlane, HasAUnitNormalWhereSeveralPlanesFitAlike)
{
  // The corners of a cube, and of a rod of length 5 with a section of 1 x 1.
  for (const double length : {1.0, 5.0}) {
    PointList corners;
    for (const double x : {0.0, length})
      for (const double y : {0.0, 1.0})
        for (const double z : {0.0, 1.0})
          corners.emplace_back (x, y, z);
    const PlaneFit fit = fitPlane (momentsOf (corners, corners[0])).value();
    EXPECT_NEAR (fit.plane.normal.norm(), 1.0, 1e-12);
    EXPECT_NEAR (fit.variances[0], 0.25, 1e-6);
  }
}

TEST (FitPlane, IsNothingForPointsThatSpanNoPlane)
{
  PointList line, equal, with_nan = noisyPatch ({0, 0, 0}), with_infinity = with_nan;
  for (int i = 0; i < 50; ++i) {
    line.push_back (Eigen::Vector3d (1, 2, 3) + 0.1 * i * Eigen::Vector3d (1, -2, 0.5));
    equal.push_back ({1.1, 2.2, 3.3});
  }
  with_nan[7].x() = NAN;
  with_infinity[7].x() = INFINITY;
  const PointList two (line.begin(), line.begin() + 2), one (1, line.front());
  for (const PointList& points : {one, two, line, equal, with_nan, with_infinity}) {
    EXPECT_FALSE (fitPlane (momentsOf (points, points.front())));
    EXPECT_FALSE (fitPlane (momentsOf (points, Eigen::Vector3d::Zero())));
  }
  EXPECT_FALSE (fitPlane (Moments()));
}

TEST (FitPlane, IsNothingForEqualPointsSummedAboutAnyOrigin)
{
  // Rounding makes their covariance positive for some origins and negative for others.
  RandomGenerator generator (seedOfTest());
  for (int draw = 0; draw < 300; ++draw) {
    const double x = drawUnit (generator), y = drawUnit (generator);
    const PointList equal (50,
                           Eigen::Vector3d (9.0 * x, 9.0 * y, drawUnit (generator)));
    EXPECT_FALSE (fitPlane (momentsOf (equal, Eigen::Vector3d::Zero()))) << draw;
  }
}

TEST (Moments, AddUpAlsoWithThemselvesAndWithNothing)
{
  const PointList points = noisyPatch ({1, 2, 3});
  const PointList half (points.begin(), points.begin() + 70);
  const PointList rest (points.begin() + 70, points.end());
  const Moments whole = momentsOf (points, half.front());
  Moments sum;
  sum += momentsOf (half, half.front());
  sum += momentsOf (rest, rest.front()); // another origin
  sum += Moments();
  EXPECT_EQ (sum.origin, whole.origin);
  EXPECT_EQ (sum.count, whole.count);
  EXPECT_TRUE (sum.sum.isApprox (whole.sum, 1e-12));
  EXPECT_TRUE (sum.covariance().isApprox (whole.covariance(), 1e-12));
  sum += sum;
  EXPECT_EQ (sum.count, 400.0);
  EXPECT_LT ((sum.centroid() - whole.centroid()).norm(), 1e-12);
}

TEST (Moments, OfAMeanAndACovarianceHaveBoth)
{
  Eigen::Matrix3d covariance;
  covariance << 4, 1, 2, 1, 5, 3, 2, 3, 6;
  const Eigen::Vector3d mean (1e6, -2e6, 3);
  const Moments moments = Moments::of (10.0, mean, covariance);
  EXPECT_EQ (moments.count, 10.0);
  EXPECT_EQ (moments.centroid(), mean);
  EXPECT_TRUE (moments.covariance().isApprox (covariance, 1e-15));
}

TEST (PlaneSegment, MeasuresTheRmsDistanceOfItsInliersToItself)
{
  // A plane of a coarse method. The plane fitted to its points is 4 cm beside it, and
  // the points lie 3 cm to both sides of the fitted plane: the rms distance to the
  // coarse plane is sqrt (4^2 + 3^2) cm.
  pcl_ops::PlaneSegment segment;
  segment.centroid = {2, 0, 0};
  segment.normal = Eigen::Vector3d::UnitX();
  segment.moments.origin = segment.centroid;
  for (const double x : {4_cm - 3_cm, 4_cm + 3_cm})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0})
        segment.moments.add (x, y, z);
  EXPECT_NEAR (segment.rms(), 5_cm, 1e-12);
  EXPECT_EQ (segment.plane().distance ({2.5, 3, 4}), 0.5);
}

TEST (Orientation, HasAName)
{
  EXPECT_STREQ (toString (pcl_ops::Orientation::Horizontal), "horizontal");
  EXPECT_STREQ (toString (pcl_ops::Orientation::Vertical), "vertical");
  EXPECT_STREQ (toString (pcl_ops::Orientation::Other), "other");
}

TEST (AngleBetween, IsExactForPlanesThatAreNearlyParallel)
{
  // The cosine of a millionth of a radian is 1 but for the last digits.
  for (const double angle : {1e-9, 1e-6, 0.5}) {
    pcl_ops::PlaneSegment level, tilted;
    tilted.normal = {std::sin (angle), 0, -std::cos (angle)};
    EXPECT_NEAR (angleBetween (level, tilted), angle, 1e-6 * angle);
  }
}
