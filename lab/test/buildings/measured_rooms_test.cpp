// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Rooms of real clouds against those that were measured by hand; measured_rooms.tsv
// says how.
#include <gtest/gtest.h>

#include <evaluation/data/data_sets.h>
#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/detect_planes.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using namespace pcl_ops;

namespace {

namespace fs = std::filesystem;

struct MeasuredRoom {
  std::vector<Eigen::Vector2d> corners = {};
  double max_error = 0.0; // of the area, as a share

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

/** By the names of their files. */
std::map<std::string, MeasuredCloud>
measuredClouds ()
{
  std::map<std::string, MeasuredCloud> clouds;
  std::ifstream file (PCL_OPS_MEASURED_ROOMS);
  for (std::string line; std::getline (file, line);) {
    if (line.empty() || line[0] == '#')
      continue;
    std::istringstream row (line);
    std::string name, up, corners, percent;
    for (std::string* const text : {&name, &up, &corners, &percent})
      std::getline (row, *text, '\t');
    MeasuredCloud& cloud = clouds[name];
    char comma = ',';
    std::istringstream (up) >> cloud.up.x() >> comma >> cloud.up.y() >> comma >>
        cloud.up.z();
    if (corners == "none")
      continue;
    MeasuredRoom& room = cloud.rooms.emplace_back();
    room.max_error = 0.01 * std::stod (percent);
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

} // namespace

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
