// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "buildings/plan_walls.h"

using namespace pcl_ops;
using namespace pcl_ops::internal::buildings;

namespace {

/** \brief A face from the origin of its line on, whose points reach over these
 * intervals of the line, also at the cut. */
WallFace
faceOn (const PlanLine& line, const Intervals& intervals)
{
  WallFace face;
  face.line = line;
  face.seen = face.at_cut = intervals;
  return face;
}

} // namespace

TEST (WallSpans, EndWhereAnotherWallMeetsThemThoughNothingIsLeftToMove)
{
  // Between both walls on the x axis are 2 m, at whose begin another wall stands.
  const WallFace two_walls = faceOn ({{0, 0}, {1, 0}}, {{0, 3}, {5, 8}});
  const WallFace across = faceOn ({{3, 0}, {0, 1}}, {{0, 3}});
  const std::vector<WallSpan> spans = spansOf ({two_walls, across}, {});
  ASSERT_EQ (spans.size(), 3u);
  EXPECT_EQ (spans[0].whole.to, 3.0);
  EXPECT_EQ (spans[1].whole.from, 5.0);
}
