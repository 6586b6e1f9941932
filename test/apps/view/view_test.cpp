// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <picture/colors.h>
#include <view/camera.h>
#include <view/found_planes.h>
#include <view/picking.h>
#include <view/point_colors.h>
#include <view/texts.h>
#include <view/view_state.h>

#include <algorithm>
#include <limits>

using namespace pcl_ops;
using namespace pcl_ops::apps;

namespace {

bool
isSame (const pcl::RGB& first, const pcl::RGB& second)
{
  return first.r == second.r && first.g == second.g && first.b == second.b;
}

/** \brief A square of 2 m at z = 0 and a point off it, 0.5 m higher. */
XyzCloud::ConstPtr
tableAndPoint ()
{
  const auto cloud = pcl::make_shared<XyzCloud>();
  for (int x = 0; x <= 100; ++x)
    for (int y = 0; y <= 100; ++y)
      cloud->emplace_back (
          0.02f * static_cast<float> (x), 0.02f * static_cast<float> (y), 0.0f);
  cloud->emplace_back (1.0f, 1.0f, 0.5f);
  return cloud;
}

PlaneSegment
planeOf (const pcl::Indices& inliers)
{
  PlaneSegment plane;
  plane.inliers = inliers;
  return plane;
}

/** \brief Planes with nothing but their points, of a cloud of so many. */
FoundPlanes
foundOf (const std::vector<pcl::Indices>& inliers, std::size_t points)
{
  FoundPlanes found;
  for (const pcl::Indices& plane : inliers) {
    found.planes.push_back (planeOf (plane));
    found.extents.emplace_back();
    found.colors.push_back (static_cast<std::uint32_t> (found.planes.size()));
  }
  found.labels = labelsOf (found.planes, points);
  return found;
}

} // namespace

TEST (PlaneFinder, WorksOnlyForAnotherMethodPresetOrMerging)
{
  PlaneFinder finder ({}, tableAndPoint());
  const DetectionRun merged;
  DetectionRun before;
  before.merging = false;
  finder.find (merged);
  finder.find (merged);
  EXPECT_EQ (finder.numberOfDetections(), 1u);
  finder.find (before);
  EXPECT_EQ (finder.numberOfDetections(), 2u);
  finder.find (merged);
  finder.find (before);
  EXPECT_EQ (finder.numberOfDetections(), 2u);
  DetectionRun other;
  other.method = "kht";
  finder.find (other);
  EXPECT_EQ (finder.numberOfDetections(), 3u);
}

TEST (PlaneFinder, FindsTheTableByEveryMethod)
{
  const XyzCloud::ConstPtr cloud = tableAndPoint();
  for (const Method& method : allMethods()) {
    PlaneFinder finder ({}, cloud);
    DetectionRun run;
    run.method = method.name;
    const FoundPlanes& found = finder.find (run);
    ASSERT_EQ (found.planes.size(), 1u) << method.name;
    EXPECT_NEAR (found.extents[0].area, 4.0, 0.3) << method.name;
    EXPECT_EQ (found.labels.front(), 1u) << method.name;
    EXPECT_EQ (found.labels.back(), 0u) << method.name;
  }
}

TEST (PlaneFinder, KeepsWhatItFoundIfTheNextRunFails)
{
  DetectorOptions options;
  // Refused: the outer one is smaller than the inner one.
  options.own = {{"inner-radius", "0.2"}, {"outer-radius", "0.1"}};
  PlaneFinder finder (options, tableAndPoint());
  const FoundPlanes& found = finder.find ({});
  DetectionRun refused;
  refused.method = "fspf";
  EXPECT_ANY_THROW (finder.find (refused));
  EXPECT_EQ (&finder.find ({}), &found);
}

TEST (BeforeMerging, ThereAreAtLeastAsManyPlanes)
{
  // Two halves of a table, one 2 cm higher: one plane once merged.
  const auto cloud = pcl::make_shared<XyzCloud>();
  for (int x = 0; x < 100; ++x)
    for (int y = 0; y < 100; ++y)
      cloud->emplace_back (0.03f * static_cast<float> (x),
                           0.03f * static_cast<float> (y),
                           x < 50 ? 0.0f : 0.02f);
  DetectorOptions options;
  options.threshold = 0.03;
  for (const Method& method : allMethods()) {
    PlaneFinder finder (options, cloud);
    DetectionRun run;
    run.method = method.name;
    const std::size_t after = finder.find (run).planes.size();
    run.merging = false;
    EXPECT_GE (finder.find (run).planes.size(), after) << method.name;
  }
}

TEST (BeforeMerging, TheLargestPartKeepsTheColour)
{
  const FoundPlanes after = foundOf ({{0, 1, 2, 3, 4}, {5, 6}}, 8);
  const FoundPlanes before = foundOf ({{2, 3, 4}, {0, 1}, {5, 6}, {7}}, 8);
  EXPECT_EQ (colorsBeforeMerging (before, after),
             (std::vector<std::uint32_t>{1, 3, 2, 4}));
}

TEST (PointColors, ArePlanesGreyOrTheInput)
{
  const FoundPlanes found = foundOf ({{0}}, 2);
  const std::vector<pcl::RGB> input = {{1, 2, 3}, {4, 5, 6}};
  ViewState state;
  std::vector<pcl::RGB> colors = pointColors (found, state, input);
  EXPECT_TRUE (isSame (colors[0], colorOfLabel (1)));
  EXPECT_TRUE (isSame (colors[1], colorOfLabel (0)));
  state.coloring = Coloring::Input;
  colors = pointColors (found, state, input);
  EXPECT_TRUE (isSame (colors[0], input[0]));
  EXPECT_TRUE (isSame (colors[1], input[1]));
}

TEST (PointColors, OrientationsDiffer)
{
  FoundPlanes found = foundOf ({{0}, {1}}, 2);
  found.planes[0].orientation = Orientation::Horizontal;
  found.planes[1].orientation = Orientation::Vertical;
  ViewState state;
  state.coloring = Coloring::Orientations;
  const std::vector<pcl::RGB> colors = pointColors (found, state, {{}, {}});
  EXPECT_GT (colors[0].g, colors[0].b);
  EXPECT_GT (colors[1].b, colors[1].g);
}

TEST (PointColors, OnlyTheSelectedPlaneDoesNotFade)
{
  const FoundPlanes found = foundOf ({{0}, {1}}, 3);
  ViewState state;
  state.selected = 2;
  const std::vector<pcl::RGB> colors = pointColors (found, state, {{}, {}, {}});
  EXPECT_FALSE (isSame (colors[0], colorOfLabel (1)));
  EXPECT_TRUE (isSame (colors[1], colorOfLabel (2)));
  EXPECT_FALSE (isSame (colors[2], colorOfLabel (0)));
}

TEST (InputColors, AreTheHeightWhereTheFileHasNone)
{
  XyzCloud coordinates;
  for (int i = 0; i < 5; ++i)
    coordinates.emplace_back (0.0f, 0.0f, static_cast<float> (i));
  const float missing = std::numeric_limits<float>::quiet_NaN();
  coordinates.emplace_back (missing, missing, missing);
  const std::vector<pcl::RGB> colors =
      inputColors ({}, coordinates, Eigen::Vector3f::UnitZ());
  ASSERT_EQ (colors.size(), coordinates.size());
  EXPECT_GT (colors[4].r, colors[0].r); // from blue to yellow
  EXPECT_GT (colors[4].g, colors[0].g);
}

TEST (Picking, TakesTheNearestPointUnderTheCursor)
{
  Projection projection; // a cube of 2 m, seen along z
  projection.size = {200, 100};
  XyzCloud cloud;
  cloud.emplace_back (0.0f, 0.0f, 0.5f);
  cloud.emplace_back (0.01f, 0.0f, -0.5f);
  cloud.emplace_back (0.5f, 0.5f, 0.0f);
  EXPECT_EQ (pointAt ({100, 50}, 4, cloud, projection), 1);
  EXPECT_EQ (pointAt ({150, 75}, 4, cloud, projection), 2);
  EXPECT_FALSE (pointAt ({20, 20}, 4, cloud, projection));
}

TEST (Picking, LeavesOutWhatIsBehindTheEyeOrHasNoCoordinates)
{
  Projection projection;
  projection.size = {200, 100};
  projection.to_cube (3, 3) = 0.0;
  projection.to_cube (3, 2) = 1.0; // a pinhole at the origin
  XyzCloud cloud;
  const float missing = std::numeric_limits<float>::quiet_NaN();
  cloud.emplace_back (0.0f, 0.0f, -1.0f);
  cloud.emplace_back (missing, missing, missing);
  EXPECT_FALSE (pointAt ({100, 50}, 4, cloud, projection));
}

TEST (Camera, LooksAtTheCloudAsItsSensorDid)
{
  XyzCloud wall; // 3 m in front of a camera, whose y axis points down
  for (int x = -10; x <= 10; ++x)
    for (int y = -10; y <= 10; ++y)
      wall.emplace_back (
          0.1f * static_cast<float> (x), 0.1f * static_cast<float> (y), 3.0f);
  const Camera camera = cameraFor (wall, {}, Eigen::Vector3f::UnitZ(), 400, 300);
  EXPECT_LT ((camera.eye - Eigen::Vector3d::Zero()).norm(), 1e-6);
  EXPECT_LT ((camera.target - Eigen::Vector3d (0, 0, 3)).norm(), 0.05);
  EXPECT_GT (camera.up.dot (-Eigen::Vector3d::UnitY()), 0.99);
  EXPECT_NEAR (camera.angle, 2.0 * std::atan2 (1.0, 3.0) * 180.0 / M_PI, 3.0);
}

TEST (Camera, DrawsFewerPointsLarger)
{
  EXPECT_GT (pointSizeFor (1000, 640, 480), pointSizeFor (1000000, 640, 480));
  EXPECT_GE (pointSizeFor (0, 640, 480), 1);
}

TEST (Texts, GiveThePlaneInTheFrameOfTheFile)
{
  FoundPlanes found = foundOf ({{0, 1, 2}}, 3);
  found.planes[0].orientation = Orientation::Horizontal;
  found.extents[0].area = 1.5;
  const std::string text = planeText (found, 1, {0, 0, 10});
  EXPECT_NE (text.find ("plane 1: horizontal, 3 points, area 1.500"), std::string::npos)
      << text;
  EXPECT_NE (text.find ("1.0000 z - 10.0000 = 0"), std::string::npos) << text;
}

TEST (Texts, SayWhatToChangeWhereNothingWasFound)
{
  FoundPlanes found = foundOf ({}, 3);
  found.advice = "lower --min-inliers";
  const std::string text = statusText ("folder/room.pcd", found, {});
  EXPECT_EQ (text.find ("room.pcd, 3 points"), 0u) << text;
  EXPECT_NE (text.find ("0 planes"), std::string::npos) << text;
  EXPECT_NE (text.find (found.advice), std::string::npos) << text;
}

TEST (Texts, SayWhetherTheUpAxisWasFound)
{
  FoundPlanes found = foundOf ({}, 3);
  found.up_note = "Up axis: the planes cannot tell";
  const std::string text = statusText ("room.pcd", found, {});
  EXPECT_NE (text.find (found.up_note), std::string::npos) << text;
}

TEST (Texts, AreWrappedBetweenWords)
{
  std::string text = "word";
  for (int i = 0; i < 50; ++i)
    text += " word";
  std::string lines = wrapped (text);
  std::size_t longest = 0, start = 0;
  for (std::size_t end = lines.find ('\n'); end != std::string::npos;
       end = lines.find ('\n', start)) {
    longest = std::max (longest, end - start);
    start = end + 1;
  }
  EXPECT_GT (longest, 40u);
  EXPECT_LE (longest, 64u);
  std::replace (lines.begin(), lines.end(), '\n', ' ');
  EXPECT_EQ (lines, text);
}

TEST (Texts, ListEveryKey)
{
  const std::string text = keysText();
  for (const Key& key : allKeys())
    EXPECT_NE (text.find (key.name + "  " + key.help), std::string::npos) << key.name;
}
