// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "buildings/inside_cells.h"

using namespace pcl_ops::internal::buildings;

namespace {

using CellsInside = std::vector<char>;

/** \brief A cell of 4 m^2 of which a share is covered. */
CellEvidence
coveredBy (double share)
{
  return {4.0 * share, 4.0 * (1.0 - share), 0.0};
}

} // namespace

TEST (CellsInside, AreThoseMostlyCoveredWhereWallsAreBetween)
{
  EXPECT_EQ (cellsInside ({coveredBy (0.6), coveredBy (0.4)}, {{0, 1, 0.0}}),
             CellsInside ({1, 0}));
}

TEST (CellsInside, GoOnOverAStripThatWasNotSeenUpToAWall)
{
  // 4 m of a border without a wall, to a strip of 0.3 m and to one of 0.6 m.
  const CellEvidence room{20.0, 0.0, 0.0};
  EXPECT_EQ (cellsInside ({room, {0.0, 1.2, 0.0}}, {{0, 1, 4.0}}),
             CellsInside ({1, 1}));
  EXPECT_EQ (cellsInside ({room, {0.0, 2.4, 0.0}}, {{0, 1, 4.0}}),
             CellsInside ({1, 0}));
}

TEST (CellsInside, DoNotGoOnToWhereNothingIs)
{
  const CellEvidence room{20.0, 0.0, 0.0};
  EXPECT_EQ (cellsInside ({room, {0.0, 1.2, 4.0}}, {{0, 1, 4.0}}),
             CellsInside ({1, 0}));
}

TEST (CellsInside, CrossSeveralStripsToAWall)
{
  // Strips of 0.1 m, one behind the other: each alone would only move the border.
  const CellEvidence room{20.0, 0.0, 0.0};
  const CellEvidence strip{0.0, 0.4, 0.0};
  EXPECT_EQ (cellsInside ({room, strip, strip, strip},
                          {{0, 1, 4.0}, {1, 2, 4.0}, {2, 3, 4.0}}),
             CellsInside ({1, 1, 1, 1}));
}

TEST (CellsInside, OfNoneAreNone) { EXPECT_TRUE (cellsInside ({}, {}).empty()); }
