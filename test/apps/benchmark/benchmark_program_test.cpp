// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/run_program.h>
#include <support/temporary_folder.h>

#include <filesystem>
#include <string>

namespace {

constexpr const char* quick = " --runs 1 --memory-points 2000";

ProgramRun
measure (const std::string& arguments)
{
  return runProgram (PCL_OPS_BENCHMARK_PROGRAM, arguments);
}

/** The JSON of a run that works. */
nlohmann::json
jsonOf (const std::string& arguments)
{
  const TemporaryFolder folder ("_json");
  const ProgramRun run = measure (arguments + quick + " --json " + folder / "out.json");
  EXPECT_EQ (run.exit_code, 0) << run.text;
  return nlohmann::json::parse (contentOf (folder / "out.json"));
}

void
simulate (const std::string& file)
{
  runProgram (PCL_OPS_SIMULATE_PROGRAM, file + " --points 2000 --quiet");
}

} // namespace

TEST (BenchmarkProgram, WritesTimesAndMemoryAsJson)
{
  const auto cloud = jsonOf ("simulated:2000")["clouds"][0];
  EXPECT_EQ (cloud["points"], 2000);
  EXPECT_EQ (cloud["peak_memory"]["cloud_bytes"], 32000.0);
  for (const char* measure : {"KdTreeFLANN construction",
                              "copy of the cloud",
                              "ops",
                              "ops, two threads",
                              "kht",
                              "pcl-sac"})
    EXPECT_GT (cloud["times"][measure]["detection_ms"].get<double>(), 0.0) << measure;
}

TEST (BenchmarkProgram, PrintsMarkdownTables)
{
  const ProgramRun run = measure (std::string ("simulated:2000 --no-peers") + quick);
  EXPECT_EQ (run.exit_code, 0);
  EXPECT_EQ (run.text.rfind ("**Times [ms], scan-2000, 2000 points**\n\n| ", 0), 0u)
      << run.text;
  for (const char* part : {"| ops ", "| copy of the cloud ", "- Machine: ", "MB more"})
    EXPECT_NE (run.text.find (part), std::string::npos) << part << run.text;
  EXPECT_EQ (run.text.find ("pcl-sac"), std::string::npos) << run.text;
}

TEST (BenchmarkProgram, MeasuresEveryCloudOfAFolderAndLeavesOutBrokenOnes)
{
  const TemporaryFolder folder;
  for (const char* name : {"first.pcd", "second.pcd"})
    simulate (folder / name);
  EXPECT_EQ (jsonOf (folder.path() + " --no-peers")["clouds"].size(), 2u);
  folder.write ("third.pcd", "VERSION 0.7\nFIELDS x y z\n");
  const ProgramRun run = measure (folder.path() + " --no-peers" + quick);
  EXPECT_EQ (run.exit_code, 1);
  EXPECT_NE (run.text.find ("left out: " + folder / "third.pcd"), std::string::npos);
  EXPECT_NE (run.text.find ("second.pcd, 2000 points"), std::string::npos) << run.text;
}

TEST (BenchmarkProgram, ScalingWritesEverySeries)
{
  const TemporaryFolder folder;
  const ProgramRun run = measure ("simulated:2000 --no-peers --scaling " +
                                  folder / "out --scaling-points 1000,3000" + quick);
  EXPECT_EQ (run.exit_code, 0) << run.text;
  const std::string csv = contentOf (folder / "out/scaling.csv");
  for (const char* row : {"\npoints,1000,",
                          "\npoints,3000,",
                          "\nthreads,2,",
                          ",\"scan-2000\",",
                          "\nsampling_rate,0.3,",
                          "\nplanes,300,"})
    EXPECT_NE (csv.find (row), std::string::npos) << row << csv;
}

TEST (BenchmarkProgram, RefusesWrongUsage)
{
  expectError (measure (""), 2, "INPUT");
  expectError (measure ("simulated:100 --runs 0"), 2, "--runs");
  expectError (measure ("simulated:many"), 2, "simulated");
  expectError (measure ("simulated:,"), 2, "simulated");
  expectError (measure ("simulated:9 --scaling-points 3,x"), 2, "--scaling-points");
  expectError (measure ("simulated:100 --no-peers --peer-runs 2"), 2, "--no-peers");
  expectError (measure ("simulated:100 --color"), 2, "--color");
}

TEST (BenchmarkProgram, SaysWhatIsMissingOrInTheWay)
{
  const TemporaryFolder folder;
  expectError (measure ("/no/such.pcd"), 1, "/no/such.pcd");
  expectError (measure (folder.path()), 1, folder.path());
  const std::string broken = folder.write ("broken.pcd", "VERSION 0.7\nFIELDS x\n");
  expectError (measure (broken + quick), 1, broken);
  const std::string output = folder / "absent/out.json";
  expectError (measure ("simulated:100 --json " + output), 1, output);
  EXPECT_EQ (measure ("simulated:100 --scaling " + broken).exit_code, 1);
  EXPECT_EQ (folder.fileCount(), 1u);
}
