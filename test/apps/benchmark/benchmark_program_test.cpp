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

} // namespace

TEST (BenchmarkProgram, PrintsMarkdownTablesAndWritesTimesAndMemoryAsJson)
{
  const TemporaryFolder folder;
  const ProgramRun run = measure (std::string ("simulated:2000") + quick + " --json " +
                                  folder / "out.json");
  ASSERT_EQ (run.exit_code, 0) << run.text;
  EXPECT_EQ (run.text.rfind ("**Times [ms], scan-2000, 2000 points**\n\n| ", 0), 0u)
      << run.text;
  for (const char* part : {"| ops ", "| copy of the cloud ", "- Machine: ", "MB more"})
    EXPECT_NE (run.text.find (part), std::string::npos) << part << run.text;
  const auto json = nlohmann::json::parse (contentOf (folder / "out.json"));
  const auto& cloud = json["clouds"][0];
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

TEST (BenchmarkProgram, MeasuresEveryCloudOfAFolderAndLeavesOutBrokenOnes)
{
  const TemporaryFolder folder;
  for (const char* name : {"first.pcd", "second.pcd"})
    runProgram (PCL_OPS_SIMULATE_PROGRAM, folder / name + " --points 2000 --quiet");
  folder.write ("third.pcd", "VERSION 0.7\nFIELDS x y z\n");
  const ProgramRun run = measure (folder.path() + " --no-peers" + quick);
  EXPECT_EQ (run.exit_code, 1);
  for (const std::string& part : {"left out: " + folder / "third.pcd",
                                  std::string ("first.pcd, 2000 points"),
                                  std::string ("second.pcd, 2000 points")})
    EXPECT_NE (run.text.find (part), std::string::npos) << run.text;
  EXPECT_EQ (run.text.find ("pcl-sac"), std::string::npos) << run.text;
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
