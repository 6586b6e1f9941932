// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/plane_pieces.h>

using namespace pcl_ops;

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr double spacing = 1_cm; // of neighboring points

/** \brief The horizontal plane through the centroid of a cloud, with all points as
 * inliers. */
PlaneSegment
planeOf (const Cloud& cloud)
{
  return planeOfPoints (
      cloud, upTo<pcl::Indices> (cloud.size()), Eigen::Vector3d::UnitZ());
}

/** \brief The pieces of the one plane that all points of a cloud are on. */
PlanePieces
piecesOf (const Cloud& cloud, const PlanePiecesParameters& parameters = {})
{
  return findPlanePieces (cloud, {planeOf (cloud)}, parameters);
}

/** \brief Adds a square of steps x steps points 1 cm apart, with a corner at (x, y). */
void
addSquare (int steps, double x, double y, Cloud& cloud)
{
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j)
      cloud.push_back (toPoint ({x + spacing * i, y + spacing * j, 0.0}));
}

constexpr std::size_t tiles_of_floor = 8 * 8;

/** \brief 8 x 8 tiles of 6 x 6 points.
 * \param[in] gap between neighboring tiles [spacings] */
Cloud
tiledFloor (double gap)
{
  constexpr int points = 6, tiles = 8; // along an edge
  const double step = spacing * (points - 1 + gap);
  Cloud cloud;
  for (int i = 0; i < tiles; ++i)
    for (int j = 0; j < tiles; ++j)
      addSquare (points, step * i, step * j, cloud);
  return cloud;
}

/** \brief What a lidar 1.7 m above the ground sees of it: the lowest beam is 15 degrees
 * below the horizon, each next one 2 degrees higher; each beam has 1,800 points.
 * \param[in] noise standard deviation of the distances along the ground [m] */
Cloud
rings (int beams, double noise)
{
  constexpr int directions = 1800;
  constexpr double height = 1.7_m;
  RandomGenerator generator (seedOfTest());
  Cloud cloud;
  for (int beam = 0; beam < beams; ++beam)
    for (int i = 0; i < directions; ++i) {
      const double azimuth = 360.0_deg * i / directions;
      const double range = height / std::tan ((15.0 - 2.0 * beam) * 1.0_deg) +
                           noise * drawGaussian (generator);
      cloud.push_back (
          toPoint ({range * std::cos (azimuth), range * std::sin (azimuth), 0.0}));
    }
  return cloud;
}

/** \brief The positions of the points of each piece, sorted. The list of pieces is
 * sorted by them, too. */
std::vector<std::vector<std::array<float, 3>>>
positionsOf (const PlanePieces& found, const Cloud& cloud)
{
  std::vector<std::vector<std::array<float, 3>>> positions_by_piece;
  for (const PlaneSegment& piece : found.pieces) {
    std::vector<std::array<float, 3>>& positions = positions_by_piece.emplace_back();
    for (const pcl::index_t index : piece.inliers)
      positions.push_back ({cloud[index].x, cloud[index].y, cloud[index].z});
    std::sort (positions.begin(), positions.end());
  }
  std::sort (positions_by_piece.begin(), positions_by_piece.end());
  return positions_by_piece;
}

} // namespace

TEST (PlanePieces, TilesTenSpacingsApartAreAPieceEach)
{
  // By default max_gap is 8 spacings.
  EXPECT_EQ (piecesOf (tiledFloor (10)).pieces.size(), tiles_of_floor);
}

TEST (PlanePieces, TilesSixSpacingsApartAreOnePiece)
{
  EXPECT_EQ (piecesOf (tiledFloor (6)).pieces.size(), 1u);
}

TEST (PlanePieces, TheWidestGapIsAParameter)
{
  PlanePiecesParameters parameters;
  parameters.max_gap = 4;
  EXPECT_EQ (piecesOf (tiledFloor (6), parameters).pieces.size(), tiles_of_floor);
  parameters.max_gap = 12;
  EXPECT_EQ (piecesOf (tiledFloor (10), parameters).pieces.size(), 1u);
}

TEST (PlanePieces, TilesTenSpacingsApartAreAPieceEachWhateverTheSpacing)
{
  Cloud cloud = tiledFloor (10);
  for (pcl::PointXYZ& point : cloud)
    point.getVector3fMap() *= 50.0f;
  EXPECT_EQ (piecesOf (cloud).pieces.size(), tiles_of_floor);
}

TEST (PlanePieces, TilesOfScatteredPointsAreAPieceEach)
{
  RandomGenerator generator (seedOfTest());
  Cloud cloud;
  for (int tile = 0; tile < 9; ++tile) // 3 x 3 tiles with gaps of 15 cm
    for (int i = 0; i < 400; ++i) {    // in 20 cm x 20 cm: 1 cm apart in the mean
      const double x = 0.35 * (tile % 3) + 0.2 * drawUnit (generator);
      const double y = 0.35 * (tile / 3) + 0.2 * drawUnit (generator);
      cloud.push_back (toPoint ({x, y, 0.0}));
    }
  EXPECT_EQ (piecesOf (cloud).pieces.size(), 9u);
}

TEST (PlanePieces, TheGroundOfALidarIsOnePieceThoughItsRingsAreFarApart)
{
  const Cloud ground = rings (6, 0.0);
  EXPECT_EQ (piecesOf (ground).pieces.size(), 1u);
}

TEST (PlanePieces, TheGroundIsOnePieceWhereNoiseExceedsTheSpacingAlongARing)
{
  const Cloud ground = rings (6, 3_cm);
  EXPECT_EQ (piecesOf (ground).pieces.size(), 1u);
}

TEST (PlanePieces, APatchBesideTheGroundOfALidarIsAPieceOfItsOwn)
{
  Cloud ground = rings (4, 2_cm);
  addSquare (10, 100.0, 0.0, ground);
  EXPECT_EQ (piecesOf (ground).pieces.size(), 2u);
}

TEST (PlanePieces, AFineTileBesideACoarseOneIsApartByItsOwnSpacing)
{
  Cloud cloud;
  addSquare (20, 0.0, 0.0, cloud);
  for (pcl::PointXYZ& point : cloud)
    point.getVector3fMap() *= 10.0f; // 10 cm apart, to x = 1.9 m
  // A gap of 0.5 m: 5 spacings of the coarse tile and 50 of the fine one.
  addSquare (20, 2.4, 0.0, cloud);
  EXPECT_EQ (piecesOf (cloud).pieces.size(), 2u);
}

TEST (PlanePieces, ComeByFallingSizeWithTheIndexOfTheirPlane)
{
  Cloud cloud;
  addSquare (10, 0, 0, cloud);   // 100 points of the first plane
  addSquare (20, 0.5, 0, cloud); // 400 points of the second plane
  addSquare (5, 1, 0, cloud);    // 25 more of it
  pcl::Indices all = upTo<pcl::Indices> (cloud.size());
  const pcl::Indices first (all.begin(), all.begin() + 100);
  const pcl::Indices second (all.begin() + 100, all.end());
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  const PlanePieces found = findPlanePieces (
      cloud, {planeOfPoints (cloud, first, up), planeOfPoints (cloud, second, up)});
  EXPECT_EQ (found.planes, std::vector<std::size_t> ({1, 0, 1}));
  ASSERT_EQ (found.pieces.size(), 3u);
  EXPECT_EQ (found.pieces[0].inliers,
             pcl::Indices (all.begin() + 100, all.begin() + 500));
  EXPECT_EQ (found.pieces[1].inliers, first);
  EXPECT_EQ (found.pieces[2].inliers, pcl::Indices (all.begin() + 500, all.end()));
}

TEST (PlanePieces, HaveTheEquationOfTheirPlaneAndMomentsOfTheirOwn)
{
  Cloud cloud;
  addSquare (10, 0, 0, cloud);
  addSquare (6, 1, 0, cloud);
  for (pcl::PointXYZ& point : cloud) // the second square is 1 mm higher
    point.z = point.x > 0.5f ? 0.001f : 0.0f;
  PlaneSegment plane = planeOf (cloud);
  plane.orientation = Orientation::Horizontal;
  const PlanePieces found = findPlanePieces (cloud, {plane});
  ASSERT_EQ (found.pieces.size(), 2u);
  const PlaneSegment& piece = found.pieces[1];
  EXPECT_EQ (piece.normal, plane.normal);
  EXPECT_EQ (piece.orientation, plane.orientation);
  EXPECT_NEAR (piece.plane().offset, plane.plane().offset, 1e-12);
  EXPECT_NEAR (piece.centroid.x(), 1.025, 1e-6) << "the middle of 1 m to 1.05 m";
  EXPECT_EQ (piece.moments.count, 36.0);
  const double height_of_plane = std::abs (plane.plane().offset);
  EXPECT_NEAR (piece.rms(), 0.001 - height_of_plane, 1e-6);
}

TEST (PlanePieces, APlaneWithoutAGapStaysAsItIs)
{
  Cloud cloud;
  addSquare (10, 0, 0, cloud);
  const PlaneSegment plane = planeOf (cloud);
  const PlanePieces found = findPlanePieces (cloud, {plane});
  ASSERT_EQ (found.pieces.size(), 1u);
  EXPECT_EQ (found.pieces[0].inliers, plane.inliers);
  EXPECT_EQ (found.pieces[0].centroid, plane.centroid);
  EXPECT_EQ (found.pieces[0].moments.products, plane.moments.products);
}

TEST (PlanePieces, FewPointsArePartOfTheNearestPiece)
{
  Cloud cloud;
  addSquare (10, 0, 0, cloud);
  addSquare (4, 0.3, 0, cloud); // 16 points; a piece needs min_points, 20
  addSquare (8, 0.8, 0, cloud);
  const PlanePieces found = piecesOf (cloud);
  ASSERT_EQ (found.pieces.size(), 2u);
  EXPECT_EQ (found.pieces[0].inliers, upTo<pcl::Indices> (100 + 16));
  PlanePiecesParameters parameters;
  parameters.min_points = 10;
  EXPECT_EQ (piecesOf (cloud, parameters).pieces.size(), 3u);
}

TEST (PlanePieces, EqualPointsCountButDoNotChangeTheSpacing)
{
  Cloud cloud = tiledFloor (10);
  const std::size_t size = cloud.size();
  constexpr int copies = 20;
  for (std::size_t i = 0; i < size; ++i)
    for (int copy = 0; copy < copies; ++copy)
      cloud.push_back (cloud[i]);
  const PlanePieces found = piecesOf (cloud);
  ASSERT_EQ (found.pieces.size(), tiles_of_floor);
  EXPECT_EQ (found.pieces[0].inliers.size(), 36u * (1u + copies));
}

TEST (PlanePieces, LeaveOutInliersWithoutCoordinates)
{
  Cloud cloud = tiledFloor (10);
  for (std::size_t i = 0; i < cloud.size(); i += 50)
    cloud[i].x = NAN;
  const PlaneSegment plane = planeOf (tiledFloor (10));
  const PlanePieces found = findPlanePieces (cloud, {plane});
  EXPECT_EQ (found.pieces.size(), tiles_of_floor);
  for (const PlaneSegment& piece : found.pieces)
    for (const pcl::index_t index : piece.inliers)
      EXPECT_NE (index % 50, 0);
}

TEST (PlanePieces, AreTheSameForAnyOrderOfThePoints)
{
  Cloud cloud = rings (3, 2_cm);
  addSquare (10, 100.0, 0.0, cloud);
  addSquare (3, 103.0, 0.0, cloud);
  const auto expected = positionsOf (piecesOf (cloud), cloud);
  ASSERT_EQ (expected.size(), 2u);
  // The inliers of this plane are all indices, so it is also a plane of the reversed
  // cloud.
  const PlaneSegment plane = planeOf (cloud);
  Cloud reversed = cloud;
  std::reverse (reversed.begin(), reversed.end());
  const PlanePieces found = findPlanePieces (reversed, {plane});
  ASSERT_EQ (positionsOf (found, reversed), expected);
  const PlanePieces in_order = findPlanePieces (cloud, {plane});
  ASSERT_EQ (in_order.pieces.size(), expected.size());
  EXPECT_EQ (found.pieces[0].moments.products, in_order.pieces[0].moments.products);
}

TEST (PlanePieces, AreTheSameForAnyNumberOfThreads)
{
  const Cloud cloud = tiledFloor (10);
  const PlaneSegment plane = planeOf (cloud);
  const PlanePieces by_one = findPlanePieces (cloud, {plane}, {}, one_thread);
  const PlanePieces by_four = findPlanePieces (cloud, {plane}, {}, 4);
  ASSERT_EQ (by_one.pieces.size(), tiles_of_floor);
  ASSERT_EQ (by_one.pieces.size(), by_four.pieces.size());
  for (std::size_t i = 0; i < by_one.pieces.size(); ++i)
    EXPECT_EQ (by_one.pieces[i].inliers, by_four.pieces[i].inliers);
}

TEST (PlanePieces, PointsOnALineAreDividedByAGap)
{
  // A line of points 1 cm apart with a gap of 1 m in its middle.
  Cloud cloud;
  for (int i = 0; i < 100; ++i)
    cloud.push_back (toPoint ({spacing * i + (i < 50 ? 0.0 : 1.0), 0.0, 0.0}));
  EXPECT_EQ (piecesOf (cloud).pieces.size(), 2u);
}

TEST (PlanePieces, OfAPlaneWithoutInliersOrWithOneIsThePlane)
{
  Cloud cloud;
  addSquare (10, 0, 0, cloud);
  PlaneSegment plane = planeOf (cloud);
  for (const std::size_t size : {1u, 0u}) {
    plane.inliers.resize (size);
    EXPECT_EQ (findPlanePieces (cloud, {plane}).pieces.size(), 1u);
  }
}

TEST (PlanePieces, OfATooSmallCloudOrWithAnInvalidGapAreRefused)
{
  Cloud cloud;
  addSquare (10, 0, 0, cloud);
  const PlaneSegment plane = planeOf (cloud);
  cloud.resize (99);
  EXPECT_THROW (findPlanePieces (cloud, {plane}), std::invalid_argument);
  for (const double gap : {0.5, -1.0, HUGE_VAL, std::nan ("")}) {
    PlanePiecesParameters parameters;
    parameters.max_gap = gap;
    EXPECT_THROW (findPlanePieces (cloud, {}, parameters), std::invalid_argument);
  }
}
