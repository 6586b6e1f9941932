// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Compares rooms found in real clouds with rooms measured by hand; measured_rooms.tsv
// describes the measurement.
#include <gtest/gtest.h>

#include <evaluation/data/data_sets.h>
#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/detect_planes.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

using namespace pcl_ops;

namespace {

namespace fs = std::filesystem;

struct MeasuredRoom {
  std::vector<Eigen::Vector2d> corners = {};
  double max_error = 0.0;                         // of the area, as a share
  std::optional<double> floor = {}, ceiling = {}; // [m], where they were seen

  double
  area () const
  {
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector2d& next = corners[(i + 1) % corners.size()];
      twice += corners[i].x() * next.y() - corners[i].y() * next.x();
    }
    return 0.5 * twice;
  }
};

struct MeasuredCloud {
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  std::vector<MeasuredRoom> rooms = {}; // by falling area
};

std::optional<double>
heightOf (const std::string& text)
{
  return text == "unseen" ? std::nullopt : std::make_optional (std::stod (text));
}

/** Returns the measured clouds by file name. */
std::map<std::string, MeasuredCloud>
measuredClouds ()
{
  std::map<std::string, MeasuredCloud> clouds;
  std::ifstream file (PCL_OPS_MEASURED_ROOMS);
  for (std::string line; std::getline (file, line);) {
    if (line.empty() || line[0] == '#')
      continue;
    std::istringstream row (line);
    std::string name, up, corners, percent, floor, ceiling;
    for (std::string* const text : {&name, &up, &corners, &percent, &floor, &ceiling})
      std::getline (row, *text, '\t');
    MeasuredCloud& cloud = clouds[name];
    char comma = ',';
    std::istringstream (up) >> cloud.up.x() >> comma >> cloud.up.y() >> comma >>
        cloud.up.z();
    if (corners == "none")
      continue;
    MeasuredRoom& room = cloud.rooms.emplace_back();
    room.max_error = 0.01 * std::stod (percent);
    room.floor = heightOf (floor);
    room.ceiling = heightOf (ceiling);
    std::istringstream places (corners);
    for (double x = 0.0, y = 0.0; places >> x >> comma >> y;)
      room.corners.emplace_back (x, y);
  }
  return clouds;
}

FloorPlan
planOfFile (const fs::path& file, const Eigen::Vector3d& up)
{
  const evaluation::EvaluationCloud loaded =
      evaluation::dataSetOf ("clouds:" + file.string()).at (0).load();
  OrientedPointSamplingParameters parameters;
  parameters.up_axis = up.cast<float>();
  const std::vector<PlaneSegment> planes = detectPlanes (*loaded.cloud, parameters);
  std::vector<PlaneExtent> extents;
  for (const PlaneSegment& plane : planes)
    extents.push_back (planeExtent (*loaded.cloud, plane));
  return findFloorPlan (*loaded.cloud, planes, planeKinds (planes, extents, up), up);
}

using Segments = std::vector<std::pair<Eigen::Vector2d, Eigen::Vector2d>>;

double
distanceTo (const Segments& segments, const Eigen::Vector2d& place)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : segments) {
    const Eigen::Vector2d way = to - from;
    const double share =
        std::clamp (way.dot (place - from) / way.squaredNorm(), 0.0, 1.0);
    nearest = std::min (nearest, (from + share * way - place).norm());
  }
  return nearest;
}

/** Returns the length of segments that is within a distance of other segments, and the
 * whole length of the segments [m]. */
std::pair<double, double>
lengthNear (const Segments& segments, const Segments& others, double distance)
{
  constexpr double step = 0.02; // [m]
  double near = 0.0;
  double all = 0.0;
  for (const auto& [from, to] : segments) {
    const auto steps = static_cast<int> (std::ceil ((to - from).norm() / step));
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d place = from + (i + 0.5) / steps * (to - from);
      all += step;
      near += distanceTo (others, place) < distance ? step : 0.0;
    }
  }
  return {near, all};
}

Segments
outlinesOf (const MeasuredCloud& cloud)
{
  Segments outlines;
  for (const MeasuredRoom& room : cloud.rooms)
    for (std::size_t i = 0; i < room.corners.size(); ++i)
      outlines.emplace_back (room.corners[i],
                             room.corners[(i + 1) % room.corners.size()]);
  return outlines;
}

Segments
wallsOf (const FloorPlan& plan)
{
  Segments walls;
  for (const PlanWall& wall : plan.walls)
    walls.emplace_back (wall.from, wall.to);
  return walls;
}

} // namespace

TEST (MeasuredRooms, HaveTheirWalls)
{
  constexpr double same = 0.1; // [m]
  double measured_length = 0.0;
  double found = 0.0;
  double drawn = 0.0;
  double right = 0.0;
  for (const auto& [name, measured] : measuredClouds()) {
    const auto file = fs::path (PCL_OPS_DATA_DIR) / name;
    if (measured.rooms.empty())
      continue;
    if (!fs::exists (file))
      GTEST_SKIP() << "no " << file;
    const Segments truth = outlinesOf (measured);
    const Segments walls = wallsOf (planOfFile (file, measured.up));
    const auto [near_walls, of_truth] = lengthNear (truth, walls, same);
    const auto [near_truth, of_walls] = lengthNear (walls, truth, same);
    std::printf (
        "| %s | walls of %.1f m, found %.0f %% | drawn %.1f m, right %.0f %% |\n",
        name.c_str(),
        of_truth,
        100.0 * near_walls / of_truth,
        of_walls,
        100.0 * near_truth / of_walls);
    measured_length += of_truth;
    found += near_walls;
    drawn += of_walls;
    right += near_truth;
  }
  EXPECT_GT (found, 0.85 * measured_length);
  EXPECT_GT (right, 0.9 * drawn);
}

TEST (MeasuredRooms, AreFoundAndNoOthers)
{
  const auto clouds = measuredClouds();
  ASSERT_FALSE (clouds.empty());
  for (const auto& [name, measured] : clouds) {
    const auto file = fs::path (PCL_OPS_DATA_DIR) / name;
    if (!fs::exists (file))
      GTEST_SKIP() << "no " << file;
    const FloorPlan plan = planOfFile (file, measured.up);
    EXPECT_EQ (plan.rooms.size(), measured.rooms.size()) << name;
    for (std::size_t i = 0; i < measured.rooms.size() && i < plan.rooms.size(); ++i) {
      const double area = measured.rooms[i].area();
      EXPECT_NEAR (plan.rooms[i].area, area, measured.rooms[i].max_error * area)
          << name;
      std::printf ("| %s | %.2f m^2 | %.2f m^2 | %+.1f %% |\n",
                   name.c_str(),
                   area,
                   plan.rooms[i].area,
                   100.0 * (plan.rooms[i].area / area - 1.0));
    }
  }
}

TEST (MeasuredRooms, HaveTheirHeights)
{
  constexpr double same = 0.02; // [m]
  for (const auto& [name, measured] : measuredClouds()) {
    const auto file = fs::path (PCL_OPS_DATA_DIR) / name;
    if (measured.rooms.empty())
      continue;
    if (!fs::exists (file))
      GTEST_SKIP() << "no " << file;
    const FloorPlan plan = planOfFile (file, measured.up);
    ASSERT_EQ (plan.rooms.size(), measured.rooms.size()) << name;
    for (std::size_t i = 0; i < measured.rooms.size(); ++i) {
      const MeasuredRoom& truth = measured.rooms[i];
      const PlanRoom& room = plan.rooms[i];
      ASSERT_EQ (room.floor.has_value(), truth.floor.has_value()) << name;
      ASSERT_EQ (room.ceiling.has_value(), truth.ceiling.has_value()) << name;
      EXPECT_NEAR (*room.floor, *truth.floor, same) << name;
      if (truth.ceiling) {
        EXPECT_NEAR (*room.ceiling, *truth.ceiling, same) << name;
        EXPECT_NEAR (*room.ceiling - *room.floor, *truth.ceiling - *truth.floor, same)
            << name;
      }
    }
  }
}
