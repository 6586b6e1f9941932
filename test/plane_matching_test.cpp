// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "matching/patch.h"
#include "plane_board.h"
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

/** \brief A corner of a room 3 m ahead, and two shelves 0.3 m above each other. */
Planes
corner ()
{
  return {board ({0, 3, -1}, Vector3d::UnitZ(), {4, 4}),
          board ({0, 5, 0}, -Vector3d::UnitY(), {4, 2}),
          board ({2, 3, 0}, -Vector3d::UnitX(), {4, 2}),
          board ({-1, 4.7, 0.0}, Vector3d::UnitZ(), {1, 0.4}),
          board ({-1, 4.7, 0.3}, Vector3d::UnitZ(), {1, 0.4})};
}

/** \brief The same as seen from elsewhere. */
Planes
seenFrom (const Isometry3d& pose, Planes planes)
{
  for (PlaneSegment& plane : planes)
    plane = moved (pose.inverse(), plane);
  return planes;
}

Isometry3d
motion (double degrees, const Vector3d& axis, const Vector3d& shift)
{
  return Eigen::Translation3d (shift) *
         Eigen::AngleAxisd (degrees * 1_deg, axis.normalized());
}

const Isometry3d stays = Isometry3d::Identity();

const Labels each{0, 1, 2, 3, 4};

} // namespace

TEST (MatchPlanes, FindsEachPlaneOfAFrameInItselfInAnyOrder)
{
  const Planes all = corner();
  EXPECT_EQ (matchPlanes (all, all).previous, each);
  EXPECT_EQ (matchPlanes (all, {all[4], all[1]}).previous, (Labels{4, 1}));
  PlaneMatchingParameters all_of_it;
  all_of_it.min_overlap = 1.0;
  const Planes turned = seenFrom (motion (40, {0, 0.2, 1}, {1, 0.5, 0}), all);
  EXPECT_EQ (matchPlanes (turned, turned, stays, all_of_it).previous, each);
}

TEST (MatchPlanes, TakesThePoseAsThatOfTheCurrentFrameInThePrevious)
{
  const Isometry3d pose = motion (40, {0, 0.2, 1}, {1, 0.5, 0});
  const Planes current = seenFrom (pose, corner());
  PlaneMatchingParameters exact;
  exact.rotation_error = exact.translation_error = 0.001;
  EXPECT_EQ (matchPlanes (corner(), current, pose, exact).previous, each);
  const Labels inverted =
      matchPlanes (corner(), current, pose.inverse(), exact).previous;
  EXPECT_EQ (std::count (inverted.begin(), inverted.end(), no_plane), 5);
}

TEST (MatchPlanes, MendsAPoseThatIsOffUntilShelvesAreTheRightOnes)
{
  // 4 degrees are 0.33 m at the shelves: more than from one to the next.
  const Isometry3d error = motion (4, Vector3d::UnitX(), {0.03, 0, 0.02});
  const PlaneMatches matches = matchPlanes (corner(), seenFrom (error, corner()));
  EXPECT_EQ (matches.previous, each);
  EXPECT_TRUE (matches.pose.isApprox (error, 0.005)) << matches.pose.matrix();
}

TEST (MatchPlanes, TakesPosesThatAreFarOffIfToldSo)
{
  for (const double degrees : {5.0, 10.0, 15.0, 20.0})
    for (const Vector3d& axis : {Vector3d (1, 0, 0), {0, 1, 0}, {0, 0, 1}, {1, 2, 3}}) {
      PlaneMatchingParameters rough;
      rough.rotation_error = degrees * 1_deg;
      const Isometry3d error = motion (degrees, axis, {0, 0, 0});
      const PlaneMatches matches =
          matchPlanes (corner(), seenFrom (error, corner()), stays, rough);
      EXPECT_EQ (matches.previous, each) << degrees << " about " << axis.transpose();
    }
}

TEST (MatchPlanes, MatchesWhatOverlapsAndThePoseAndTheNoiseExplain)
{
  const auto with = [] (double translation_error, double min_overlap) {
    PlaneMatchingParameters parameters;
    parameters.translation_error = translation_error;
    parameters.min_overlap = min_overlap;
    return parameters;
  };
  PlaneMatchingParameters exact;
  exact.rotation_error = exact.translation_error = 0.0;
  const auto level = [] (double x, double z, double width, double noise = 0.002) {
    return board ({x, 0, z}, Vector3d::UnitZ(), {width, 1}, noise);
  };
  const auto upright = [] (double x, double width) {
    return board ({x, 0, 0}, Vector3d::UnitY(), {width, 2});
  };
  const PlaneSegment floor = level (0, 0, 1), table = level (0, 0.3, 1), none{};
  const PlaneSegment door = upright (0, 1), other_door = upright (1.5, 1);
  const Planes pieces = {upright (-1.5, 0.8), upright (0.5, 3)};
  const struct {
    const char* planes;
    Planes previous, current;
    PlaneMatchingParameters parameters;
    Labels expected;
  } rows[] = {
      {"farther than the pose is off", {floor}, {table}, {}, {no_plane}},
      {"as far as it is", {floor}, {table}, with (0.2, 0.3), {0}},
      {"one equation", {door, other_door}, {other_door, door}, {}, {1, 0}},
      {"but not the same ends", {door}, {other_door}, {}, {no_plane}},
      {"half over it", {level (0, 0, 2)}, {level (1, 0, 2)}, with (0.05, 0.4), {0}},
      {"not enough",
       {level (0, 0, 2)},
       {level (1, 0, 2)},
       with (0.05, 0.6),
       {no_plane}},
      {"the one that overlaps most", {upright (0, 4)}, pieces, {}, {no_plane, 0}},
      {"5 cm apart", {level (0, 0, 2)}, {level (0, 0.05, 2)}, exact, {no_plane}},
      {"noisy", {level (0, 0, 2, 0.03)}, {level (0, 0.05, 2, 0.03)}, exact, {0}},
      {"what is none", {none, floor}, {floor, none}, {}, {1, no_plane}},
      {"nothing in the next", {floor}, {}, {}, {}},
      {"nothing before", {}, {floor}, {}, {no_plane}}};
  for (const auto& [name, previous, current, parameters, expected] : rows)
    EXPECT_EQ (matchPlanes (previous, current, stays, parameters).previous, expected)
        << name;
}

TEST (MatchPlanes, RefusesWrongArguments)
{
  PlaneMatchingParameters wrong;
  wrong.min_overlap = 1.1;
  EXPECT_THROW (matchPlanes ({}, {}, stays, wrong), std::invalid_argument);
  EXPECT_THROW (PlaneTracker{wrong}, std::invalid_argument);
  Isometry3d nowhere = stays;
  nowhere.translation().x() = NAN;
  EXPECT_THROW (matchPlanes ({}, {}, nowhere), std::invalid_argument);
}

TEST (PlaneTracker, KnowsAPlaneWhereEarlierFramesSawIt)
{
  PlaneTracker tracker;
  for (const auto& [from, to] : {std::pair (0.0, 4.0), {3.0, 5.0}, {0.0, 1.4}}) {
    const Vector3d middle (0.5 * (from + to), 3, -1);
    const Planes floor = {board (middle, Vector3d::UnitZ(), {to - from, 2})};
    EXPECT_EQ (tracker.track (floor, stays), Numbers{1});
  }
}

TEST (PlaneTracker, KnowsAPlaneAgainThatWasOutOfSightUnlessToldToForgetIt)
{
  PlaneTracker forgets ({}, 2), remembers;
  const Planes all = corner();
  const Planes without_shelf = {all[0], all[1], all[2], all[3]};
  for (const int frames : {2, 3})
    for (PlaneTracker* const tracker : {&forgets, &remembers}) {
      tracker->track (all, stays);
      for (int i = 0; i < frames; ++i)
        tracker->track (without_shelf, stays);
      const bool is_known = tracker == &remembers || frames == 2;
      EXPECT_EQ (tracker->planes().size(), is_known ? 5u : 4u);
      EXPECT_EQ (tracker->track (all, stays),
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
  Isometry3d truth = stays, told = stays;
  for (int i = 0; i < 30; ++i) {
    EXPECT_EQ (tracker.track (seenFrom (truth, corner()), told),
               (Numbers{1, 2, 3, 4, 5}))
        << i;
    EXPECT_TRUE (tracker.pose().isApprox (truth, 0.015)) << tracker.pose().matrix();
    truth = truth * motion (1, Vector3d::UnitZ(), {0.01, 0.02, 0});
    told = told * motion (2, Vector3d::UnitZ(), {0.02, 0.02, 0.01});
  }
}

TEST (PlaneTracker, HasPlanesInTheCommonFrame)
{
  const Isometry3d pose = motion (30, Vector3d::UnitZ(), {1, 2, 0.5});
  PlaneTracker tracker;
  tracker.track (seenFrom (pose, corner()), pose);
  ASSERT_EQ (tracker.planes().size(), 5U);
  for (std::size_t i = 0; i < 5; ++i) {
    const PlaneSegment &plane = tracker.planes()[i].plane, truth = corner()[i];
    EXPECT_TRUE (plane.centroid.isApprox (truth.centroid, 1e-9));
    EXPECT_TRUE (plane.normal.isApprox (truth.normal, 1e-9));
  }
}

TEST (PlaneTracker, CountsTheFramesOfEachPlane)
{
  const PlaneSegment floor = corner()[0], wall = corner()[1];
  PlaneTracker tracker;
  for (const Planes& frame : {Planes{floor}, {floor, wall}, {wall}, {floor}})
    tracker.track (frame, stays);
  std::vector<std::array<std::size_t, 3>> seen;
  for (const TrackedPlane& plane : tracker.planes())
    seen.push_back ({plane.first_seen, plane.last_seen, plane.times_seen});
  EXPECT_EQ (seen, (decltype (seen){{0, 3, 3}, {1, 2, 2}}));
}

TEST (PlaneTracker, JoinsTheExtentsOfAllFrames)
{
  PlaneTracker tracker;
  for (const double x : {0.0, 1.0, 2.0, 1.0})
    tracker.track ({board ({x, 3, -1}, Vector3d::UnitZ(), {2, 1})}, stays);
  ASSERT_EQ (tracker.planes().size(), 1U);
  const PlaneExtent& extent = tracker.planes()[0].extent;
  EXPECT_NEAR (extent.length, 4.0, 0.02);
  EXPECT_NEAR (extent.width, 1.0, 0.02);
  EXPECT_NEAR (extent.area, 4.0, 0.03);
  EXPECT_TRUE (extent.center.isApprox (Vector3d (1, 3, -1), 1e-6))
      << extent.center.transpose();
}

TEST (PlaneTracker, ForgetsPlanesFartherThanTold)
{
  PlaneTracker tracker ({}, std::nullopt, 5.0);
  const auto goesOn = [&] (double x) {
    tracker.track ({}, motion (0, Vector3d::UnitZ(), {x, 0, 0}));
    return tracker.planes().size();
  };
  tracker.track ({board ({0, 0, -1}, Vector3d::UnitZ(), {2, 2})}, stays);
  EXPECT_EQ (goesOn (5), 1U) << "its near side is 4 m away";
  EXPECT_EQ (goesOn (7), 0U);
  EXPECT_THROW (PlaneTracker ({}, std::nullopt, -1.0), std::invalid_argument);
}
