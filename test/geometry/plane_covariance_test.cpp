// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>

#include "scene.h"

using namespace pcl_ops;

namespace {

/** \brief A tilted board of 2.6 m x 0.7 m, some 10 m from zero; its edges are parallel
 * to no axis. */
const Surface board{{10, 2, 1}, {2.4, 0.9, 0.3}, {-0.2, 0.5, 0.4}};

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief So many points drawn uniformly on the board.
 * \param[in] noise standard deviation along the normal [m] */
Cloud
drawBoard (int points, double noise, RandomGenerator& generator)
{
  Cloud cloud;
  for (int i = 0; i < points; ++i)
    cloud.push_back (toPoint (drawPointOf (board, noise, generator)));
  return cloud;
}

/** \brief The plane fitted to all points of a cloud. */
PlaneSegment
fittedTo (const Cloud& cloud)
{
  PlaneSegment plane = planeOfPoints (
      cloud, upTo<pcl::Indices> (cloud.size()), Eigen::Vector3d::UnitZ());
  plane.normal = fitPlane (plane.moments)->plane.normal;
  return plane;
}

/** \brief Errors of the plane in the order of the covariance: by how much the true
 * board is tilted relative to the plane along both axes [rad], and moved along its
 * normal [m]. */
Eigen::Vector3d
errorsOf (const PlaneSegment& plane, const PlaneCovariance& covariance)
{
  Eigen::Vector3d normal = board.normal();
  if (normal.dot (plane.normal) < 0.0)
    normal = -normal;
  const double cosine = normal.dot (plane.normal);
  Eigen::Vector3d errors;
  errors.head<2>() = -covariance.axes.transpose() * normal / cosine;
  errors[2] = normal.dot (board.center() - plane.centroid) / cosine;
  return errors;
}

} // namespace

TEST (PlaneCovariance, SaysHowFarFitsOfManyAndOfFewPointsAreOff)
{
  constexpr int draws = 1000;
  for (const auto& [points, noise] : {std::pair (300, 1_cm), {30, 5_mm}}) {
    RandomGenerator generator (seedOfTest());
    // Means over many draws of the squared errors, divided by their variances, and of
    // the squared Mahalanobis distance, divided by its degrees of freedom. The
    // covariance is right if the expected value of each is 1.
    Eigen::Vector3d normalized_squared_errors = Eigen::Vector3d::Zero();
    double normalized_squared_distance = 0.0;
    for (int i = 0; i < draws; ++i) {
      const PlaneSegment plane = fittedTo (drawBoard (points, noise, generator));
      const std::optional<PlaneCovariance> covariance =
          independentPlaneCovariance (plane);
      const Eigen::Vector3d errors = errorsOf (plane, *covariance);
      const Eigen::Matrix3d& matrix = covariance->matrix;
      normalized_squared_errors +=
          errors.cwiseAbs2().cwiseQuotient (matrix.diagonal()) / draws;
      normalized_squared_distance +=
          errors.dot (matrix.inverse() * errors) / 3.0 / draws;
    }
    for (const double normalized : {normalized_squared_errors[0],
                                    normalized_squared_errors[1],
                                    normalized_squared_errors[2],
                                    normalized_squared_distance})
      EXPECT_NEAR (1.0, std::sqrt (normalized), 10_percent);
  }
}

TEST (PlaneCovariance, OfFourCornersIsThatComputedByHand)
{
  // The corners of a rectangle of 4 m x 2 m, 0.1 m above and below it by turns. The
  // squares of the heights sum to 4 * 0.01 m^2. Four points less three parameters of a
  // plane leave one degree of freedom, by which the sum is divided.
  constexpr double variance = 0.04; // [m^2]
  PlaneSegment plane;
  for (const double x : {2.0, -2.0})
    for (const double y : {1.0, -1.0})
      plane.moments.add (x, y, 0.05 * x * y);
  const std::optional<PlaneCovariance> covariance = independentPlaneCovariance (plane);
  const Eigen::Matrix2d tilts = covariance->matrix.topLeftCorner<2, 2>();
  const Eigen::Matrix3d in_space =
      covariance->axes * tilts * covariance->axes.transpose();
  EXPECT_NEAR (variance / (4 * 2.0 * 2.0), in_space (0, 0), 1e-12) << "|x| is 2";
  EXPECT_NEAR (variance / (4 * 1.0 * 1.0), in_space (1, 1), 1e-12) << "|y| is 1";
  EXPECT_NEAR (variance / 4, covariance->matrix (2, 2), 1e-12);
}

TEST (PlaneCovariance, OfACloudDoesNotShrinkWhereNeighborsErrAlike)
{
  RandomGenerator generator (seedOfTest());
  const Cloud once = drawBoard (2000, 1_cm, generator);
  constexpr int copies = 9; // each 1 mm beside the one before, with the same errors
  Cloud often;
  for (int copy = 0; copy < copies; ++copy)
    for (const pcl::PointXYZ& point : once)
      often.push_back (toPoint (point.getVector3fMap().cast<double>() +
                                copy * 1_mm * board.first.normalized()));
  const auto covarianceIn = [] (const Cloud& cloud) {
    const PlaneSegment plane = fittedTo (cloud);
    return std::make_pair (independentPlaneCovariance (plane)->matrix,
                           planeCovariance (cloud, plane)->matrix);
  };
  const auto [independent, correlated] = covarianceIn (once);
  const auto [independent_often, correlated_often] = covarianceIn (often);
  EXPECT_NEAR (
      independent_often (2, 2), independent (2, 2) / copies, 1e-3 * independent (2, 2));
  EXPECT_NEAR (correlated_often (2, 2) / correlated (2, 2), 1.0, 20_percent);
  EXPECT_NEAR (correlated_often (0, 0) / correlated (0, 0), 1.0, 20_percent);
  // The factor f in the documentation of planeCovariance: errors in real clouds are
  // this many times those expected.
  constexpr double measured_factor = 1.7;
  EXPECT_NEAR (
      correlated (2, 2) / independent (2, 2), measured_factor * measured_factor, 1.0);
}

TEST (PlaneCovariance, OfACloudCountsPointsThatErrAlikeInASixtyFourthOfThePlaneOnce)
{
  // A level plane of 8 m x 8 m. On each square meter points are at one height.
  const auto covarianceOf = [] (int points_per_side) { // of a square meter
    RandomGenerator generator (seedOfTest());
    Cloud cloud;
    for (int column = 0; column < 8; ++column)
      for (int row = 0; row < 8; ++row) {
        const double height = 1_cm * drawGaussian (generator);
        for (int i = 0; i < points_per_side; ++i)
          for (int j = 0; j < points_per_side; ++j)
            cloud.push_back (toPoint ({column + (i + 0.5) / points_per_side,
                                       row + (j + 0.5) / points_per_side,
                                       height}));
      }
    const PlaneSegment plane = planeOfPoints (
        cloud, upTo<pcl::Indices> (cloud.size()), Eigen::Vector3d::UnitZ());
    return planeCovariance (cloud, plane)->matrix;
  };
  const Eigen::Matrix3d of_one_point = covarianceOf (1);
  const Eigen::Matrix3d of_sixteen_points = covarianceOf (4);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR (of_sixteen_points (i, i) / of_one_point (i, i), 1.0, 20_percent);
}

TEST (PlaneCovariance, TellsInliersApartThatAreFarFromThePlane)
{
  // The moments are those of a board of some meters. The inliers are thousands of
  // kilometers away on four sides of it, which tell four errors: enough for three
  // numbers.
  PlaneSegment plane;
  for (const double x : {2.0, -2.0})
    for (const double y : {1.0, -1.0})
      plane.moments.add (x, y, 0.05 * x * y);
  plane.normal = Eigen::Vector3d::UnitZ();
  constexpr float far = 1e10f;
  Cloud cloud;
  for (const float x : {far, -far})
    for (const float y : {far, -far})
      cloud.emplace_back (x, y, x > y ? 0.1f : -0.1f);
  plane.inliers = upTo<pcl::Indices> (cloud.size());
  EXPECT_TRUE (planeCovariance (cloud, plane));
}

TEST (PlaneCovariance, OfACloudLeavesOutInliersThatAreNotFinite)
{
  RandomGenerator generator (seedOfTest());
  Cloud cloud = drawBoard (300, 1_cm, generator);
  PlaneSegment plane = fittedTo (cloud);
  const Eigen::Matrix3d matrix = planeCovariance (cloud, plane)->matrix;
  for (const float missing : {NAN, INFINITY}) {
    plane.inliers.push_back (static_cast<pcl::index_t> (cloud.size()));
    cloud.emplace_back (10.0f, missing, 1.0f);
  }
  EXPECT_EQ (planeCovariance (cloud, plane)->matrix, matrix);
}

TEST (PlaneCovariance, OfACloudIsNoneIfAllInliersAreInThreePlaces)
{
  // The moments are those of a board of some meters. Three errors tell no more than the
  // three numbers of a plane, and nothing of their spread.
  PlaneSegment plane;
  for (const double x : {2.0, -2.0})
    for (const double y : {1.0, -1.0})
      plane.moments.add (x, y, 0.05 * x * y);
  plane.normal = Eigen::Vector3d::UnitZ();
  Cloud cloud;
  for (int i = 0; i < 10; ++i) {
    cloud.emplace_back (2.0f, 1.0f, 0.1f);
    cloud.emplace_back (2.0f, -1.0f, -0.1f);
    cloud.emplace_back (-2.0f, 1.0f, -0.1f);
  }
  plane.inliers = upTo<pcl::Indices> (cloud.size());
  EXPECT_FALSE (planeCovariance (cloud, plane));
  cloud.emplace_back (-2.0f, -1.0f, 0.1f); // a fourth place
  plane.inliers = upTo<pcl::Indices> (cloud.size());
  EXPECT_TRUE (planeCovariance (cloud, plane));
}

TEST (PlaneCovariance, IsNoneOfANormalWithinTheSurface)
{
  RandomGenerator generator (seedOfTest());
  Cloud cloud;
  for (int i = 0; i < 100; ++i)
    cloud.push_back (toPoint ({drawUnit (generator), drawUnit (generator), 0.0}));
  PlaneSegment plane = fittedTo (cloud);
  plane.normal = Eigen::Vector3d::UnitX();
  EXPECT_FALSE (planeCovariance (cloud, plane));
}

TEST (PlaneCovariance, RefusesInliersOutsideTheCloud)
{
  const Cloud cloud = *Scene().floor (1, 2).build().cloud;
  for (const pcl::index_t outside : {-1, static_cast<int> (cloud.size())}) {
    PlaneSegment plane = fittedTo (cloud);
    plane.inliers.push_back (outside);
    EXPECT_THROW (planeCovariance (cloud, plane), std::invalid_argument);
  }
}

TEST (PlaneCovariance, IsNoneWithoutAPlane)
{
  PlaneSegment empty, line, three_points; // three points have no residuals
  for (const double x : {0.0, 1.0, 2.0, 3.0, 4.0})
    line.moments.add (x, x, 0.0);
  for (const double x : {0.0, 1.0, 2.0})
    three_points.moments.add (x, x * x, 0.0);
  for (const PlaneSegment& plane : {empty, line, three_points})
    EXPECT_FALSE (independentPlaneCovariance (plane)) << plane.moments.count;
}
