// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "paper/local_plane_sampling.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

constexpr double theta_h = 5_cm;

Coordinates
pointsAt (const std::vector<Eigen::Vector3f>& positions)
{
  Coordinates points;
  for (const Eigen::Vector3f& p : positions)
    points.add (p.x(), p.y(), p.z());
  return points;
}

/** A hypothesis around the first point, p_r1 and p_r2 being any of the others. */
std::optional<Plane>
hypothesisAround (const std::vector<Eigen::Vector3f>& positions, double inner_radius)
{
  const Coordinates points = pointsAt (positions);
  RandomGenerator generator (seedOfTest());
  return drawHypothesis (points, 0, upTo (points.size()), inner_radius, generator);
}

/** Adds points all over a square of 4 cm x 4 cm on the plane z = 0. */
void
addPatch (std::size_t size, Coordinates& points)
{
  RandomGenerator generator (seedOfTest());
  for (std::size_t i = 0; i < size; ++i) {
    const double x = 4_cm * drawUnit (generator), y = 4_cm * drawUnit (generator);
    points.add (static_cast<float> (x), static_cast<float> (y), 0.0f);
  }
}

/** Adds points at least 1 m from the patch and from each other, without neighbors. */
void
addLonePoints (std::size_t size, Coordinates& points)
{
  for (std::size_t i = 1; i <= size; ++i)
    points.add (0, 0, static_cast<float> (i));
}

LocalPlanes
sample (const Coordinates& points, const LocalSamplingParameters& parameters)
{
  const Indices all = upTo (points.size());
  return sampleLocalPlanes (
      points,
      [&] (std::uint32_t, Indices& sphere) {
        sphere = all;
        return all.size();
      },
      parameters,
      theta_h,
      seedOfTest());
}

LocalPlanes
samplePatch (std::size_t size, const LocalSamplingParameters& parameters)
{
  Coordinates points;
  addPatch (size, points);
  return sample (points, parameters);
}

/** P (X > k) of X inliers among n samples drawn with repetition. */
double
binomialTail (int k, int n, double inlier_share)
{
  double tail = 0.0;
  for (int i = k + 1; i <= n; ++i)
    tail += std::exp (std::lgamma (n + 1.0) - std::lgamma (i + 1.0) -
                      std::lgamma (n - i + 1.0) + i * std::log (inlier_share) +
                      (n - i) * std::log1p (-inlier_share));
  return tail;
}

const pcl::Indices some{0, 2, 4, 6, 7, 8};

DetectorInput
without (const CloudView& cloud = {})
{
  return {cloud, &some, Eigen::Vector3d::Zero(), nullptr};
}

/** Fails unless the search finds each point within the radius of every point once, as
 * brute force does. Points so near the sphere that rounding decides do not count. */
void
expectFindsAll (const Coordinates& coordinates, double radius)
{
  Points points;
  static_cast<Coordinates&> (points) = coordinates;
  const Spheres spheres = spheresAround (without(), points, radius, 1);
  const auto& [x, y, z] = spheres.points;
  EXPECT_TRUE (
      std::is_permutation (x.begin(), x.end(), points.x.begin(), points.x.end()));
  Indices sphere{99, 98, 97};
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    spheres.find (i, sphere);
    std::vector<int> times (points.size());
    for (const std::uint32_t found : sphere)
      ++times[found];
    for (std::uint32_t j = 0; j < points.size(); ++j) {
      const double distance = (spheres.points[i] - spheres.points[j]).norm();
      const bool is_near_surface = std::abs (distance - radius) <= 1e-5 * radius;
      ASSERT_TRUE (is_near_surface || times[j] == (distance <= radius ? 1 : 0));
    }
  }
}

} // namespace

TEST (DrawHypothesis, IsThePlaneThroughThreePoints)
{
  const Plane plane = hypothesisAround ({{1, 2, 3}, {1, 3, 3}, {1, 2, 4}}, 2_m).value();
  EXPECT_NEAR (std::abs (plane.normal.x()), 1.0, 1e-12);
  EXPECT_NEAR (plane.distance ({1, 7, -5}), 0.0, 1e-12);
}

TEST (DrawHypothesis, TakesNoPointBeyondTheInnerRadius)
{
  const auto points =
      pointsAt ({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {3, 0, 3}, {0, 4, 1}});
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 100; ++i) {
    const auto plane =
        drawHypothesis (points, 0, upTo (points.size()), 1.5_m, generator);
    EXPECT_EQ (std::abs (plane.value().normal.z()), 1.0);
  }
}

TEST (DrawHypothesis, IsNoneForEqualPointsAndALine)
{
  EXPECT_FALSE (hypothesisAround ({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, 1_m));
  EXPECT_FALSE (hypothesisAround ({{1, 2, 3}, {1, 2, 4}, {1, 2, 4}}, 2_m));
  EXPECT_FALSE (hypothesisAround ({{1, 2, 3}}, 1_m));
  EXPECT_FALSE (hypothesisAround ({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}}, 99_m));
}

TEST (DrawHypothesis, DrawsAgainUntilThePointsMakeATriangle)
{
  std::vector<Eigen::Vector3f> positions (50, {0, 0, 0});
  positions.insert (positions.end(), 20, {1, 0, 0});
  positions.emplace_back (0, 1, 0);
  EXPECT_TRUE (hypothesisAround (positions, 2_m));
}

TEST (SampleLocalPlanes, AcceptAsManySpheresAsTheShareOfInliersSays)
{
  // p_r0 must be on the patch: a lone point has no neighbors for a hypothesis.
  constexpr int size = 1000;
  LocalSamplingParameters parameters;
  parameters.max_hypotheses_per_point = 5.0;
  parameters.max_inliers_per_point = parameters.max_visits_per_point = 1e9;
  for (const double share : {0.7, 0.75, 0.8, 0.85, 0.9, 0.95}) {
    const auto on_patch = static_cast<std::size_t> (share * size);
    Coordinates points;
    addPatch (on_patch, points);
    addLonePoints (size - on_patch, points);
    const auto accepted =
        static_cast<double> (sample (points, parameters).moments.size());
    const double rate = share * binomialTail (64, 80, share);
    const double tries = 5.0 * size;
    const double deviation = std::sqrt (tries * rate * (1.0 - rate));
    EXPECT_NEAR (accepted, tries * rate, 4.0 * deviation) << share;
  }
}

TEST (SampleLocalPlanes, EndsAtTheNumberOfInliersHypothesesOrVisits)
{
  LocalSamplingParameters inliers, hypotheses, visits;
  inliers.max_inliers_per_point = 3.5;
  EXPECT_EQ (samplePatch (200, inliers).moments.size(), 4u);
  hypotheses.max_inliers_per_point = hypotheses.max_visits_per_point = 1e9;
  hypotheses.max_hypotheses_per_point = 0.5;
  EXPECT_EQ (samplePatch (200, hypotheses).hypotheses, 100u);
  visits.max_inliers_per_point = 1e9;
  // Each hypothesis costs the 200 points of its sphere and 100 more.
  visits.max_visits_per_point = 7 * 1.5;
  EXPECT_EQ (samplePatch (200, visits).hypotheses, 7u);
}

TEST (SampleLocalPlanes, CountsWhatEmptySpheresCostInACrowd)
{
  constexpr std::size_t size = 200;
  Coordinates points;
  addLonePoints (size, points);
  // Like a search whose voxels hold all points: it visits many and finds one.
  const auto find_itself = [] (std::uint32_t center, Indices& sphere) {
    sphere = {center};
    return std::size_t (3 * 300);
  };
  LocalSamplingParameters parameters;
  parameters.max_visits_per_point = 200.0;
  EXPECT_EQ (sampleLocalPlanes (points, find_itself, parameters, theta_h, seedOfTest())
                 .hypotheses,
             size / 2);
}

TEST (SampleLocalPlanes, CountsDrawsThatGiveNoTriangle)
{
  // A sphere costs its 200 points, a hundred, and a thousand draws of equal points.
  constexpr std::size_t size = 200;
  Coordinates points;
  for (std::size_t i = 0; i < size; ++i)
    points.add (1, 2, 3);
  LocalSamplingParameters parameters;
  parameters.max_visits_per_point = 65.0;
  EXPECT_EQ (sample (points, parameters).hypotheses, 10u);
}

TEST (SampleLocalPlanes, SkipsSpheresWithFewerPointsThanSamples)
{
  EXPECT_FALSE (samplePatch (80, {}).moments.empty());
  LocalSamplingParameters patient;
  patient.max_visits_per_point = 1e9;
  const LocalPlanes skipped = samplePatch (79, patient);
  EXPECT_TRUE (skipped.moments.empty());
  EXPECT_EQ (skipped.hypotheses, 79u) << "K_max";
}

TEST (SampleLocalPlanes, CountsAllInliersOfTheSphereOrTheTestedOnesAlone)
{
  Coordinates points;
  addPatch (900, points);
  addLonePoints (50, points);
  for (const Moments& inliers : sample (points, {}).moments)
    EXPECT_EQ (inliers.count, 900.0);
  LocalSamplingParameters tested;
  tested.inliers = LocalSamplingParameters::Inliers::Samples;
  for (const Moments& inliers : samplePatch (900, tested).moments)
    EXPECT_EQ (inliers.count, 80.0);
}

TEST (Spheres, HoldWhatLookingAtAllPointsFindsAlsoDuplicatesAndBesidePointsFarAway)
{
  for (const double radius : {1_cm, 5_cm, 20_cm, 3_m})
    expectFindsAll (pointsInACube (1000, 1_m), radius);
  expectFindsAll ({}, 10_cm);
  Coordinates equal, points = pointsInACube (500, 1_m);
  for (int i = 0; i < 5; ++i)
    equal.add (1, 2, 3);
  expectFindsAll (equal, 1_mm);
  points.add (1e7f, 0, 0);
  points.add (-1e12f, 1e12f, 0);
  expectFindsAll (points, 10_cm);
}

TEST (Spheres, AreThoseOfTheUsersSearchWhereThereIsOne)
{
  pcl::PointCloud<pcl::PointXYZ> cloud;
  for (int i = 0; i < 10; ++i)
    cloud.push_back ({static_cast<float> (i), 0, 0});
  DetectorInput input = without (CloudView (cloud));
  input.search_over = [] (const pcl::Indices&) {
    NeighborSearch search;
    search.within = [] (pcl::index_t point, double radius, auto& found, auto&) {
      EXPECT_EQ (point, 7);
      EXPECT_EQ (radius, 1.5);
      found = {4, 5, 7}; // 5 is none of ours
    };
    return search;
  };
  const Points points = finitePoints (input.cloud, 1, &some);
  Indices sphere;
  spheresAround (input, points, 1.5, 1).find (4, sphere);
  EXPECT_EQ (sphere, (Indices{2, 4})) << "positions of 4 and 7 among them";
}
