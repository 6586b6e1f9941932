// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <tiles/ranks.h>
#include <tiles/tile_grid.h>

#include <set>
#include <tuple>

using namespace pcl_ops::apps;

namespace {

/** \brief Cells of half a meter, tiles of 24 x 24 columns of cells, 12 m x 12 m, and
 * points near zero. */
const TileGrid grid{0.5, 24, {0, 0, 0}};

std::set<TileKey>
tilesAround (double x, double y)
{
  std::set<TileKey> tiles;
  grid.forTilesAround (grid.cellOf ({x, y, 0.0}),
                       [&tiles] (const TileKey& tile) { tiles.insert (tile); });
  return tiles;
}

TEST (TileGrid, PutsABorderIntoTheTileThatBeginsThere)
{
  const double east = 500'004.0, north = 5'400'000.0; // borders of tiles [m]
  const std::tuple<double, double, TileKey> rows[] = {
      {11.999, 0.0, {0, 0}},
      {12.0, 0.0, {1, 0}},
      {0.0, -0.001, {0, -1}},
      {-12.0, -12.001, {-1, -2}},
      {east, north, {41'667, 450'000}},
      {east - 0.001, north - 0.001, {41'666, 449'999}},
      {-east, -north, {-41'667, -450'000}}};
  for (const auto& [x, y, tile] : rows)
    EXPECT_EQ (grid.tileOf (grid.cellOf ({x, y, 0.0})), tile) << x << " " << y;
}

TEST (TileGrid, ShowsAPointToOtherTilesIfItIsInTheirHalo)
{
  // A halo is 12 cells wide, 6 m: half a tile. Both points are in the tile (0, 0).
  EXPECT_EQ (tilesAround (5.9, 5.9), (std::set<TileKey>{{-1, 0}, {0, -1}, {-1, -1}}));
  EXPECT_EQ (tilesAround (6.1, 5.9), (std::set<TileKey>{{1, 0}, {0, -1}, {1, -1}}));
  const TileGrid wide{0.5, 240, {0, 0, 0}};
  const CellKey middle{120, 120, 0}, near_border{120, 11, 0}; // of the tile (0, 0)
  int others = 0;
  wide.forTilesAround (middle, [&others] (const TileKey&) { ++others; });
  EXPECT_EQ (others, 0);
  EXPECT_TRUE (wide.isSeenOnlyBy ({0, 0}, middle));
  EXPECT_FALSE (wide.isSeenOnlyBy ({0, 0}, near_border)) << "tile (0, -1) sees it, too";
  EXPECT_FALSE (wide.isSeenOnlyBy ({0, 1}, middle)) << "it is in another tile";
}

TEST (TileGrid, PutsZeroOfATilesFrameAsNearToThePointsAsTheTileAllows)
{
  const CellKey near_points{100, -52, 8};
  const TileGrid grid_near_points{0.5, 24, near_points};
  EXPECT_EQ (grid_near_points.frameOf ({4, -3}), near_points) << "it is in this tile";
  EXPECT_EQ (grid_near_points.frameOf ({6, 0}), (CellKey{144, 0, 8}))
      << "the tile has the cells 144 to 168 and 0 to 24";
  EXPECT_EQ (grid_near_points.frameOf ({0, -9}), (CellKey{24, -192, 8}))
      << "the tile has the cells 0 to 24 and -216 to -192";
}

using Positions = std::vector<std::size_t>;

TEST (Ranks, ShareTheWorkEvenlyTheLargestPartsFirst)
{
  const std::vector<std::uint64_t> work_of_part = {1, 6, 2, 3, 4};
  EXPECT_EQ (shareOf (0, 2, work_of_part), (Positions{1, 2})) << "work of 6 and 2";
  EXPECT_EQ (shareOf (1, 2, work_of_part), (Positions{4, 3, 0})) << "of 4, 3 and 1";
  EXPECT_EQ (shareOf (0, 1, work_of_part), (Positions{1, 4, 3, 2, 0}));
  EXPECT_EQ (shareOf (7, 8, work_of_part), Positions{}) << "more ranks than work";
}

} // namespace
