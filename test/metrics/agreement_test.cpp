// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <metrics/partitions.h>

#include <stdexcept>

namespace {

using pcl_ops::evaluation::agreementOf;
using pcl_ops::evaluation::PlaneLabels;

struct Case {
  const char* name;
  PlaneLabels first, second;
  double agreement;
};

const Case cases[] = {
    {"the same planes under other numbers", {1, 1, 2, 2, 0}, {7, 7, 3, 3, 0}, 1.0},
    {"no planes", {0, 0}, {0, 0}, 1.0},
    {"no points", {}, {}, 1.0},
    {"planes in one alone", {1, 1, 0}, {0, 0, 0}, 0.0},
    {"planes of other points", {1, 1, 0, 0}, {0, 0, 1, 1}, 0.0},
    {"points on no plane in both do not count",
     {1, 1, 1, 0, 0},
     {1, 1, 0, 0, 0},
     2. / 3},
    {"of a plane in two the larger part", {1, 1, 1, 1, 1}, {1, 1, 1, 2, 2}, 3. / 5},
    {"of two planes in one the larger", {1, 1, 1, 2, 2}, {4, 4, 4, 4, 4}, 3. / 5},
    // Plane 1 of the first labeling shares three points with plane 1 of the second and
    // is matched with it. So plane 2 of the first can only be matched with plane 2 of
    // the second, with which it shares none.
    {"the largest overlap first", {1, 1, 1, 1, 1, 2, 2}, {1, 1, 1, 2, 2, 1, 1}, 3. / 7},
    {"then the next one", {1, 1, 1, 1, 1, 2, 2}, {1, 1, 1, 2, 2, 2, 1}, 4. / 7},
};

TEST (Agreement, IsTheShareOfPointsOnPlanesMatchedOneToOne)
{
  for (const Case& one : cases)
    EXPECT_DOUBLE_EQ (agreementOf (one.first, one.second), one.agreement) << one.name;
}

TEST (Agreement, IsTheSameInBothDirections)
{
  for (const Case& one : cases)
    EXPECT_DOUBLE_EQ (agreementOf (one.second, one.first), one.agreement) << one.name;
}

TEST (Agreement, IsThatOfTheSamePoints)
{
  EXPECT_THROW (agreementOf ({1, 1}, {1}), std::invalid_argument);
}

} // namespace
