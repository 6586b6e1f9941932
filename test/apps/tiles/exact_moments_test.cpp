// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers/random.h>
#include <tiles/exact_moments.h>

#include <vector>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::apps;

const double unit = latticeFor (1.0);

ExactMoments
momentsOf (const std::vector<Eigen::Vector3d>& points)
{
  ExactMoments moments;
  moments.unit = unit;
  for (const Eigen::Vector3d& point : points)
    moments.add (point);
  return moments;
}

/** \brief Points on a floor of 100 m, 1 cm thick. */
std::vector<Eigen::Vector3d>
floorAt (const Eigen::Vector3d& corner)
{
  Random random (3);
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 1000; ++i) {
    const double x = 100.0 * random.unit();
    const double y = 100.0 * random.unit();
    points.push_back (corner + Eigen::Vector3d (x, y, 0.01 * random.unit()));
  }
  return points;
}

bool
areEqual (const ExactMoments& a, const ExactMoments& b)
{
  return a.count == b.count && a.sum == b.sum && a.products == b.products;
}

} // namespace

TEST (ExactMoments, OfPartsAreThoseOfTheWholeWhateverIsAddedFirst)
{
  const std::vector<Eigen::Vector3d> all = floorAt ({5e6, -5e6, 500.0});
  const ExactMoments whole = momentsOf (all);
  const ExactMoments few = momentsOf ({all.begin(), all.begin() + 137});
  const ExactMoments many = momentsOf ({all.begin() + 137, all.end()});
  ExactMoments forwards = few, backwards = many;
  forwards += many;
  backwards += few;
  EXPECT_TRUE (areEqual (forwards, whole));
  EXPECT_TRUE (areEqual (backwards, whole));
  EXPECT_FALSE (areEqual (few, whole));
}

TEST (ExactMoments, AreThoseOfTheLibraryInMetres)
{
  const Eigen::Vector3d far (5e6, -5e6, 500.0);
  Moments expected;
  expected.origin = far;
  for (const Eigen::Vector3d& point : floorAt (far)) {
    const Eigen::Vector3d local = point - far;
    expected.add (local.x(), local.y(), local.z());
  }
  const Moments moments = momentsOf (floorAt (far)).toMoments();
  EXPECT_EQ (moments.count, expected.count);
  EXPECT_LT ((moments.centroid() - expected.centroid()).norm(), unit);
  EXPECT_LT ((moments.covariance() - expected.covariance()).norm(), 100.0 * unit);
  const auto fit = fitPlane (moments), fit_of_library = fitPlane (expected);
  ASSERT_TRUE (fit && fit_of_library);
  EXPECT_NEAR (fit->plane.normal.z() / fit_of_library->plane.normal.z(), 1.0, 1e-9);
}

TEST (ExactMoments, TakeThePlaceOfTheLatticeNextToAPoint)
{
  const Moments moments = momentsOf ({{1.0 + 0.3 * unit, -2.0, 3.0}}).toMoments();
  EXPECT_EQ (moments.centroid(), Eigen::Vector3d (1.0, -2.0, 3.0));
}

TEST (ExactMoments, OfNothingAreNone)
{
  EXPECT_EQ (momentsOf ({}).toMoments().count, 0.0);
}
