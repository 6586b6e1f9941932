// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <boost/algorithm/string/replace.hpp>

#include <Eigen/Geometry>

#include <support/program_folder.h>

#include <array>
#include <fstream>
#include <random>
#include <sstream>

namespace {

using Json = nlohmann::json;
namespace fs = std::filesystem;

/** The programs of the lab as a shell runs them. */
class LabProgram : public ProgramFolder {
protected:
  LabProgram() : ProgramFolder ("") {}

  /** \param[in] command of programs by their names */
  Outcome
  runCommand (const std::string& command) const
  {
    return shell ("{ PATH=\"" PCL_OPS_PROGRAMS ":$PATH\"; " + command + "; }");
  }

  Json
  jsonOf (const std::string& command) const
  {
    const Outcome done = runCommand (command + " --json");
    EXPECT_EQ (done.exit_code, 0) << done.err;
    return Json::parse (done.out);
  }
};

/** By the name of a program, whose table it is. */
class LabTable : public LabProgram, public testing::WithParamInterface<const char*> {
protected:
  LabTable() { fs::copy (PCL_OPS_LAB_TABLES "/inputs", folder_.path(), recursive); }

  static constexpr auto recursive =
      fs::copy_options::recursive | fs::copy_options::overwrite_existing;

  static void
  expectValue (const Json& json,
               const Json::json_pointer& place,
               const std::string& what)
  {
    constexpr double tolerance = 1e-6;
    if (what == "absent")
      EXPECT_FALSE (json.contains (place));
    else if (what.rfind ("> ", 0) == 0)
      EXPECT_GT (json.at (place).get<double>(), std::stod (what.substr (2)));
    else if (const Json value = json.at (place); value.is_number())
      EXPECT_NEAR (value.get<double>(), Json::parse (what).get<double>(), tolerance);
    else
      EXPECT_EQ (value, Json::parse (what));
  }

  /** Looks where a row says for what it says. */
  void
  expect (const Outcome& done, std::string where, std::string what) const
  {
    boost::replace_all (what, "\\n", "\n");
    const bool is_absent = where.front() == '!';
    const std::size_t hash = where.find ('#');
    const std::string name = where.substr (is_absent, hash - is_absent);
    const std::string text = name.empty() || name == "out" ? done.out
                             : name == "err" || name == "line"
                                 ? done.err
                                 : contentOf (folder_ / name);
    if (hash != std::string::npos)
      expectValue (
          Json::parse (text), Json::json_pointer (where.substr (hash + 1)), what);
    else if (name == "line" || what.front() == '^')
      EXPECT_EQ (text.find (what.substr (what.front() == '^')), 0u) << text;
    else
      EXPECT_EQ (bool (contains (text, what)), !is_absent) << text;
    EXPECT_TRUE (name != "line" || lines (text) == 1) << text;
  }
};

TEST_P (LabTable, SaysWhatHappens)
{
  const std::string name = GetParam();
  if (!fs::exists (PCL_OPS_PROGRAMS "/pcl_ops_" + name))
    GTEST_SKIP() << "pcl_ops_" << name << " is not built";
  const auto rows = tableIn (PCL_OPS_LAB_TABLES "/" + name + ".tsv");
  ASSERT_FALSE (rows.empty());
  Outcome done{};
  std::string command;
  for (const auto& row : rows) {
    if (!row.at (1).empty()) {
      command = row[1];
      done = runCommand (command);
      EXPECT_EQ (std::to_string (done.exit_code), row[0]) << command << done.err;
    }
    SCOPED_TRACE (command);
    if (row.size() > 2)
      expect (done, row[2], row.at (3));
  }
}

INSTANTIATE_TEST_SUITE_P (Of,
                          LabTable,
                          testing::Values ("simulate", "evaluate", "benchmark"),
                          [] (const auto& info) { return std::string (info.param); });

/** A plane of 40 x 40 points, 2 cm apart, with 1 cm of noise that is the same for 4 x 4
 * of them, seen from above in 40 clouds, in every second by a sensor that is turned by
 * 90 degrees. */
TEST_F (LabProgram, TracksDifferencesOverWhatCovariancesAllow)
{
  fs::create_directory (folder_ / "clouds");
  std::mt19937 generator (1);
  std::normal_distribution<> noise (0.0, 0.01);
  std::string poses;
  for (int cloud = 100; cloud < 140; ++cloud) {
    const bool is_turned = cloud % 2 == 1;
    std::array<double, 100> errors{};
    for (double& error : errors)
      error = noise (generator);
    std::ostringstream text ("x,y,z,label\n", std::ios::ate);
    for (int i = 0; i < 1600; ++i) {
      const int column = i % 40, row = i / 40;
      const double x = 0.02 * column, y = 0.02 * row;
      text << (is_turned ? y : x) << ',' << (is_turned ? -x : y) << ','
           << errors[column / 4 + row / 4 * 10] - 1.0 << ",1\n";
    }
    folder_.write ("clouds/" + std::to_string (cloud) + ".xyz", text.str());
    poses += is_turned ? "0 0 0 1 0 0 0.70710678 0.70710678\n" : "0 0 0 1 0 0 0 1\n";
  }
  folder_.write ("poses.txt", poses);
  const auto json = jsonOf ("pcl_ops_evaluate track clouds clouds --poses poses.txt");
  for (const std::string errors : {"offset_errors", "tilt_errors"}) {
    EXPECT_NEAR (json[errors + "_median"], 0.67, 0.3) << json;
    EXPECT_NEAR (json[errors + "_90"], 1.64, 0.6) << json;
  }
}

/** A floor and two walls, in steps of 2 cm, seen from inside: from zero. */
TEST_F (LabProgram, FindsAllEdgesOfACornerOfExactPoints)
{
  std::ostringstream text ("x,y,z,label\n", std::ios::ate);
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      const double s = 0.02 * i - 0.99, t = 0.02 * j - 0.99;
      text << s << ',' << t << ",-1,1\n-1," << s << ',' << t << ",2\n"
           << t << ",-1," << s << ",3\n";
    }
  folder_.write ("corner.xyz", text.str());
  const auto json = jsonOf ("pcl_ops_evaluate edges clouds:corner.xyz");
  EXPECT_EQ (json["edges"][0]["wall_edges_found"], 1.0);
}

TEST_F (LabProgram, PosesOfADriveLeadToTheRoad)
{
  runCommand (
      "pcl_ops_simulate . --scene drive --sensor lidar-16 --frames 2 --noise 0");
  std::ifstream poses (folder_ / "poses.txt");
  std::string comment;
  std::getline (poses, comment);
  for (const char* name : {"frame_000.pcd", "frame_001.pcd"}) {
    double time = 0.0;
    Eigen::Vector3f from;
    Eigen::Quaternionf turn;
    poses >> time >> from.x() >> from.y() >> from.z() >> turn.x() >> turn.y() >>
        turn.z() >> turn.w();
    pcl::PointCloud<pcl::PointXYZL> cloud;
    pcl::io::loadPCDFile (folder_ / name, cloud);
    constexpr std::uint32_t road = 1; // a street's first surface
    std::size_t on_road = 0;
    for (const auto& point : cloud)
      if (point.label == road &&
          std::abs ((turn * point.getVector3fMap() + from).z()) < 1e-4f)
        ++on_road;
    EXPECT_GT (on_road, 1000u) << name;
  }
}

} // namespace
