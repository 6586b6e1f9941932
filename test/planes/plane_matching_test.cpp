// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_board.h"
#include "planes/patch.h"
#include <pcl_ops/plane_matching.h>
#include <pcl_ops/plane_tracker.h>

#include <limits>
#include <stdexcept>

using namespace pcl_ops;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using pcl_ops::internal::moved;

namespace {

using Planes = std::vector<PlaneSegment>;
using Numbers = std::vector<std::uint32_t>;

/** \brief The floor and two walls of a corner of a room, and two shelves, of which one
 * is 0.3 m above the other. The middle of the floor is 3 m from zero along y. */
Planes
roomCorner ()
{
  return {board ({0, 3, -1}, Vector3d::UnitZ(), {4, 4}),
          board ({0, 5, 0}, -Vector3d::UnitY(), {4, 2}),
          board ({2, 3, 0}, -Vector3d::UnitX(), {4, 2}),
          board ({-1, 4.7, 0.0}, Vector3d::UnitZ(), {1, 0.4}),
          board ({-1, 4.7, 0.3}, Vector3d::UnitZ(), {1, 0.4})};
}

/** \brief The planes in the frame of a sensor with this pose. */
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

/** \brief For trackers that forget no plane, however many frames do not see it. */
constexpr std::nullopt_t never_by_frames = std::nullopt;

const Isometry3d no_motion = Isometry3d::Identity();

/** \brief The matches where the planes of roomCorner() come in the same order. */
const Labels each_itself{0, 1, 2, 3, 4};

} // namespace

TEST (PlaneMatches, HaveALayoutThatNoOptionOfTheCompilerChanges)
{
  // Eigen aligns its types to 16 to 64 bytes, as -msse2, -mavx2 or -mavx512f ask for.
  static_assert (alignof (PlaneMatches) == 64);
  static_assert (alignof (PlaneTracker) == 64);
}

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
  exact.rotation_error = 0.001;    // [rad]
  exact.translation_error = 0.001; // [m]
  EXPECT_EQ (matchPlanes (roomCorner(), current, pose, exact).previous, each_itself);
  const Labels inverted =
      matchPlanes (roomCorner(), current, pose.inverse(), exact).previous;
  EXPECT_EQ (std::count (inverted.begin(), inverted.end(), no_plane), 5);
}

TEST (MatchPlanes, CorrectsAPoseByMoreThanFromOneShelfToTheNext)
{
  // 4 degrees are 0.33 m at the shelves, 4.7 m away, but one is 0.3 m above the other.
  const Isometry3d error = motion (4, Vector3d::UnitX(), {0.03, 0, 0.02});
  const PlaneMatches matches =
      matchPlanes (roomCorner(), seenFrom (error, roomCorner()));
  EXPECT_EQ (matches.previous, each_itself);
  EXPECT_TRUE (matches.pose.isApprox (error, 0.005)) << matches.pose.matrix();
}

TEST (MatchPlanes, CorrectsThePoseByOneCurrentPlaneForEachPreviousOne)
{
  // On the floor of the current frame there is a mat, 1 cm thick. The floor of the
  // previous frame matches the floor, and the mat does not change the pose.
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

/** \brief A level board, from x - width / 2 to x + width / 2 and 1 m deep, at a height
 * [m].
 * \param[in] noise how far its points are from it [m] */
PlaneSegment
levelBoard (double x, double height, double width, double noise = 0.002)
{
  return board ({x, 0, height}, Vector3d::UnitZ(), {width, 1}, noise);
}

/** \brief A part of one wall, from x - width / 2 to x + width / 2 and 2 m high. */
PlaneSegment
partOfWall (double x, double width)
{
  return board ({x, 0, 0}, Vector3d::UnitY(), {width, 2});
}

/** \brief Planes of two frames, and which of them match. */
struct MatchingCase {
  const char* name; // of the test
  Planes previous;
  Planes current;
  PlaneMatchingParameters parameters;
  /** \brief Index of the previous plane that matches each current plane. */
  Labels expected;
};

/** \brief Prints the name in messages of GoogleTest. */
void
PrintTo (const MatchingCase& row, std::ostream* stream)
{
  *stream << row.name;
}

PlaneMatchingParameters
withTranslationError (double translation_error)
{
  PlaneMatchingParameters parameters;
  parameters.translation_error = translation_error;
  return parameters;
}

PlaneMatchingParameters
withMinOverlap (double min_overlap)
{
  PlaneMatchingParameters parameters;
  parameters.min_overlap = min_overlap;
  return parameters;
}

/** \brief Parameters for a pose that has no error. */
PlaneMatchingParameters
exactPose ()
{
  PlaneMatchingParameters parameters;
  parameters.rotation_error = 0.0;
  parameters.translation_error = 0.0;
  return parameters;
}

/** \brief Planes that are apart along their normals. */
std::vector<MatchingCase>
casesOfDistance ()
{
  const PlaneSegment floor = levelBoard (0, 0, 1);
  const PlaneSegment table = levelBoard (0, 0.3, 1);
  return {
      {"RefusesAPlaneFartherAwayThanThePoseIsOff", {floor}, {table}, {}, {no_plane}},
      {"TakesAPlaneAsFarAwayAsThePoseIsOff",
       {floor},
       {table},
       withTranslationError (0.2),
       {0}},
      // Two planes differ by three numbers: two tilts and an offset. As rarely as one
      // number differs by 3 standard deviations, all three together differ by 3.76: at
      // 0.1 m each, an offset of 0.376 m.
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
      {"RefusesAPlaneFiveCentimetersAwayWhereThePoseIsExact",
       {levelBoard (0, 0, 2)},
       {levelBoard (0, 0.05, 2)},
       exactPose(),
       {no_plane}},
      {"TakesAPlaneFiveCentimetersAwayWhereNoiseExplainsIt",
       {levelBoard (0, 0, 2, 0.03)},
       {levelBoard (0, 0.05, 2, 0.03)},
       exactPose(),
       {0}}};
}

/** \brief Planes with the same equation that overlap in part or not at all. */
std::vector<MatchingCase>
casesOfOverlap ()
{
  const PlaneSegment door = partOfWall (0, 1);
  const PlaneSegment other_door = partOfWall (1.5, 1); // 0.5 m beside the first one
  return {
      {"TellsPlanesOfOneEquationApartByTheirPositions",
       {door, other_door},
       {other_door, door},
       {},
       {1, 0}},
      {"RefusesAPlaneOfTheSameEquationElsewhere", {door}, {other_door}, {}, {no_plane}},
      {"TakesAnOverlapOfHalfWhereLessIsAskedFor",
       {levelBoard (0, 0, 2)},
       {levelBoard (1, 0, 2)},
       withMinOverlap (0.4),
       {0}},
      {"RefusesAnOverlapOfHalfWhereMoreIsAskedFor",
       {levelBoard (0, 0, 2)},
       {levelBoard (1, 0, 2)},
       withMinOverlap (0.6),
       {no_plane}},
      {"TakesThePartThatOverlapsMost",
       {partOfWall (0, 4)},
       {partOfWall (-1.5, 0.8), partOfWall (0.5, 3)},
       {},
       {no_plane, 0}},
      {"TakesAPlaneOfTheSameSizeRatherThanALargerOneThatCoversIt",
       {partOfWall (0, 10), partOfWall (0.1, 1)},
       {door},
       {},
       {1}}};
}

/** \brief Frames without planes, and segments without points. */
std::vector<MatchingCase>
casesOfNothing ()
{
  const PlaneSegment floor = levelBoard (0, 0, 1);
  const PlaneSegment without_points{};
  return {{"MatchesNoSegmentWithoutPoints",
           {without_points, floor},
           {floor, without_points},
           {},
           {1, no_plane}},
          {"FindsNothingInAnEmptyFrame", {floor}, {}, {}, {}},
          {"FindsNothingAfterAnEmptyFrame", {}, {floor}, {}, {no_plane}}};
}

std::vector<MatchingCase>
allCases ()
{
  std::vector<MatchingCase> all = casesOfDistance();
  for (const std::vector<MatchingCase>& cases : {casesOfOverlap(), casesOfNothing()})
    all.insert (all.end(), cases.begin(), cases.end());
  return all;
}

class MatchPlanesCases : public testing::TestWithParam<MatchingCase> {};

} // namespace

INSTANTIATE_TEST_SUITE_P (MatchPlanes,
                          MatchPlanesCases,
                          testing::ValuesIn (allCases()),
                          [] (const auto& info) { return info.param.name; });

TEST_P (MatchPlanesCases, AreAsNamed)
{
  const MatchingCase& row = GetParam();
  EXPECT_EQ (
      matchPlanes (row.previous, row.current, no_motion, row.parameters).previous,
      row.expected);
}

TEST (MatchPlanes, RefusesAnOverlapAboveOneAndAPoseThatIsNotFinite)
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
  // The part of the floor that a frame sees, from and to an x [m]. The last one
  // overlaps only that of the first frame.
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
  constexpr double ten_thousand = 1e4; // for four decimals
  rounded.matrix() = (ten_thousand * rounded.matrix()).array().round() / ten_thousand;
  PlaneTracker tracker;
  for (int i = 0; i < 1000; ++i)
    tracker.track ({}, rounded);
  const Eigen::Matrix3d turn = tracker.pose().linear();
  EXPECT_TRUE ((turn * turn.transpose()).isIdentity (1e-12)) << turn;
  EXPECT_TRUE (tracker.pose().translation().isApprox (rounded.translation(), 1e-9));
}

TEST (PlaneTracker, FollowsASensorThatDrifts)
{
  PlaneTracker tracker;
  // From frame to frame the sensor turns by 1 degree; the given pose turns by 2.
  Isometry3d true_pose = no_motion, given_pose = no_motion;
  for (int frame = 0; frame < 30; ++frame) {
    EXPECT_EQ (tracker.track (seenFrom (true_pose, roomCorner()), given_pose),
               (Numbers{1, 2, 3, 4, 5}))
        << frame;
    EXPECT_TRUE (tracker.pose().isApprox (true_pose, 0.015)) << tracker.pose().matrix();
    true_pose = true_pose * motion (1, Vector3d::UnitZ(), {0.01, 0.02, 0});
    given_pose = given_pose * motion (2, Vector3d::UnitZ(), {0.02, 0.02, 0.01});
  }
}

TEST (PlaneTracker, HasPlanesInTheCommonFrame)
{
  const Isometry3d pose = motion (30, Vector3d::UnitZ(), {1, 2, 0.5});
  PlaneTracker tracker;
  tracker.track (seenFrom (pose, roomCorner()), pose);
  ASSERT_EQ (tracker.planes().size(), 5u);
  for (std::size_t i = 0; i < 5; ++i) {
    const PlaneSegment& plane = tracker.planes()[i].plane;
    const PlaneSegment truth = roomCorner()[i];
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
  // First frame, last frame and number of frames of each plane.
  std::vector<std::array<std::size_t, 3>> seen;
  for (const TrackedPlane& plane : tracker.planes())
    seen.push_back ({plane.first_seen, plane.last_seen, plane.times_seen});
  EXPECT_EQ (seen, (decltype (seen){{0, 3, 3}, {1, 2, 2}}));
}

TEST (PlaneTracker, JoinsTheExtentsOfAllFrames)
{
  PlaneTracker tracker;
  for (const double x : {0.0, 1.0, 2.0, 1.0})
    tracker.track ({board ({x, 3, -1}, Vector3d::UnitZ(), {2, 1})}, no_motion);
  ASSERT_EQ (tracker.planes().size(), 1u);
  const PlaneExtent& extent = tracker.planes()[0].extent;
  EXPECT_NEAR (extent.length, 4.0, 0.02);
  EXPECT_NEAR (extent.width, 1.0, 0.02);
  EXPECT_NEAR (extent.area, 4.0, 0.03);
  EXPECT_TRUE (extent.center.isApprox (Vector3d (1, 3, -1), 1e-6))
      << extent.center.transpose();
}

TEST (PlaneTracker, ForgetsPlanesWhosePointsSpanNoneAfterTheirFrame)
{
  const PlaneSegment floor = roomCorner()[0];
  PlaneSegment line;
  for (int i = 0; i < 10; ++i)
    line.moments.add (i, 0, 0);
  PlaneTracker tracker;
  for (const std::uint32_t frame : {0u, 1u, 2u}) {
    EXPECT_EQ (tracker.track ({floor, line}, no_motion), (Numbers{1, 2 + frame}))
        << "no extent tells whether the line is the one seen before";
    EXPECT_EQ (tracker.planes().size(), 2u) << "those of the frame";
  }
  tracker.track ({}, no_motion);
  EXPECT_EQ (tracker.planes().size(), 1u) << "the floor";
}

TEST (PlaneTracker, ForgetsPlanesWithoutANormalAfterTheirFrame)
{
  PlaneSegment wrong = roomCorner()[0];
  wrong.normal.setConstant (std::numeric_limits<double>::quiet_NaN());
  PlaneTracker tracker;
  tracker.track ({wrong}, no_motion);
  tracker.track ({}, no_motion);
  EXPECT_TRUE (tracker.planes().empty());
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
  EXPECT_EQ (planesAfterMovingTo (5), 1u) << "the nearest side is 4 m away";
  EXPECT_EQ (planesAfterMovingTo (7), 0u);
  EXPECT_THROW (PlaneTracker ({}, never_by_frames, -1.0), std::invalid_argument);
}
