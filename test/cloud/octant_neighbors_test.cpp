// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/octant_neighbors.h"
#include "scene.h"

using namespace pcl_ops::internal;
using namespace pcl_ops;

namespace {

/** \brief So many points in a rectangle of 1 m x 0.1 m, the denser the nearer to x = 0.
 */
PlanarPoints
pointsInAStrip (int number)
{
  RandomGenerator generator (seedOfTest());
  PlanarPoints points;
  for (int i = 0; i < number; ++i) {
    const double x = drawUnit (generator);
    points.emplace_back (x * x, 0.1 * drawUnit (generator));
  }
  return points;
}

/** \brief Index of the nearest point in an octant around a position, found by brute
 * force; no_neighbor if there is none. Of equally near points it is the first one.
 * \param[in] left_out indices of points that are no neighbors */
std::uint32_t
nearestIn (std::size_t octant,
           const Eigen::Vector2d& position,
           const std::vector<std::uint32_t>& left_out,
           const PlanarPoints& points)
{
  std::uint32_t nearest = no_neighbor;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d step = points[i] - position;
    if (std::count (left_out.begin(), left_out.end(), i) == 0 &&
        octantOf (step) == octant &&
        (nearest == no_neighbor || step.norm() < (points[nearest] - position).norm()))
      nearest = i;
  }
  return nearest;
}

/** \brief Fails unless the tree finds the same neighbors of each point as brute force.
 */
void
expectNeighborsAsByBruteForce (const PlanarPoints& points)
{
  const OctantTree tree (points);
  for (std::uint32_t point = 0; point < points.size(); ++point) {
    const OctantNeighbors neighbors = tree.neighborsOf (point);
    for (std::size_t octant = 0; octant < octants; ++octant)
      EXPECT_EQ (neighbors.points[octant],
                 nearestIn (octant, points[point], {point}, points));
  }
}

} // namespace

TEST (OctantOf, CountsEighthsOfATurnFromX)
{
  for (std::size_t octant = 0; octant < octants; ++octant) {
    // 20 degrees after the beginning of the octant, counter-clockwise.
    const double angle = (45.0 * static_cast<double> (octant) + 20.0) * 1.0_deg;
    EXPECT_EQ (octantOf ({std::cos (angle), std::sin (angle)}), octant);
  }
}

TEST (OctantOf, DiffersByFourForOppositeDirections)
{
  for (const Eigen::Vector2d& direction :
       {Eigen::Vector2d (1, 0), {1, 1}, {0, 1}, {-1, 1}, {0.0, -2.0}, {3, -1}})
    EXPECT_EQ (octantOf (-direction), (octantOf (direction) + 4) % octants);
}

TEST (OctantTree, FindsTheNearestPointInEachOctant)
{
  expectNeighborsAsByBruteForce (pointsInAStrip (500));
}

TEST (OctantTree, TakesThePointWithTheLowestIndexWherePointsAreEquallyFar)
{
  // Of points on a sparse square grid, (5, 0) and (4, 3) are equally far from (0, 0).
  RandomGenerator generator (seedOfTest());
  PlanarPoints points;
  for (int x = 0; x < 20; ++x)
    for (int y = 0; y < 400; ++y)
      if (drawUnit (generator) < 0.2)
        points.emplace_back (x, y);
  std::reverse (points.begin(), points.end()); // low indices at large x
  expectNeighborsAsByBruteForce (points);
}

TEST (OctantTree, HasEachPointInOneGroup)
{
  const PlanarPoints points = pointsInAStrip (100);
  std::vector<int> groups_with_point (points.size(), 0);
  for (const OctantTree::Group& group : OctantTree (points).groups (one_thread))
    for (const std::uint32_t point : group.points)
      ++groups_with_point[point];
  EXPECT_EQ (groups_with_point, std::vector<int> (points.size(), 1));
}

TEST (OctantTree, FindsTheNearestPointsOfOtherGroupsAroundTheCenterOfAGroup)
{
  const PlanarPoints points = pointsInAStrip (100);
  const std::vector<OctantTree::Group> groups = OctantTree (points).groups (one_thread);
  ASSERT_GT (groups.size(), 1u);
  for (const OctantTree::Group& group : groups)
    for (std::size_t octant = 0; octant < octants; ++octant)
      EXPECT_EQ (group.neighbors.points[octant],
                 nearestIn (octant, group.center, group.points, points));
}

TEST (OctantTree, HasTheSameCentersOfGroupsForAnyOrderOfThePoints)
{
  const auto centersOf = [] (const PlanarPoints& points) {
    std::vector<std::pair<double, double>> centers;
    for (const OctantTree::Group& group : OctantTree (points).groups (one_thread))
      centers.emplace_back (group.center.x(), group.center.y());
    std::sort (centers.begin(), centers.end());
    return centers;
  };
  PlanarPoints points = pointsInAStrip (1000);
  const auto centers = centersOf (points);
  std::reverse (points.begin(), points.end());
  EXPECT_EQ (centersOf (points), centers);
}
