// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges/intervals.h"
#include "scene.h"

using pcl_ops::internal::inCommon;
using pcl_ops::internal::Interval;
using pcl_ops::internal::Intervals;
using pcl_ops::internal::intervalsOf;

namespace {

void
expectAre (const Intervals& intervals, const Intervals& expected)
{
  ASSERT_EQ (intervals.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ (intervals[i].from, expected[i].from);
    EXPECT_EQ (intervals[i].to, expected[i].to);
  }
}

} // namespace

TEST (Intervals, EndAtGapsThatAreTooLong)
{
  expectAre (intervalsOf ({5, 1, 2, 3, 9, 6}, 1.5), {{1, 3}, {5, 6}, {9, 9}});
  expectAre (intervalsOf ({5, 1, 2, 3, 9, 6}, 2), {{1, 6}, {9, 9}});
  expectAre (intervalsOf ({}, 2), {});
}

TEST (Intervals, OfManyPlacesAreThoseOfAFew)
{
  // From -1 to 1 and from 1.5 to 2, thousands of times closer than the gap.
  std::vector<double> places;
  for (int i = -1000; i <= 2000; ++i)
    if (i <= 1000 || i >= 1500)
      places.push_back (0.001 * i);
  std::reverse (places.begin(), places.end());
  expectAre (intervalsOf (places, 0.4), {{-1, 1}, {1.5, 2}});
  expectAre (intervalsOf (places, 0.6), {{-1, 2}});
}

TEST (Intervals, WithoutAGapAreThePlaces)
{
  expectAre (intervalsOf ({3, 1, 1, 2}, 0.0), {{1, 1}, {2, 2}, {3, 3}});
  expectAre (intervalsOf ({1, 1, 1}, 0.0), {{1, 1}});
}

TEST (Intervals, InCommonAreWhereBothAre)
{
  const Intervals first = {{0, 2}, {3, 5}, {7, 8}};
  const Intervals second = {{1, 4}, {4.5, 6}};
  expectAre (inCommon (first, second, 0.1), {{1, 2}, {3, 4}, {4.5, 5}});
  expectAre (inCommon (second, first, 1.0), {{1, 2}, {3, 4}});
  expectAre (inCommon (first, {}, 0.0), {});
}
