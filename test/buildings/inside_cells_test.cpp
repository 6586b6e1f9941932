// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "buildings/inside_cells.h"

using namespace pcl_ops::internal::buildings;

namespace {

using CellsInside = std::vector<char>;

// CellEvidence is the covered and the uncovered area [m^2], and the length of the
// border on the rim of the plan [m].

/** \brief A cell of 20 m^2 that is all covered. */
const CellEvidence covered_room{20.0, 0.0, 0.0};

/** \brief A cell 4 m long of which nothing was seen.
 * \param[in] rim length of its border on the rim of the plan [m] */
CellEvidence
unseenStrip (double width, double rim = 0.0)
{
  return {0.0, 4.0 * width, rim};
}

/** \brief The common side of two cells, by their indices: 4 m without a wall. */
CellBorder
openBorder (std::size_t first, std::size_t second)
{
  return {first, second, 4.0};
}

/** \brief A cell of 4 m^2 of which a share is covered. */
CellEvidence
coveredBy (double share)
{
  return {4.0 * share, 4.0 * (1.0 - share), 0.0};
}

} // namespace

TEST (CellsInside, AreThoseMostlyCoveredWhereWallsAreBetween)
{
  const CellBorder wall = {0, 1, 0.0};
  EXPECT_EQ (cellsInside ({coveredBy (0.6), coveredBy (0.4)}, {wall}),
             CellsInside ({1, 0}));
}

TEST (CellsInside, GoOnOverAStripThatWasNotSeenUpToAWall)
{
  // The uncovered area of a narrow strip costs less than the open border, that of a
  // wide strip more.
  EXPECT_EQ (cellsInside ({covered_room, unseenStrip (0.3)}, {openBorder (0, 1)}),
             CellsInside ({1, 1}));
  EXPECT_EQ (cellsInside ({covered_room, unseenStrip (0.6)}, {openBorder (0, 1)}),
             CellsInside ({1, 0}));
}

TEST (CellsInside, DoNotGoOnToTheRimOfThePlan)
{
  constexpr double rim = 4.0; // all of one long side
  EXPECT_EQ (cellsInside ({covered_room, unseenStrip (0.3, rim)}, {openBorder (0, 1)}),
             CellsInside ({1, 0}));
}

TEST (CellsInside, GoOnOverSeveralStripsUpToAWall)
{
  // Strips of 0.1 m, one behind the other. If the room ended after one of them, its
  // border would be as long as before.
  const CellEvidence strip = unseenStrip (0.1);
  EXPECT_EQ (cellsInside ({covered_room, strip, strip, strip},
                          {openBorder (0, 1), openBorder (1, 2), openBorder (2, 3)}),
             CellsInside ({1, 1, 1, 1}));
}

TEST (CellsInside, OfNoneAreNone) { EXPECT_TRUE (cellsInside ({}, {}).empty()); }
