// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/plane_assignment.h"
#include "grid_scene.h"

using namespace pcl_ops::internal;
using namespace pcl_ops;

namespace {

/** \brief The level plane at a height [m]. */
Plane
atHeight (double z)
{
  return {Eigen::Vector3d::UnitZ(), -z};
}

/** \brief Points on the z axis at these heights [m]. */
Coordinates
pointsAtHeights (const std::vector<float>& heights)
{
  Coordinates points;
  for (const float z : heights)
    points.add (0.0f, 0.0f, z);
  return points;
}

/** \brief Planes of random directions, at most 0.5 m from zero. */
std::vector<Plane>
randomPlanes (std::size_t count)
{
  RandomGenerator generator (seedOfTest() + 1); // pointsInACube has the other seed
  std::vector<Plane> planes;
  for (std::size_t i = 0; i < count; ++i)
    planes.push_back (
        {drawGaussians (generator).normalized(), drawUnit (generator) - 0.5});
  return planes;
}

/** \brief Index of the plane that a point belongs to: of the planes nearer than the
 * threshold [m], by the rule the first or the nearest one; no_plane if there is none.
 */
std::int32_t
labelByBruteForce (const Eigen::Vector3d& point,
                   const std::vector<Plane>& planes,
                   double threshold,
                   AssignmentRule rule)
{
  std::int32_t best = no_plane;
  double max_distance = threshold;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const double distance = std::abs (planes[p].distance (point));
    if (distance >= max_distance)
      continue;
    best = static_cast<std::int32_t> (p);
    if (rule == AssignmentRule::First)
      break;
    max_distance = distance;
  }
  return best;
}

const std::vector<AssignmentRule> by_nearest = {AssignmentRule::Nearest};
const std::vector<AssignmentRule> by_first = {AssignmentRule::First};
const std::vector<AssignmentRule> by_either = {AssignmentRule::Nearest,
                                               AssignmentRule::First};

/** \brief Points on the z axis at these heights [m], and where they go. */
struct AssignmentCase {
  const char* name;
  std::vector<float> heights;
  std::vector<Plane> planes;
  double threshold; // [m]
  std::vector<AssignmentRule> rules;
  Labels expected; // by each of the rules
};

const AssignmentCase assignment_cases[] = {
    {"to the nearest of two planes",
     {0.0f, 0.2f, 0.8f, 1.0f},
     {atHeight (0), atHeight (1)},
     2_m,
     by_nearest,
     {0, 0, 1, 1}},
    {"to the first plane that is near enough",
     {0.0f, 0.2f, 0.8f, 1.0f, 2.5f},
     {atHeight (0), atHeight (1)},
     2_m,
     by_first,
     {0, 0, 0, 0, 1}},
    {"to the first of two equally near planes",
     {0.5f},
     {atHeight (0), atHeight (1)},
     2_m,
     by_either,
     {0}},
    {"to no plane beyond the threshold",
     {-0.06f, -0.04f, 0.04f, 0.06f},
     {atHeight (0)},
     5_cm,
     by_either,
     {no_plane, 0, 0, no_plane}},
    {"no points", {}, {atHeight (0)}, 5_cm, by_nearest, {}},
    {"no planes", {0.0f, 1.0f}, {}, 5_cm, by_nearest, {no_plane, no_plane}}};

} // namespace

TEST (AssignPoints, GivesEachPointToAPlaneNearEnough)
{
  constexpr unsigned several_threads = 2;
  for (const AssignmentCase& row : assignment_cases)
    for (const AssignmentRule rule : row.rules)
      EXPECT_EQ (assignPoints (pointsAtHeights (row.heights),
                               row.planes,
                               row.threshold,
                               rule,
                               several_threads),
                 row.expected)
          << row.name;
}

TEST (AssignPoints, AgreesWithBruteForce)
{
  const Coordinates points = pointsInACube (40000, 2_m);
  const std::vector<Plane> planes = randomPlanes (12);
  for (const AssignmentRule rule : {AssignmentRule::Nearest, AssignmentRule::First}) {
    const Labels labels = assignPoints (points, planes, 10_cm, rule, one_thread);
    int different = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
      different += labels[i] != labelByBruteForce (points[i], planes, 10_cm, rule);
    EXPECT_LE (different, 4) // of 40,000
        << "single and double precision may differ next to the threshold or to a tie";
  }
}

TEST (AssignPoints, GivesAPointItsPlaneThoughStraysReachTheLargestFloats)
{
  Coordinates points;
  for (const float x : {0.0f, 3e38f, -3e38f}) // their sums and differences overflow
    points.add (x, 0.0f, 0.0f);
  EXPECT_EQ (
      assignPoints (points, {atHeight (0)}, 5_cm, AssignmentRule::Nearest, one_thread),
      (Labels{0, 0, 0}));
}

TEST (MomentsOfLabels, AreThoseOfThePointsOfEachLabel)
{
  const Coordinates points = pointsInACube (40000, 2_m);
  const Labels labels = assignPoints (
      points, randomPlanes (3), 10_cm, AssignmentRule::Nearest, one_thread);
  std::vector<Moments> expected (3);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (labels[i] != no_plane)
      expected[static_cast<std::size_t> (labels[i])].add (
          points.x[i], points.y[i], points.z[i]);
  const std::vector<Moments> moments = momentsOfLabels (points, labels, 3, one_thread);
  for (std::size_t p = 0; p < 3; ++p) {
    EXPECT_EQ (moments[p].count, expected[p].count);
    EXPECT_TRUE (moments[p].sum.isApprox (expected[p].sum, 1e-9));
    EXPECT_TRUE (moments[p].covariance().isApprox (expected[p].covariance(), 1e-9));
  }
}
