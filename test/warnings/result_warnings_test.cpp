// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "apps/support/text.h"
#include "scene.h"
#include <pcl_ops/detect_planes.h>
#include <pcl_ops/result_warnings.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

using namespace pcl_ops;

namespace {

/** \brief Points on surfaces, with the planes that a detector would find. The points of
 * a surface are drawn uniformly and moved along its normal by Gaussian noise. */
struct LabeledPlaneScene {
  pcl::PointCloud<pcl::PointXYZ> cloud;
  std::vector<PlaneSegment> planes;
  RandomGenerator generator = RandomGenerator (seedOfTest());

  /** \brief Adds a plane, with points on a surface.
   * \param[in] points their number
   * \param[in] noise standard deviation along the normal, and noise of the plane [m] */
  LabeledPlaneScene&
  add (const Surface& surface, std::size_t points, double noise)
  {
    planes.push_back (addPointsOf (surface, points, noise));
    return *this;
  }

  /** \brief Adds points on a surface, but no plane of them. */
  LabeledPlaneScene&
  addUnassigned (const Surface& surface, std::size_t points, double noise)
  {
    addPointsOf (surface, points, noise);
    return *this;
  }

  /** \brief Adds points on a surface to the cloud and returns their plane. */
  PlaneSegment
  addPointsOf (const Surface& surface, std::size_t points, double noise)
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

  /** \brief The codes of all warnings, e.g. "thick-planes feet"; empty without one. */
  std::string
  codes (const ResultContext& context = ResultContext()) const
  {
    std::string codes;
    for (const ResultWarning& warning : warnings (context))
      codes += (codes.empty() ? "" : " ") + warning.code;
    return codes;
  }

  /** \brief The text of the first warning; throws if there is none. */
  std::string
  firstText (const ResultContext& context = ResultContext()) const
  {
    return warnings (context).at (0).text;
  }
};

const Surface floor_of_room = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
const Surface wall_of_room = {{0, 3, 0}, {4, 0, 0}, {0, 0, 2.5}};

/** \brief Points on the floor and the wall, all on their planes. */
LabeledPlaneScene
roomOfTwoPlanes ()
{
  return LabeledPlaneScene()
      .add (floor_of_room, 3000, 2_mm)
      .add (wall_of_room, 2500, 2_mm);
}

/** \brief A level square of 100 m x 100 m that begins at x [m] and y = 0. */
Surface
squareOf100m (double x = 0.0)
{
  return {{x, 0, 0}, {100, 0, 0}, {0, 100, 0}};
}

/** \brief What is like a hill of 100 m x 100 m that was taken for one plane.
 * \param[in] rms distance of the points to the plane [m]
 * \param[in] noise of the points around the plane [m] */
LabeledPlaneScene
hillOf (std::size_t points, double rms, double noise)
{
  LabeledPlaneScene hill;
  hill.add (squareOf100m(), points, rms);
  hill.planes[0].noise = noise;
  return hill;
}

/** \brief Three exact planes of 2 m x 2 m, 3 cm one behind another, as levels of a
 * quantized depth.
 * \param[in] points of each level */
LabeledPlaneScene
threeLevels (std::size_t points)
{
  LabeledPlaneScene levels;
  for (const double depth : {3.0, 3.03, 3.06})
    levels.add ({{0, 0, depth}, {2, 0, 0}, {0, 2, 0}}, points, 0.0);
  return levels;
}

/** \brief 6000 points of a tree, on no plane: ten tilted squares of 1 m x 1 m, 20 cm
 * above each other, whose points scatter by as much. */
void
addTree (LabeledPlaneScene& scene)
{
  for (int i = 0; i < 10; ++i)
    scene.addUnassigned ({{1, 1, 0.2 * i}, {1, 0.1, 0}, {-0.1, 1, 0}}, 600, 20_cm);
}

} // namespace

TEST (ResultWarnings, AreNoneOfAnOrdinaryRoom)
{
  EXPECT_EQ (roomOfTwoPlanes().codes(), "");
}

TEST (ResultWarnings, SayThatCoordinatesOfUtmStepInSinglePrecision)
{
  const auto codesWithX = [] (double x) {
    LabeledPlaneScene floor;
    // Points are 6 cm apart; coordinates may have steps of a quarter of that.
    floor.add ({{x, 0, 0}, {4, 0, 0}, {0, 3, 0}}, 3000, 2_mm);
    floor.cloud[0].x = 0.0f; // a stray point, which must not count
    return floor.codes();
  };
  EXPECT_EQ (codesWithX (-500000.0), "coarse-coordinates") << "steps of 3 cm";
  EXPECT_EQ (codesWithX (100000.0), "") << "steps of 8 mm";
  LabeledPlaneScene shifted = roomOfTwoPlanes();
  ResultContext context;
  context.shift = {500000.0, 5400000.0, 0.0};
  for (PlaneSegment& plane : shifted.planes)
    plane.moveBy (context.shift);
  EXPECT_EQ (shifted.codes (context), "") << "the cloud itself is near its zero";
}

TEST (ResultWarnings, SayThatCoordinatesStepByMoreThanAQuarterOfTheSpacing)
{
  // At 500 km the steps are 3.1 cm.
  const auto codesWithPoints = [] (std::size_t points) {
    return LabeledPlaneScene()
        .add ({{-500000, 0, 0}, {4, 0, 0}, {0, 3, 0}}, points, 2_mm)
        .codes();
  };
  EXPECT_EQ (codesWithPoints (1500), "coarse-coordinates") << "points are 9 cm apart";
  EXPECT_EQ (codesWithPoints (500), "") << "points are 15 cm apart";
}

TEST (ResultWarnings, SayNothingOfStepsWherePointsAreOnALineOrAtOnePlace)
{
  for (const double spacing : {0.0, 1_m}) {
    LabeledPlaneScene line;
    for (int i = 0; i < 1000; ++i)
      line.cloud.push_back (toPoint ({spacing * i, 0.0, 0.0}));
    EXPECT_FALSE (contains (line.codes(), "coarse-coordinates")) << spacing;
  }
}

TEST (ResultWarnings, AreNoneOfNoPoints)
{
  EXPECT_TRUE (resultWarnings ({}, {}).empty());
}

TEST (ResultWarnings, SayThatPlanesAreThickerThanThreeNoises)
{
  const LabeledPlaneScene hill = hillOf (3000, 1_m, 6_cm);
  ASSERT_EQ (hill.codes(), "thick-planes");
  const std::string text = hill.firstText();
  // The advised threshold is three times the noise.
  EXPECT_TRUE (contains (text, "100 % of the points on planes"));
  EXPECT_TRUE (contains (text, "; for thinner planes give --threshold 0.18"));
}

TEST (ResultWarnings, AreNoneOfPlanesAsThickAsThreeNoisesOrAnEighthOfTheirSpacing)
{
  // 3025 points on 100 m x 100 m: 1.8 m apart, an eighth of which is 0.23 m.
  const auto codesOf = [] (double rms, double noise) {
    return hillOf (3025, rms, noise).codes();
  };
  EXPECT_EQ (codesOf (1_m, 1.0 / 2.7), "");
  EXPECT_EQ (codesOf (1_m, 1.0 / 3.3), "thick-planes");
  EXPECT_EQ (codesOf (20_cm, 1_cm), "");
  EXPECT_EQ (codesOf (26_cm, 1_cm), "thick-planes");
}

TEST (ResultWarnings, TellRmsAndNoiseOfTheLargestThickPlane)
{
  LabeledPlaneScene hills;
  const struct {
    double x;   // where the hill begins [m]
    double rms; // [m]
    std::size_t points;
  } rows[] = {{0.0, 0.5, 2000}, {200.0, 1.0, 4000}, {400.0, 0.7, 3000}};
  for (const auto& row : rows) {
    hills.add (squareOf100m (row.x), row.points, row.rms);
    hills.planes.back().noise = 0.1 * row.rms;
  }
  ASSERT_EQ (hills.codes(), "thick-planes");
  const std::string text = hills.firstText();
  const std::string before_rms = "(rms ";
  const std::size_t rms = text.find (before_rms) + before_rms.size();
  EXPECT_NEAR (std::stod (text.substr (rms)), 1_m, 10_cm) << text;
  EXPECT_TRUE (contains (text, "noise 0.1 of the largest"));
}

TEST (ResultWarnings, NameParametersAsPythonDoes)
{
  const LabeledPlaneScene hill = hillOf (3000, 1_m, 6_cm);
  ResultContext context;
  context.names = ParameterNames::Python;
  ASSERT_EQ (hill.codes (context), "thick-planes");
  const std::string text = hill.firstText (context);
  EXPECT_TRUE (contains (text, "give distance_threshold=0.18"));
}

TEST (ResultWarnings, SayThatPlanesOfNoRmsLieOneBehindAnother)
{
  const LabeledPlaneScene levels = threeLevels (1500);
  ASSERT_EQ (levels.codes(), "exact-levels");
  const std::string text = levels.firstText();
  EXPECT_TRUE (contains (text, "3 planes have an rms of 0"));
  EXPECT_TRUE (contains (text, "use --method ops without --voxel-size"));
  ResultContext default_search;
  default_search.search = OrientedPointSamplingParameters();
  const std::string text_by_default = levels.firstText (default_search);
  EXPECT_TRUE (contains (text_by_default, "give --voxel-size 0.15")) << "5 x 3 cm";
}

TEST (ResultWarnings, AreNoneOfAModelWithoutNoise)
{
  // A shelf of three boards and one side. As the side is not parallel to the boards,
  // they are faces of a model and no levels.
  EXPECT_EQ (LabeledPlaneScene()
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
  LabeledPlaneScene plates;
  for (const double height : {0.0, 0.25, 0.5})
    plates.add ({{0, 0, height}, {4, 0, 0}, {0, 3, 0}}, 3000, 0.0);
  EXPECT_EQ (plates.codes(), "exact-levels") << "without the rim";
  plates.add ({{0, 3, 0}, {4, 0, 0}, {0, 0, 0.25}}, 250, 0.0);
  EXPECT_EQ (plates.codes(), "");
}

TEST (ResultWarnings, AreNoneOfLevelsWithLessThan5PerCentOfThePointsOnPlanes)
{
  // The levels have 3600 points: 5.7 % or 4.3 % of those on planes.
  const auto codesWithWall = [] (std::size_t points_of_wall) {
    LabeledPlaneScene levels = threeLevels (1200);
    levels.add ({{0, 0, 5}, {4, 0, 0}, {0, 3, 0}}, points_of_wall, 2_mm);
    return levels.codes();
  };
  EXPECT_EQ (codesWithWall (60'000), "exact-levels");
  EXPECT_EQ (codesWithWall (80'000), "");
}

TEST (ResultWarnings, AreNoneOfAThinWallWithoutNoise)
{
  EXPECT_EQ (LabeledPlaneScene()
                 .add ({{0, 0, 0}, {4, 0, 0}, {0, 0, 2.5}}, 1500, 0.0)
                 .add ({{0, 0.2, 0}, {4, 0, 0}, {0, 0, 2.5}}, 1500, 0.0)
                 .codes(),
             "");
}

TEST (ResultWarnings, AreNoneOfExactPlanesFartherApartThanATenthOfTheirWidth)
{
  const auto codesWithStep = [] (double step) {
    LabeledPlaneScene plates; // 2 m x 2 m each
    for (const int level : {0, 1, 2})
      plates.add ({{0, 0, level * step}, {2, 0, 0}, {0, 2, 0}}, 1500, 0.0);
    return plates.codes();
  };
  EXPECT_EQ (codesWithStep (17_cm), "exact-levels");
  EXPECT_EQ (codesWithStep (23_cm), "");
}

TEST (ResultWarnings, AreNoneOfExactPlanesBesideEachOther)
{
  // Each plate of 2 m x 2 m begins a distance [m] beside the one before, 3 cm above it.
  const auto codesWithDistance = [] (double distance) {
    LabeledPlaneScene plates;
    for (const int plate : {0, 1, 2})
      plates.add (
          {{plate * distance, 0, 3_cm * plate}, {2, 0, 0}, {0, 2, 0}}, 1500, 0.0);
    return plates.codes();
  };
  EXPECT_EQ (codesWithDistance (1.5), "exact-levels") << "they overlap";
  EXPECT_EQ (codesWithDistance (2.5), "") << "50 cm between them";
}

TEST (ResultWarnings, AreNoneOfStairsWithoutNoise)
{
  LabeledPlaneScene stairs;
  for (const int step : {0, 1, 2})
    stairs.add ({{0, 0.3 * step, 0.17 * step}, {2, 0, 0}, {0, 0.3, 0}}, 1500, 0.0);
  EXPECT_EQ (stairs.codes(), "");
}

TEST (ResultWarnings, SayThatLabelsAreMixedPointByPoint)
{
  LabeledPlaneScene wall;
  wall.add (wall_of_room, 2500, 5_mm);
  Surface wall_behind = wall_of_room;
  wall_behind.corner.y() += 2_mm; // less than the noise
  wall.add (wall_behind, 2500, 5_mm);
  ASSERT_EQ (wall.codes(), "mixed-labels");
  const std::string text = wall.firstText();
  EXPECT_TRUE (
      contains (text, "planes 1 and 2; for one plane give --merge-distance 0.00"));
}

TEST (ResultWarnings, AreNoneOfLabelsMixedBetweenPlanesAtMoreThan15Degrees)
{
  // Two boards of 1 m x 1 m that cross in their middle, with a noise of 4 cm.
  const auto codesWithAngle = [] (double angle) {
    const double x = std::cos (angle), z = std::sin (angle);
    return LabeledPlaneScene()
        .add ({{-0.5, 0, 0}, {1, 0, 0}, {0, 1, 0}}, 2000, 4_cm)
        .add ({{-0.5 * x, 0, -0.5 * z}, {x, 0, z}, {0, 1, 0}}, 2000, 4_cm)
        .codes();
  };
  EXPECT_EQ (codesWithAngle (12_deg), "mixed-labels");
  EXPECT_EQ (codesWithAngle (18_deg), "");
}

TEST (ResultWarnings, AreNoneOfWallsFartherApartThanTwiceTheSumOfBothRms)
{
  // Points are 6 cm apart and scatter by 5 mm: the sum is 1 cm.
  const auto codesWithDistance = [] (double distance) {
    Surface wall_behind = wall_of_room;
    wall_behind.corner.y() += distance;
    return LabeledPlaneScene()
        .add (wall_of_room, 2500, 5_mm)
        .add (wall_behind, 2500, 5_mm)
        .codes();
  };
  EXPECT_EQ (codesWithDistance (12_mm), "mixed-labels");
  EXPECT_EQ (codesWithDistance (30_mm), "");
}

TEST (ResultWarnings, AreNoneOfPlanesOfWhichASmallPartIsMixed)
{
  // Two walls of 4 m on one plane. Where they overlap, half of the neighbors of a point
  // are on the other one.
  const auto codesWithOverlap = [] (double overlap) {
    Surface second = wall_of_room;
    second.corner.x() += 4_m - overlap;
    return LabeledPlaneScene()
        .add (wall_of_room, 2500, 5_mm)
        .add (second, 2500, 5_mm)
        .codes();
  };
  EXPECT_EQ (codesWithOverlap (1.4), "mixed-labels") << "18 % of the neighbors";
  EXPECT_EQ (codesWithOverlap (0.5), "") << "6 %";
}

TEST (ResultWarnings, AreNoneOfPlanesThatMeet)
{
  LabeledPlaneScene room = roomOfTwoPlanes();
  room.add ({{0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 2000, 2_mm);
  EXPECT_EQ (room.codes(), "");
}

namespace {

/** \brief A room of which a floor and a wall are on planes, but not a wall 10 cm thick:
 * it has 3,000 points on each of its sides. */
LabeledPlaneScene
roomWithThinWall ()
{
  LabeledPlaneScene room = roomOfTwoPlanes();
  room.addUnassigned ({{1, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 3000, 2_mm);
  room.addUnassigned ({{1.1, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 3000, 2_mm);
  return room;
}

} // namespace

TEST (ResultWarnings, SayWhichSamplingRatePutsPointsOnPlanes)
{
  ResultContext context;
  EXPECT_EQ (roomWithThinWall().codes (context), "") << "its search is not known";
  context.search = OrientedPointSamplingParameters();
  ASSERT_EQ (roomWithThinWall().codes (context), "unassigned-points");
  const std::string text = roomWithThinWall().firstText (context);
  // 6,000 of 11,500 points.
  EXPECT_TRUE (contains (text, "52 % of the points are on no plane"));
  EXPECT_TRUE (contains (text, " give --sampling-rate 0.3"));
}

TEST (ResultWarnings, SayWhichSamplingRatePutsPointsOnPlanesThoughABushWasTakenForOne)
{
  LabeledPlaneScene garden;
  garden.add (floor_of_room, 1000, 2_mm);
  garden.add ({{9, 9, 1}, {1, 0.1, 0}, {-0.1, 1, 0}}, 2000, 50_cm);
  garden.addUnassigned ({{1, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 3000, 2_mm);
  garden.addUnassigned ({{1.1, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 3000, 2_mm);
  ResultContext context;
  context.search = OrientedPointSamplingParameters();
  ASSERT_EQ (garden.codes (context), "unassigned-points");
  EXPECT_TRUE (contains (garden.firstText (context), " give --sampling-rate 0.3"));
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

TEST (ResultWarnings, DoNotLeaveOutTheThresholdThatOpsOnPointsNeeds)
{
  ResultContext context;
  context.search = OrientedPointSamplingParameters::paper();
  EXPECT_NO_THROW (roomWithThinWall().codes (context));
}

TEST (ResultWarnings, SayWhichGivenValueLeavesPointsOut)
{
  LabeledPlaneScene room = roomOfTwoPlanes();
  room.addUnassigned ({{0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 5000, 2_mm);
  ResultContext context;
  context.search = OrientedPointSamplingParameters();
  context.search->min_points = 1'000'000;
  ASSERT_EQ (room.codes (context), "unassigned-points");
  const std::string text = room.firstText (context);
  EXPECT_TRUE (contains (text, "on planes leave out --min-points"));
}

TEST (ResultWarnings, SayWhichShareOfPointsIsOnPlanesWithoutAGivenValue)
{
  LabeledPlaneScene room = roomOfTwoPlanes();
  room.addUnassigned ({{0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, 5000, 2_mm);
  const OrientedPointSamplingParameters defaults;
  OrientedPointSamplingParameters thin, large, many;
  thin.distance_threshold = 1e-5; // [m]; the noise is 2 mm
  large.min_points = 1'000'000;
  many.min_samples = 1'000'000;
  const struct {
    OrientedPointSamplingParameters search;
    const char* option;
  } rows[] = {{thin, "--threshold"}, {large, "--min-points"}, {many, "--min-inliers"}};
  for (const auto& row : rows) {
    ResultContext context;
    context.search = row.search;
    ASSERT_EQ (room.codes (context), "unassigned-points") << row.option;
    const std::string text = room.firstText (context);
    EXPECT_TRUE (contains (text, std::string ("on planes leave out ") + row.option))
        << text;
    const std::string before_share = "; for ";
    const std::size_t share = text.find (before_share) + before_share.size();
    EXPECT_NEAR (std::stod (text.substr (share)), 100.0, 5.0) << text;
  }
}

TEST (ResultWarnings, CountPlanesOf3PerCentOfThePointsIfAnotherValueFindsThem)
{
  // Of 20,000 points half are on a floor and a wall, the others on no plane: these are
  // on boards, which a smaller min_points finds, and in a bush.
  const auto codesWithBoards = [] (int boards, std::size_t points_of_board) {
    LabeledPlaneScene garden;
    garden.add (floor_of_room, 6000, 2_mm).add (wall_of_room, 4000, 2_mm);
    for (int i = 0; i < boards; ++i)
      garden.addUnassigned (
          {{20.0 + 2 * i, 0, 0}, {1, 0, 0.3 * i}, {0, 1, 0}}, points_of_board, 2_mm);
    garden.addUnassigned ({{9, 9, 1}, {1, 0.1, 0}, {-0.1, 1, 0}},
                          10'000 - boards * points_of_board,
                          50_cm);
    ResultContext context;
    context.search = OrientedPointSamplingParameters();
    context.search->min_points = 1'000'000;
    return garden.codes (context);
  };
  EXPECT_EQ (codesWithBoards (6, 900), "unassigned-points") << "4.5 % each";
  EXPECT_EQ (codesWithBoards (12, 450), "") << "2.2 % each";
}

TEST (ResultWarnings, AdviseNoOtherValueForMoreThan100000Points)
{
  const auto codesWithPoints = [] (std::size_t points) {
    LabeledPlaneScene room;
    room.add (floor_of_room, points / 2, 2_mm);
    room.addUnassigned (wall_of_room, points / 2, 2_mm);
    ResultContext context;
    context.search = OrientedPointSamplingParameters();
    context.search->min_points = 1'000'000;
    return room.codes (context);
  };
  EXPECT_EQ (codesWithPoints (80'000), "unassigned-points");
  EXPECT_EQ (codesWithPoints (120'000), "");
}

TEST (ResultWarnings, AdviseAnotherValueOnlyIfItPuts20PerCentMoreOnPlanes)
{
  // Half of 20,000 points are on a floor and a wall, the others on no plane: these are
  // on a second wall, which a smaller min_points finds, and in a bush.
  const auto codesWithWall = [] (std::size_t points_of_wall) {
    LabeledPlaneScene garden;
    garden.add (floor_of_room, 6000, 2_mm).add (wall_of_room, 4000, 2_mm);
    garden.addUnassigned ({{0, 0, 0}, {0, 3, 0}, {0, 0, 2.5}}, points_of_wall, 2_mm);
    garden.addUnassigned (
        {{9, 9, 1}, {1, 0.1, 0}, {-0.1, 1, 0}}, 10'000 - points_of_wall, 50_cm);
    ResultContext context;
    context.search = OrientedPointSamplingParameters();
    context.search->min_points = 1'000'000;
    return garden.codes (context);
  };
  EXPECT_EQ (codesWithWall (3000), "") << "15 % of all points";
  EXPECT_EQ (codesWithWall (5000), "unassigned-points") << "25 % of all points";
}

TEST (ResultWarnings, AreNoneOfPointsOnNoPlaneThatNoValuePutsOnOne)
{
  LabeledPlaneScene room = roomOfTwoPlanes();
  addTree (room);
  ResultContext context;
  context.search = OrientedPointSamplingParameters();
  EXPECT_EQ (room.codes (context), "");
}

TEST (ResultWarnings, SayWhichVoxelSizeMakesPlanesOfTilesThinner)
{
  const LabeledPlaneScene hill = hillOf (3000, 1_m, 6_cm);
  ResultContext context;
  context.tiles.emplace().voxel_size = 3.0;
  ASSERT_EQ (hill.codes (context), "thick-planes");
  const std::string text = hill.firstText (context);
  EXPECT_TRUE (contains (text, "for thinner planes give --voxel-size 1.5"))
      << "half the voxel size";
}

TEST (ResultWarnings, CompareThicknessWithTheSpacingOfTheSurveyNotOfItsSample)
{
  // Points of the sample are 5.8 m apart, those of the survey 0.58 m.
  const LabeledPlaneScene hill = hillOf (300, 50_cm, 6_cm);
  ResultContext context;
  context.tiles.emplace();
  EXPECT_EQ (hill.codes (context), "") << "as if the sample were the survey";
  context.tiles->sampled_share = 0.01;
  EXPECT_EQ (hill.codes (context), "thick-planes");
}

TEST (ResultWarnings, SayWhichVoxelSizePutsPlacesOfTilesOnPlanes)
{
  const Surface board = {{0, 5, 0}, {2, 0, 0}, {0, 0, 2}};
  LabeledPlaneScene room;
  room.add (floor_of_room, 2000, 2_mm).addUnassigned (board, 4000, 2_mm);
  const LabeledPlaneScene around_board = LabeledPlaneScene().add (board, 4000, 2_mm);
  LabeledPlaneScene tree;
  addTree (tree);
  ResultContext context;
  TiledSearch& tiles = context.tiles.emplace();
  tiles.voxel_size = 0.4;
  tiles.places_on_none = {around_board.cloud};
  ASSERT_EQ (room.codes (context), "unassigned-points");
  const std::string text = room.firstText (context);
  EXPECT_TRUE (contains (text, "67 % of the points are on no plane; for some "));
  EXPECT_TRUE (contains (text, " on planes give --voxel-size 0.2"));
  tiles.places_on_none.insert (tiles.places_on_none.begin(), CloudView());
  EXPECT_EQ (room.firstText (context), text) << "a place without points tells nothing";
  tiles.places_on_none.push_back (tree.cloud);
  EXPECT_EQ (room.codes (context), "") << "one of two parts of the survey is a tree";
  tiles.places_on_none = {CloudView()};
  EXPECT_EQ (room.codes (context), "") << "no place has points";
}

TEST (ResultWarnings, SayWhichShareOfPointsASmallerVoxelSizePutsOnPlanes)
{
  // A fifth of the points is on planes. Of the others one place is a board, and another
  // one has three points on a board for two points of a tree: 80 % on average.
  const Surface board = {{0, 5, 0}, {2, 0, 0}, {0, 0, 2}};
  LabeledPlaneScene survey;
  survey.add (floor_of_room, 2000, 2_mm).addUnassigned (board, 8000, 2_mm);
  LabeledPlaneScene around_board, around_tree;
  around_board.addUnassigned (board, 4000, 2_mm);
  around_tree.addUnassigned (board, 9000, 2_mm);
  addTree (around_tree);
  ResultContext context;
  TiledSearch& tiles = context.tiles.emplace();
  tiles.voxel_size = 0.4;
  tiles.places_on_none = {around_board.cloud, around_tree.cloud};
  ASSERT_EQ (survey.codes (context), "unassigned-points");
  const std::string text = survey.firstText (context);
  const std::string before_share = "; for some ";
  const std::size_t share = text.find (before_share) + before_share.size();
  EXPECT_NEAR (std::stod (text.substr (share)), 20 + 0.8 * 80, 4.0) << text;
}

TEST (ResultWarnings, SayThatACloudLooksLikeMillimeters)
{
  LabeledPlaneScene room;
  room.add ({{0, 0, 0}, {4000, 0, 0}, {0, 3000, 0}}, 3000, 2.0);
  room.add ({{0, 3000, 0}, {4000, 0, 0}, {0, 0, 2500}}, 2500, 2.0);
  ASSERT_EQ (room.codes(), "millimeters");
  const std::string text = room.firstText();
  // Without the 1 % of points with the least coordinates along an axis, and the 1 %
  // with the largest ones.
  EXPECT_TRUE (contains (text, "3900 x 2900 x 2400 wide"));
  EXPECT_TRUE (contains (text, "; give --meter 1000"));
  ResultContext context;
  context.has_meter = true;
  EXPECT_EQ (room.codes (context), "");
}

TEST (ResultWarnings, TakeACloudWiderThan1000AlongAllAxesForOneInMillimeters)
{
  const auto codesWithHeight = [] (double height) {
    return LabeledPlaneScene()
        .add ({{0, 0, 0}, {4000, 0, 0}, {0, 3000, 0}}, 3000, 2.0)
        .add ({{0, 3000, 0}, {4000, 0, 0}, {0, 0, height}}, 3000, 2.0)
        .codes();
  };
  EXPECT_EQ (codesWithHeight (900.0), "");
  EXPECT_EQ (codesWithHeight (1200.0), "millimeters");
}

TEST (ResultWarnings, LeaveStraysOutOfTheExtentOfACloud)
{
  // The room is some meters wide; strays are 5 km away in all directions.
  const auto codesWithStrays = [] (std::size_t strays) {
    LabeledPlaneScene room = roomOfTwoPlanes();
    for (std::size_t i = 0; i < strays; ++i)
      room.cloud.emplace_back (5000.0f, 5000.0f, 5000.0f);
    return room.codes();
  };
  EXPECT_EQ (codesWithStrays (35), "") << "0.6 %";
  EXPECT_EQ (codesWithStrays (85), "millimeters") << "1.5 %";
}

TEST (ResultWarnings, AreNoneOfASurveyOfAKilometer)
{
  EXPECT_EQ (LabeledPlaneScene()
                 .add ({{0, 0, 0}, {2000, 0, 0}, {0, 3000, 300}}, 5000, 0.05)
                 .codes(),
             "");
}

TEST (ResultWarnings, SayThatAReferenceSystemIsInFeetOrDegrees)
{
  ResultContext context;
  context.unit = CoordinateUnit::Foot;
  ASSERT_EQ (roomOfTwoPlanes().codes (context), "feet");
  const std::string text = roomOfTwoPlanes().firstText (context);
  EXPECT_TRUE (contains (text, "; give --meter 3.2808"));
  context.has_meter = true;
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "");
  context.unit = CoordinateUnit::Degree;
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "degrees")
      << "the length of a meter does not help";
}

TEST (ResultWarnings, SayThatAWidthOfDegreesHasAHeightOfMeters)
{
  const LabeledPlaneScene wall_in_degrees = LabeledPlaneScene().add (
      {{11, 48, 498}, {1e-4, 1e-5, 0}, {0, 0, 2.5}}, 3000, 0.0);
  EXPECT_EQ (wall_in_degrees.codes(), "degrees");
  ResultContext in_meters;
  in_meters.unit = CoordinateUnit::Meter;
  EXPECT_EQ (wall_in_degrees.codes (in_meters), "");
  ResultContext shifted; // x is then 512356, which is no degree
  shifted.shift = {512345, 5412345, 0};
  EXPECT_EQ (wall_in_degrees.codes (shifted), "");
}

TEST (ResultWarnings, TakeLessThanADegreeWith200TimesTheHeightForDegrees)
{
  // A wall with a width in degrees and a height in meters.
  const auto codesOf = [] (double width, double height) {
    return LabeledPlaneScene()
        .add ({{11, 48, 498}, {width, 0.1 * width, 0}, {0, 0, height}}, 3000, 0.0)
        .codes();
  };
  EXPECT_EQ (codesOf (0.1, 15.0), "");
  EXPECT_EQ (codesOf (0.1, 30.0), "degrees");
  EXPECT_EQ (codesOf (0.9, 300.0), "degrees");
  EXPECT_EQ (codesOf (1.2, 300.0), "");
}

TEST (ResultWarnings, SayThatPosesAreOfACamera)
{
  ResultContext context;
  context.has_camera_poses = true;
  ASSERT_EQ (roomOfTwoPlanes().codes (context), "camera-poses");
  const std::string text = roomOfTwoPlanes().firstText (context);
  EXPECT_TRUE (contains (text, "; give --calib calib.txt"));
}

TEST (ResultWarnings, SayThatACloudWasNotSeenFromItsViewpoint)
{
  // Four boards, each behind the one before. Seen from the given viewpoint the first
  // would hide the others.
  LabeledPlaneScene boards;
  for (const double depth : {1.0, 2.0, 3.0, 4.0})
    boards.add ({{-1, depth, 0}, {2, 0, 0}, {0, 0, 2}}, 4000, 2_mm);
  ResultContext context;
  EXPECT_EQ (boards.codes (context), "") << "no viewpoint was given";
  context.viewpoint = Eigen::Vector3d (0, -1, 1);
  ASSERT_EQ (boards.codes (context), "viewpoint");
  const std::string text = boards.firstText (context);
  EXPECT_TRUE (contains (text, "VIEWPOINT 0,-1,1"));
  EXPECT_TRUE (contains (text, "or 0 0 0 if it is not known"));
  context.viewpoint = Eigen::Vector3d (2, 1, 1);
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "") << "from within the room";
}

TEST (ResultWarnings, SayThatKindsNeedToKnowWhichWayIsUp)
{
  // In the frame of a camera: y points down, z ahead.
  LabeledPlaneScene seen;
  seen.add ({{-2, 1, 1}, {4, 0, 0}, {0, 0, 3}}, 3000, 2_mm);
  seen.add ({{-2, 1, 4}, {4, 0, 0}, {0, -2.5, 0}}, 3000, 2_mm);
  ResultContext context;
  context.up_knowledge = UpKnowledge::Assumed;
  EXPECT_EQ (seen.codes (context), "") << "no kinds were requested";
  context.uses_kinds = true;
  ASSERT_EQ (seen.codes (context), "unknown-up");
  const std::string text = seen.firstText (context);
  EXPECT_TRUE (
      contains (text, "0,0,1 is ahead in a cloud that looks like a depth camera's"));
  EXPECT_TRUE (contains (text, "; give --up auto or --up x,y,z"));
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "") << "z is up";
  LabeledPlaneScene roof;
  roof.add ({{50, 50, 20}, {8, 0, 0}, {0, 4, 3}}, 1000, 2_cm);
  EXPECT_EQ (roof.codes (context), "") << "no floor, but no camera either";
  context.suggested_up = Eigen::Vector3d (0, -1, 0); // by the planes
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "unknown-up");
  context.up_knowledge = UpKnowledge::NotFound;
  EXPECT_EQ (roomOfTwoPlanes().codes (context), "unknown-up");
  context.up_knowledge = UpKnowledge::Known;
  EXPECT_EQ (seen.codes (context), "");
}

TEST (ResultWarnings, TakeTheLowestLevelOf3PerCentOfThePointsForAFloor)
{
  // Seen by a camera that looks along z: 6,000 points on a plane along z, and a level
  // square.
  ResultContext context;
  context.up_knowledge = UpKnowledge::Assumed;
  context.uses_kinds = true;
  const auto codesWithLevel = [&] (std::size_t points_of_level) {
    return LabeledPlaneScene()
        .add ({{-2, 1, 1}, {4, 0, 0}, {0, 0, 3}}, 6000, 2_mm)
        .add ({{-0.1, 0.1, 0.5}, {0.2, 0, 0}, {0, 0.2, 0}}, points_of_level, 2_mm)
        .codes (context);
  };
  EXPECT_EQ (codesWithLevel (240), "") << "3.8 %";
  EXPECT_EQ (codesWithLevel (120), "unknown-up") << "2 %";
}

TEST (ResultWarnings, TakeNoLevelForAFloorThat10PerCentOfThePointsAreBelow)
{
  // As in the test before, but with points 20 cm below the level square.
  ResultContext context;
  context.up_knowledge = UpKnowledge::Assumed;
  context.uses_kinds = true;
  const auto codesWithPointsBelow = [&] (std::size_t points_below) {
    return LabeledPlaneScene()
        .add ({{-2, 1, 1}, {4, 0, 0}, {0, 0, 3}}, 6000, 2_mm)
        .add ({{-0.1, 0.1, 0.5}, {0.2, 0, 0}, {0, 0.2, 0}}, 500, 2_mm)
        .addUnassigned (
            {{-0.1, 0.1, 0.3}, {0.2, 0, 0}, {0, 0.2, 0}}, points_below, 2_mm)
        .codes (context);
  };
  EXPECT_EQ (codesWithPointsBelow (400), "") << "6 %";
  EXPECT_EQ (codesWithPointsBelow (1000), "unknown-up") << "13 %";
}

TEST (ResultWarnings, TakeAPlaneThatRisesByMoreThan15DegreesForNoFloor)
{
  // As in the tests before, but the square rises by an angle.
  ResultContext context;
  context.up_knowledge = UpKnowledge::Assumed;
  context.uses_kinds = true;
  const auto codesWithSlope = [&] (double angle) {
    return LabeledPlaneScene()
        .add ({{-2, 1, 1}, {4, 0, 0}, {0, 0, 3}}, 6000, 2_mm)
        .add ({{-0.1, 0.1, 0.5},
               {0.2, 0, 0},
               {0, 0.2 * std::cos (angle), 0.2 * std::sin (angle)}},
              500,
              2_mm)
        .codes (context);
  };
  EXPECT_EQ (codesWithSlope (12_deg), "");
  EXPECT_EQ (codesWithSlope (20_deg), "unknown-up");
}

TEST (ResultWarnings, TakePointsForBelowAFloorIfTheyAreLowerByMoreThanThreeRms)
{
  // As in the tests before, with an rms of 2 mm and 13 % of the points below the level.
  ResultContext context;
  context.up_knowledge = UpKnowledge::Assumed;
  context.uses_kinds = true;
  const auto codesWithDepth = [&] (double depth) {
    return LabeledPlaneScene()
        .add ({{-2, 1, 1}, {4, 0, 0}, {0, 0, 3}}, 6000, 2_mm)
        .add ({{-0.1, 0.1, 0.5}, {0.2, 0, 0}, {0, 0.2, 0}}, 500, 2_mm)
        .addUnassigned ({{-0.1, 0.1, 0.5 - depth}, {0.2, 0, 0}, {0, 0.2, 0}}, 1000, 0.0)
        .codes (context);
  };
  EXPECT_EQ (codesWithDepth (4_mm), "");
  EXPECT_EQ (codesWithDepth (9_mm), "unknown-up");
}

TEST (ResultWarnings, SayWhyAFloorPlanHasNoWall)
{
  // "CODE: TEXT" of the first warning; empty without a warning.
  ResultContext context;
  const auto warningOf = [&] (const PlanCounts& counts,
                              const LabeledPlaneScene& scene) {
    context.plan = counts;
    const std::vector<ResultWarning> warnings = scene.warnings (context);
    return warnings.empty() ? "" : warnings[0].code + ": " + warnings[0].text;
  };
  const auto expectBegin = [&] (const PlanCounts& counts, const std::string& begin) {
    const std::string warning = warningOf (counts, roomOfTwoPlanes());
    EXPECT_EQ (warning.substr (0, begin.size()), begin);
  };
  // The members of PlanCounts: walls of the plan, planes that are walls before filters,
  // those after filters, and whether a plane is a floor.
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
  EXPECT_EQ (warningOf ({3, 12, 12, true}, roomOfTwoPlanes()), "");
  context.tiles.emplace(); // the program for tiles has no --up
  expectBegin (
      {0, 0, 0, true},
      "empty-plan: the floor plan has 0 walls: no plane is a wall; z has to be "
      "up; give --meter");
  context.tiles.reset();
  LabeledPlaneScene wall_in_millimeters;
  wall_in_millimeters.add ({{0, 3000, 0}, {4000, 2000, 0}, {0, 0, 2500}}, 2500, 2.0);
  EXPECT_NE (
      warningOf ({0, 0, 0, true}, wall_in_millimeters).find ("looks like millimeters"),
      std::string::npos);
}

TEST (ResultWarnings, AreTheThreeMostImportantUnlessMoreAreRequested)
{
  // A thick plane in millimeters.
  LabeledPlaneScene wall;
  wall.add ({{0, 3000, 0}, {4000, 2000, 0}, {0, 0, 2500}}, 2500, 200.0);
  wall.planes[0].noise = 2.0;
  ResultContext context;
  context.has_camera_poses = true;
  context.up_knowledge = UpKnowledge::NotFound;
  context.uses_kinds = true;
  EXPECT_EQ (wall.codes (context), "millimeters camera-poses unknown-up");
  context.max_warnings = 10;
  EXPECT_EQ (wall.codes (context), "millimeters camera-poses unknown-up thick-planes");
}

TEST (ResultWarnings, DoNotDependOnTheOrderOfThePoints)
{
  LabeledPlaneScene wall;
  wall.add (wall_of_room, 2500, 5_mm).add (wall_of_room, 2500, 5_mm);
  LabeledPlaneScene reversed = wall;
  std::reverse (reversed.cloud.begin(), reversed.cloud.end());
  for (PlaneSegment& plane : reversed.planes) {
    for (pcl::index_t& index : plane.inliers)
      index = static_cast<pcl::index_t> (wall.cloud.size()) - 1 - index;
    std::reverse (plane.inliers.begin(), plane.inliers.end());
  }
  ASSERT_EQ (wall.warnings().size(), 1U);
  EXPECT_EQ (wall.firstText(), reversed.firstText());
}

TEST (ResultWarnings, RefuseInliersOfAnotherCloud)
{
  LabeledPlaneScene room = roomOfTwoPlanes();
  room.planes[0].inliers.back() = 1'000'000; // the cloud has 5,500 points
  EXPECT_THROW (room.warnings(), std::invalid_argument);
}
