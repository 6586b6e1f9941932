// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers/random.h>
#include <tiles/exact_moments.h>
#include <tiles/plane_joining.h>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::apps;

const double unit = momentsUnit (1.0);

ExactMoments
momentsOf (const std::vector<Eigen::Vector3d>& points)
{
  ExactMoments moments;
  moments.unit = unit;
  for (const Eigen::Vector3d& point : points)
    moments.add (point);
  return moments;
}

/** \brief Points on a floor of 100 m x 100 m, 1 cm thick. */
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

TEST (ExactMoments, OfPartsAreThoseOfTheWhole)
{
  const std::vector<Eigen::Vector3d> all = floorAt ({5e6, -5e6, 500.0});
  const ExactMoments whole = momentsOf (all);
  const ExactMoments few = momentsOf ({all.begin(), all.begin() + 137});
  const ExactMoments many = momentsOf ({all.begin() + 137, all.end()});
  EXPECT_TRUE (few.sums + many.sums == whole.sums);
  EXPECT_FALSE (few.sums == whole.sums);
}

TEST (ExactMoments, AreThoseOfTheLibraryInMeters)
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
}

TEST (ExactMoments, RoundAPointToTheLattice)
{
  const Moments moments = momentsOf ({{1.0 + 0.3 * unit, -2.0, 3.0}}).toMoments();
  EXPECT_EQ (moments.centroid(), Eigen::Vector3d (1.0, -2.0, 3.0));
  EXPECT_EQ (momentsOf ({}).toMoments().count, 0.0);
}

/** \brief A wall along x, 3 m high, as a piece of a tile that sees only its own points.
 * Points are up to 2 cm off the wall.
 * \param[in] first,last x of its ends [m]
 * \param[in] y of the wall [m] */
TilePiece
wall (int first, int last, double y)
{
  Random random (first);
  TilePiece piece;
  piece.own_moments.unit = unit;
  for (int x = 10 * first; x < 10 * last; ++x)
    for (int z = 0; z < 30; ++z)
      piece.own_moments.add ({0.1 * x, y + 0.04 * random.unit() - 0.02, 0.1 * z});
  piece.seen_moments = piece.own_moments.toMoments();
  return piece;
}

/** \brief Two tiles in a row along x, each with its planes. */
using Row = std::vector<TilePlanes>;

JoinedPlanes
joined (const Row& row)
{
  return joinPlanes ({{0, 0}, {1, 0}},
                     [&row] (const TileKey& tile) { return row[tile[0]]; });
}

/** \brief Two tiles with a wall each, 10 m long. Both have their walls in the same
 * twelve cells, of 1 m, around x = 10 m.
 * \param[in] y_of_first,y_of_second of the walls [m] */
Row
twoTiles (double y_of_first, double y_of_second)
{
  std::vector<BorderVoxel> shared;
  for (int x = 8; x < 12; ++x)
    for (int z = 0; z < 3; ++z)
      shared.push_back ({{x, 0, z}, 0});
  return {{{wall (0, 10, y_of_first)}, shared}, {{wall (10, 20, y_of_second)}, shared}};
}

TEST (PlaneJoining, AddsTheMomentsOfOwnPointsOnly)
{
  Row row = twoTiles (5.0, 5.0);
  row[1].pieces[0].seen_moments = wall (8, 20, 5.0).seen_moments; // with the halo
  EXPECT_TRUE (joined (row).planes.at (0).moments.sums ==
               row[0].pieces[0].own_moments.sums + row[1].pieces[0].own_moments.sums);
}

TEST (PlaneJoining, JoinsNoPlanesThatAreApartNotParallelOrShareFewerThanThreeCells)
{
  EXPECT_EQ (joined (twoTiles (5.0, 5.1)).planes.size(), 2u) << "10 cm apart";
  Row row = twoTiles (5.0, 5.0);
  for (const std::size_t shared : {2, 0}) {
    row[1].border_voxels.resize (shared);
    EXPECT_EQ (joined (row).planes.size(), 2u) << shared << " cells are shared";
  }
  row = twoTiles (5.0, 5.0);
  ExactMoments floor;
  floor.unit = unit;
  for (int x = 0; x < 100; ++x)
    for (int y = 0; y < 100; ++y)
      floor.add ({10.0 + 0.1 * x, 0.1 * y, 0.0});
  row[1].pieces[0].own_moments = floor;
  row[1].pieces[0].seen_moments = floor.toMoments();
  EXPECT_EQ (joined (row).planes.size(), 2u) << "the floor at its foot";
}

TEST (PlaneJoining, NumbersPlanesByFallingSize)
{
  Row row = twoTiles (5.0, 7.0);
  row[1].pieces[0] = wall (10, 40, 7.0);
  const JoinedPlanes found = joined (row);
  EXPECT_EQ (found.numbers, (std::vector<std::vector<std::uint32_t>>{{2}, {1}}));
  EXPECT_TRUE (found.planes[0].moments.sums == row[1].pieces[0].own_moments.sums);
}

} // namespace
