// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_run.h"

#include <pcl/common/io.h>

#include <cli/errors.h>
#include <cli/parallel.h>
#include <cli/program.h>
#include <evaluation/detectors/limited_run.h>
#include <io/cloud_file.h>
#include <io/output_file.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <filesystem>
#include <limits>

namespace pcl_ops::evaluation {

namespace {

constexpr const char* fewer_at_a_time = "give a smaller cloud or fewer --jobs";

struct CloudTask {
  std::string data_set;
  const CloudSource* source;
};

/** One evaluation: what its threads share. */
class Evaluation {
public:
  Evaluation (const EvaluationPlan& plan,
              ResultsFile& results,
              std::ostream& messages,
              bool is_terminal)
  : plan_ (plan)
  , results_ (results)
  , tasks_ (tasksOf (plan))
  , progress_ (tasks_.size(), messages, apps::progressStyleOf (is_terminal))
  {}

  EvaluationSummary
  run ()
  {
    apps::runInParallel (tasks_.size(), plan_.jobs, [this] (std::size_t i) {
      evaluateCloud (tasks_[i]);
      progress_.step();
    });
    return {clouds_, new_rows_, broken_clouds_, failed_runs_, stopped_runs_};
  }

private:
  static std::vector<CloudTask>
  tasksOf (const EvaluationPlan& plan)
  {
    std::vector<CloudTask> tasks;
    for (const DataSet& data_set : plan.data_sets)
      for (const CloudSource& source : data_set.clouds)
        tasks.push_back ({data_set.name, &source});
    return tasks;
  }

  void
  evaluateCloud (const CloudTask& task)
  {
    if (isComplete (task)) {
      ++clouds_;
      return;
    }
    EvaluationCloud cloud;
    PlaneLabels truth;
    try {
      apps::inMemory (task.source->name, fewer_at_a_time, [&] {
        cloud = task.source->load();
        truth = truthOf (cloud, plan_.truth);
      });
    }
    catch (const apps::OutputError&) {
      throw;
    }
    catch (const std::exception& error) {
      ++broken_clouds_;
      progress_.note (apps::errorLine (std::string ("left out: ") + error.what()));
      return;
    }
    saveLabels (task, "truth", *cloud.cloud, truth);
    for (const Configuration& configuration : plan_.configurations)
      evaluateConfiguration (task, configuration, cloud, truth);
    ++clouds_;
  }

  ResultRow
  emptyRow (const CloudTask& task, const std::string& truth) const
  {
    return {task.data_set, task.source->name, truth, "", plan_.settings.seed, {}};
  }

  /** Known without loading the cloud only where its rows say which truth it has. */
  bool
  isComplete (const CloudTask& task) const
  {
    for (const Configuration& configuration : plan_.configurations) {
      ResultRow row = emptyRow (task, truthName (EvaluationCloud{}, plan_.truth));
      row.configuration = configuration.name;
      const bool grown = results_.has (row.key());
      row.truth = exact_truth;
      if (!grown && !results_.has (row.key()))
        return false;
    }
    return true;
  }

  void
  saveLabels (const CloudTask& task,
              const std::string& name,
              const XyzCloud& cloud,
              const PlaneLabels& labels) const
  {
    if (plan_.labels_folder.empty())
      return;
    pcl::PointCloud<pcl::PointXYZL> labeled;
    pcl::copyPointCloud (cloud, labeled);
    for (std::size_t i = 0; i < labels.size(); ++i)
      labeled[i].label = labels[i];
    const std::filesystem::path folder =
        std::filesystem::path (plan_.labels_folder) / task.data_set / task.source->name;
    apps::makeFolder (folder.string());
    apps::saveLabeledPcd ((folder / (name + ".pcd")).string(), labeled);
  }

  std::optional<DetectorRun>
  detect (const Configuration& configuration, const EvaluationCloud& cloud) const
  {
    RunSettings settings = plan_.settings;
    settings.up = cloud.up;
    settings.clock = Clock::Processor;
    settings.grid = cloud.grid ? &*cloud.grid : nullptr;
    return configuration.is_peer
               ? runLimited (configuration, cloud.cloud, settings, plan_.time_limit)
               : configuration.run (cloud.cloud, settings);
  }

  /** Nothing but how long it took, so that it is not tried again. */
  std::vector<double>
  valuesOfStopped (const CloudTask& task, const Configuration& configuration)
  {
    ++stopped_runs_;
    progress_.note (apps::errorLine (
        configuration.name + " on " + task.source->name + ": stopped after " +
        std::to_string (plan_.time_limit) + " s; more by --time-limit"));
    constexpr double milliseconds = 1e3;
    DetectorRun run;
    run.durations.detection = milliseconds * plan_.time_limit;
    std::vector<double> values = valuesOf ({}, run);
    for (double& value : values)
      if (value != run.durations.detection)
        value = std::numeric_limits<double>::quiet_NaN();
    return values;
  }

  void
  evaluateConfiguration (const CloudTask& task,
                         const Configuration& configuration,
                         const EvaluationCloud& cloud,
                         const PlaneLabels& truth)
  {
    ResultRow row = emptyRow (task, truthName (cloud, plan_.truth));
    row.configuration = configuration.name;
    if (results_.has (row.key()) || (configuration.needs_grid && !cloud.grid))
      return;
    try {
      row.values = apps::inMemory (configuration.name, fewer_at_a_time, [&] {
        const std::optional<DetectorRun> run = detect (configuration, cloud);
        if (run)
          saveLabels (task, configuration.name, *cloud.cloud, run->labels);
        return run ? valuesOf (
                         compareLabels (*cloud.cloud, truth, run->labels, {cloud.up}),
                         *run)
                   : valuesOfStopped (task, configuration);
      });
    }
    catch (const std::exception& error) {
      ++failed_runs_;
      progress_.note (apps::errorLine (configuration.name + " failed on " +
                                       task.source->name + ": " + error.what()));
      return;
    }
    results_.add (row);
    ++new_rows_;
  }

  const EvaluationPlan& plan_;
  ResultsFile& results_;
  std::vector<CloudTask> tasks_;
  apps::Progress progress_;
  std::atomic<std::size_t> clouds_{0}, new_rows_{0}, broken_clouds_{0}, failed_runs_{0},
      stopped_runs_{0};
};

} // namespace

EvaluationSummary
evaluate (const EvaluationPlan& plan,
          ResultsFile& results,
          std::ostream& messages,
          bool is_terminal)
{
  return Evaluation (plan, results, messages, is_terminal).run();
}

} // namespace pcl_ops::evaluation
