// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "stories.h"

#include "constants.h"

#include <algorithm>
#include <cstddef>
#include <tuple>

namespace pcl_ops::internal::buildings {
namespace {

/** \brief Returns the levels that are large enough to make stories. */
std::vector<Level>
largeLevels (const std::vector<Level>& levels)
{
  double largest = 0.0;
  for (const Level& level : levels)
    largest = std::max (largest, level.area);
  std::vector<Level> large;
  for (const Level& level : levels)
    if (level.area >= std::max (constants.min_level_area,
                                constants.min_share_of_largest_level * largest))
      large.push_back (level);
  return large;
}

/** \brief Adds a level whose normal does not point down: as the ceiling of the last
 * story or as the floor of a new one. It may be a ceiling, too: if the sensor is
 * unknown, all normals point up, and a roof seen from outside ends the last story. A
 * highest level too small for a ceiling is ignored if the last story has no ceiling.
 * \param[in] next the next large level above; nullptr for the highest level */
void
addUpperLevel (const Level& level, const Level* next, std::vector<Story>& stories)
{
  Story& story = stories.back();
  const bool is_highest = next == nullptr;
  // A floor follows closely above: both are the two sides of one deck.
  const bool is_underside_of_deck =
      !is_highest && !next->faces_down &&
      next->height - level.height <= constants.max_deck_thickness;
  const bool may_be_ceiling =
      !level.is_below_sensor && (is_highest || is_underside_of_deck);
  if (is_highest && !story.ceiling &&
      level.area < constants.min_ceiling_share_of_floor * story.area)
    return;
  if (may_be_ceiling && !story.ceiling)
    story.ceiling = level.height;
  else
    stories.push_back ({level.height, {}, level.area});
}

} // namespace

std::vector<Level>
levelsOf (std::vector<LevelPlane> planes)
{
  std::sort (
      planes.begin(), planes.end(), [] (const LevelPlane& a, const LevelPlane& b) {
        return std::tie (a.height, a.area, a.faces_down) <
               std::tie (b.height, b.area, b.faces_down);
      });
  std::vector<Level> levels;
  for (std::size_t first = 0, next = 0; first < planes.size(); first = next) {
    double area = 0.0;
    double area_times_height = 0.0;
    double area_from_below = 0.0;
    double area_below_sensor = 0.0;
    while (next < planes.size() &&
           planes[next].height - planes[first].height <= constants.same_level) {
      area += planes[next].area;
      area_times_height += planes[next].area * planes[next].height;
      area_from_below += planes[next].faces_down ? planes[next].area : 0.0;
      area_below_sensor += planes[next].is_below_sensor ? planes[next].area : 0.0;
      ++next;
    }
    const double height = area > 0.0 ? area_times_height / area : planes[first].height;
    levels.push_back (
        {height, area, area_from_below > 0.5 * area, area_below_sensor > 0.5 * area});
  }
  return levels;
}

std::vector<Story>
storiesOf (const std::vector<Level>& levels, double lowest)
{
  const std::vector<Level> large = largeLevels (levels);
  std::vector<Story> stories = {{lowest}};
  for (std::size_t i = 0; i < large.size(); ++i) {
    const Level& level = large[i];
    Story& story = stories.back();
    const double rise = level.height - story.floor;
    // So large a level is the ground even if the foot of a wall or a ditch is lower.
    const bool is_ground = level.area >= constants.min_ground_area;
    const double max_rise = is_ground ? constants.headroom : constants.max_step;
    const bool may_be_first_floor =
        rise < max_rise || (is_ground && level.is_below_sensor);
    if (i == 0 && !level.faces_down && may_be_first_floor)
      story = {level.height, {}, level.area};
    else if (rise < constants.headroom)
      continue;
    else if (level.faces_down) // a higher ceiling replaces a lower one
      story.ceiling = level.height;
    else
      addUpperLevel (level, i + 1 < large.size() ? &large[i + 1] : nullptr, stories);
  }
  return stories;
}

const Story&
storyAt (const std::vector<Story>& stories, double height)
{
  const Story* highest_below = &stories.front();
  for (const Story& story : stories)
    if (story.floor <= height + constants.same_level)
      highest_below = &story;
  return *highest_below;
}

} // namespace pcl_ops::internal::buildings
