// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene.h"
#include <pcl_ops/detect_planes.h>
#include <pcl_ops/result_warnings.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

using namespace pcl_ops;

namespace {

/** \brief Points on surfaces, with the planes that a detector would find. */
struct LabelledPlaneScene {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  std::vector<PlaneSegment> planes;
  RandomGenerator generator = RandomGenerator (seedOfTest());

  /** \brief Adds a plane: points on a surface.
   * \param[in] noise standard deviation along the normal [m] */
  LabelledPlaneScene&
  add (const Surface& surface, std::size_t points, double noise)
  {
    planes.push_back (planeOn (surface, points, noise));
    return *this;
  }

  /** \brief Adds points on a surface, but no plane of them. */
  LabelledPlaneScene&
  addUnassigned (const Surface& surface, std::size_t points, double noise)
  {
    planeOn (surface, points, noise);
    return *this;
  }

  /** \brief Adds points on a surface to the cloud and returns their plane. */
  PlaneSegment
  planeOn (const Surface& surface, std::size_t points, double noise)
  {
    PlaneSegment plane;
    plane.centroid = plane.moments.origin = surface.center();
    plane.normal = surface.normal();
    for (std::size_t i = 0; i < points; ++i) {
      const Eigen::Vector3d point = drawPointOf (surface, noise, generator);
      const Eigen::Vector3d offset = point - plane.centroid;
      plane.moments.add (offset.x(), offset.y(), offset.z());
      plane.inliers.push_back (static_cast<pcl::index_t> (cloud.size()));
      cloud.push_back (toPoint (point));
    }
    plane.noise = noise;
    plane.orientation =
        orientationOf (plane.normal, Eigen::Vector3d::UnitZ(), paper_angle_tolerance);
    return plane;
  }

  std::vector<ResultWarning>
  warnings (const ResultContext& context = ResultContext()) const
  {
    return resultWarnings (cloud, planes, context);
  }

  /** \brief The codes of all warnings, e.g. "thick-planes unit". */
  std::string
  codes (const ResultContext& context = ResultContext()) const
  {
    std::string codes;
    for (const ResultWarning& warning : warnings (context))
      codes += (codes.empty() ? "" : " ") + warning.code;
    return codes;
  }
};

/** \brief Whether a text has a part; a failure shows the text. */
testing::AssertionResult
contains (const std::string& text, const std::string& part)
{
  return testing::AssertionResult (text.find (part) != std::string::npos)
         << "the text: " << text;
}

const Surface floor_of_room = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
const Surface wall_of_room = {{0, 3, 0}, {4, 0, 0}, {0, 0, 2.5}};

LabelledPlaneScene
roomOfTwoPlanes ()
{
  return LabelledPlaneScene()
      .add (floor_of_room, 3000, 2_mm)
      .add (wall_of_room, 2500, 2_mm);
}

} // namespace

TEST (ResultWarnings, AreNoneOfAnOrdinaryRoom)
{
  EXPECT_EQ (roomOfTwoPlanes().codes(), "");
}

TEST (ResultWarnings, SayThatCoordinatesOfUtmStepInSinglePrecision)
{
  const auto codes = [] (double east) {
    LabelledPlaneScene room;
    // Points are 6 cm apart.
    room.add ({{east, 0, 0}, {4, 0, 0}, {0, 3, 0}}, 3000, 2_mm);
    room.cloud[0].x = 0.0f; // a stray point tells nothing
    return room.codes();
  };
  EXPECT_EQ (codes (-500000.0), "coarse-coordinates") << "steps of 3 cm";
  EXPECT_EQ (codes (100000.0), "") << "steps of 8 mm";
  LabelledPlaneScene shifted = roomOfTwoPlanes();
  ResultContext context;
  context.shift = {500000.0, 5400000.0, 0.0};
  for (PlaneSegment& plane : shifted.planes)
    plane.moveBy (context.shift);
  EXPECT_EQ (shifted.codes (context), "") << "the cloud itself is near its zero";
}

TEST (ResultWarnings, SayNothingOfStepsWherePointsAreOnALineOrAtOnePlace)
{
  for (const double length : {0.0, 1_m}) {
    LabelledPlaneScene line;
    for (int i = 0; i < 1000; ++i)
      line.cloud.push_back (toPoint ({length * i, 0.0, 0.0}));
    EXPECT_FALSE (contains (line.codes(), "coarse-coordinates")) << length;
  }
}

TEST (ResultWarnings, AreNoneOfNoPoints)
{
  EXPECT_TRUE (resultWarnings ({}, {}).empty());
}

TEST (ResultWarnings, SayThatPlanesAreThickerThanThreeNoises)
{
  LabelledPlaneScene hill;
  hill.add ({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, 3000, 1.0);
  hill.planes[0].noise = 0.06;
  ASSERT_EQ (hill.codes(), "thick-planes");
  const std::string text = hill.warnings()[0].text;
  EXPECT_TRUE (contains (text, "100 % of the points on planes"));
  EXPECT_TRUE (contains (text, "; for thinner planes give --threshold 0.18"));
}

TEST (ResultWarnings, AreNoneOfPlanesAsThickAsThreeNoisesOrAnEighthOfTheirSpacing)
{
  // 3025 points on 100 m x 100 m: 1.8 m apart, an eighth of which is 0.23 m.
  const auto codes = [] (double rms, double noise) {
    LabelledPlaneScene hill;
    hill.add ({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, 3025, rms);
    hill.planes[0].noise = noise;
    return hill.codes();
  };
  EXPECT_EQ (codes (1.0, 1.0 / 2.7), "");
  EXPECT_EQ (codes (1.0, 1.0 / 3.3), "thick-planes");
  EXPECT_EQ (codes (0.2, 0.01), "");
  EXPECT_EQ (codes (0.26, 0.01), "thick-planes");
}

TEST (ResultWarnings, TellRmsAndNoiseOfTheLargestThickPlane)
{
  LabelledPlaneScene hills;
  const struct {
    double x; // where the hill begins [m]
    double rms;
    std::size_t points;
  } rows[] = {{0.0, 0.5, 2000}, {200.0, 1.0, 4000}, {400.0, 0.7, 3000}};
  for (const auto& row : rows) {
    hills.add ({{row.x, 0, 0}, {100, 0, 0}, {0, 100, 0}}, row.points, row.rms);
    hills.planes.back().noise = 0.1 * row.rms;
  }
  ASSERT_EQ (hills.codes(), "thick-planes");
  const std::string text = hills.warnings()[0].text;
  EXPECT_TRUE (contains (text, "noise 0.1 of the largest"));
}

TEST (ResultWarnings, NameParametersAsPythonDoes)
{
  LabelledPlaneScene hill;
  hill.add ({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, 3000, 1.0);
  hill.planes[0].noise = 0.06;
  ResultContext context;
  context.names = ParameterNames::Python;
  ASSERT_EQ (hill.codes (context), "thick-planes");
  const std::string text = hill.warnings (context)[0].text;
  EXPECT_TRUE (contains (text, "give distance_threshold=0.18"));
}

TEST (ResultWarnings, SayThatPlanesOfNoRmsLieOneBehindAnother)
{
  LabelledPlaneScene levels;
  for (const double depth : {3.0, 3.03, 3.06})
    levels.add ({{0, 0, depth}, {2, 0, 0}, {0, 2, 0}}, 1500, 0.0);
  ASSERT_EQ (levels.codes(), "exact-levels");
  const std::string text = levels.warnings()[0].text;
  EXPECT_TRUE (contains (text, "3 planes have an rms of 0"));
  EXPECT_TRUE (contains (text, "use --method ops without --voxel-size"));
  ResultContext of_default;
  of_default.search = OrientedPointSamplingParameters();
  const std::string by_default = levels.warnings (of_default)[0].text;
  EXPECT_TRUE (contains (by_default, "give --voxel-size 0.15"));
}

TEST (ResultWarnings, AreNoneOfAModelWithoutNoise)
{
  // A shelf of three boards with a side. As the side faces another way, the boards are
  // faces of a model and no levels.
  EXPECT_EQ (LabelledPlaneScene()
                 .add ({{0, 0, 0.5}, {4, 0, 0}, {0, 3, 0}}, 3000, 0.0)
                 .add ({{0, 0, 0.25}, {4, 0, 0}, {0, 3, 0}}, 3000, 0.0)
                 .add (floor_of_room, 3000, 0.0)
                 .add (wall_of_room, 2500, 0.0)
                 .codes(),
             "");
}

TEST (ResultWarnings, AreNoneOfAModelWhoseSidesAreSmall)
{
  // Plates of 4 m x 3 m with a rim of 0.25 m at one side.
  LabelledPlaneScene plates;
  for (const double height : {0.0, 0.25, 0.5})
    plates.add ({{0, 0, height}, {4, 0, 0}, {0, 3, 0}}, 3000, 0.0);
  EXPECT_EQ (plates.codes(), "exact-levels");
  plates.add ({{0, 3, 0}, {4, 0, 0}, {0, 0, 0.25}}, 250, 0.0);
  EXPECT_EQ (plates.codes(), "");
}

TEST (ResultWarnings, AreNoneOfLevelsWithLessThan5PerCentOfThePointsOnPlanes)
{
  const auto codesWithWall = [] (std::size_t points) {
    LabelledPlaneScene levels;
    for (const double depth : {3.0, 3.03, 3.06})
      levels.add ({{0, 0, depth}, {2, 0, 0}, {0, 2, 0}}, 1200, 0.0);
    return levels.add ({{0, 0, 5}, {4, 0, 0}, {0, 3, 0}}, points, 2_mm).codes();
  };
  EXPECT_EQ (codesWithWall (60'000), "exact-levels");
  EXPECT_EQ (codesWithWall (80'000), "");
}

TEST (ResultWarnings, AreNoneOfAThinWallWithoutNoise)
{
  EXPECT_EQ (LabelledPlaneScene()
                 .add ({{0, 0, 0}, {4, 0, 0}, {0, 0, 2.5}}, 1500, 0.0)
                 .add ({{0, 0.2, 0}, {4, 0, 0}, {0, 0, 2.5}}, 1500, 0.0)
                 .codes(),
             "");
}

TEST (ResultWarnings, AreNoneOfExactPlanesFartherApartThanATenthOfTheirWidth)
{
  const auto codesWithStep = [] (double step) {
    LabelledPlaneScene plates; // 2 m x 2 m each
    for (const int level : {0, 1, 2})
      plates.add ({{0, 0, level * step}, {2, 0, 0}, {0, 2, 0}}, 1500, 0.0);
    return plates.codes();
  };
  EXPECT_EQ (codesWithStep (17_cm), "exact-levels");
  EXPECT_EQ (codesWithStep (23_cm), "");
}

TEST (ResultWarnings, AreNoneOfExactPlanesBesideEachOther)
{
  const auto codesWithDistance = [] (double meters) {
    LabelledPlaneScene plates; // 2 m x 2 m each, 3 cm above the one before
    for (const int plate : {0, 1, 2})
      plates.add ({{plate * meters, 0, 3_cm * plate}, {2, 0, 0}, {0, 2, 0}}, 1500, 0.0);
    return plates.codes();
  };
  EXPECT_EQ (codesWithDistance (1.5), "exact-levels");
  EXPECT_EQ (codesWithDistance (2.5), "");
}

TEST (ResultWarnings, AreNoneOfStairsWithoutNoise)
{
  LabelledPlaneScene stairs;
  for (const int step : {0, 1, 2})
    stairs.add ({{0, 0.3 * step, 0.17 * step}, {2, 0, 0}, {0, 0.3, 0}}, 1500, 0.0);
  EXPECT_EQ (stairs.codes(), "");
}

TEST (ResultWarnings, SayThatLabelsAreMixedPointByPoint)
{
  LabelledPlaneScene wall;
  wall.add (wall_of_room, 2500, 5_mm);
  Surface again = wall_of_room;
  again.corner.y() += 2_mm;
  wall.add (again, 2500, 5_mm);
  ASSERT_EQ (wall.codes(), "mixed-labels");
  const std::string text = wall.warnings()[0].text;
  EXPECT_TRUE (
      contains (text, "planes 1 and 2; for one plane give --merge-distance 0.00"));
}

TEST (ResultWarnings, AreNoneOfPlanesThatMeet)
{
  LabelledPlaneScene room = roomOfTwoPlanes();
  room.add ({{0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 2000, 2_mm);
  EXPECT_EQ (room.codes(), "");
}

namespace {

/** \brief A room of which a floor and a wall are found, but not a wall of 10 cm: the
 * 3,000 points of each of its sides are on no plane. */
LabelledPlaneScene
roomWithThinWall ()
{
  LabelledPlaneScene room = roomOfTwoPlanes();
  room.addUnassigned ({{1, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 3000, 2_mm);
  room.addUnassigned ({{1.1, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 3000, 2_mm);
  return room;
}

} // namespace

TEST (ResultWarnings, SayWhichSamplingRatePutsPointsOnPlanes)
{
  ResultContext context;
  EXPECT_EQ (roomWithThinWall().codes (context), "") << "a search that is not known";
  context.search = OrientedPointSamplingParameters();
  ASSERT_EQ (roomWithThinWall().codes (context), "unassigned-points");
  const std::string text = roomWithThinWall().warnings (context)[0].text;
  EXPECT_TRUE (contains (text, "52 % of the points are on no plane"));
  EXPECT_TRUE (contains (text, " give --sampling-rate 0.3"));
}

TEST (ResultWarnings, DoNotCallTheObserverOfTheSearch)
{
  ResultContext context;
  context.search = OrientedPointSamplingParameters();
  int calls = 0;
  context.search->on_stage = [&calls] (const StageResult&) { ++calls; };
  ASSERT_EQ (roomWithThinWall().codes (context), "unassigned-points");
  EXPECT_EQ (calls, 0);
}

TEST (ResultWarnings, SayWhichGivenValueLeavesPointsOut)
{
  LabelledPlaneScene room = roomOfTwoPlanes();
  room.addUnassigned ({{0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 5000, 2_mm);
  ResultContext context;
  context.search = OrientedPointSamplingParameters();
  context.search->min_points = 1'000'000;
  ASSERT_EQ (room.codes (context), "unassigned-points");
  const std::string text = room.warnings (context)[0].text;
  EXPECT_TRUE (contains (text, "on planes leave out --min-points"));
}

TEST (ResultWarnings, AdviseAnotherValueOnlyIfItPuts20PerCentMoreOnPlanes)
{
  // 20,000 points: a floor and a wall, another wall on no plane, and a tree.
  const auto codesWithWall = [] (std::size_t points) {
    LabelledPlaneScene garden;
    garden.add (floor_of_room, 6000, 2_mm).add (wall_of_room, 4000, 2_mm);
    garden.addUnassigned ({{0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, points, 2_mm);
    garden.addUnassigned (
        {{9, 9, 1}, {1, 0.1, 0}, {-0.1, 1, 0}}, 10'000 - points, 50_cm);
    ResultContext context;
    context.search = OrientedPointSamplingParameters();
    context.search->min_points = 1'000'000;
    return garden.codes (context);
  };
  EXPECT_EQ (codesWithWall (3000), "") << "15 %";
  EXPECT_EQ (codesWithWall (5000), "unassigned-points") << "25 %";
}

TEST (ResultWarnings, AreNoneOfPointsOnNoPlaneThatNoValuePutsOnOne)
{
  LabelledPlaneScene tree = roomOfTwoPlanes();
  for (int i = 0; i < 10; ++i)
    tree.addUnassigned ({{1, 1, 0.2 * i}, {1, 0.1, 0}, {-0.1, 1, 0}}, 600, 20_cm);
  ResultContext context;
  context.search = OrientedPointSamplingParameters();
  EXPECT_EQ (tree.codes (context), "");
}

TEST (ResultWarnings, SayWhichVoxelSizeMakesPlanesOfTilesThinner)
{
  LabelledPlaneScene hill;
  hill.add ({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, 3000, 1.0);
  hill.planes[0].noise = 0.06;
  ResultContext context;
  context.tiles.emplace().voxel_size = 3.0;
  ASSERT_EQ (hill.codes (context), "thick-planes");
  const std::string text = hill.warnings (context)[0].text;
  EXPECT_TRUE (contains (text, "for thinner planes give --voxel-size 1.5"));
}

TEST (ResultWarnings, CompareThicknessWithTheSpacingOfTheSurveyNotOfItsSample)
{
  LabelledPlaneScene hill; // 5.8 m between points, 0.58 m in the survey
  hill.add ({{0, 0, 0}, {100, 0, 0}, {0, 100, 0}}, 300, 0.5);
  hill.planes[0].noise = 0.06;
  ResultContext context;
  context.tiles.emplace();
  EXPECT_EQ (hill.codes (context), "");
  context.tiles->sampled_share = 0.01;
  EXPECT_EQ (hill.codes (context), "thick-planes");
}

TEST (ResultWarnings, SayWhichVoxelSizePutsPlacesOfTilesOnPlanes)
{
  const Surface board = {{0, 5, 0}, {2, 0, 0}, {0, 0, 2}};
  LabelledPlaneScene boards;
  boards.add (floor_of_room, 2000, 2_mm).addUnassigned (board, 4000, 2_mm);
  const LabelledPlaneScene around_board = LabelledPlaneScene().add (board, 4000, 2_mm);
  LabelledPlaneScene tree;
  for (int i = 0; i < 10; ++i)
    tree.add ({{1, 1, 0.2 * i}, {1, 0.1, 0}, {-0.1, 1, 0}}, 600, 20_cm);
  ResultContext context;
  TiledSearch& tiles = context.tiles.emplace();
  tiles.voxel_size = 0.4;
  tiles.places_on_none = {around_board.cloud};
  ASSERT_EQ (boards.codes (context), "unassigned-points");
  const std::string text = boards.warnings (context)[0].text;
  EXPECT_TRUE (contains (text, "67 % of the points are on no plane; for some "));
  EXPECT_TRUE (contains (text, " on planes give --voxel-size 0.2"));
  tiles.places_on_none.push_back (tree.cloud);
  EXPECT_EQ (boards.codes (context), "") << "of two samples one is a tree";
}

TEST (ResultWarnings, SayThatACloudLooksLikeMillimeters)
{
  LabelledPlaneScene room;
  room.add ({{0, 0, 0}, {4000, 0, 0}, {0, 3000, 0}}, 3000, 2.0);
  room.add ({{0, 3000, 0}, {4000, 0, 0}, {0, 0, 2500}}, 2500, 2.0);
  ASSERT_EQ (room.codes(), "millimeters");
  const std::string text = room.warnings()[0].text;
  EXPECT_TRUE (contains (text, "3900 x 2900 x 2400 wide"));
  EXPECT_TRUE (contains (text, "; give --meter 1000"));
  ResultContext context;
  context.has_meter = true;
  EXPECT_EQ (room.codes (context), "");
}

TEST (ResultWarnings, TakeACloudWiderThan1000AlongAllAxesForOneInMillimeters)
{
  const auto codes = [] (double height) {
    return LabelledPlaneScene()
        .add ({{0, 0, 0}, {4000, 0, 0}, {0, 3000, 0}}, 3000, 2.0)
        .add ({{0, 3000, 0}, {4000, 0, 0}, {0, 0, height}}, 3000, 2.0)
        .codes();
  };
  EXPECT_EQ (codes (900.0), "");
  EXPECT_EQ (codes (1200.0), "millimeters");
}

TEST (ResultWarnings, AreNoneOfASurveyOfAKilometer)
{
  EXPECT_EQ (LabelledPlaneScene()
                 .add ({{0, 0, 0}, {2000, 0, 0}, {0, 3000, 300}}, 5000, 0.05)
                 .codes(),
             "");
}

TEST (ResultWarnings, SayThatAReferenceSystemIsInFeetOrDegrees)
{
  ResultContext context;
  context.unit = CoordinateUnit::Foot;
  ASSERT_EQ (roomOfTwoPlanes().codes (context), "feet");
  const std::string text = roomOfTwoPlanes().warnings (context)[0].text;
  EXPECT_TRUE (contains (text, "; give --meter 3.2808"));
  context.has_meter = true;
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "");
  context.unit = CoordinateUnit::Degree;
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "degrees") << "no meter mends these";
}

TEST (ResultWarnings, SayThatAWidthOfDegreesHasAHeightOfMeters)
{
  const LabelledPlaneScene wall_in_degrees = LabelledPlaneScene().add (
      {{11, 48, 498}, {1e-4, 1e-5, 0}, {0, 0, 2.5}}, 3000, 0.0);
  EXPECT_EQ (wall_in_degrees.codes(), "degrees");
  ResultContext in_meters;
  in_meters.unit = CoordinateUnit::Meter;
  EXPECT_EQ (wall_in_degrees.codes (in_meters), "");
  ResultContext beyond_degrees;
  beyond_degrees.shift = {512345, 5412345, 0};
  EXPECT_EQ (wall_in_degrees.codes (beyond_degrees), "");
}

TEST (ResultWarnings, TakeLessThanADegreeWith200TimesTheHeightForDegrees)
{
  const auto codes = [] (double width, double height) {
    return LabelledPlaneScene()
        .add ({{11, 48, 498}, {width, 0.1 * width, 0}, {0, 0, height}}, 3000, 0.0)
        .codes();
  };
  EXPECT_EQ (codes (0.1, 15.0), "");
  EXPECT_EQ (codes (0.1, 30.0), "degrees");
  EXPECT_EQ (codes (0.9, 300.0), "degrees");
  EXPECT_EQ (codes (1.2, 300.0), "");
}

TEST (ResultWarnings, SayThatPosesAreOfACamera)
{
  ResultContext context;
  context.has_camera_poses = true;
  ASSERT_EQ (roomOfTwoPlanes().codes (context), "camera-poses");
  const std::string text = roomOfTwoPlanes().warnings (context)[0].text;
  EXPECT_TRUE (contains (text, "; give --calib calib.txt"));
}

TEST (ResultWarnings, SayThatACloudWasNotSeenFromItsViewpoint)
{
  // Four boards, each behind the one before. Seen from the given viewpoint the first
  // would hide the others.
  LabelledPlaneScene boards;
  for (const double depth : {1.0, 2.0, 3.0, 4.0})
    boards.add ({{-1, depth, 0}, {2, 0, 0}, {0, 0, 2}}, 4000, 2_mm);
  ResultContext context;
  EXPECT_EQ (boards.codes (context), "") << "no viewpoint was given";
  context.viewpoint = Eigen::Vector3d (0, -1, 1);
  ASSERT_EQ (boards.codes (context), "viewpoint");
  const std::string text = boards.warnings (context)[0].text;
  EXPECT_TRUE (contains (text, "VIEWPOINT 0,-1,1"));
  EXPECT_TRUE (contains (text, "or 0 0 0 if it is not known"));
  context.viewpoint = Eigen::Vector3d (2, 1, 1);
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "") << "from within the room";
}

TEST (ResultWarnings, SayThatKindsNeedToKnowWhichWayIsUp)
{
  // In the frame of a camera: y points down, z ahead.
  LabelledPlaneScene seen;
  seen.add ({{-2, 1, 1}, {4, 0, 0}, {0, 0, 3}}, 3000, 2_mm);
  seen.add ({{-2, 1, 4}, {4, 0, 0}, {0, -2.5, 0}}, 3000, 2_mm);
  ResultContext context;
  context.up_knowledge = UpKnowledge::Assumed;
  EXPECT_EQ (seen.codes (context), "") << "kinds that nobody asked for";
  context.uses_kinds = true;
  ASSERT_EQ (seen.codes (context), "unknown-up");
  const std::string text = seen.warnings (context)[0].text;
  EXPECT_TRUE (
      contains (text, "0,0,1 is ahead in a cloud that looks like a depth camera's"));
  EXPECT_TRUE (contains (text, "; give --up auto or --up x,y,z"));
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "") << "z as it mostly is";
  LabelledPlaneScene roof;
  roof.add ({{50, 50, 20}, {8, 0, 0}, {0, 4, 3}}, 1000, 2_cm);
  EXPECT_EQ (roof.codes (context), "") << "no floor, but no camera either";
  context.suggested_up = Eigen::Vector3d (0, -1, 0);
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "unknown-up");
  context.up_knowledge = UpKnowledge::NotFound;
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "unknown-up");
  context.up_knowledge = UpKnowledge::Known;
  EXPECT_EQ (seen.codes (context), "");
}

TEST (ResultWarnings, TakeTheLowestLevelOf3PerCentOfThePointsForAFloor)
{
  ResultContext context;
  context.up_knowledge = UpKnowledge::Assumed;
  context.uses_kinds = true;
  const auto codesWithLevel = [&] (std::size_t points) {
    return LabelledPlaneScene()
        .add ({{-2, 1, 1}, {4, 0, 0}, {0, 0, 3}}, 6000, 2_mm)
        .add ({{-0.1, 0.1, 0.5}, {0.2, 0, 0}, {0, 0.2, 0}}, points, 2_mm)
        .codes (context);
  };
  EXPECT_EQ (codesWithLevel (240), "");
  EXPECT_EQ (codesWithLevel (120), "unknown-up");
}

TEST (ResultWarnings, TakeNoLevelForAFloorThat10PerCentOfThePointsAreBelow)
{
  ResultContext context;
  context.up_knowledge = UpKnowledge::Assumed;
  context.uses_kinds = true;
  const auto codesWithPointsBelow = [&] (std::size_t points) {
    return LabelledPlaneScene()
        .add ({{-2, 1, 1}, {4, 0, 0}, {0, 0, 3}}, 6000, 2_mm)
        .add ({{-0.1, 0.1, 0.5}, {0.2, 0, 0}, {0, 0.2, 0}}, 500, 2_mm)
        .addUnassigned ({{-0.1, 0.1, 0.3}, {0.2, 0, 0}, {0, 0.2, 0}}, points, 2_mm)
        .codes (context);
  };
  EXPECT_EQ (codesWithPointsBelow (400), "") << "6 %";
  EXPECT_EQ (codesWithPointsBelow (1000), "unknown-up") << "13 %";
}

TEST (ResultWarnings, SayWhyAFloorPlanHasNoWall)
{
  const auto textOf = [] (const PlanCounts& counts, const LabelledPlaneScene& scene) {
    ResultContext context;
    context.plan = counts;
    const std::vector<ResultWarning> warnings = scene.warnings (context);
    return warnings.empty() ? "" : warnings[0].code + ": " + warnings[0].text;
  };
  const auto expectBegin = [&] (const PlanCounts& counts, const std::string& begin) {
    const std::string text = textOf (counts, roomOfTwoPlanes());
    EXPECT_EQ (text.substr (0, begin.size()), begin);
  };
  // PlanCounts: walls of the plan, planes that are walls before and after filters, and
  // whether there is a floor.
  expectBegin (
      {0, 0, 0, false},
      "empty-plan: the floor plan has 0 walls: no plane is a wall and none a floor; "
      "give --up");
  expectBegin ({0, 0, 0, true},
               "empty-plan: the floor plan has 0 walls: no plane is a wall; give --up");
  expectBegin (
      {0, 12, 0, true},
      "empty-plan: the floor plan has 0 walls: filters drop all planes that are "
      "walls (12); leave them out");
  expectBegin (
      {0, 12, 12, true},
      "empty-plan: the floor plan has 0 walls: none of the planes that are walls "
      "(12) is where it is cut; give another --plan-height");
  EXPECT_EQ (textOf ({3, 12, 12, true}, roomOfTwoPlanes()), "");
  LabelledPlaneScene wall_in_millimeters;
  wall_in_millimeters.add ({{0, 3000, 0}, {4000, 2000, 0}, {0, 0, 2500}}, 2500, 2.0);
  EXPECT_NE (
      textOf ({0, 0, 0, true}, wall_in_millimeters).find ("looks like millimeters"),
      std::string::npos);
}

TEST (ResultWarnings, AreTheThreeMostImportant)
{
  LabelledPlaneScene room;
  room.add ({{0, 3000, 0}, {4000, 2000, 0}, {0, 0, 2500}}, 2500, 200.0);
  room.planes[0].noise = 2.0;
  ResultContext context;
  context.has_camera_poses = true;
  context.up_knowledge = UpKnowledge::NotFound;
  context.uses_kinds = true;
  EXPECT_EQ (room.codes (context), "millimeters camera-poses unknown-up");
  context.max_warnings = 10;
  EXPECT_EQ (room.codes (context), "millimeters camera-poses unknown-up thick-planes");
}

TEST (ResultWarnings, DoNotDependOnTheOrderOfThePoints)
{
  LabelledPlaneScene wall;
  wall.add (wall_of_room, 2500, 5_mm).add (wall_of_room, 2500, 5_mm);
  LabelledPlaneScene reversed = wall;
  std::reverse (reversed.cloud.begin(), reversed.cloud.end());
  for (PlaneSegment& plane : reversed.planes) {
    for (pcl::index_t& index : plane.inliers)
      index = static_cast<pcl::index_t> (wall.cloud.size()) - 1 - index;
    std::reverse (plane.inliers.begin(), plane.inliers.end());
  }
  ASSERT_EQ (wall.warnings().size(), 1U);
  EXPECT_EQ (wall.warnings()[0].text, reversed.warnings()[0].text);
}

TEST (ResultWarnings, RefuseInliersOfAnotherCloud)
{
  LabelledPlaneScene room = roomOfTwoPlanes();
  room.planes[0].inliers.back() = 1'000'000;
  EXPECT_THROW (room.warnings(), std::invalid_argument);
}
