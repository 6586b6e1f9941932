// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/run_program.h>
#include <support/temporary_folder.h>

#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;

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

class PlaneCommands : public testing::Test {
protected:
  /** \brief Floor and wall; in b.json the wall is first and the floor 1 cm higher, and
   * there is a table in place of the shelf. */
  PlaneCommands()
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

  ProgramRun
  compare (const std::string& options = "", const std::string& second = "b.json") const
  {
    return runProgram (PCL_OPS_EVALUATE_PROGRAM,
                       "planes '" + folder_ / "a.json" + "' '" + folder_ / second +
                           "' " + options);
  }

  TemporaryFolder folder_;
};

} // namespace

TEST_F (PlaneCommands, TellWhichPlanesAreOneAndHowFarApart)
{
  const ProgramRun run = compare ("--json");
  ASSERT_EQ (run.exit_code, 0) << run.text;
  const Json json = Json::parse (run.text);
  ASSERT_EQ (json["matched"].size(), 2U) << run.text;
  EXPECT_EQ (json["matched"][0]["a"], 1);
  EXPECT_EQ (json["matched"][0]["b"], 2);
  EXPECT_NEAR (json["matched"][0]["offset"], 0.01, 1e-9);
  EXPECT_NEAR (json["matched"][0]["angle"], 0.0, 1e-9);
  EXPECT_EQ (json["matched"][1]["a"], 2);
  EXPECT_EQ (json["matched"][1]["b"], 1);
  EXPECT_EQ (json["only_a"], Json{3});
  EXPECT_EQ (json["only_b"], Json{7});
}

TEST_F (PlaneCommands, PrintATable)
{
  const ProgramRun run = compare();
  EXPECT_EQ (run.exit_code, 0);
  EXPECT_NE (run.text.find ("0.0100"), std::string::npos) << run.text;
  EXPECT_NE (run.text.find ("a.json: 3\n"), std::string::npos) << run.text;
  EXPECT_NE (run.text.find ("b.json: 7\n"), std::string::npos) << run.text;
}

TEST_F (PlaneCommands, GoByTheEquationWhereThereIsNoHull)
{
  Json floor = square (4, true, 0, 0, 0.01);
  floor.erase ("hull");
  write ("b.json", {floor});
  const Json json = Json::parse (compare ("--json").text);
  ASSERT_EQ (json["matched"].size(), 1U);
  EXPECT_EQ (json["matched"][0]["a"], 1);
}

TEST_F (PlaneCommands, AreTheSameFarFromZero)
{
  const auto moved = [] (const Json& plane) {
    Json far = plane;
    const std::vector<double> shift = {500000.0, 5400000.0, 300.0};
    double along = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      far["centroid"][i] = plane["centroid"][i].get<double>() + shift[i];
      along += plane["coefficients"][i].get<double>() * shift[i];
      for (auto& corner : far["hull"])
        corner[i] = corner[i].get<double>() + shift[i];
    }
    far["coefficients"][3] = plane["coefficients"][3].get<double>() - along;
    return far;
  };
  write ("a.json",
         {moved (square (1, true, 0, 0, 0)), moved (square (2, false, 3, 0, 1))});
  write ("b.json",
         {moved (square (1, true, 0, 0, 0.01)), moved (square (2, true, 0, 0, 2))});
  const Json json = Json::parse (compare ("--json").text);
  ASSERT_EQ (json["matched"].size(), 1U);
  EXPECT_NEAR (json["matched"][0]["offset"], 0.01, 1e-6);
}

TEST_F (PlaneCommands, NameFileAndKeyOfWhatIsWrong)
{
  const auto expectRefused = [&] (const std::string& complaint) {
    const ProgramRun run = compare ("", "bad.json");
    EXPECT_EQ (run.exit_code, 1) << run.text;
    EXPECT_NE (run.text.find ("bad.json: " + complaint), std::string::npos) << run.text;
    EXPECT_EQ (std::count (run.text.begin(), run.text.end(), '\n'), 1) << run.text;
  };
  expectRefused ("does not exist");
  folder_.write ("bad.json", "{");
  expectRefused ("is no JSON");
  folder_.write ("bad.json", "[1]");
  expectRefused ("planes is missing");
  folder_.write ("bad.json", "{\"planes\": 3}");
  expectRefused ("planes is no list");
  const auto without = [&] (const char* key) {
    Json plane = square (1, true, 0, 0, 0);
    plane.erase (key);
    write ("bad.json", {square (1, true, 0, 0, 0), plane});
    expectRefused ("planes[1]." + std::string (key) + " is missing");
  };
  for (const char* key :
       {"id", "orientation", "points", "centroid", "rms", "coefficients"})
    without (key);
  const auto with = [&] (const char* key, const Json& value, const char* complaint) {
    Json plane = square (1, true, 0, 0, 0);
    plane[key] = value;
    write ("bad.json", {plane});
    expectRefused ("planes[0]." + std::string (complaint));
  };
  with ("id", -1, "id is no whole number from 0");
  with ("points", 0, "points is too small");
  with ("rms", "x", "rms is no number");
  with ("centroid", {1, 2}, "centroid has not 3 numbers");
  with ("centroid", {1, 2, "x"}, "centroid[2] is no number");
  with ("coefficients", {0, 0, 0, 1}, "coefficients has the normal 0 0 0");
  with ("orientation", "steep", "orientation is not horizontal, vertical or other");
  with ("hull", {{1, 2, 3}, 4}, "hull[1] is no list");
}

TEST_F (PlaneCommands, RefuseNumbersThatCannotBeSquared)
{
  const auto complaintAbout = [&] (const char* key, const Json& value) {
    Json plane = square (1, true, 0, 0, 0);
    plane[key] = value;
    write ("bad.json", {plane});
    const ProgramRun run = compare ("", "bad.json");
    EXPECT_EQ (run.exit_code, 1) << run.text;
    return run.text.substr (std::min (run.text.find ("planes[0]"), run.text.size()));
  };
  const auto too_large = [] (const std::string& entry) {
    return "planes[0]." + entry +
           " is too large; give planes as pcl_ops_segment --planes FILE.json and "
           "pcl_ops_tiles write them\n";
  };
  EXPECT_EQ (complaintAbout ("points", 1e200), too_large ("points"));
  EXPECT_EQ (complaintAbout ("rms", 1e200), too_large ("rms"));
  EXPECT_EQ (complaintAbout ("centroid", {1e308, 0, 0}), too_large ("centroid[0]"));
  EXPECT_EQ (complaintAbout ("coefficients", {1e308, 1e308, 1e308, 1}),
             too_large ("coefficients[0]"));
  EXPECT_EQ (complaintAbout ("hull", {{0, 0, 0}, {1, 0, 0}, {1, -1e200, 0}}),
             too_large ("hull[2][1]"));
}

TEST_F (PlaneCommands, MatchInTheLargestUnitACloudCanHave)
{
  constexpr double unit = 1e38;
  Json far = square (1, true, 0, 0, 0);
  far["rms"] = 0.002 * unit;
  for (Json& corner : far["hull"])
    for (Json& number : corner)
      number = number.get<double>() * unit;
  write ("a.json", {far});
  write ("b.json", {far});
  const ProgramRun run = compare ("--json");
  ASSERT_EQ (run.exit_code, 0) << run.text;
  EXPECT_EQ (Json::parse (run.text)["matched"].size(), 1U) << run.text;
}

TEST_F (PlaneCommands, CountPlanesThatKeepTheirNumber)
{
  const auto cloud = [] (const std::string& labels) {
    const std::size_t points =
        static_cast<std::size_t> (std::count (labels.begin(), labels.end(), ' ')) + 1;
    std::string text = "VERSION 0.7\nFIELDS x y z label\nSIZE 4 4 4 4\nTYPE F F F U\n"
                       "COUNT 1 1 1 1\nWIDTH " +
                       std::to_string (points) +
                       "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " +
                       std::to_string (points) + "\nDATA ascii\n";
    std::istringstream all (labels);
    int x = 0;
    for (std::string label; all >> label; ++x)
      text += std::to_string (x) + " 0 0 " + label + "\n";
    return text;
  };
  std::filesystem::create_directories (folder_ / "truth");
  std::filesystem::create_directories (folder_ / "result");
  const std::vector<std::string> results = {"4 4 5 5 6", "4 4 5 5 0", "4 4 7 7 0"};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const std::string name = "/" + std::to_string (i) + ".pcd";
    folder_.write ("truth" + name, cloud ("1 1 2 2 3"));
    folder_.write ("result" + name, cloud (results[i]));
  }
  const ProgramRun run = runProgram (PCL_OPS_EVALUATE_PROGRAM,
                                     "track '" + folder_ / "truth" + "' '" +
                                         folder_ / "result" + "' --json");
  ASSERT_EQ (run.exit_code, 0) << run.text;
  const Json json = Json::parse (run.text);
  EXPECT_EQ (json["planes"], 2) << "the third is found once only";
  EXPECT_EQ (json["planes_kept"], 1);
  EXPECT_EQ (json["sightings"], 4);
  EXPECT_EQ (json["sightings_kept"], 3);
  EXPECT_EQ (json["numbers"], 4);
}
