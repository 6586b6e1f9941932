// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/program_folder.h>

#include <string>
#include <tuple>
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

class PlanesCommand : public ProgramFolder {
protected:
  /** \brief Floor and wall; in b.json the wall is first and the floor 1 cm higher, and
   * there is a table in place of the shelf. */
  PlanesCommand() : ProgramFolder (PCL_OPS_EVALUATE_PROGRAM)
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

  Json
  compared () const
  {
    return Json::parse (expectDone ("planes a.json b.json --json").out);
  }
};

} // namespace

TEST_F (PlanesCommand, TellsWhichPlanesAreOneAndHowFarApart)
{
  const Json json = compared();
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
  const Json json = compared();
  ASSERT_EQ (json["matched"].size(), 1U);
  EXPECT_EQ (json["matched"][0]["a"], 1);
}

TEST_F (PlanesCommand, IsTheSameFarFromZero)
{
  const double x = 500000, y = 5400000, z = 300;
  write ("a.json", {square (1, true, x, y, z), square (2, false, x + 3, y, z + 1)});
  write ("b.json", {square (1, true, x, y, z + 0.01), square (2, true, x, y, z + 2)});
  const Json json = compared();
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
  for (const std::string key :
       {"id", "orientation", "points", "centroid", "rms", "coefficients"}) {
    Json plane = square (1, true, 0, 0, 0);
    plane.erase (key);
    write ("bad.json", {square (1, true, 0, 0, 0), plane});
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
    Json plane = square (1, true, 0, 0, 0);
    plane[key] = value;
    write ("bad.json", {plane});
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
  EXPECT_EQ (compared()["matched"].size(), 1U);
}
