// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "buildings/stories.h"

using namespace pcl_ops::internal::buildings;

namespace {

// LevelPlane has a height [m], an area [m^2] and two flags. The first one, faces_down,
// says from which side the plane was seen; the second one is is_below_sensor.
const bool from_below = true;
const bool from_above = false;
const bool below_sensor = true;

constexpr double no_ceiling = -1.0;

/** \brief The heights of the floor and of the ceiling of each story [m]. */
using StoryHeights = std::vector<std::pair<double, double>>;

/** \brief The stories of level planes; their ceiling is no_ceiling where none was seen.
 * \param[in] lowest height of the lowest plane of the scene, of any direction [m] */
StoryHeights
heightsOfStories (const std::vector<LevelPlane>& planes, double lowest = 0.0)
{
  StoryHeights heights;
  for (const Story& story : storiesOf (levelsOf (planes), lowest))
    heights.emplace_back (story.floor, story.ceiling.value_or (no_ceiling));
  return heights;
}

} // namespace

TEST (Levels, ArePlanesWithin15CentimetersAndHaveTheirMeanHeightByArea)
{
  const std::vector<Level> levels = levelsOf (
      {{2.5, 12.0, from_below}, {0.1, 1.0, from_above}, {0.0, 3.0, from_above}});
  ASSERT_EQ (levels.size(), 2u);
  EXPECT_DOUBLE_EQ (levels[0].height, 0.025);
  EXPECT_DOUBLE_EQ (levels[0].area, 4.0);
  EXPECT_DOUBLE_EQ (levels[1].height, 2.5);
  EXPECT_EQ (levelsOf ({{0.0, 1.0, from_above}, {0.14, 1.0, from_above}}).size(), 1u);
  EXPECT_EQ (levelsOf ({{0.0, 1.0, from_above}, {0.16, 1.0, from_above}}).size(), 2u);
}

TEST (Levels, HaveTheFlagsOfMostOfTheirArea)
{
  EXPECT_TRUE (
      levelsOf ({{0.0, 0.2, from_above}, {0.1, 0.3, from_below}}).front().faces_down);
  EXPECT_FALSE (
      levelsOf ({{0.0, 0.3, from_above}, {0.1, 0.2, from_below}}).front().faces_down);
  EXPECT_TRUE (levelsOf ({{0.0, 0.2, from_above}, {0.1, 0.3, from_above, below_sensor}})
                   .front()
                   .is_below_sensor);
  EXPECT_FALSE (
      levelsOf ({{0.0, 0.3, from_above}, {0.1, 0.2, from_above, below_sensor}})
          .front()
          .is_below_sensor);
}

TEST (Stories, HaveAFloorAndACeiling)
{
  EXPECT_EQ (heightsOfStories ({{0.0, 12.0, from_above}, {2.5, 12.0, from_below}}),
             (StoryHeights{{0.0, 2.5}}));
  EXPECT_EQ (heightsOfStories ({{0.0, 12.0, from_above},
                                {2.5, 12.0, from_below},
                                {2.75, 12.0, from_above},
                                {5.25, 12.0, from_below}}),
             (StoryHeights{{0.0, 2.5}, {2.75, 5.25}}));
}

TEST (Stories, BeginAtTheLowestPlaneWhereNoFloorWasSeen)
{
  EXPECT_EQ (heightsOfStories ({{2.5, 12.0, from_below}}, 0.25),
             (StoryHeights{{0.25, 2.5}}));
  EXPECT_EQ (heightsOfStories ({}, 0.25), (StoryHeights{{0.25, no_ceiling}}));
}

TEST (Stories, HaveNoFloorAtATableTop)
{
  // The table top has less than a fifth of the area of the ceiling.
  EXPECT_EQ (heightsOfStories ({{0.75, 2.0, from_above}, {2.5, 12.0, from_below}}),
             (StoryHeights{{0.0, 2.5}}));
}

TEST (StoryAt, IsTheHighestWhoseFloorIsAtMost15CentimetersAbove)
{
  const std::vector<Story> stories = storiesOf (
      levelsOf (
          {{0.0, 12.0, from_above}, {2.5, 12.0, from_below}, {2.75, 12.0, from_above}}),
      0.0);
  ASSERT_EQ (stories.size(), 2u);
  EXPECT_EQ (storyAt (stories, -1.0).floor, 0.0);
  EXPECT_EQ (storyAt (stories, 2.5).floor, 0.0);
  EXPECT_EQ (storyAt (stories, 2.65).floor, 2.75) << "within 15 cm of its floor";
  EXPECT_EQ (storyAt (stories, 9.0).floor, 2.75);
}
