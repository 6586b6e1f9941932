// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <tiles/tile_grid.h>

#include <set>
#include <vector>

namespace {

using namespace pcl_ops::apps;

/** \brief Cells of half a metre, tiles of 24 of them, 12 m. */
const TileGrid grid (0.5, 24, {0, 0, 0});

TileKey
tileAt (double x, double y)
{
  return grid.tileOf (grid.cellOf ({x, y, 0.0}));
}

std::set<TileKey>
tilesAround (double x, double y)
{
  std::set<TileKey> tiles;
  grid.forTilesAround (grid.cellOf ({x, y, 0.0}),
                       [&tiles] (const TileKey& tile) { tiles.insert (tile); });
  return tiles;
}

} // namespace

TEST (TileGrid, HasABorderInTheTileThatBeginsThere)
{
  EXPECT_EQ (tileAt (11.999, 0.0), (TileKey{0, 0}));
  EXPECT_EQ (tileAt (12.0, 0.0), (TileKey{1, 0}));
  EXPECT_EQ (tileAt (0.0, -0.001), (TileKey{0, -1}));
  EXPECT_EQ (tileAt (-12.0, -12.001), (TileKey{-1, -2}));
}

TEST (TileGrid, TellsTilesApartWhereCoordinatesAreLarge)
{
  const double east = 500'004.0, north = 5'400'000.0; // whole tiles from zero
  EXPECT_EQ (tileAt (east, north), (TileKey{41'667, 450'000}));
  EXPECT_EQ (tileAt (east - 0.001, north - 0.001), (TileKey{41'666, 449'999}));
  EXPECT_EQ (tileAt (-east, -north), (TileKey{-41'667, -450'000}));
}

TEST (TileGrid, ShowsAPointToTilesWhoseHaloItIsIn)
{
  // 12 cells are 6 m: half a tile.
  EXPECT_EQ (tilesAround (5.9, 5.9), (std::set<TileKey>{{-1, 0}, {0, -1}, {-1, -1}}));
  EXPECT_EQ (tilesAround (6.1, 5.9), (std::set<TileKey>{{1, 0}, {0, -1}, {1, -1}}));
  const TileGrid wide (0.5, 240, {0, 0, 0});
  int others = 0;
  wide.forTilesAround ({120, 120, 0}, [&others] (const TileKey&) { ++others; });
  EXPECT_EQ (others, 0) << "far from all borders";
  EXPECT_TRUE (wide.isInside ({0, 0}, {120, 120, 0}));
  EXPECT_FALSE (wide.isInside ({0, 0}, {120, 11, 0}));
  EXPECT_FALSE (wide.isInside ({0, 1}, {120, 120, 0}));
}

TEST (TileGrid, HasFramesInWholeCoarsestVoxelsNearThePlaceOfAllTiles)
{
  const CellKey place{100, -52, 8};
  const TileGrid near_place (0.5, 24, place);
  EXPECT_EQ (near_place.frameOf ({4, -3}), place) << "the place is in this tile";
  EXPECT_EQ (near_place.frameOf ({6, 0}), (CellKey{144, 0, 8}));
  EXPECT_EQ (near_place.frameOf ({0, -9}), (CellKey{24, -192, 8}));
}

TEST (TileGrid, LeavesOutWhatHasNoCell)
{
  EXPECT_TRUE (grid.reaches ({5e6, -5e6, 1e4}));
  EXPECT_FALSE (grid.reaches ({std::nan (""), 0, 0}));
  EXPECT_FALSE (grid.reaches ({0, 1e300, 0}));
}
