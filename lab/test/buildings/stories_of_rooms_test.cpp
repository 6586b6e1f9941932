// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Which rooms of simulated stories, plain and hard ones, floor plans have. To see the
// output of this test: ctest --test-dir build -R lab_buildings_test -V
#include <gtest/gtest.h>

#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/detect_planes.h>
#include <simulation/story.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <set>
#include <string>
#include <utility>

using namespace pcl_ops;
using namespace pcl_ops::simulation;

namespace {

FloorPlan
planOf (const LabeledCloud& points)
{
  const CloudView cloud (points);
  const std::vector<PlaneSegment> planes =
      detectPlanes (cloud, OrientedPointSamplingParameters());
  std::vector<PlaneExtent> extents;
  for (const PlaneSegment& plane : planes)
    extents.push_back (planeExtent (cloud, plane));
  const Vector3d up = Vector3d::UnitZ();
  return findFloorPlan (cloud, planes, planeKinds (planes, extents, up), up);
}

/** \brief Numbers of rooms, and of doors between two rooms that were found. */
struct Tally {
  double true_rooms = 0.0, found_rooms = 0.0, exact_rooms = 0.0;
  double drawn_rooms = 0.0, invented_rooms = 0.0; // of plans
  double true_doors = 0.0, found_doors = 0.0, invented_doors = 0.0;
};

/** \brief Compares the doors between rooms.
 * \param[in] truth for each room of the plan the index of its true room; nullopt: an
 * invented room */
void
addDoors (const Story& story,
          const FloorPlan& plan,
          const std::vector<std::optional<std::size_t>>& truth,
          Tally& tally)
{
  std::set<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t i = 0; i < plan.rooms.size(); ++i)
    for (const std::size_t j : plan.roomsBehindDoorsOf (i))
      if (truth[i] && truth[j])
        found.insert (std::minmax (*truth[i], *truth[j]));
  const auto isFound = [&] (std::size_t room) {
    return std::find (truth.begin(), truth.end(), room) != truth.end();
  };
  for (const auto& [one, other] : story.doors)
    if (isFound (one) && isFound (other)) {
      tally.true_doors += 1.0;
      tally.found_doors += static_cast<double> (found.count ({one, other}));
    }
  for (const auto& door : found)
    tally.invented_doors += story.doors.count (door) == 0 ? 1.0 : 0.0;
}

/** \brief Counts rooms and doors. A true room is found if a room of the plan has its
 * middle in it and 4/5 to 5/4 of its area; it is exact if the areas agree within 3 %.
 * Other rooms of the plan are invented. */
void
addRooms (const Story& story, const FloorPlan& plan, Tally& tally)
{
  constexpr double factor_of_found = 1.25; // largest factor between the areas
  constexpr double factor_of_exact = 1.03;
  const Isometry3d to_rooms = turnZ (-story.yaw);
  std::vector<char> is_found (story.rooms.size(), 0);
  std::vector<std::optional<std::size_t>> truth;
  for (const PlanRoom& drawn : plan.rooms) {
    truth.emplace_back();
    const Vector3d middle =
        to_rooms * Vector3d (drawn.middle.x(), drawn.middle.y(), 0.0);
    for (std::size_t i = 0; i < story.rooms.size(); ++i) {
      const double area = story.rooms[i].volume(); // of a 2-d box
      const double factor = std::max (drawn.area / area, area / drawn.area);
      if (is_found[i] || factor > factor_of_found ||
          !story.rooms[i].contains (middle.head<2>().eval()))
        continue;
      is_found[i] = 1;
      truth.back() = i;
      tally.found_rooms += 1.0;
      tally.exact_rooms += factor < factor_of_exact ? 1.0 : 0.0;
    }
    tally.invented_rooms += truth.back() ? 0.0 : 1.0;
  }
  tally.true_rooms += static_cast<double> (story.rooms.size());
  tally.drawn_rooms += static_cast<double> (plan.rooms.size());
  addDoors (story, plan, truth, tally);
}

/** \brief Counts in simulated stories, and prints the numbers. */
Tally
tallyOf (const std::string& title, const StoryHardship& hardship, Seed stories = 3)
{
  Tally tally;
  for (Seed seed = 1; seed <= stories; ++seed) {
    const Story story = makeStory (seed, hardship);
    addRooms (story, planOf (story.cloud), tally);
  }
  std::printf ("| %s | %.0f rooms | %.0f found | %.0f within 3 %% | %.0f invented | "
               "%.0f doors | %.0f found | %.0f invented |\n",
               title.c_str(),
               tally.true_rooms,
               tally.found_rooms,
               tally.exact_rooms,
               tally.invented_rooms,
               tally.true_doors,
               tally.found_doors,
               tally.invented_doors);
  return tally;
}

/** \brief Expects nine of ten rooms found, four of five rooms within 3 %, nearly no
 * invented room or door, and nine of ten of the doors between found rooms. */
void
expectNearlyAll (const Tally& rooms)
{
  EXPECT_GE (rooms.found_rooms, 0.9 * rooms.true_rooms);
  EXPECT_GE (rooms.exact_rooms, 0.8 * rooms.true_rooms);
  EXPECT_LE (rooms.invented_rooms, 0.05 * rooms.drawn_rooms);
  EXPECT_GE (rooms.found_doors, 0.9 * rooms.true_doors);
  EXPECT_LE (rooms.invented_doors, 0.05 * rooms.true_doors);
}

} // namespace

TEST (Stories, ThatArePlainHaveAllRoomsAndDoorsAndNoOthers)
{
  const Tally plain = tallyOf ("plain", {}, 1);
  EXPECT_EQ (plain.found_rooms, plain.true_rooms);
  EXPECT_EQ (plain.exact_rooms, plain.true_rooms);
  EXPECT_EQ (plain.invented_rooms, 0.0);
  EXPECT_EQ (plain.found_doors, plain.true_doors);
  EXPECT_EQ (plain.invented_doors, 0.0);
}

TEST (Stories, WithFurnitureAndClutterHaveNearlyAllRooms)
{
  StoryHardship furnished;
  furnished.furnished = 0.4;
  furnished.clutter = 4;
  furnished.noise = 0.005;
  expectNearlyAll (tallyOf ("furniture, clutter", furnished));
}

TEST (Stories, WithGlassAndMissingPiecesHaveNearlyAllRooms)
{
  StoryHardship unseen;
  unseen.has_glass = true;
  unseen.missing = 0.1;
  unseen.noise = 0.005;
  expectNearlyAll (tallyOf ("glass, missing", unseen));
}

TEST (Stories, WithDriftAndNoiseHaveNearlyAllRooms)
{
  StoryHardship drifting;
  drifting.furnished = 0.2;
  drifting.drift = 0.01;
  drifting.noise = 0.02;
  expectNearlyAll (tallyOf ("drift, noise", drifting));
}

TEST (Stories, WithoutCeilingsHaveNearlyAllRooms)
{
  StoryHardship open;
  open.furnished = 0.2;
  open.has_ceiling = false;
  expectNearlyAll (tallyOf ("no ceilings", open));
}
