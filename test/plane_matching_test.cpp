// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_board.h"
#include "scene.h"
#include <pcl_ops/plane_matching.h>
#include <pcl_ops/plane_tracker.h>

#include <array>
#include <stdexcept>

using namespace pcl_ops;
using Eigen::Isometry3d;
using Eigen::Vector3d;

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

TEST (MatchPlanes, DoesNotMatchWhatThePoseCannotExplain)
{
  const Planes floor = {board ({0, 0, 0}, Vector3d::UnitZ(), {1, 1})};
  const Planes table = {board ({0, 0, 0.3}, Vector3d::UnitZ(), {1, 1})};
  EXPECT_EQ (matchPlanes (floor, table).previous, (Labels{no_plane}));
  PlaneMatchingParameters loose;
  loose.translation_error = 0.2;
  EXPECT_EQ (matchPlanes (floor, table, stays, loose).previous, (Labels{0}));
}

TEST (MatchPlanes, TellsPlanesOfOneEquationApartByWhereTheyEnd)
{
  const Planes doors = {board ({0, 0, 0}, Vector3d::UnitY(), {1, 2}),
                        board ({1.5, 0, 0}, Vector3d::UnitY(), {1, 2})};
  EXPECT_EQ (matchPlanes (doors, {doors[1], doors[0]}).previous, (Labels{1, 0}));
  EXPECT_EQ (matchPlanes ({doors[0]}, {doors[1]}).previous, (Labels{no_plane}));
}

TEST (MatchPlanes, AsksForTheOverlapGiven)
{
  const Planes before = {board ({0, 0, 0}, Vector3d::UnitZ(), {2, 1})};
  const Planes now = {board ({1, 0, 0}, Vector3d::UnitZ(), {2, 1})}; // half over it
  PlaneMatchingParameters parameters;
  parameters.min_overlap = 0.4;
  EXPECT_EQ (matchPlanes (before, now, stays, parameters).previous, (Labels{0}));
  parameters.min_overlap = 0.6;
  EXPECT_EQ (matchPlanes (before, now, stays, parameters).previous, (Labels{no_plane}));
}

TEST (MatchPlanes, GivesAPreviousPlaneToTheOneThatOverlapsItMost)
{
  const Planes wall = {board ({0, 0, 0}, Vector3d::UnitY(), {4, 2})};
  const Planes pieces = {board ({-1.5, 0, 0}, Vector3d::UnitY(), {0.8, 2}),
                         board ({0.5, 0, 0}, Vector3d::UnitY(), {3, 2})};
  EXPECT_EQ (matchPlanes (wall, pieces).previous, (Labels{no_plane, 0}));
}

TEST (MatchPlanes, NeedsNoThresholdOfItsOwnForNoisyPlanes)
{
  PlaneMatchingParameters exact;
  exact.rotation_error = exact.translation_error = 0.0;
  const auto isMatched = [&] (double noise) {
    const Planes before = {board ({0, 0, 0}, Vector3d::UnitZ(), {2, 2}, noise)};
    const Planes now = {board ({0, 0, 0.05}, Vector3d::UnitZ(), {2, 2}, noise)};
    return matchPlanes (before, now, stays, exact).previous[0] == 0;
  };
  EXPECT_FALSE (isMatched (0.002));
  EXPECT_TRUE (isMatched (0.03));
}

TEST (MatchPlanes, HasNoMatchForWhatIsNoPlane)
{
  const Planes all = corner();
  EXPECT_EQ (matchPlanes ({PlaneSegment(), all[0]}, {all[0], PlaneSegment()}).previous,
             (Labels{1, no_plane}));
  EXPECT_TRUE (matchPlanes (all, {}).previous.empty());
  EXPECT_EQ (matchPlanes ({}, {all[0]}).previous, (Labels{no_plane}));
}

TEST (MatchPlanes, RefusesWrongArguments)
{
  PlaneMatchingParameters wrong;
  wrong.min_overlap = 1.1;
  EXPECT_THROW (matchPlanes ({}, {}, stays, wrong), std::invalid_argument);
  EXPECT_THROW (PlaneTracker{wrong}, std::invalid_argument);
  Isometry3d nowhere = stays;
  nowhere.translation().x() = std::nan ("");
  EXPECT_THROW (matchPlanes ({}, {}, nowhere), std::invalid_argument);
}

TEST (PlaneTracker, KnowsAPlaneWhereEarlierFramesSawIt)
{
  const auto floor = [] (double from, double to) -> Planes {
    return {board ({0.5 * (from + to), 3, -1}, Vector3d::UnitZ(), {to - from, 2})};
  };
  PlaneTracker tracker;
  EXPECT_EQ (tracker.track (floor (0.0, 4.0), stays), Numbers{1});
  EXPECT_EQ (tracker.track (floor (3.0, 5.0), stays), Numbers{1});
  EXPECT_EQ (tracker.track (floor (0.0, 1.4), stays), Numbers{1});
}

TEST (PlaneTracker, KnowsAPlaneAgainThatWasOutOfSightUnlessToldToForgetIt)
{
  PlaneTracker forgets (PlaneMatchingParameters(), 2), remembers;
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
    truth = truth * motion (1, Vector3d::UnitZ(), {0.01, 0.02, 0});
    told = told * motion (2, Vector3d::UnitZ(), {0.02, 0.02, 0.01});
  }
  const Isometry3d last =
      truth * motion (1, Vector3d::UnitZ(), {0.01, 0.02, 0}).inverse();
  EXPECT_TRUE (tracker.pose().isApprox (last, 0.015)) << tracker.pose().matrix();
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
  PlaneTracker tracker (PlaneMatchingParameters(), std::nullopt, 5.0);
  const auto goesOn = [&] (double x) {
    tracker.track ({}, motion (0, Vector3d::UnitZ(), {x, 0, 0}));
    return tracker.planes().size();
  };
  tracker.track ({board ({0, 0, -1}, Vector3d::UnitZ(), {2, 2})}, stays);
  EXPECT_EQ (goesOn (5), 1U) << "its near side is 4 m away";
  EXPECT_EQ (goesOn (7), 0U);
  EXPECT_THROW (PlaneTracker (PlaneMatchingParameters(), std::nullopt, -1.0),
                std::invalid_argument);
}
