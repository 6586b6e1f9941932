// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/program_folder.h>

#include <string>

namespace {

constexpr const char* quick = " --runs 1 --memory-points 2000";

class BenchmarkProgram : public ProgramFolder {
protected:
  BenchmarkProgram() : ProgramFolder (PCL_OPS_BENCHMARK_PROGRAM) {}
};

} // namespace

TEST_F (BenchmarkProgram, PrintsMarkdownTablesAndWritesTimesAndMemoryAsJson)
{
  const std::string said =
      expectDone (std::string ("simulated:2000 --json out.json") + quick).out;
  EXPECT_EQ (said.find ("**Times [ms], scan-2000, 2000 points**\n\n| "), 0u) << said;
  for (const char* part : {"| ops ", "| copy of the cloud ", "- Machine: ", "MB more"})
    EXPECT_TRUE (contains (said, part)) << part;
  const auto json = jsonIn ("out.json");
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

TEST_F (BenchmarkProgram, MeasuresEveryCloudOfAFolderAndLeavesOutBrokenOnes)
{
  for (const char* name : {"first.pcd", "second.pcd"})
    shell (std::string ("'" PCL_OPS_SIMULATE_PROGRAM "' --points 2000 --quiet ") +
           name);
  folder_.write ("third.pcd", "VERSION 0.7\nFIELDS x y z\n");
  const Outcome done = run (std::string (". --no-peers") + quick);
  EXPECT_EQ (done.exit_code, 1);
  for (const char* part :
       {"left out: ./third.pcd", "first.pcd, 2000 points", "second.pcd, 2000 points"})
    EXPECT_TRUE (contains (done.out + done.err, part));
  EXPECT_FALSE (contains (done.out, "pcl-sac")) << done.out;
}

TEST_F (BenchmarkProgram, ScalingWritesEverySeries)
{
  expectDone (std::string ("simulated:2000 --no-peers --scaling out "
                           "--scaling-points 1000,3000") +
              quick);
  const std::string csv = contentOf (folder_ / "out/scaling.csv");
  for (const char* row : {"\npoints,1000,",
                          "\npoints,3000,",
                          "\nthreads,2,",
                          ",\"scan-2000\",",
                          "\nsampling_rate,0.3,",
                          "\nplanes,300,"})
    EXPECT_TRUE (contains (csv, row)) << row;
}
