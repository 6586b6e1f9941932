// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "base/stage_clock.h"

using pcl_ops::internal::StageClock;

namespace {

/** \brief For two milliseconds. */
void
work ()
{
  for (const StageClock clock; clock.total() < 2.0;)
    continue;
}

} // namespace

TEST (StageClock, AddsTheTimeOfEachLap)
{
  StageClock clock;
  double first = 0.0, second = 100.0;
  work();
  clock.lap (first);
  work();
  clock.lap (second);
  EXPECT_GE (first, 1.0);
  EXPECT_GE (second, 101.0) << "added to what was there";
}

TEST (StageClock, HasTheLapsForItsTotal)
{
  StageClock clock;
  double laps = 0.0;
  for (int i = 0; i < 3; ++i) {
    work();
    clock.lap (laps);
  }
  EXPECT_LE (laps, clock.total());
  EXPECT_GE (laps, 0.5 * clock.total());
}
