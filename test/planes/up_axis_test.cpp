// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planes/patch.h"
#include "scene.h"
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/up_axis.h>

using Eigen::Vector3d;
using pcl_ops::internal::moved;
using namespace pcl_ops;

namespace {

const Vector3d up = Vector3d::UnitZ();

/** \brief A surface as a detector returns it, with a point every 10 cm and its normal
 * towards the sensor.
 * \param[in] sensor,surface in meters; sensor is its position
 * \param[in] unit lengths of the plane are this many times those in meters, for example
 * 1000 for millimeters */
PlaneSegment
seenFrom (const Vector3d& sensor, const Surface& surface, double unit = 1.0)
{
  PlaneSegment plane;
  plane.centroid = unit * surface.center();
  plane.moments =
      momentsOf ({unit * surface.corner, unit * surface.first, unit * surface.second},
                 static_cast<int> (surface.first.norm() / 10_cm),
                 static_cast<int> (surface.second.norm() / 10_cm));
  const bool faces_sensor = surface.normal().dot (sensor - surface.center()) > 0.0;
  plane.normal = faces_sensor ? surface.normal() : Vector3d (-surface.normal());
  return plane;
}

/** \brief The up axis by faces that a sensor sees, however low its confidence is. */
UpAxis
upAxisSeenFrom (const Vector3d& sensor, const std::vector<Surface>& faces)
{
  std::vector<PlaneSegment> planes;
  for (const Surface& face : faces)
    planes.push_back (seenFrom (sensor, face));
  UpAxisParameters parameters;
  parameters.min_confidence = 0.0;
  return estimateUpAxis (planes, sensor, parameters).value();
}

/** \brief Position of the sensor in \ref furnishedRoom. */
const Vector3d eye (0.5_m, 2_m, 1.4_m);
const Surface room_floor{{0, 0, 0}, {6, 0, 0}, {0, 4, 0}};
const Surface table_top{{3, 1, 0.75}, {1.5, 0, 0}, {0, 1, 0}};
const Surface wall_ahead{{6, 0, 0}, {0, 4, 0}, {0, 0, 2.4}};
const Surface wall_beside{{0, 0, 0}, {6, 0, 0}, {0, 0, 2.4}};

/** \brief A room of 6 m x 4 m seen from one end: the floor, a table top, the wall at
 * the far end and one beside. */
std::vector<PlaneSegment>
furnishedRoom (double unit = 1.0)
{
  return {seenFrom (eye, room_floor, unit),
          seenFrom (eye, wall_beside, unit),
          seenFrom (eye, wall_ahead, unit),
          seenFrom (eye, table_top, unit)};
}

/** \brief Fails unless the axis is z, up to a small angle.
 * \param[in] tolerance the largest angle [rad] */
void
expectUp (const UpAxis& found, double tolerance)
{
  EXPECT_LE ((found.direction - up).norm(), tolerance);
}

} // namespace

TEST (UpAxis, IsWhereTheFloorFacesAndTheWallsStandHoweverTheRoomIsTurnedInAnyUnit)
{
  const UpAxis upright = estimateUpAxis (furnishedRoom(), eye).value();
  expectUp (upright, 0.1_deg);
  EXPECT_GE (upright.confidence, 0.7);
  EXPECT_LE (upright.confidence, 1.0);
  const std::optional<UpAxis> in_millimeters =
      estimateUpAxis (furnishedRoom (1000.0), 1000.0 * eye);
  EXPECT_NEAR (in_millimeters.value().confidence, upright.confidence, 1e-9);
  RandomGenerator generator (seedOfTest());
  for (int i = 0; i < 50; ++i) {
    Eigen::Isometry3d pose (drawTurn (generator));
    pose.translation() << 10, -20, 30;
    std::vector<PlaneSegment> planes;
    for (const PlaneSegment& plane : furnishedRoom())
      planes.push_back (moved (pose, plane));
    const UpAxis found = estimateUpAxis (planes, pose * eye).value();
    EXPECT_LE ((found.direction - pose.linear() * up).norm(), 0.1_deg);
    EXPECT_NEAR (found.confidence, upright.confidence, 1e-6);
  }
}

TEST (UpAxis, IsTakenByADetectorInEitherPrecision)
{
  OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setUpAxis (cameraUp());
  EXPECT_EQ (ops.getUpAxis(), Eigen::Vector3f (0, -1, 0));
  ops.setUpAxis (UpAxis().direction);
  EXPECT_EQ (ops.getUpAxis(), Eigen::Vector3f::UnitZ());
  ops.setUpAxis (-Eigen::Vector3f::UnitX());
  EXPECT_EQ (ops.getUpAxis(), Eigen::Vector3f (-1, 0, 0));
  ops.setUpAxis ({0, 2, 0});
  EXPECT_EQ (ops.getUpAxis(), Eigen::Vector3f (0, 2, 0));
}

TEST (UpAxis, FollowsMostPlanesAndNotASingleTiltedOne)
{
  std::vector<PlaneSegment> planes = furnishedRoom();
  const Surface ramp{{2, 0.5, 0}, {1, 0, 0.3}, {0, 1, 0}}; // rises by 17 degrees
  planes.push_back (seenFrom (eye, ramp));
  expectUp (estimateUpAxis (planes, eye).value(), 0.5_deg);
}

TEST (UpAxis, IsAcrossWallsWhereManyAreLargerThanTheFloor)
{
  std::vector<PlaneSegment> planes; // walls of 8 m x 3 m in three directions
  for (const double degrees : {0.0, 60.0, 120.0})
    for (const double distance : {-3.0, -2.0, 2.0, 3.0, 4.0}) {
      const Eigen::AngleAxisd turn (degrees * 1_deg, Vector3d::UnitZ());
      planes.push_back (seenFrom (
          eye,
          {turn * Vector3d (distance, -4, 0), turn * Vector3d (0, 8, 0), {0, 0, 3}}));
    }
  // The floor of 2.5 m x 2.5 m rises by 10 cm: its normal is not quite the up axis.
  planes.push_back (seenFrom (eye, {{-1, -1, 0}, {2.5, 0, 0}, {0, 2.5, 0.1}}));
  UpAxisParameters parameters; // of which hardly any limit holds
  parameters.min_share = 0.001;
  parameters.min_confidence = 0.0;
  expectUp (estimateUpAxis (planes, eye, parameters).value(), 1_deg);
}

TEST (UpAxis, IsThatOfTheLargestPlanesHoweverManyBoardsLeanAgainstThem)
{
  std::vector<PlaneSegment> planes; // boards that lean by 45 degrees to all sides
  for (int i = 0; i < 20; ++i) {
    const Eigen::AngleAxisd turn (i * 18_deg, Vector3d::UnitZ());
    planes.push_back (seenFrom (
        eye, {{3, 2, 0}, turn * Vector3d (0.5, 0, 0), turn * Vector3d (0, 0.3, 0.3)}));
  }
  for (const PlaneSegment& plane : furnishedRoom())
    planes.push_back (plane);
  expectUp (estimateUpAxis (planes, eye).value(), 0.1_deg);
}

TEST (UpAxis, NeedsAFloorAndAWall)
{
  const PlaneSegment floor = seenFrom (eye, room_floor);
  const PlaneSegment table = seenFrom (eye, table_top);
  const PlaneSegment wall = seenFrom (eye, wall_ahead);
  for (const std::vector<PlaneSegment>& planes :
       {std::vector<PlaneSegment>{}, {wall}, {floor, table}})
    EXPECT_FALSE (estimateUpAxis (planes, eye));
  expectUp (estimateUpAxis ({floor, wall}, eye).value(), 0.1_deg);
}

TEST (UpAxis, IsTheNormalOfAnExactFloorIfNoWallIsNeeded)
{
  UpAxisParameters parameters;
  parameters.min_share = 0.0;
  expectUp (estimateUpAxis ({seenFrom (eye, room_floor)}, eye, parameters).value(),
            0.1_deg);
}

TEST (UpAxis, NeedsAFloorWhereWallsStandInThreeDirections)
{
  std::vector<PlaneSegment> planes;
  for (const double degrees : {0.0, 60.0, 120.0}) {
    const Eigen::AngleAxisd turn (degrees * 1_deg, Vector3d::UnitZ());
    planes.push_back (seenFrom (
        eye, {turn * Vector3d (5, -4, 0), turn * Vector3d (0, 8, 0), {0, 0, 3}}));
  }
  UpAxisParameters parameters;
  parameters.min_confidence = 0.0;
  EXPECT_FALSE (estimateUpAxis (planes, eye, parameters));
}

TEST (UpAxis, MayBeDownWhereFewPlanesFaceUpOrTheseAreNotLevel)
{
  // A landing of 1 m x 0.4 m in the middle between two walls, which are 20 m apart: at
  // the mean height, so that as many points are high as low.
  const auto confidenceIfLandingRises = [] (double angle) {
    const Vector3d above_landing (10_m, 2_m, 1.5_m);
    const Vector3d along (std::cos (angle), 0, std::sin (angle));
    const std::vector<PlaneSegment> planes{
        seenFrom (above_landing,
                  {Vector3d (10, 1.8, 1) - 0.5 * along, along, {0, 0.4, 0}}),
        seenFrom (above_landing, {{0, 0, 0}, {0, 4, 0}, {0, 0, 2}}),
        seenFrom (above_landing, {{20, 0, 0}, {0, 4, 0}, {0, 0, 2}})};
    UpAxisParameters parameters;
    parameters.min_confidence = 0.0;
    const UpAxis found = estimateUpAxis (planes, above_landing, parameters).value();
    expectUp (found, 1_deg);
    return found.confidence;
  };
  const double level = confidenceIfLandingRises (0.0);
  EXPECT_GT (level, 0.7);
  EXPECT_LT (level, 0.82);
  EXPECT_LT (confidenceIfLandingRises (5_deg), level - 0.1)
      << "near the tolerance of 7 degrees it hardly counts";
}

TEST (UpAxis, IsWhereTheSensorLooksLeastInTheCornerOfACube)
{
  const std::vector<Surface> faces{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
                                   {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}},
                                   {{0, 0, 0}, {0, 0, 2}, {2, 0, 0}}};
  const Vector3d mean = Vector3d::Constant (2.0 / 3.0); // of all points
  // The sensor looks along all three edges, but along z a quarter less.
  const Vector3d viewpoint = mean + Vector3d (1, 1, 0.75);
  const UpAxis found = upAxisSeenFrom (viewpoint, faces);
  expectUp (found, 0.1_deg);
  EXPECT_GT (found.confidence, 0.55);
  EXPECT_LT (found.confidence, 0.8);
}

TEST (UpAxis, IsWhereARoomExtendsLeast)
{
  // The corner of a cube that is lower than wide, seen from the mean of its points: the
  // sensor looks along none of the edges.
  const std::vector<Surface> faces{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
                                   {{0, 0, 0}, {0, 2, 0}, {0, 0, 1.6}},
                                   {{0, 0, 0}, {0, 0, 1.6}, {2, 0, 0}}};
  const Vector3d mean (0.69, 0.69, 0.49);
  const UpAxis found = upAxisSeenFrom (mean, faces);
  expectUp (found, 0.1_deg);
  EXPECT_GT (found.confidence, 0.6);
  EXPECT_LT (found.confidence, 0.9);
}

TEST (UpAxis, IsWhereMostPlanesAreVerticalIfAsManyFaceOtherWays)
{
  // Three squares of 2 m x 2 m that cross in their middle, where the sensor is, each
  // across one of the axes; and four wings of a revolving door about the z axis, which
  // are 1 m high and stand across neither x nor y. The first square faces up.
  const Vector3d middle = Vector3d::Zero();
  std::vector<PlaneSegment> planes{
      seenFrom (middle, {{-1, -1, 0}, {0, 2, 0}, {2, 0, 0}}),
      seenFrom (middle, {{0, -1, -1}, {0, 2, 0}, {0, 0, 2}}),
      seenFrom (middle, {{-1, 0, -1}, {0, 0, 2}, {2, 0, 0}})};
  for (const double degrees : {30.0, 60.0, 120.0, 150.0}) {
    const Vector3d along =
        Eigen::AngleAxisd (degrees * 1_deg, up) * Vector3d (1.4, 0, 0);
    planes.push_back (seenFrom (middle, {-0.5 * (along + up), along, up}));
  }
  UpAxisParameters parameters;
  parameters.min_confidence = 0.0;
  expectUp (estimateUpAxis (planes, middle, parameters).value(), 0.1_deg);
}

TEST (UpAxis, CannotBeToldInTheCornerOfACube)
{
  // Seen along the diagonal, each of the three faces may be the floor.
  const Vector3d diagonal (3, 3, 3);
  const std::vector<PlaneSegment> planes{
      seenFrom (diagonal, {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}),
      seenFrom (diagonal, {{0, 0, 0}, {0, 2, 0}, {0, 0, 2}}),
      seenFrom (diagonal, {{0, 0, 0}, {0, 0, 2}, {2, 0, 0}})};
  EXPECT_FALSE (estimateUpAxis (planes, diagonal));
  UpAxisParameters parameters;
  parameters.min_confidence = 0.0;
  EXPECT_LE (estimateUpAxis (planes, diagonal, parameters).value().confidence, 0.34)
      << "a third for each of three directions";
}

TEST (UpAxis, IsWhereFewPointsAreHighIfAsManyPlanesFaceUpAsDown)
{
  // A yard of 4 m x 4 m seen from its middle, the mean of all points: the ground has
  // twice the points of two roofs above it. Their weights are the roots of the points,
  // as many on both sides. The middle of the walls is at the height of the sensor.
  const Vector3d middle (2_m, 2_m, 1_m);
  std::vector<PlaneSegment> planes;
  for (const Surface& surface : {Surface{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}},
                                 Surface{{0, 0, 3}, {2, 0, 0}, {0, 2, 0}},
                                 Surface{{2, 2, 3}, {2, 0, 0}, {0, 2, 0}},
                                 Surface{{0, 0, 0}, {0, 4, 0}, {0, 0, 2}},
                                 Surface{{4, 0, 0}, {0, 4, 0}, {0, 0, 2}}})
    planes.push_back (seenFrom (middle, surface));
  UpAxisParameters parameters;
  parameters.min_confidence = 0.0;
  const UpAxis found = estimateUpAxis (planes, middle, parameters).value();
  expectUp (found, 0.1_deg);
  EXPECT_GT (found.confidence, 0.6) << "that of down is less";
  EXPECT_LT (found.confidence, 0.85) << "but it may be down";
}

TEST (UpAxis, CannotBeToldAllAroundARoomWithACeiling)
{
  const Vector3d middle (3_m, 2_m, 1.3_m);
  const Surface ceiling{{0, 0, 2.8}, {6, 0, 0}, {0, 4, 0}};
  const Surface lamp{{1, 1, 2.6}, {2, 0, 0}, {0, 2, 0}};
  const Surface free_ground{{2, 1.5, 0}, {2, 0, 0}, {0, 1, 0}};
  const Surface wall_behind{{0, 0, 0}, {0, 4, 0}, {0, 0, 2.8}};
  const Surface high_wall_ahead{{6, 0, 0}, {0, 4, 0}, {0, 0, 2.8}};
  const Surface other_wall{{0, 4, 0}, {6, 0, 0}, {0, 0, 2.8}};
  std::vector<PlaneSegment> planes;
  for (const Surface& surface :
       {ceiling, lamp, wall_behind, high_wall_ahead, other_wall, wall_beside})
    planes.push_back (seenFrom (middle, surface));
  EXPECT_TRUE (estimateUpAxis (planes, middle)) << "no floor was seen";
  planes.push_back (seenFrom (middle, free_ground));
  EXPECT_FALSE (estimateUpAxis (planes, middle));
}

TEST (UpAxis, IsToldThoughACeilingIsSeenIfTheSensorLooksAhead)
{
  // A room of 6 m x 4 m. From its middle the sensor looks in all directions; 1 m from
  // one end it mostly looks along the room.
  for (const double x : {3_m, 1_m}) {
    const Vector3d sensor (x, 2_m, 1.2_m);
    std::vector<PlaneSegment> planes;
    for (const Surface& surface : {room_floor,
                                   wall_ahead,
                                   wall_beside,
                                   Surface{{0, 4, 0}, {6, 0, 0}, {0, 0, 2.4}},
                                   Surface{{2, 1, 2.4}, {2, 0, 0}, {0, 2, 0}}})
      planes.push_back (seenFrom (sensor, surface));
    EXPECT_EQ (estimateUpAxis (planes, sensor).has_value(), x < 2_m);
  }
}

TEST (UpAxis, RefusesWhatIsNotFiniteOrOutOfItsRangeAndLeavesOutBrokenPlanes)
{
  for (const Vector3d& nowhere : {Vector3d (NAN, 0, 0), Vector3d (0, INFINITY, 0)})
    EXPECT_FALSE (estimateUpAxis (furnishedRoom(), nowhere));
  UpAxisParameters in_degrees;
  in_degrees.angle_tolerance = 7.0; // has to be in radians
  EXPECT_FALSE (estimateUpAxis (furnishedRoom(), eye, in_degrees));
  std::vector<PlaneSegment> planes = furnishedRoom();
  planes.push_back (PlaneSegment()); // no points
  planes.push_back (planes.front());
  planes.back().normal.x() = NAN;
  EXPECT_EQ (estimateUpAxis (planes, eye).value().confidence,
             estimateUpAxis (furnishedRoom(), eye).value().confidence);
}

TEST (NameOrientations, NamesPlanesForAnAxisUnlessItIsNone)
{
  std::vector<PlaneSegment> planes = furnishedRoom();
  ASSERT_TRUE (nameOrientations (planes, {1, 0, 1}, 7_deg));
  EXPECT_EQ (planes[0].orientation, Orientation::Other);
  ASSERT_TRUE (nameOrientations (planes, 5.0 * up, 7_deg));
  EXPECT_FALSE (nameOrientations (planes, Vector3d::Zero(), 7_deg));
  EXPECT_FALSE (nameOrientations (planes, {NAN, 0, 1}, 7_deg));
  EXPECT_FALSE (nameOrientations (planes, up, -1_deg));
  EXPECT_FALSE (nameOrientations (planes, up, NAN));
  EXPECT_EQ (planes[0].orientation, Orientation::Horizontal);
  EXPECT_EQ (planes[1].orientation, Orientation::Vertical);
}
