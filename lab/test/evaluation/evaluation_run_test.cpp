// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <evaluation/data/changed_clouds.h>
#include <evaluation/report/evaluation_run.h>
#include <support/temporary_folder.h>
#include <support/text.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <csignal>
#include <cstdlib>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace {

using namespace pcl_ops::evaluation;

/** Ten points in a row, all on true plane 1. */
CloudSource
rowOfPoints (const std::string& name)
{
  return {"rows", name, [] {
            EvaluationCloud cloud;
            cloud.cloud.reset (new XyzCloud (10, 1));
            for (int i = 0; i < 10; ++i)
              (*cloud.cloud)[i] = pcl::PointXYZ (float (i), 0, 0);
            cloud.truth = PlaneLabels (10, 1);
            return cloud;
          }};
}

/** Returns a detector of others, which runs in a process of its own. */
Configuration
peer (const std::string& name, decltype (Configuration::run) run)
{
  constexpr bool is_peer = true;
  return {name, {}, std::move (run), is_peer};
}

/** Returns a detector that gives the first \p labeled points the label 1 and counts its
 * calls. */
Configuration
labeling (const std::string& name, std::size_t labeled, std::atomic<int>& calls)
{
  return {name, {}, [=, &calls] (const auto& cloud, const RunSettings&) {
            ++calls;
            DetectorRun run;
            run.labels.assign (cloud->size(), 0);
            std::fill_n (run.labels.begin(), std::min (labeled, cloud->size()), 1);
            run.planes_before_merging = 7;
            run.durations.detection = 1500.0;
            return run;
          }};
}

class EvaluationRunTest : public testing::Test {
protected:
  TemporaryFolder folder;
  std::string file = folder / "results.csv";
  std::atomic<int> calls{0};
  std::ostringstream messages;
  EvaluationPlan plan;

  EvaluationRunTest()
  {
    plan.file = file;
    plan.truth.min_points = 1;
    plan.clouds = {rowOfPoints ("a"), rowOfPoints ("b")};
    plan.configurations = {labeling ("all-right", 10, calls),
                           labeling ("half-right", 5, calls)};
  }

  EvaluationSummary
  run ()
  {
    constexpr bool is_terminal = false;
    return evaluate (plan, messages, is_terminal);
  }
};

TEST_F (EvaluationRunTest, WritesARowForEachCloudAndConfiguration)
{
  const EvaluationSummary summary = run();
  EXPECT_EQ (summary.clouds, 2u);
  EXPECT_EQ (summary.new_rows, 4u);
  const std::string rows = contentOf (file);
  // data_set,cloud,truth,configuration,seed,points,truth_planes,result_planes,
  // planes_before_merging,classification_accuracy,segmentation_accuracy,
  // segmentation_accuracy_all, ..., detection_ms
  for (const char* row : {"\nrows,a,exact,all-right,42,10,1,1,7,1,1,1,.*,1500,0,",
                          "\nrows,b,exact,half-right,42,10,1,1,7,1,0.5,0.5,.*,1500,0,"})
    EXPECT_TRUE (std::regex_search (rows, std::regex (row))) << rows;
}

TEST_F (EvaluationRunTest, EveryColumnHasANumberWhereTheTruthIsKnown)
{
  const auto squareOfPoints = [] {
    EvaluationCloud cloud;
    cloud.cloud.reset (new XyzCloud);
    for (int i = 0; i < 400; ++i)
      cloud.cloud->emplace_back (float (i % 20), float (i / 20), 0.0f);
    cloud.truth = PlaneLabels (400, 1);
    return cloud;
  };
  plan.clouds = {{"squares", "a", squareOfPoints}};
  plan.configurations = {labeling ("all-right", 400, calls)};
  plan.runs_on_changes = true;
  EXPECT_EQ (run().new_rows, 1u);
  EXPECT_EQ (lines (contentOf (file)), 2u) << "the header and a row";
  EXPECT_FALSE (contains (contentOf (file), "nan")) << contentOf (file);
}

TEST_F (EvaluationRunTest, EveryMetricHasAColumn)
{
  run();
  const std::string header = contentOf (file).substr (0, contentOf (file).find ('\n'));
  const Metrics metrics = compareLabels ({}, {}, {});
  for (const NamedValues& values : {metrics.named, namedCounts (metrics)})
    for (const auto& named : values)
      EXPECT_TRUE (contains (header + ',', ',' + named.first + ',')) << named.first;
}

TEST_F (EvaluationRunTest, RowsTellHowFarLabelsOfChangedCloudsAgree)
{
  // The first five of ten points are a plane. If thinning leaves one of the five out,
  // the plane has the other four and the sixth point.
  plan.clouds = {rowOfPoints ("a")};
  plan.configurations = {labeling ("all-right", 10, calls)};
  run();
  EXPECT_TRUE (contains (contentOf (file), ",nan,nan,nan,nan,nan\n"))
      << "not asked for";
  EXPECT_EQ (calls, 1);
  plan.configurations.push_back (labeling ("half-right", 5, calls));
  plan.runs_on_changes = true;
  run();
  EXPECT_EQ (calls, 1 + 1 + int (cloud_changes.size()));
  // moved, turned, thinned, jittered, rounded
  EXPECT_TRUE (std::regex_search (contentOf (file),
                                  std::regex ("half-right.*,1,1,(1|0\\.8),1,1\n")))
      << contentOf (file);
}

TEST_F (EvaluationRunTest, SamplesOfCloudsHaveTheTruthOfTheirPoints)
{
  plan.most_points = 6;
  plan.configurations = {labeling ("all-right", 10, calls)};
  run();
  EXPECT_TRUE (contains (contentOf (file),
                         "\nrows-6-points,a,exact,all-right,42,6,1,1,7,1,1,1,"))
      << contentOf (file);
}

TEST_F (EvaluationRunTest, TakesNoRowsOfOtherSamplesOrPositionsForItsOwn)
{
  run();
  for (const std::size_t most_points : {6, 5}) {
    plan.most_points = most_points;
    EXPECT_EQ (run().new_rows, 4u) << most_points;
  }
  plan.shift = {0.5f, 0.25f, -2.0f};
  EXPECT_EQ (run().new_rows, 4u);
  EXPECT_EQ (run().new_rows, 0u) << "the same once more";
  for (const char* begin :
       {"\nrows,a,", "\nrows-6-points,a,", "\nrows-5-points-shifted-0.5_0.25_-2,a,"})
    EXPECT_TRUE (contains (contentOf (file), begin)) << begin;
}

TEST_F (EvaluationRunTest, GoesOnWhereItWasInterrupted)
{
  run();
  EXPECT_EQ (run().new_rows, 0u);
  EXPECT_EQ (calls, 4) << "no row is computed twice";
  const std::string complete = contentOf (file);
  // The last row is cut in its middle, as by a power failure.
  std::filesystem::resize_file (file, complete.size() - 20);
  EXPECT_EQ (run().new_rows, 1u);
  EXPECT_EQ (contentOf (file), complete);
}

TEST_F (EvaluationRunTest, ManyThreadsAddConfigurationsToEarlierOnes)
{
  for (int i = 0; i < 20; ++i)
    plan.clouds.push_back (rowOfPoints ("cloud " + std::to_string (i)));
  plan.jobs = 4;
  EXPECT_EQ (run().new_rows, 44u);
  plan.configurations.push_back (labeling ("new", 3, calls));
  EXPECT_EQ (run().new_rows, 22u);
  EXPECT_EQ (lines (contentOf (file)), 1u + 66u);
}

TEST_F (EvaluationRunTest, APeerThatTakesTooLongIsStoppedAndNotTriedAgain)
{
  const auto hang = [] (const auto&, const auto&) -> DetectorRun {
    for (volatile bool forever = true; forever;) {
    }
    return {};
  };
  plan.configurations = {peer ("hanging", hang)};
  plan.clouds.resize (1);
  plan.time_limit = 1;
  EXPECT_EQ (run().stopped_runs, 1u);
  EXPECT_TRUE (contains (messages.str(), "hanging on a: stopped after 1 s"));
  EXPECT_TRUE (contains (contentOf (file), "\nrows,a,exact,hanging,42,nan,"));
  EXPECT_TRUE (contains (contentOf (file), ",nan,1000,nan,"));
  EXPECT_EQ (run().stopped_runs, 0u);
}

TEST_F (EvaluationRunTest, ADetectorThatFailsAndAPeerThatCrashesAreReportedAndCounted)
{
  const auto crash = [] (const auto&, const auto&) -> DetectorRun { std::abort(); };
  const auto fail = [] (const auto&, const auto&) -> DetectorRun {
    throw std::runtime_error ("no memory");
  };
  plan.configurations.insert (
      plan.configurations.begin(),
      {peer ("crashing", crash), peer ("failing", fail), {"failing here", {}, fail}});
  const EvaluationSummary summary = run();
  EXPECT_EQ (summary.failed_runs, 6u);
  EXPECT_EQ (summary.new_rows, 4u);
  for (const char* message : {"crashing failed on a: ",
                              "failing failed on a: no memory",
                              "failing here failed on a: no memory"})
    EXPECT_TRUE (contains (messages.str(), message));
}

TEST_F (EvaluationRunTest, ToldOfNoDetectorItOnlySavesTheClouds)
{
  plan.configurations.clear();
  plan.labels_folder = folder / "labels";
  EXPECT_EQ (run().clouds, 2u);
  for (const char* cloud : {"a", "b"})
    EXPECT_TRUE (
        std::filesystem::exists (folder / "labels/rows/" + cloud + "/truth.pcd"));
  EXPECT_EQ (lines (contentOf (file)), 1u) << "the header alone";
}

TEST_F (EvaluationRunTest, LabelsOfTheUsersFilesAreReadAgainInEachRun)
{
  std::set<std::string> asked;
  Configuration own = labeling ("own", 10, calls);
  own.is_own = true;
  own.run = [&, labels = own.run] (const auto& cloud, const RunSettings& settings) {
    asked.insert (settings.data_set + '/' + settings.cloud_name);
    return labels (cloud, settings);
  };
  plan.configurations = {own};
  run();
  EXPECT_EQ (asked, (std::set<std::string>{"rows/a", "rows/b"}));
  plan.configurations[0].run = labeling ("own", 5, calls).run;
  EXPECT_EQ (run().new_rows, 2u);
  EXPECT_TRUE (std::regex_search (contentOf (file), // up to segmentation accuracy
                                  std::regex ("a,exact,own,42,10,1,1,7,1,1,(.*\n)*"
                                              ".*a,exact,own,42,10,1,1,7,1,0.5,")))
      << contentOf (file);
}

TEST_F (EvaluationRunTest, AFullDiskLeavesTheRowsThatHadRoom)
{
  run();
  const std::string before = contentOf (file);
  plan.clouds.push_back (rowOfPoints ("c"));
  const auto usual_handler = std::signal (SIGXFSZ, SIG_IGN);
  rlimit usual{};
  ::getrlimit (RLIMIT_FSIZE, &usual);
  const rlimit as_on_a_full_disk{before.size() + 20, usual.rlim_max};
  ::setrlimit (RLIMIT_FSIZE, &as_on_a_full_disk);
  EXPECT_THROW (run(), pcl_ops::apps::OutputError);
  ::setrlimit (RLIMIT_FSIZE, &usual);
  std::signal (SIGXFSZ, usual_handler);
  EXPECT_EQ (contentOf (file), before);
  EXPECT_EQ (run().new_rows, 2u);
}

} // namespace
