// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "buildings/intervals.h"

using namespace pcl_ops::internal::buildings;

namespace {

/** \brief Interval::from and Interval::to of several intervals. */
using IntervalEnds = std::vector<std::pair<double, double>>;

IntervalEnds
endsOfIntervals (const Intervals& intervals)
{
  IntervalEnds ends;
  for (const Interval& interval : intervals)
    ends.emplace_back (interval.from, interval.to);
  return ends;
}

} // namespace

TEST (Intervals, OfPositionsEndAtGapsAboveTheLargestAllowed)
{
  constexpr double max_gap = 2.0;
  EXPECT_EQ (endsOfIntervals (intervalsOf ({7, 0, 1, 2, 5, 6}, max_gap)),
             (IntervalEnds{{0, 2}, {5, 7}}));
  EXPECT_EQ (endsOfIntervals (intervalsOf ({0, 2, 4}, max_gap)),
             (IntervalEnds{{0, 4}}));
  EXPECT_TRUE (intervalsOf ({}, max_gap).empty());
}

TEST (Intervals, OfTwoListsAreJoinedWhereTheyOverlapOrNearlyTouch)
{
  constexpr double small_gap = 0.5;
  constexpr double gap_of_one = 1.0;
  EXPECT_EQ (endsOfIntervals (unionOf ({{0, 5}, {8, 9}}, {{1, 2}, {6, 7}}, small_gap)),
             (IntervalEnds{{0, 5}, {6, 7}, {8, 9}}));
  EXPECT_EQ (endsOfIntervals (unionOf ({{0, 5}, {8, 9}}, {{4, 7}}, gap_of_one)),
             (IntervalEnds{{0, 9}}));
}

TEST (Intervals, WithoutOthersAreTheRemainingParts)
{
  const Intervals whole{{0, 10}, {20, 30}};
  EXPECT_EQ (endsOfIntervals (without (whole, {{2, 3}, {5, 6}, {8, 22}})),
             (IntervalEnds{{0, 2}, {3, 5}, {6, 8}, {22, 30}}));
  EXPECT_EQ (endsOfIntervals (without (whole, {{-1, 40}})), IntervalEnds());
  EXPECT_EQ (endsOfIntervals (without (whole, {{10, 20}})),
             (IntervalEnds{{0, 10}, {20, 30}}));
}

TEST (CoveredLength, IsThatOfTheIntervalsWithinAnotherOne)
{
  EXPECT_EQ (coveredLength ({2, 8}, {{0, 3}, {4, 5}, {7, 9}, {10, 11}}), 3.0);
  EXPECT_EQ (coveredLength ({2, 8}, {{0, 2}, {8, 9}}), 0.0);
}
