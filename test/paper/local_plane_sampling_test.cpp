// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "paper/local_plane_sampling.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

constexpr double theta_h = 5_cm;
/** No sampling ends at this number of inliers, hypotheses or visits per point. */
constexpr double no_limit = 1e9;

Coordinates
pointsAt (const std::vector<Eigen::Vector3f>& positions)
{
  Coordinates points;
  for (const Eigen::Vector3f& p : positions)
    points.add (p.x(), p.y(), p.z());
  return points;
}

/** A hypothesis around the first point; its two other points are any of the others. */
std::optional<Plane>
hypothesisAround (const std::vector<Eigen::Vector3f>& positions, double inner_radius)
{
  const Coordinates points = pointsAt (positions);
  RandomGenerator generator (seedOfTest());
  constexpr std::uint32_t center = 0;
  return drawHypothesis (points, center, upTo (points.size()), inner_radius, generator);
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

/** Local planes among points that are all in each other's spheres. */
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

const pcl::Indices some_indices{0, 2, 4, 6, 7, 8};

/** Some points of a cloud, without a search of the user. */
DetectorInput
inputWithoutSearch (const CloudView& cloud = {})
{
  return {cloud, &some_indices, Eigen::Vector3d::Zero(), nullptr};
}

/** Fails unless the search finds each point within the radius of every point once, as
 * brute force does. Points so near the sphere that rounding decides do not count. */
void
expectFindsAll (const Coordinates& coordinates, double radius)
{
  Points points;
  static_cast<Coordinates&> (points) = coordinates;
  const Spheres spheres =
      spheresAround (inputWithoutSearch(), points, radius, one_thread);
  const auto& [x, y, z] = spheres.points;
  EXPECT_TRUE (
      std::is_permutation (x.begin(), x.end(), points.x.begin(), points.x.end()));
  Indices sphere{99, 98, 97}; // what is there is replaced
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    spheres.find (i, sphere);
    std::vector<int> times_found (points.size());
    for (const std::uint32_t found : sphere)
      ++times_found[found];
    for (std::uint32_t j = 0; j < points.size(); ++j) {
      const double distance = (spheres.points[i] - spheres.points[j]).norm();
      const bool is_near_surface = std::abs (distance - radius) <= 1e-5 * radius;
      const int expected = distance <= radius ? 1 : 0;
      ASSERT_TRUE (is_near_surface || times_found[j] == expected);
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
  // A sphere is accepted if its center is on the patch, as a lone point has no
  // neighbors for a hypothesis, and if more than 64 of 80 tested points are on the
  // patch, too.
  constexpr int size = 1000;
  constexpr double hypotheses_per_point = 5.0;
  LocalSamplingParameters parameters;
  parameters.max_hypotheses_per_point = hypotheses_per_point;
  parameters.max_inliers_per_point = parameters.max_visits_per_point = no_limit;
  for (const double share : {0.7, 0.75, 0.8, 0.85, 0.9, 0.95}) {
    const auto on_patch = static_cast<std::size_t> (share * size);
    Coordinates points;
    addPatch (on_patch, points);
    addLonePoints (size - on_patch, points);
    const auto accepted =
        static_cast<double> (sample (points, parameters).moments.size());
    const double rate = share * binomialTail (64, 80, share);
    constexpr double tries = hypotheses_per_point * size;
    const double deviation = std::sqrt (tries * rate * (1.0 - rate)); // binomial
    EXPECT_NEAR (accepted, tries * rate, 4.0 * deviation) << share;
  }
}

TEST (SampleLocalPlanes, EndsAtTheNumberOfInliersHypothesesOrVisits)
{
  LocalSamplingParameters inliers, hypotheses, visits;
  inliers.max_inliers_per_point = 3.5; // each plane has all points as inliers
  EXPECT_EQ (samplePatch (200, inliers).moments.size(), 4u);
  hypotheses.max_inliers_per_point = hypotheses.max_visits_per_point = no_limit;
  hypotheses.max_hypotheses_per_point = 0.5;
  EXPECT_EQ (samplePatch (200, hypotheses).hypotheses, 100u);
  visits.max_inliers_per_point = no_limit;
  // Each hypothesis costs the 200 points of its sphere and 100 more: 1.5 visits per
  // point.
  visits.max_visits_per_point = 7 * 1.5;
  EXPECT_EQ (samplePatch (200, visits).hypotheses, 7u);
}

TEST (SampleLocalPlanes, CountsWhatEmptySpheresCostInACrowd)
{
  constexpr std::size_t size = 200;
  Coordinates points;
  addLonePoints (size, points);
  // Like a search whose voxels hold many points: it examines 900 and finds one. A
  // sphere costs 400 visits, a third of the examined points and 100 more, and there are
  // 200 * size visits.
  const auto findItself = [] (std::uint32_t center, Indices& sphere) {
    sphere = {center};
    return std::size_t (3 * 300);
  };
  LocalSamplingParameters parameters;
  parameters.max_visits_per_point = 200.0;
  EXPECT_EQ (sampleLocalPlanes (points, findItself, parameters, theta_h, seedOfTest())
                 .hypotheses,
             size / 2);
}

TEST (SampleLocalPlanes, CountsDrawsThatGiveNoTriangle)
{
  // A sphere costs its 200 points, 100 more, and 1000 draws of equal points. Visits of
  // 65 per point are enough for ten spheres.
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
  LocalSamplingParameters without_limit;
  without_limit.max_visits_per_point = no_limit;
  const LocalPlanes skipped = samplePatch (79, without_limit);
  EXPECT_TRUE (skipped.moments.empty());
  EXPECT_EQ (skipped.hypotheses, 79u) << "K_max, one per point";
}

TEST (SampleLocalPlanes, CountsAllInliersOfTheSphereOrTheTestedOnesAlone)
{
  Coordinates points;
  addPatch (900, points);
  addLonePoints (50, points);
  for (const Moments& inliers : sample (points, {}).moments)
    EXPECT_EQ (inliers.count, 900.0);
  LocalSamplingParameters tested_alone;
  tested_alone.inliers = LocalSamplingParameters::Inliers::Samples;
  for (const Moments& inliers : samplePatch (900, tested_alone).moments)
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
  DetectorInput input = inputWithoutSearch (CloudView (cloud));
  input.search_over = [] (const pcl::Indices&) {
    NeighborSearch search;
    search.within = [] (pcl::index_t point, double radius, auto& found, auto&) {
      EXPECT_EQ (point, 7);
      EXPECT_EQ (radius, 1.5);
      found = {4, 5, 7}; // 5 is none of some_indices
    };
    return search;
  };
  const Points points = finitePoints (input.cloud, one_thread, &some_indices);
  Indices sphere;
  constexpr std::uint32_t position_of_7 = 4; // in some_indices
  spheresAround (input, points, 1.5, one_thread).find (position_of_7, sphere);
  EXPECT_EQ (sphere, (Indices{2, position_of_7})) << "the positions of 4 and 7";
}
