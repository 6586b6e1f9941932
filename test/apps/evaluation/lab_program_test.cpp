// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <boost/algorithm/string/replace.hpp>

#include <support/program_folder.h>

#include <array>
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
    return shell ("{ PATH=\"" PCL_OPS_PROGRAMS ":$PATH\"; PYTHON='" PCL_OPS_PYTHON3
                  "'; REPORT='" PCL_OPS_REPORT "'; " +
                  command + "; }");
  }

  static void
  expectValue (const Json& json,
               const Json::json_pointer& place,
               const std::string& what)
  {
    constexpr double tolerance = 1e-6;
    if (what == "absent")
      EXPECT_FALSE (json.contains (place));
    else if (what.front() == '>')
      EXPECT_GT (json.at (place).get<double>(), std::stod (what.substr (1)));
    else if (what.front() == '<')
      EXPECT_LT (json.at (place).get<double>(), std::stod (what.substr (1)));
    else if (const Json value = json.at (place); value.is_number())
      EXPECT_NEAR (value.get<double>(), Json::parse (what).get<double>(), tolerance);
    else
      EXPECT_EQ (value, Json::parse (what));
  }

  /** Looks where a row says for what it says. */
  void
  expect (const Outcome& done, const std::string& where, std::string what) const
  {
    boost::replace_all (what, "\\n", "\n");
    const bool is_absent = where.front() == '!';
    const std::size_t hash = where.find ('#');
    const std::string name = where.substr (is_absent, hash - is_absent);
    std::string text = done.err;
    if (name.empty() || name == "out")
      text = done.out;
    else if (name != "err" && name != "line")
      text = contentOf (folder_ / name);
    if (hash != std::string::npos)
      expectValue (
          Json::parse (text), Json::json_pointer (where.substr (hash + 1)), what);
    else if (name == "line" || what.front() == '^')
      EXPECT_EQ (text.find (what.substr (what.front() == '^')), 0u) << text;
    else
      EXPECT_EQ (bool (contains (text, what)), !is_absent) << text;
    EXPECT_TRUE (name != "line" || lines (text) == 1) << text;
  }

  /** \param[in] name of a program, whose table it is */
  void
  expectTable (const std::string& name) const
  {
    fs::copy (
        PCL_OPS_LAB_TABLES "/inputs", folder_.path(), fs::copy_options::recursive);
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
};

TEST_F (LabProgram, Simulates) { expectTable ("simulate"); }

TEST_F (LabProgram, Evaluates) { expectTable ("evaluate"); }

TEST_F (LabProgram, Reports)
{
  if (!fs::exists (PCL_OPS_PYTHON3))
    GTEST_SKIP() << "no Python";
  expectTable ("report");
}

TEST_F (LabProgram, Benchmarks)
{
  if (!fs::exists (PCL_OPS_PROGRAMS "/pcl_ops_benchmark"))
    GTEST_SKIP() << "pcl_ops_benchmark is not built";
  expectTable ("benchmark");
}

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
  const auto json = Json::parse (
      runCommand ("pcl_ops_evaluate track clouds clouds --poses poses.txt --json").out);
  for (const std::string errors : {"offset_errors", "tilt_errors"}) {
    EXPECT_NEAR (json[errors + "_median"], 0.67, 0.3) << json;
    EXPECT_NEAR (json[errors + "_90"], 1.64, 0.6) << json;
  }
}

} // namespace
