// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/run_program.h>
#include <support/temporary_folder.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>

namespace {

ProgramRun
evaluate (const std::string& arguments)
{
  return runProgram (PCL_OPS_EVALUATE_PROGRAM, arguments);
}

std::string
pcd (int points, const std::string& rows)
{
  const std::string number = std::to_string (points);
  return "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
         "WIDTH " +
         number + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number +
         "\nDATA ascii\n" + rows;
}

/** A floor of side x side points, 2 cm apart; label(i) of the i-th. */
template <typename LabelOf>
std::string
floorOf (int side, LabelOf label)
{
  std::ostringstream rows;
  for (int i = 0; i < side * side; ++i)
    rows << 0.02 * (i % side) << ' ' << 0.02 * (i / side) << " 0 " << label (i) << '\n';
  return pcd (side * side, rows.str());
}

const std::string one_plane = floorOf (10, [] (int) { return 1; });
const std::string two_halves = floorOf (10, [] (int i) { return i < 60 ? 4 : 9; });
const std::string no_plane = floorOf (10, [] (int) { return 0; });

TEST (EvaluateProgram, ComparesTwoLabeledCloudsAsJsonAndAsText)
{
  const TemporaryFolder folder;
  const std::string compare = "compare " + folder.write ("truth.pcd", one_plane) + " " +
                              folder.write ("result.pcd", two_halves);
  const ProgramRun run = evaluate (compare + " --json");
  ASSERT_EQ (run.exit_code, 0) << run.text;
  const auto json = nlohmann::json::parse (run.text);
  EXPECT_EQ (json["classification_accuracy"], 1.0); // both halves are horizontal
  EXPECT_EQ (json["precision"], 0.5);
  EXPECT_EQ (json["precision_75"], 0.0);
  EXPECT_EQ (json["points_off_planes_called_planes"], 0.0);
  EXPECT_EQ (json["by_size"][0].dump(),
             "{\"below\":200,\"fewest_points\":0,\"found\":1,\"found_75\":0,"
             "\"planes\":1}");
  EXPECT_TRUE (json["by_width"][5]["below"].is_null());
  const std::string text = evaluate (compare).text;
  for (const char* line : {"\nsegmentation_accuracy             0.6000\n",
                           "\n**by_size**\n",
                           "\n| 0             |   200 |      1 |     1 |        0 |\n",
                           "\n| 1.0000    |      - |"})
    EXPECT_NE (text.find (line), std::string::npos) << line << text;
}

TEST (EvaluateProgram, AnEmptyTruthIsSaidButCompared)
{
  const TemporaryFolder folder;
  const std::string truth = folder.write ("truth.pcd", no_plane),
                    result = folder.write ("result.pcd", one_plane);
  const ProgramRun run = evaluate ("compare " + truth + " " + result);
  EXPECT_EQ (run.exit_code, 0);
  EXPECT_NE (run.text.find ("truth.pcd: has no plane"), std::string::npos);
}

TEST (EvaluateProgram, ComparesTextByItsColumnOfLabels)
{
  const TemporaryFolder folder;
  std::ostringstream rows;
  rows << "x,y,z,label\n";
  for (int i = 0; i < 100; ++i)
    rows << 0.02 * (i % 10) << ',' << 0.02 * (i / 10) << ",0," << (i < 60 ? 4 : 9)
         << '\n';
  const ProgramRun run =
      evaluate ("compare " + folder.write ("truth.pcd", one_plane) + " " +
                folder.write ("result.csv", rows.str()) + " --json");
  ASSERT_EQ (run.exit_code, 0) << run.text;
  EXPECT_EQ (nlohmann::json::parse (run.text)["segmentation_accuracy"], 0.6);
  const std::string half = folder.write ("half.csv", "x,y,z,label\n1,2,3,1.5\n");
  expectError (evaluate ("compare " + half + " " + half), 1, half);
}

TEST (EvaluateProgram, CloudsThatDoNotBelongTogetherAreErrors)
{
  const TemporaryFolder folder;
  const std::string truth = folder.write ("truth.pcd", one_plane),
                    larger = folder.write ("larger.pcd",
                                           floorOf (11, [] (int) { return 1; })),
                    moved = folder.write (
                        "moved.pcd",
                        std::string (one_plane).replace (
                            one_plane.find ("\n0 0 0 1\n"), 9, "\n9 9 9 1\n"));
  expectError (evaluate ("compare " + truth + " " + larger), 1, larger);
  expectError (evaluate ("compare " + truth + " " + moved), 1, moved);
}

TEST (EvaluateProgram, HelpAndVersionEndWithZero)
{
  for (const char* arguments :
       {"--help", "-h", "--version", "run --help", "compare --help", "detectors"}) {
    const ProgramRun run = evaluate (arguments);
    EXPECT_EQ (run.exit_code, 0) << arguments;
    EXPECT_FALSE (run.text.empty()) << arguments;
  }
}

TEST (EvaluateProgram, ARunWritesRowsAndLeavesOutBrokenClouds)
{
  const TemporaryFolder folder;
  std::filesystem::create_directories (folder / "clouds");
  folder.write ("clouds/floor.pcd", floorOf (60, [] (int) { return 1; }));
  const std::string command =
      "run " + folder / "out" + " clouds:" + folder / "clouds" + " --detectors ops";
  const ProgramRun first = evaluate (command), second = evaluate (command);
  EXPECT_EQ (first.exit_code, 0) << first.text;
  EXPECT_NE (first.text.find ("1 clouds evaluated, 1 new rows"), std::string::npos);
  EXPECT_NE (second.text.find ("1 clouds evaluated, 0 new rows"), std::string::npos);
  folder.write ("clouds/broken.pcd", "VERSION 0.7\nFIELDS x y z\n");
  const ProgramRun broken = evaluate (command);
  EXPECT_EQ (broken.exit_code, 1);
  EXPECT_NE (broken.text.find ("left out: " + folder / "clouds/broken.pcd"),
             std::string::npos);
  EXPECT_NE (broken.text.find ("0 new rows; 1 clouds left out"), std::string::npos)
      << broken.text;
}

TEST (EvaluateProgram, CountsPlanesThatKeepTheirNumber)
{
  const TemporaryFolder folder;
  const auto writeCloud = [&] (const std::string& name, const std::string& labels) {
    std::string rows;
    for (const char label : labels)
      rows += std::to_string (rows.size()) + " 0 0 " + label + '\n';
    folder.write (name, pcd (static_cast<int> (labels.size()), rows));
  };
  std::filesystem::create_directories (folder / "truth");
  std::filesystem::create_directories (folder / "result");
  for (const auto& [name, result] :
       {std::pair ("/0.pcd", "44556"), {"/1.pcd", "44550"}, {"/2.pcd", "44770"}}) {
    writeCloud (std::string ("truth") + name, "11223");
    writeCloud (std::string ("result") + name, result);
  }
  const ProgramRun run =
      evaluate ("track " + folder / "truth" + " " + folder / "result" + " --json");
  ASSERT_EQ (run.exit_code, 0) << run.text;
  const auto json = nlohmann::json::parse (run.text);
  EXPECT_EQ (json["planes"], 2) << "the third is found once only";
  EXPECT_EQ (json["planes_kept"], 1);
  EXPECT_EQ (json["sightings"], 4);
  EXPECT_EQ (json["sightings_kept"], 3);
  EXPECT_EQ (json["numbers"], 4);
  const std::string pose = folder.write ("pose.txt", "0 0 0 0 0 0 0 1\n");
  expectError (evaluate ("track " + folder / "truth" + " " + folder / "result" +
                         " --poses " + pose),
               1,
               pose);
}

/** A plane of 40 x 40 points, 2 cm apart, with 1 cm of noise that is the same for 4 x 4
 * of them, seen from above in 40 clouds, in every second by a sensor that is turned by
 * 90 degrees. */
TEST (EvaluateProgram, TracksDifferencesOverWhatCovariancesAllow)
{
  const TemporaryFolder folder;
  std::filesystem::create_directories (folder / "clouds");
  std::mt19937 generator (1);
  std::normal_distribution<> noise (0.0, 0.01);
  std::string poses;
  for (int cloud = 100; cloud < 140; ++cloud) {
    const bool is_turned = cloud % 2 == 1;
    std::array<double, 100> errors{};
    for (double& error : errors)
      error = noise (generator);
    std::ostringstream rows;
    for (int i = 0; i < 1600; ++i) {
      const int column = i % 40, row = i / 40;
      const double x = 0.02 * column, y = 0.02 * row;
      rows << (is_turned ? y : x) << ' ' << (is_turned ? -x : y) << ' '
           << errors[column / 4 + row / 4 * 10] - 1.0 << " 1\n";
    }
    folder.write ("clouds/" + std::to_string (cloud) + ".pcd", pcd (1600, rows.str()));
    poses += is_turned ? "0 0 0 1 0 0 0.70710678 0.70710678\n" : "0 0 0 1 0 0 0 1\n";
  }
  const std::string clouds = folder / "clouds";
  const ProgramRun run =
      evaluate ("track " + clouds + " " + clouds + " --json --poses " +
                folder.write ("poses.txt", poses));
  ASSERT_EQ (run.exit_code, 0) << run.text;
  const auto json = nlohmann::json::parse (run.text);
  for (const std::string errors : {"offset_errors", "tilt_errors"}) {
    EXPECT_NEAR (json[errors + "_median"], 0.67, 0.3) << run.text;
    EXPECT_NEAR (json[errors + "_90"], 1.64, 0.6) << run.text;
  }
}

/** A floor and two walls that meet at zero, in steps of 2 cm, seen from inside. */
TEST (EvaluateProgram, FindsAllEdgesOfACornerOfExactPoints)
{
  const TemporaryFolder folder;
  std::ostringstream rows;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      const double s = 0.01 + 0.02 * i, t = 0.01 + 0.02 * j;
      rows << s << ' ' << t << " 0 1\n0 " << s << ' ' << t << " 2\n"
           << t << " 0 " << s << " 3\n";
    }
  std::string cloud = pcd (30000, rows.str());
  cloud.replace (cloud.find ("VIEWPOINT 0 0 0"), 15, "VIEWPOINT 1 1 1");
  const ProgramRun run =
      evaluate ("edges clouds:" + folder.write ("corner.pcd", cloud));
  EXPECT_EQ (run.exit_code, 0) << run.text;
  EXPECT_NE (run.text.find ("| clouds   |           1.0000 "), std::string::npos)
      << run.text;
}

} // namespace
