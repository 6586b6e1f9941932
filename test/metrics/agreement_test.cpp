// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <metrics/partitions.h>

#include <stdexcept>

namespace {

using pcl_ops::evaluation::agreementOf;
using pcl_ops::evaluation::PlaneLabels;

/** \brief Two labelings of the same points, in which 0 is no plane, and their
 * agreement. */
struct Case {
  const char* name;
  PlaneLabels first, second;
  double agreement;
};

const Case cases[] = {
    {"the same planes under other numbers", {1, 1, 2, 2, 0}, {7, 7, 3, 3, 0}, 1.0},
    {"no planes", {0, 0}, {0, 0}, 1.0},
    {"no points", {}, {}, 1.0},
    {"planes in one labeling alone", {1, 1, 0}, {0, 0, 0}, 0.0},
    {"planes of other points", {1, 1, 0, 0}, {0, 0, 1, 1}, 0.0},
    {"points on no plane in both do not count",
     {1, 1, 1, 0, 0},
     {1, 1, 0, 0, 0},
     2. / 3},
    {"of a plane that is divided the larger part counts",
     {1, 1, 1, 1, 1},
     {1, 1, 1, 2, 2},
     3. / 5},
    {"of two planes that are merged the larger one counts",
     {1, 1, 1, 2, 2},
     {4, 4, 4, 4, 4},
     3. / 5},
    // Plane 1 of the first labeling shares three points with plane 1 of the second and
    // is matched with it. So plane 2 of the first can only be matched with plane 2 of
    // the second, with which it shares none.
    {"the planes with the largest overlap are matched first",
     {1, 1, 1, 1, 1, 2, 2},
     {1, 1, 1, 2, 2, 1, 1},
     3. / 7},
    {"then those with the largest overlap of the others",
     {1, 1, 1, 1, 1, 2, 2},
     {1, 1, 1, 2, 2, 2, 1},
     4. / 7},
};

TEST (Agreement, IsTheShareOfPointsOnPlanesMatchedOneToOne)
{
  for (const Case& row : cases)
    EXPECT_DOUBLE_EQ (agreementOf (row.first, row.second), row.agreement) << row.name;
}

TEST (Agreement, IsTheSameInBothDirections)
{
  for (const Case& row : cases)
    EXPECT_DOUBLE_EQ (agreementOf (row.second, row.first), row.agreement) << row.name;
}

TEST (Agreement, RefusesLabelingsOfDifferentNumbersOfPoints)
{
  EXPECT_THROW (agreementOf ({1, 1}, {1}), std::invalid_argument);
}

} // namespace
