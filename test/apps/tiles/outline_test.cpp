// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers/random.h>
#include <tiles/plane_outline.h>

#include <functional>
#include <tuple>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::apps;

constexpr double lattice = 0.01; // unit of the coordinates of LatticePoint [m]
constexpr double cell = 1.0;     // edge of a cell of the tiles [m]
const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();

using Within = std::function<bool (const Eigen::Vector2d&)>;

/** \brief Points of a square of 20 m that are in a shape, on average twenty on each
 * square meter. The square is level, or a wall along x. */
std::vector<OutlinePoint>
placesIn (const Within& is_within, bool is_wall = false)
{
  Random random (7);
  std::vector<OutlinePoint> places;
  for (int i = 0; i < 20 * 20 * 20; ++i) {
    const double x = 20.0 * random.unit(), y = 20.0 * random.unit();
    const auto u = std::llround (x / lattice), v = std::llround (y / lattice);
    if (is_within ({x, y}))
      places.push_back (
          {is_wall ? LatticePoint{u, 0, v} : LatticePoint{u, v, 0}, true});
  }
  return places;
}

/** \brief In place of a number of points: corners stay where the edges have them. */
constexpr double so_many_that_corners_stay = 1e12;

/** \brief The outline of a plane.
 * \param[in] points number of points on the plane; by default as many as \ref placesIn
 * draws */
std::vector<PlanarRings>
outlineOf (const std::vector<OutlineEdge>& edges,
           const Eigen::Vector3d& normal = up,
           double points = 8000.0)
{
  constexpr double min_area = 2.25; // of holes, and of all parts but the largest [m^2]
  return apps::outlineOf (
      edges, PlaneFrame (Eigen::Vector3d::Zero(), normal), lattice, points, min_area);
}

std::vector<PlanarRings>
outlineOf (const std::vector<OutlinePoint>& places, const Eigen::Vector3d& normal = up)
{
  return outlineOf (outlineEdges (places, normal, cell / lattice), normal);
}

/** \brief Area of an outline less that of its holes [m^2]; below 0 if the outline runs
 * clockwise. */
double
areaOf (const PlanarRings& rings)
{
  const PlaneFrame frame (Eigen::Vector3d::Zero(), up);
  return extentOf (rings, rings.front(), frame).area;
}

/** \brief Distance to the middle of the square of 20 m [m]. */
double
fromMiddle (const Eigen::Vector2d& point)
{
  return (point - Eigen::Vector2d (10, 10)).norm();
}

} // namespace

TEST (Outline, IsTheSameFromEitherSideAndOnAWall)
{
  for (const bool is_wall : {false, true})
    for (const double sign : {1.0, -1.0}) {
      const Eigen::Vector3d normal = is_wall ? Eigen::Vector3d::UnitY() : up;
      const auto places = placesIn ([] (auto&) { return true; }, is_wall);
      const auto outline = outlineOf (places, sign * normal);
      ASSERT_EQ (outline.size(), 1u);
      EXPECT_EQ (outline[0].size(), 1u) << "no holes";
      EXPECT_NEAR (areaOf (outline[0]), 400.0, 8.0) << "counterclockwise: above zero";
    }
}

TEST (Outline, HasHolesAndPartsThatAreNotTooSmall)
{
  struct Part {
    std::size_t rings;
    // [m^2]; the tolerance is about the length of the rings times 0.1 m, which is half
    // the distance of neighboring points.
    double area, tolerance;
  };
  const std::tuple<const char*, Within, std::vector<Part>> rows[] = {
      {"a hole",
       [] (const auto& point) { return fromMiddle (point) > 5.0; },
       {{2, 400.0 - 25.0 * M_PI, 12.0}}},
      // The small part, of 0.8 m^2, is 3.5 m from the others: more than the diameter of
      // the circles that join points, which is three cells.
      {"two parts, the larger one first, and one too small between them",
       [] (const auto& point) {
         return point.x() < 4.0 || point.x() > 12.0 ||
                (point - Eigen::Vector2d (8, 10)).norm() < 0.5;
       },
       {{1, 160.0, 6.0}, {1, 80.0, 5.0}}},
      {"a part in a hole",
       [] (const auto& point) {
         return fromMiddle (point) < 3.0 || fromMiddle (point) > 7.0;
       },
       {{2, 400.0 - 49.0 * M_PI, 16.0}, {1, 9.0 * M_PI, 2.0}}}};
  for (const auto& [name, is_within, parts] : rows) {
    SCOPED_TRACE (name);
    const auto outline = outlineOf (placesIn (is_within));
    ASSERT_EQ (outline.size(), parts.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_EQ (outline[i].size(), parts[i].rings);
      EXPECT_NEAR (areaOf (outline[i]), parts[i].area, parts[i].tolerance);
    }
  }
}

TEST (Outline, OfTwoTilesIsThatOfOne)
{
  // The border of the tiles is at x = 9.3 m. Each tile sees points up to 6 m beyond it.
  constexpr std::int64_t border = 930, halo = 600; // [units of the lattice]
  const auto is_within = [] (const Eigen::Vector2d& point) {
    return (point - Eigen::Vector2d (9, 12)).norm() > 3.0;
  };
  std::vector<OutlineEdge> edges;
  for (const bool is_east : {false, true}) {
    std::vector<OutlinePoint> seen;
    for (OutlinePoint point : placesIn (is_within)) {
      const std::int64_t east_of_border = point.position[0] - border;
      const std::int64_t beyond = is_east ? -east_of_border : east_of_border;
      point.is_own = is_east ? beyond <= 0 : beyond < 0;
      if (beyond < halo)
        seen.push_back (point);
    }
    const auto own = outlineEdges (seen, up, cell / lattice);
    edges.insert (edges.end(), own.begin(), own.end());
  }
  const auto whole = outlineOf (placesIn (is_within)), joined = outlineOf (edges);
  ASSERT_EQ (joined.size(), 1u);
  ASSERT_EQ (whole.size(), 1u);
  EXPECT_EQ (joined[0].size(), whole[0].size());
  // The areas differ a little: in one tile, points around x = 9.3 m are thinned, too.
  EXPECT_NEAR (areaOf (joined[0]), areaOf (whole[0]), 0.3);
}

TEST (Outline, OfSquaresThatTouchIsOfTwoParts)
{
  // A square of 10 m x 10 m with its lower corner at (low, low).
  const auto square = [] (std::int64_t low) {
    const LatticePoint a{low, low, 0}, b{low + 1000, low, 0},
        c{low + 1000, low + 1000, 0}, d{low, low + 1000, 0};
    return std::vector<OutlineEdge>{{a, b}, {b, c}, {c, d}, {d, a}};
  };
  std::vector<OutlineEdge> edges = square (0);
  const auto other = square (1000);
  edges.insert (edges.end(), other.begin(), other.end());
  const auto outline = outlineOf (edges, up, so_many_that_corners_stay);
  ASSERT_EQ (outline.size(), 2u);
  for (const PlanarRings& part : outline)
    EXPECT_NEAR (areaOf (part), 100.0, 1e-3);
}

TEST (Outline, HasNoSpikesWhereItsRingBeginsAndEnds)
{
  // The outline of a square of 10 m has a spike: it leaves a side, goes to a tip, and
  // returns to a point 1 cm beside the point that it left, as if another tile had
  // rounded that point differently. The tip is outside the square in the first turn of
  // the loop, inside in the second. In the third turn the spike outside has two edges
  // on its way to the tip and two on its way back. A ring begins at its corner with the
  // least x, then the least y: at the tip outside, and at zero, where the spike inside
  // ends.
  using Ring = std::vector<LatticePoint>;
  for (const Ring& spike : {Ring{{0, 501, 0}, {-500, 500, 0}, {0, 500, 0}, {0, 0, 0}},
                            Ring{{0, 1, 0}, {500, 500, 0}, {0, 0, 0}},
                            Ring{{0, 501, 0},
                                 {-400, 501, 0},
                                 {-500, 500, 0},
                                 {-400, 500, 0},
                                 {0, 500, 0},
                                 {0, 0, 0}}}) {
    Ring ring{{1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0}};
    ring.insert (ring.end(), spike.begin(), spike.end());
    std::vector<OutlineEdge> edges;
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.push_back ({ring[i], ring[(i + 1) % ring.size()]});
    const auto outline = outlineOf (edges, up, so_many_that_corners_stay);
    ASSERT_EQ (outline.size(), 1u);
    const double from_zero_to_tip = 5.0 * std::sqrt (2.0);
    for (const Eigen::Vector2d& corner : outline[0][0])
      EXPECT_GT (std::abs (corner.norm() - from_zero_to_tip), 1.0)
          << corner.transpose();
    EXPECT_NEAR (areaOf (outline[0]), 100.0, 0.1);
  }
}

TEST (Outline, IsNotMovedWhereHolesTogetherAreLargerThanTheirPart)
{
  // A part of 10 m x 10 m counter-clockwise, and beside it two rings of 9 m x 9 m
  // clockwise, as edges that two tiles do not share may leave them. The rings count as
  // holes of the part: less area than none is left to tell how far apart points are.
  std::vector<OutlineEdge> edges;
  const auto add_ring = [&edges] (const std::vector<LatticePoint>& ring) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      edges.push_back ({ring[i], ring[(i + 1) % ring.size()]});
  };
  add_ring ({{0, 0, 0}, {1000, 0, 0}, {1000, 1000, 0}, {0, 1000, 0}});
  for (const std::int64_t x : {2000, 4000})
    add_ring ({{x, 0, 0}, {x, 900, 0}, {x + 900, 900, 0}, {x + 900, 0, 0}});
  const auto outline = outlineOf (edges);
  ASSERT_EQ (outline.size(), 1u);
  EXPECT_NEAR (areaOf ({outline[0][0]}), 100.0, 1e-3);
}

TEST (Outline, OfNoPointsOrALineIsEmpty)
{
  EXPECT_TRUE (outlineEdges ({}, up, cell / lattice).empty());
  std::vector<OutlinePoint> line;
  for (std::int64_t i = 0; i < 50; ++i)
    line.push_back ({{i, 0, 0}, true});
  EXPECT_TRUE (outlineOf (line).empty());
}
