// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "paper/local_plane_sampling.h"

#include <array>

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

/** Defaults of LocalSamplingParameters: N_loc points of a sphere are tested, and more
 * than alpha_min of them have to be inliers. */
constexpr int n_loc = 80;
constexpr double alpha_min = 0.8;
/** A limit of inliers, hypotheses or visits per point that no test reaches. */
constexpr double no_limit = 1e9;

Coordinates
pointsAt (const std::vector<Eigen::Vector3f>& positions)
{
  Coordinates points;
  for (const Eigen::Vector3f& p : positions)
    points.add (p.x(), p.y(), p.z());
  return points;
}

/** A hypothesis through the first point and two of the others. All points are in the
 * sphere.
 * \param[in] inner_radius r1 [m] */
std::optional<Plane>
hypothesisThroughFirst (const std::vector<Eigen::Vector3f>& positions,
                        double inner_radius)
{
  const Coordinates points = pointsAt (positions);
  RandomGenerator generator (seedOfTest());
  constexpr std::uint32_t first = 0;
  return drawHypothesis (points, first, upTo (points.size()), inner_radius, generator);
}

/** Adds points drawn uniformly in a square of 4 cm x 4 cm on the plane z = 0: all are
 * within r1, 10 cm by default, of each other. */
void
addPatch (std::size_t size, Coordinates& points)
{
  RandomGenerator generator (seedOfTest());
  for (std::size_t i = 0; i < size; ++i) {
    const double x = 4_cm * drawUnit (generator), y = 4_cm * drawUnit (generator);
    points.add (static_cast<float> (x), static_cast<float> (y), 0.0f);
  }
}

/** Adds points at z = 1 m, 2 m, ..: none is within r1 of another one or of the patch.
 */
void
addLonePoints (std::size_t size, Coordinates& points)
{
  for (std::size_t i = 1; i <= size; ++i)
    points.add (0, 0, static_cast<float> (i));
}

/** Local planes of spheres that hold all points each, whatever their distance. */
LocalPlanes
sampleInSpheresOfAll (const Coordinates& points,
                      const LocalSamplingParameters& parameters)
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

/** The same of a patch of so many points alone. */
LocalPlanes
samplePatch (std::size_t size, const LocalSamplingParameters& parameters)
{
  Coordinates points;
  addPatch (size, points);
  return sampleInSpheresOfAll (points, parameters);
}

/** The probability of more than min_inliers inliers among samples that are drawn with
 * replacement: the sum of binomial (samples, i) p^i (1 - p)^(samples - i) over i, with
 * p = inlier_share. */
double
probabilityOfMoreThan (int min_inliers, int samples, double inlier_share)
{
  double probability = 0.0;
  for (int i = min_inliers + 1; i <= samples; ++i)
    probability +=
        std::exp (std::lgamma (samples + 1.0) - std::lgamma (i + 1.0) -
                  std::lgamma (samples - i + 1.0) + i * std::log (inlier_share) +
                  (samples - i) * std::log1p (-inlier_share));
  return probability;
}

/** The points of the cloud that a detector uses. */
const pcl::Indices some_indices{0, 2, 4, 6, 7, 8};

/** The points \ref some_indices of a cloud, without a search of the user. */
DetectorInput
inputWithoutSearch (const CloudView& cloud = {})
{
  return {cloud, &some_indices, Eigen::Vector3d::Zero(), nullptr};
}

/** The positions of points, in lexicographic order. */
std::vector<std::array<float, 3>>
sortedPositions (const Coordinates& points)
{
  std::vector<std::array<float, 3>> positions;
  for (std::size_t i = 0; i < points.size(); ++i)
    positions.push_back ({points.x[i], points.y[i], points.z[i]});
  std::sort (positions.begin(), positions.end());
  return positions;
}

/** Fails unless the sphere around each point holds every point within the radius once
 * and no other point, as by brute force. Points so near the surface of the sphere that
 * rounding decides may be in it or not. */
void
expectSpheresAsByBruteForce (const Coordinates& coordinates, double radius)
{
  Points points; // Points::index is empty: they are the whole cloud
  static_cast<Coordinates&> (points) = coordinates;
  // Without a search of the user the cloud and the indices of the input are not read.
  const Spheres spheres =
      spheresAround (inputWithoutSearch(), points, radius, one_thread);
  EXPECT_EQ (sortedPositions (spheres.points), sortedPositions (points));
  Indices sphere{99, 98, 97}; // of an earlier call: find must overwrite them
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
  const Plane plane =
      hypothesisThroughFirst ({{1, 2, 3}, {1, 3, 3}, {1, 2, 4}}, 2_m).value();
  EXPECT_NEAR (std::abs (plane.normal.x()), 1.0, 1e-12);
  EXPECT_NEAR (plane.distance ({1, 7, -5}), 0.0, 1e-12);
}

TEST (DrawHypothesis, TakesNoPointBeyondTheInnerRadius)
{
  // The first three points are near each other on the plane z = 0, the last three are
  // 2 m and more from the first.
  const Coordinates points =
      pointsAt ({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 2}, {3, 0, 3}, {0, 4, 1}});
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 100; ++i) {
    const std::optional<Plane> plane =
        drawHypothesis (points, 0, upTo (points.size()), 1.5_m, generator);
    EXPECT_EQ (std::abs (plane.value().normal.z()), 1.0);
  }
}

TEST (DrawHypothesis, IsNothingWithoutThreePointsThatMakeATriangle)
{
  EXPECT_FALSE (hypothesisThroughFirst ({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, 1_m));
  EXPECT_FALSE (hypothesisThroughFirst ({{1, 2, 3}, {1, 2, 4}, {1, 2, 4}}, 2_m));
  EXPECT_FALSE (hypothesisThroughFirst ({{1, 2, 3}}, 1_m));
  EXPECT_FALSE (
      hypothesisThroughFirst ({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}, {3, 6, 9}}, 99_m));
}

TEST (DrawHypothesis, DrawsAgainUntilThePointsMakeATriangle)
{
  // Every triangle has the last point, one of 71, as a corner.
  std::vector<Eigen::Vector3f> positions (50, {0, 0, 0});
  positions.insert (positions.end(), 20, {1, 0, 0});
  positions.emplace_back (0, 1, 0);
  EXPECT_TRUE (hypothesisThroughFirst (positions, 2_m));
}

TEST (SampleLocalPlanes, AcceptsAsManySpheresAsTheBinomialDistributionOfInliersSays)
{
  // A sphere is accepted if its center is on the patch, as a lone point has no points
  // near enough (r1) for a hypothesis, and if more than alpha_min of its N_loc tested
  // points are on the patch, too.
  constexpr int size = 1000;
  constexpr double hypotheses_per_point = 5.0;
  LocalSamplingParameters parameters;
  parameters.max_hypotheses_per_point = hypotheses_per_point;
  parameters.max_inliers_per_point = parameters.max_visits_per_point = no_limit;
  for (const double inlier_share : {0.7, 0.75, 0.8, 0.85, 0.9, 0.95}) {
    const auto on_patch = static_cast<std::size_t> (inlier_share * size);
    Coordinates points;
    addPatch (on_patch, points);
    addLonePoints (size - on_patch, points);
    const auto accepted =
        static_cast<double> (sampleInSpheresOfAll (points, parameters).moments.size());
    const double probability =
        inlier_share *
        probabilityOfMoreThan (int (alpha_min * n_loc), n_loc, inlier_share);
    constexpr double tries = hypotheses_per_point * size;
    const double standard_deviation =
        std::sqrt (tries * probability * (1.0 - probability));
    EXPECT_NEAR (accepted, tries * probability, 4.0 * standard_deviation)
        << inlier_share;
  }
}

TEST (SampleLocalPlanes, EndsAtTheLimitOfInliersHypothesesOrVisits)
{
  LocalSamplingParameters few_inliers, few_hypotheses, few_visits;
  // Each plane has all points as inliers: the fourth one exceeds 3.5 per point.
  few_inliers.max_inliers_per_point = 3.5;
  EXPECT_EQ (samplePatch (200, few_inliers).moments.size(), 4u);
  few_hypotheses.max_inliers_per_point = no_limit;
  few_hypotheses.max_visits_per_point = no_limit;
  few_hypotheses.max_hypotheses_per_point = 0.5;
  EXPECT_EQ (samplePatch (200, few_hypotheses).hypotheses, 100u);
  few_visits.max_inliers_per_point = no_limit;
  // A visit is a point looked at (max_visits_per_point). Each hypothesis costs the 200
  // points of its sphere and 100 more, which stand for all other work: 1.5 visits per
  // point.
  few_visits.max_visits_per_point = 7 * 1.5;
  EXPECT_EQ (samplePatch (200, few_visits).hypotheses, 7u);
}

TEST (SampleLocalPlanes, CountsThePointsExaminedToFindANearlyEmptySphere)
{
  constexpr std::size_t size = 200;
  Coordinates points;
  addLonePoints (size, points);
  // Like a search whose voxels hold many points: it examines 900 and finds the center
  // alone. So a sphere costs 400 visits, a third of the examined points and 100 more,
  // and 200 * size visits are enough for size / 2 spheres.
  constexpr std::size_t examined = 900;
  const auto findCenterAlone = [] (std::uint32_t center, Indices& sphere) {
    sphere = {center};
    return examined;
  };
  LocalSamplingParameters parameters;
  parameters.max_visits_per_point = 200.0;
  const LocalPlanes found =
      sampleLocalPlanes (points, findCenterAlone, parameters, theta_h, seedOfTest());
  EXPECT_EQ (found.hypotheses, size / 2);
}

TEST (SampleLocalPlanes, CountsDrawsThatGiveNoTriangle)
{
  // A sphere costs its 200 points, 100 more, and 1000 draws of equal points: 1300
  // visits. 65 visits per point, 13,000, are enough for ten spheres.
  constexpr std::size_t size = 200;
  Coordinates points;
  for (std::size_t i = 0; i < size; ++i)
    points.add (1, 2, 3);
  LocalSamplingParameters parameters;
  parameters.max_visits_per_point = 65.0;
  EXPECT_EQ (sampleInSpheresOfAll (points, parameters).hypotheses, 10u);
}

TEST (SampleLocalPlanes, SkipsSpheresWithFewerPointsThanTestedPoints)
{
  EXPECT_FALSE (samplePatch (n_loc, {}).moments.empty());
  LocalSamplingParameters without_visit_limit;
  without_visit_limit.max_visits_per_point = no_limit;
  constexpr std::size_t too_few = n_loc - 1;
  const LocalPlanes skipped = samplePatch (too_few, without_visit_limit);
  EXPECT_TRUE (skipped.moments.empty());
  EXPECT_EQ (skipped.hypotheses, too_few)
      << "one per point: K_max, max_hypotheses_per_point";
}

TEST (SampleLocalPlanes, CountsAllInliersOfTheSphereOrTheTestedOnesAlone)
{
  Coordinates points;
  addPatch (900, points);
  addLonePoints (50, points);
  const LocalPlanes with_all = sampleInSpheresOfAll (points, {});
  EXPECT_FALSE (with_all.moments.empty());
  for (const Moments& inliers : with_all.moments)
    EXPECT_EQ (inliers.count, 900.0);
  LocalSamplingParameters tested_alone;
  tested_alone.inliers = LocalSamplingParameters::Inliers::Samples;
  const LocalPlanes with_tested = samplePatch (900, tested_alone);
  EXPECT_FALSE (with_tested.moments.empty());
  for (const Moments& inliers : with_tested.moments)
    EXPECT_EQ (inliers.count, n_loc);
}

TEST (Spheres, HoldThePointsWithinTheRadiusAlsoAmongDuplicatesAndBesidePointsFarAway)
{
  for (const double radius : {1_cm, 5_cm, 20_cm, 3_m})
    expectSpheresAsByBruteForce (pointsInACube (1000, 1_m), radius);
  expectSpheresAsByBruteForce ({}, 10_cm);
  Coordinates equal, points = pointsInACube (500, 1_m);
  for (int i = 0; i < 5; ++i)
    equal.add (1, 2, 3);
  expectSpheresAsByBruteForce (equal, 1_mm);
  points.add (1e7f, 0, 0);
  points.add (-1e12f, 1e12f, 0);
  expectSpheresAsByBruteForce (points, 10_cm);
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
      EXPECT_EQ (radius, 1.5_m);
      found = {4, 5, 7}; // 5 is not in some_indices
    };
    return search;
  };
  const Points points = finitePoints (input.cloud, one_thread, &some_indices);
  Indices sphere;
  constexpr std::uint32_t position_of_4 = 2, position_of_7 = 4; // in some_indices
  spheresAround (input, points, 1.5_m, one_thread).find (position_of_7, sphere);
  EXPECT_EQ (sphere, (Indices{position_of_4, position_of_7}));
}
