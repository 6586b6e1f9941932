// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/program_folder.h>

#include <array>
#include <filesystem>
#include <random>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

namespace {

using Json = nlohmann::json;

class EvaluateProgram : public ProgramFolder {
protected:
  EvaluateProgram() : ProgramFolder (PCL_OPS_EVALUATE_PROGRAM) {}

  Json
  jsonOf (const std::string& arguments) const
  {
    return Json::parse (expectDone (arguments + " --json").out);
  }
};

std::string
pcd (int points, const std::string& rows)
{
  const std::string number = std::to_string (points);
  return "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\nCOUNT 1 1 1 1\n"
         "WIDTH " +
         number + "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + number +
         "\nDATA ascii\n" + rows;
}

/** A floor of side x side points, 2 cm apart, of which the first 60 have a label and
 * the others another one. */
std::string
floorOf (int side, const char* label, const char* other, char separator = ' ')
{
  std::ostringstream rows;
  for (int i = 0; i < side * side; ++i)
    rows << 0.02 * (i % side) << separator << 0.02 * (i / side) << separator << 0
         << separator << (i < 60 ? label : other) << '\n';
  return separator == ' ' ? pcd (side * side, rows.str()) : rows.str();
}

const std::string one_plane = floorOf (10, "1", "1"), no_plane = floorOf (10, "0", "0"),
                  two_halves = floorOf (10, "4", "9");

TEST_F (EvaluateProgram, ComparesTwoLabeledCloudsAsJsonAndAsText)
{
  folder_.write ("truth.pcd", one_plane);
  folder_.write ("result.pcd", two_halves);
  const auto json = jsonOf ("compare truth.pcd result.pcd");
  EXPECT_EQ (json["classification_accuracy"], 1.0); // both halves are horizontal
  EXPECT_EQ (json["precision"], 0.5);
  EXPECT_EQ (json["precision_75"], 0.0);
  EXPECT_EQ (json["points_off_planes_called_planes"], 0.0);
  EXPECT_EQ (json["by_size"][0].dump(),
             "{\"below\":200,\"fewest_points\":0,\"found\":1,\"found_75\":0,"
             "\"planes\":1}");
  EXPECT_TRUE (json["by_width"][5]["below"].is_null());
  const std::string text = expectDone ("compare truth.pcd result.pcd").out;
  for (const char* line : {"\nsegmentation_accuracy             0.6000\n",
                           "\n**by_size**\n",
                           "\n| 0             |   200 |      1 |     1 |        0 |\n",
                           "\n| 1.0000    |      - |"})
    EXPECT_TRUE (contains (text, line)) << line;
}

TEST_F (EvaluateProgram, AnEmptyTruthIsSaidButCompared)
{
  folder_.write ("truth.pcd", no_plane);
  folder_.write ("result.pcd", one_plane);
  const Outcome done = expectDone ("compare truth.pcd result.pcd");
  EXPECT_TRUE (contains (done.err, "truth.pcd: has no plane"));
}

TEST_F (EvaluateProgram, ComparesTextByItsColumnOfLabels)
{
  folder_.write ("truth.pcd", one_plane);
  folder_.write ("result.csv", "x,y,z,label\n" + floorOf (10, "4", "9", ','));
  EXPECT_EQ (jsonOf ("compare truth.pcd result.csv")["segmentation_accuracy"], 0.6);
  folder_.write ("half.csv", "x,y,z,label\n1,2,3,1.5\n");
  expectRefused ("compare half.csv half.csv", "half.csv: ");
}

TEST_F (EvaluateProgram, CloudsThatDoNotBelongTogetherAreErrors)
{
  folder_.write ("truth.pcd", one_plane);
  folder_.write ("larger.pcd", floorOf (11, "1", "1"));
  folder_.write ("moved.pcd",
                 std::string (one_plane).replace (
                     one_plane.find ("\n0 0 0 1\n"), 9, "\n9 9 9 1\n"));
  expectRefused ("compare truth.pcd larger.pcd", "larger.pcd: ");
  expectRefused ("compare truth.pcd moved.pcd", "moved.pcd: ");
}

TEST_F (EvaluateProgram, HelpAndVersionEndWithZero)
{
  for (const char* arguments :
       {"--help", "-h", "--version", "run --help", "compare --help", "detectors"})
    EXPECT_NE (expectDone (arguments).out, "") << arguments;
}

TEST_F (EvaluateProgram, ARunWritesRowsAndLeavesOutBrokenClouds)
{
  std::filesystem::create_directories (folder_ / "clouds");
  folder_.write ("clouds/floor.pcd", floorOf (60, "1", "1"));
  const std::string command = "run out clouds:clouds --detectors ops";
  for (const char* rows : {"1", "0"})
    EXPECT_TRUE (contains (expectDone (command).out,
                           std::string ("1 clouds evaluated, ") + rows + " new rows"));
  folder_.write ("clouds/broken.pcd", "VERSION 0.7\nFIELDS x y z\n");
  const Outcome broken = run (command);
  EXPECT_EQ (broken.exit_code, 1);
  EXPECT_TRUE (contains (broken.err, "left out: clouds/broken.pcd"));
  EXPECT_TRUE (contains (broken.out, "0 new rows; 1 clouds left out"));
}

TEST_F (EvaluateProgram, CountsPlanesThatKeepTheirNumber)
{
  const auto writeCloud = [&] (const std::string& name, const std::string& labels) {
    std::string rows;
    for (const char label : labels)
      rows += std::to_string (rows.size()) + " 0 0 " + label + '\n';
    folder_.write (name, pcd (int (labels.size()), rows));
  };
  std::filesystem::create_directories (folder_ / "truth");
  std::filesystem::create_directories (folder_ / "result");
  for (const auto& [name, result] :
       {std::pair ("/0.pcd", "44556"), {"/1.pcd", "44550"}, {"/2.pcd", "44770"}}) {
    writeCloud (std::string ("truth") + name, "11223");
    writeCloud (std::string ("result") + name, result);
  }
  const auto json = jsonOf ("track truth result");
  EXPECT_EQ (json["planes"], 2) << "the third is found once only";
  EXPECT_EQ (json["planes_kept"], 1);
  EXPECT_EQ (json["sightings"], 4);
  EXPECT_EQ (json["sightings_kept"], 3);
  EXPECT_EQ (json["numbers"], 4);
  folder_.write ("pose.txt", "0 0 0 0 0 0 0 1\n");
  expectRefused ("track truth result --poses pose.txt", "pose.txt: ");
}

/** A plane of 40 x 40 points, 2 cm apart, with 1 cm of noise that is the same for 4 x 4
 * of them, seen from above in 40 clouds, in every second by a sensor that is turned by
 * 90 degrees. */
TEST_F (EvaluateProgram, TracksDifferencesOverWhatCovariancesAllow)
{
  std::filesystem::create_directories (folder_ / "clouds");
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
    folder_.write ("clouds/" + std::to_string (cloud) + ".pcd", pcd (1600, rows.str()));
    poses += is_turned ? "0 0 0 1 0 0 0.70710678 0.70710678\n" : "0 0 0 1 0 0 0 1\n";
  }
  folder_.write ("poses.txt", poses);
  const auto json = jsonOf ("track clouds clouds --poses poses.txt");
  for (const std::string errors : {"offset_errors", "tilt_errors"}) {
    EXPECT_NEAR (json[errors + "_median"], 0.67, 0.3) << json;
    EXPECT_NEAR (json[errors + "_90"], 1.64, 0.6) << json;
  }
}

/** A floor and two walls that meet at zero, in steps of 2 cm, seen from inside. */
TEST_F (EvaluateProgram, FindsAllEdgesOfACornerOfExactPoints)
{
  std::ostringstream rows;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      const double s = 0.01 + 0.02 * i, t = 0.01 + 0.02 * j;
      rows << s << ' ' << t << " 0 1\n0 " << s << ' ' << t << " 2\n"
           << t << " 0 " << s << " 3\n";
    }
  std::string cloud = pcd (30000, rows.str());
  cloud.replace (cloud.find ("VIEWPOINT 0 0 0"), 15, "VIEWPOINT 1 1 1");
  folder_.write ("corner.pcd", cloud);
  EXPECT_TRUE (contains (expectDone ("edges clouds:corner.pcd").out,
                         "| clouds   |           1.0000 "));
}

/** \brief A square of 2 m around a place, lying (c along z) or standing (along x). */
Json
square (int id, bool lies, double x, double y, double z)
{
  Json plane;
  plane["id"] = id;
  plane["orientation"] = lies ? "horizontal" : "vertical";
  plane["points"] = 1000;
  plane["centroid"] = {x, y, z};
  plane["rms"] = 0.002;
  plane["coefficients"] = {lies ? 0.0 : 1.0, 0.0, lies ? 1.0 : 0.0, lies ? -z : -x};
  for (const auto& [s, t] :
       std::vector<std::pair<int, int>>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    plane["hull"].push_back (lies ? Json{x + s, y + t, z} : Json{x, y + s, z + t});
  return plane;
}

class PlanesCommand : public EvaluateProgram {
protected:
  /** \brief Floor and wall; in b.json the wall is first and the floor 1 cm higher, and
   * there is a table in place of the shelf. */
  PlanesCommand()
  {
    write ("a.json",
           {square (1, true, 0, 0, 0),
            square (2, false, 3, 0, 1),
            square (3, true, 5, 5, 2)});
    write ("b.json",
           {square (1, false, 3, 0, 1),
            square (2, true, 0, 0, 0.01),
            square (7, true, 5, 5, 1)});
  }

  void
  write (const std::string& name, const std::vector<Json>& planes) const
  {
    folder_.write (name, Json{{"planes", planes}}.dump());
  }
};

TEST_F (PlanesCommand, TellsWhichPlanesAreOneAndHowFarApart)
{
  const Json json = jsonOf ("planes a.json b.json");
  ASSERT_EQ (json["matched"].size(), 2U);
  EXPECT_EQ (json["matched"][0]["a"], 1);
  EXPECT_EQ (json["matched"][0]["b"], 2);
  EXPECT_NEAR (json["matched"][0]["offset"], 0.01, 1e-9);
  EXPECT_NEAR (json["matched"][0]["angle"], 0.0, 1e-9);
  EXPECT_EQ (json["matched"][1]["a"], 2);
  EXPECT_EQ (json["matched"][1]["b"], 1);
  EXPECT_EQ (json["only_a"], Json{3});
  EXPECT_EQ (json["only_b"], Json{7});
  const std::string table = expectDone ("planes a.json b.json").out;
  for (const char* part : {"| 0.0100 |", "only_a                            [3]\n"})
    EXPECT_TRUE (contains (table, part));
}

TEST_F (PlanesCommand, GoesByTheEquationWhereThereIsNoHull)
{
  Json floor = square (4, true, 0, 0, 0.01);
  floor.erase ("hull");
  write ("b.json", {floor});
  const Json json = jsonOf ("planes a.json b.json");
  ASSERT_EQ (json["matched"].size(), 1U);
  EXPECT_EQ (json["matched"][0]["a"], 1);
}

TEST_F (PlanesCommand, IsTheSameFarFromZero)
{
  const double x = 500000, y = 5400000, z = 300;
  write ("a.json", {square (1, true, x, y, z), square (2, false, x + 3, y, z + 1)});
  write ("b.json", {square (1, true, x, y, z + 0.01), square (2, true, x, y, z + 2)});
  const Json json = jsonOf ("planes a.json b.json");
  ASSERT_EQ (json["matched"].size(), 1U);
  EXPECT_NEAR (json["matched"][0]["offset"], 0.01, 1e-6);
}

TEST_F (PlanesCommand, NamesFileAndKeyOfWhatIsWrong)
{
  const auto expect = [&] (const std::string& complaint) {
    expectRefused ("planes a.json bad.json", "bad.json: " + complaint);
  };
  expect ("does not exist");
  for (const auto& [text, complaint] : {std::pair ("{", "is no JSON"),
                                        {"[1]", "planes is missing"},
                                        {"{\"planes\": 3}", "planes is no list"}}) {
    folder_.write ("bad.json", text);
    expect (complaint);
  }
  const Json plane = square (1, true, 0, 0, 0);
  for (const std::string key :
       {"id", "orientation", "points", "centroid", "rms", "coefficients"}) {
    Json without = plane;
    without.erase (key);
    write ("bad.json", {plane, without});
    expect ("planes[1]." + key + " is missing");
  }
  const std::tuple<const char*, Json, const char*> wrong[] = {
      {"id", -1, "id is no whole number from 0"},
      {"points", 0, "points is too small"},
      {"rms", "x", "rms is no number"},
      {"centroid", {1, 2}, "centroid has not 3 numbers"},
      {"centroid", {1, 2, "x"}, "centroid[2] is no number"},
      {"coefficients", {0, 0, 0, 1}, "coefficients has the normal 0 0 0"},
      {"orientation", "steep", "orientation is not horizontal, vertical or other"},
      {"hull", {{1, 2, 3}, 4}, "hull[1] is no list"},
      // What could not be squared.
      {"points", 1e200, "points is too large"},
      {"rms", 1e200, "rms is too large"},
      {"centroid", {1e308, 0, 0}, "centroid[0] is too large"},
      {"coefficients", {1e308, 1e308, 1e308, 1}, "coefficients[0] is too large"},
      {"hull", {{0, 0, 0}, {1, 0, 0}, {1, -1e200, 0}}, "hull[2][1] is too large"}};
  for (const auto& [key, value, complaint] : wrong) {
    Json bad = plane;
    bad[key] = value;
    write ("bad.json", {bad});
    expect (std::string ("planes[0].") + complaint);
  }
}

TEST_F (PlanesCommand, MatchesInTheLargestUnitACloudCanHave)
{
  constexpr double unit = 1e38;
  Json far = square (1, true, 0, 0, 0);
  far["rms"] = 0.002 * unit;
  for (Json& corner : far["hull"])
    for (Json& number : corner)
      number = number.get<double>() * unit;
  write ("a.json", {far});
  write ("b.json", {far});
  EXPECT_EQ (jsonOf ("planes a.json b.json")["matched"].size(), 1U);
}

} // namespace
