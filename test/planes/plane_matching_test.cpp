// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_board.h"
#include "planes/patch.h"
#include <pcl_ops/plane_matching.h>
#include <pcl_ops/plane_tracker.h>

#include <stdexcept>

using namespace pcl_ops;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using pcl_ops::internal::moved;

namespace {

using Planes = std::vector<PlaneSegment>;
using Numbers = std::vector<std::uint32_t>;

/** \brief The floor and two walls of a corner of a room, and two shelves 0.3 m above
 * each other. The middle of the floor is 3 m ahead along y. */
Planes
roomCorner ()
{
  return {board ({0, 3, -1}, Vector3d::UnitZ(), {4, 4}),
          board ({0, 5, 0}, -Vector3d::UnitY(), {4, 2}),
          board ({2, 3, 0}, -Vector3d::UnitX(), {4, 2}),
          board ({-1, 4.7, 0.0}, Vector3d::UnitZ(), {1, 0.4}),
          board ({-1, 4.7, 0.3}, Vector3d::UnitZ(), {1, 0.4})};
}

/** \brief The same planes as seen from another pose. */
Planes
seenFrom (const Isometry3d& pose, Planes planes)
{
  for (PlaneSegment& plane : planes)
    plane = moved (pose.inverse(), plane);
  return planes;
}

/** \brief A turn about an axis through zero, and then a shift [m]. */
Isometry3d
motion (double degrees, const Vector3d& axis, const Vector3d& shift)
{
  return Eigen::Translation3d (shift) *
         Eigen::AngleAxisd (degrees * 1_deg, axis.normalized());
}

/** \brief For trackers that forget no plane by the number of frames. */
constexpr std::nullopt_t never_by_frames = std::nullopt;

const Isometry3d no_motion = Isometry3d::Identity();

/** \brief The matches where the planes of roomCorner() come in the same order. */
const Labels each_itself{0, 1, 2, 3, 4};

} // namespace

TEST (MatchPlanes, FindsEachPlaneOfAFrameInItselfInAnyOrder)
{
  const Planes all = roomCorner();
  EXPECT_EQ (matchPlanes (all, all).previous, each_itself);
  EXPECT_EQ (matchPlanes (all, {all[4], all[1]}).previous, (Labels{4, 1}));
  PlaneMatchingParameters whole_overlap;
  whole_overlap.min_overlap = 1.0;
  const Planes turned = seenFrom (motion (40, {0, 0.2, 1}, {1, 0.5, 0}), all);
  EXPECT_EQ (matchPlanes (turned, turned, no_motion, whole_overlap).previous,
             each_itself);
}

TEST (MatchPlanes, TakesThePoseOfTheCurrentFrameInThePreviousOneNotItsInverse)
{
  const Isometry3d pose = motion (40, {0, 0.2, 1}, {1, 0.5, 0});
  const Planes current = seenFrom (pose, roomCorner());
  PlaneMatchingParameters exact;
  exact.rotation_error = exact.translation_error = 0.001;
  EXPECT_EQ (matchPlanes (roomCorner(), current, pose, exact).previous, each_itself);
  const Labels inverted =
      matchPlanes (roomCorner(), current, pose.inverse(), exact).previous;
  EXPECT_EQ (std::count (inverted.begin(), inverted.end(), no_plane), 5);
}

TEST (MatchPlanes, CorrectsAPoseByMoreThanFromOneShelfToTheNext)
{
  // 4 degrees are 0.33 m at the shelves, which are 0.3 m above each other.
  const Isometry3d error = motion (4, Vector3d::UnitX(), {0.03, 0, 0.02});
  const PlaneMatches matches =
      matchPlanes (roomCorner(), seenFrom (error, roomCorner()));
  EXPECT_EQ (matches.previous, each_itself);
  EXPECT_TRUE (matches.pose.isApprox (error, 0.005)) << matches.pose.matrix();
}

TEST (MatchPlanes, CorrectsThePoseByOneCurrentPlaneForEachPreviousOne)
{
  // A mat on the floor, 1 cm thick, that was not there before. The floor before matches
  // the floor now, and the mat tells nothing about the pose.
  Planes current = roomCorner();
  current.push_back (board ({0, 3, -0.99}, Vector3d::UnitZ(), {3.5, 3.5}));
  const PlaneMatches matches = matchPlanes (roomCorner(), current);
  EXPECT_EQ (matches.previous, (Labels{0, 1, 2, 3, 4, no_plane}));
  EXPECT_TRUE (matches.pose.isApprox (no_motion, 1e-6)) << matches.pose.matrix();
}

TEST (MatchPlanes, CorrectsPosesThatAreFarOffIfItsParametersAllowIt)
{
  for (const double degrees : {5.0, 10.0, 15.0, 20.0})
    for (const Vector3d& axis : {Vector3d (1, 0, 0), {0, 1, 0}, {0, 0, 1}, {1, 2, 3}}) {
      PlaneMatchingParameters rough;
      rough.rotation_error = degrees * 1_deg;
      const Isometry3d error = motion (degrees, axis, {0, 0, 0});
      const PlaneMatches matches =
          matchPlanes (roomCorner(), seenFrom (error, roomCorner()), no_motion, rough);
      EXPECT_EQ (matches.previous, each_itself)
          << degrees << " about " << axis.transpose();
    }
}

namespace {

/** A level board 1 m deep, \p height over the floor. */
PlaneSegment
levelBoard (double x, double height, double width, double noise = 0.002)
{
  return board ({x, 0, height}, Vector3d::UnitZ(), {width, 1}, noise);
}

/** A part of one wall, 2 m high. */
PlaneSegment
partOfWall (double x, double width)
{
  return board ({x, 0, 0}, Vector3d::UnitY(), {width, 2});
}

struct MatchingCase {
  const char* name; // of the test
  Planes previous;
  Planes current;
  PlaneMatchingParameters parameters;
  /** Index of the previous plane that matches each current plane. */
  Labels expected;
};

void
PrintTo (const MatchingCase& row, std::ostream* stream)
{
  *stream << row.name;
}

PlaneMatchingParameters
withTranslationError (double length)
{
  PlaneMatchingParameters parameters;
  parameters.translation_error = length;
  return parameters;
}

PlaneMatchingParameters
withMinOverlap (double share)
{
  PlaneMatchingParameters parameters;
  parameters.min_overlap = share;
  return parameters;
}

/** Parameters for a pose without an error. */
PlaneMatchingParameters
exactPose ()
{
  PlaneMatchingParameters parameters;
  parameters.rotation_error = 0.0;
  parameters.translation_error = 0.0;
  return parameters;
}

std::vector<MatchingCase>
matchingCases ()
{
  const PlaneSegment floor = levelBoard (0, 0, 1);
  const PlaneSegment table = levelBoard (0, 0.3, 1);
  const PlaneSegment door = partOfWall (0, 1);
  const PlaneSegment next_door = partOfWall (1.5, 1);
  const PlaneSegment no_plane_at_all{};
  return {
      {"RefusesAPlaneFartherAwayThanThePoseIsOff", {floor}, {table}, {}, {no_plane}},
      {"TakesAPlaneAsFarAwayAsThePoseIsOff",
       {floor},
       {table},
       withTranslationError (0.2),
       {0}},
      // Three standard deviations of three numbers are 3.76 of one: 0.376 m.
      {"TakesAPlaneWithinThreeStandardDeviationsOfThreeNumbers",
       {floor},
       {levelBoard (0, 0.35, 1)},
       withTranslationError (0.1),
       {0}},
      {"RefusesAPlaneBeyondThreeStandardDeviationsOfThreeNumbers",
       {floor},
       {levelBoard (0, 0.42, 1)},
       withTranslationError (0.1),
       {no_plane}},
      {"TellsPlanesOfOneEquationByTheirPlaces",
       {door, next_door},
       {next_door, door},
       {},
       {1, 0}},
      {"RefusesAPlaneOfTheSameEquationElsewhere", {door}, {next_door}, {}, {no_plane}},
      {"TakesHalfAnOverlapWhereLessIsAskedFor",
       {levelBoard (0, 0, 2)},
       {levelBoard (1, 0, 2)},
       withMinOverlap (0.4),
       {0}},
      {"RefusesHalfAnOverlapWhereMoreIsAskedFor",
       {levelBoard (0, 0, 2)},
       {levelBoard (1, 0, 2)},
       withMinOverlap (0.6),
       {no_plane}},
      {"TakesThePartThatOverlapsMost",
       {partOfWall (0, 4)},
       {partOfWall (-1.5, 0.8), partOfWall (0.5, 3)},
       {},
       {no_plane, 0}},
      {"TakesTheDoorOfItsSizeNotTheWallAllOfItIsOn",
       {partOfWall (0, 10), partOfWall (0.1, 1)},
       {door},
       {},
       {1}},
      {"RefusesAPlaneFiveCentimetersAwayWhereThePoseIsExact",
       {levelBoard (0, 0, 2)},
       {levelBoard (0, 0.05, 2)},
       exactPose(),
       {no_plane}},
      {"TakesAPlaneFiveCentimetersAwayWhereNoiseExplainsIt",
       {levelBoard (0, 0, 2, 0.03)},
       {levelBoard (0, 0.05, 2, 0.03)},
       exactPose(),
       {0}},
      {"LeavesOutSegmentsThatSpanNoPlane",
       {no_plane_at_all, floor},
       {floor, no_plane_at_all},
       {},
       {1, no_plane}},
      {"FindsNothingInAnEmptyFrame", {floor}, {}, {}, {}},
      {"FindsNothingAfterAnEmptyFrame", {}, {floor}, {}, {no_plane}}};
}

class MatchPlanesCases : public testing::TestWithParam<MatchingCase> {};

} // namespace

INSTANTIATE_TEST_SUITE_P (MatchPlanes,
                          MatchPlanesCases,
                          testing::ValuesIn (matchingCases()),
                          [] (const auto& info) { return info.param.name; });

TEST_P (MatchPlanesCases, AreAsNamed)
{
  const MatchingCase& row = GetParam();
  EXPECT_EQ (
      matchPlanes (row.previous, row.current, no_motion, row.parameters).previous,
      row.expected);
}

TEST (MatchPlanes, RefusesWrongArguments)
{
  PlaneMatchingParameters wrong;
  wrong.min_overlap = 1.1;
  EXPECT_THROW (matchPlanes ({}, {}, no_motion, wrong), std::invalid_argument);
  EXPECT_THROW (PlaneTracker{wrong}, std::invalid_argument);
  Isometry3d nowhere = no_motion;
  nowhere.translation().x() = NAN;
  EXPECT_THROW (matchPlanes ({}, {}, nowhere), std::invalid_argument);
}

TEST (PlaneTracker, KnowsAPlaneWhereEarlierFramesSawIt)
{
  PlaneTracker tracker;
  for (const auto& [from, to] : {std::pair (0.0, 4.0), {3.0, 5.0}, {0.0, 1.4}}) {
    const Vector3d middle (0.5 * (from + to), 3, -1);
    const Planes floor = {board (middle, Vector3d::UnitZ(), {to - from, 2})};
    EXPECT_EQ (tracker.track (floor, no_motion), Numbers{1});
  }
}

TEST (PlaneTracker, KnowsAPlaneAgainThatWasOutOfSightUnlessToldToForgetIt)
{
  constexpr std::size_t frames_to_forget = 2;
  PlaneTracker forgets ({}, frames_to_forget), remembers;
  const Planes all = roomCorner();
  const Planes without_shelf = {all[0], all[1], all[2], all[3]};
  for (const std::size_t frames : {frames_to_forget, frames_to_forget + 1})
    for (PlaneTracker* const tracker : {&forgets, &remembers}) {
      tracker->track (all, no_motion);
      for (std::size_t i = 0; i < frames; ++i)
        tracker->track (without_shelf, no_motion);
      const bool is_known = tracker == &remembers || frames <= frames_to_forget;
      EXPECT_EQ (tracker->planes().size(), is_known ? 5u : 4u);
      EXPECT_EQ (tracker->track (all, no_motion),
                 (Numbers{1, 2, 3, 4, is_known ? 5u : 6u}));
    }
}

TEST (PlaneTracker, StaysRigidWhereGivenPosesAreRounded)
{
  Isometry3d rounded = motion (40, {0, 0.2, 1}, {1, 0.5, 0});
  constexpr double decimals = 1e4;
  rounded.matrix() = (decimals * rounded.matrix()).array().round() / decimals;
  PlaneTracker tracker;
  for (int i = 0; i < 1000; ++i)
    tracker.track ({}, rounded);
  const Eigen::Matrix3d turn = tracker.pose().linear();
  EXPECT_TRUE ((turn * turn.transpose()).isIdentity (1e-12)) << turn;
}

TEST (PlaneTracker, FollowsASensorThatDrifts)
{
  PlaneTracker tracker;
  Isometry3d true_pose = no_motion, told_pose = no_motion;
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ (tracker.track (seenFrom (true_pose, roomCorner()), told_pose),
               (Numbers{1, 2, 3, 4, 5}))
        << i;
    EXPECT_TRUE (tracker.pose().isApprox (true_pose, 0.015)) << tracker.pose().matrix();
    true_pose = true_pose * motion (1, Vector3d::UnitZ(), {0.01, 0.02, 0});
    told_pose = told_pose * motion (2, Vector3d::UnitZ(), {0.02, 0.02, 0.01});
  }
}

TEST (PlaneTracker, HasPlanesInTheCommonFrame)
{
  const Isometry3d pose = motion (30, Vector3d::UnitZ(), {1, 2, 0.5});
  PlaneTracker tracker;
  tracker.track (seenFrom (pose, roomCorner()), pose);
  ASSERT_EQ (tracker.planes().size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const PlaneSegment &plane = tracker.planes()[i].plane, truth = roomCorner()[i];
    EXPECT_TRUE (plane.centroid.isApprox (truth.centroid, 1e-9));
    EXPECT_TRUE (plane.normal.isApprox (truth.normal, 1e-9));
  }
}

TEST (PlaneTracker, CountsTheFramesOfEachPlane)
{
  const PlaneSegment floor = roomCorner()[0], wall = roomCorner()[1];
  PlaneTracker tracker;
  for (const Planes& frame : {Planes{floor}, {floor, wall}, {wall}, {floor}})
    tracker.track (frame, no_motion);
  std::vector<std::array<std::size_t, 3>>
      seen; // first and last frame, number of frames
  for (const TrackedPlane& plane : tracker.planes())
    seen.push_back ({plane.first_seen, plane.last_seen, plane.times_seen});
  EXPECT_EQ (seen, (decltype (seen){{0, 3, 3}, {1, 2, 2}}));
}

TEST (PlaneTracker, JoinsTheExtentsOfAllFrames)
{
  PlaneTracker tracker;
  for (const double x : {0.0, 1.0, 2.0, 1.0})
    tracker.track ({board ({x, 3, -1}, Vector3d::UnitZ(), {2, 1})}, no_motion);
  ASSERT_EQ (tracker.planes().size(), 1U);
  const PlaneExtent& extent = tracker.planes()[0].extent;
  EXPECT_NEAR (extent.length, 4.0, 0.02);
  EXPECT_NEAR (extent.width, 1.0, 0.02);
  EXPECT_NEAR (extent.area, 4.0, 0.03);
  EXPECT_TRUE (extent.center.isApprox (Vector3d (1, 3, -1), 1e-6))
      << extent.center.transpose();
}

TEST (PlaneTracker, KeepsAPlaneAsLongAsACornerOfItMayBeWithinTheDistance)
{
  // A board of 4 m x 3 m reaches up to 2.5 m from its middle.
  constexpr double max_distance = 5_m;
  const struct {
    double to_middle; // [m]
    std::size_t planes;
  } rows[] = {{7.3_m, 1}, {8.0_m, 0}};
  for (const auto& [to_middle, planes] : rows) {
    PlaneTracker tracker ({}, never_by_frames, max_distance);
    tracker.track ({board ({0, 0, 0}, Vector3d::UnitZ(), {4, 3})}, no_motion);
    tracker.track ({}, motion (0, Vector3d::UnitZ(), {to_middle, 0, 0}));
    EXPECT_EQ (tracker.planes().size(), planes) << to_middle;
  }
}

TEST (PlaneTracker, ForgetsPlanesBeyondTheGivenDistance)
{
  constexpr double max_distance = 5_m;
  PlaneTracker tracker ({}, never_by_frames, max_distance);
  const auto planesAfterMovingTo = [&] (double x) {
    tracker.track ({}, motion (0, Vector3d::UnitZ(), {x, 0, 0}));
    return tracker.planes().size();
  };
  tracker.track ({board ({0, 0, -1}, Vector3d::UnitZ(), {2, 2})}, no_motion);
  EXPECT_EQ (planesAfterMovingTo (5), 1U) << "its near side is 4 m away";
  EXPECT_EQ (planesAfterMovingTo (7), 0U);
  EXPECT_THROW (PlaneTracker ({}, never_by_frames, -1.0), std::invalid_argument);
}
