// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_run.h"

#include <pcl/common/io.h>

#include <cli/errors.h>
#include <cli/parallel.h>
#include <cli/program.h>
#include <evaluation/detectors/limited_run.h>
#include <io/labeled_pcd.h>
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
  : plan_ (plan), results_ (results)
  {
    for (const DataSet& data_set : plan.data_sets)
      for (const CloudSource& source : data_set.clouds)
        tasks_.push_back ({data_set.name, &source});
    progress_.emplace (tasks_.size(), messages, apps::progressStyleOf (is_terminal));
  }

  EvaluationSummary
  run ()
  {
    apps::runInParallel (tasks_.size(), plan_.jobs, [this] (std::size_t i) {
      evaluateCloud (tasks_[i]);
      progress_->step();
    });
    return {clouds_, new_rows_, broken_clouds_, failed_runs_, stopped_runs_};
  }

private:
  void
  note (const std::string& line)
  {
    progress_->note (apps::errorLine (line));
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
      note (std::string ("left out: ") + error.what());
      return;
    }
    saveLabels (task, "truth", *cloud.cloud, truth);
    for (const Configuration& configuration : plan_.configurations)
      evaluateConfiguration (task, configuration, cloud, truth);
    ++clouds_;
  }

  ResultKey
  keyOf (const CloudTask& task,
         const std::string& truth,
         const Configuration& configuration) const
  {
    return {task.data_set,
            task.source->name,
            truth,
            configuration.name,
            plan_.settings.seed};
  }

  /** Known without loading the cloud only where its rows say which truth it has. */
  bool
  isComplete (const CloudTask& task) const
  {
    const std::string grown = truthName (EvaluationCloud{}, plan_.truth);
    return std::all_of (plan_.configurations.begin(),
                        plan_.configurations.end(),
                        [&] (const Configuration& configuration) {
                          return results_.has (keyOf (task, grown, configuration)) ||
                                 results_.has (
                                     keyOf (task, exact_truth, configuration));
                        });
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

  /** All numbers, or of a run that was stopped none but how long it took, so that it is
   * not tried again. */
  NamedValues
  valuesOf (const Configuration& configuration,
            const EvaluationCloud& cloud,
            const PlaneLabels& truth,
            const CloudTask& task)
  {
    if (const std::optional<DetectorRun> run = detect (configuration, cloud)) {
      saveLabels (task, configuration.name, *cloud.cloud, run->labels);
      return namedValues (compareLabels (*cloud.cloud, truth, run->labels, {cloud.up}),
                          *run);
    }
    ++stopped_runs_;
    note (configuration.name + " on " + task.source->name + ": stopped after " +
          std::to_string (plan_.time_limit) + " s; more by --time-limit");
    NamedValues values = namedValues (compareLabels ({}, {}, {}), {});
    for (auto& [column, value] : values)
      value = column == "detection_ms" ? 1e3 * plan_.time_limit
                                       : std::numeric_limits<double>::quiet_NaN();
    return values;
  }

  void
  evaluateConfiguration (const CloudTask& task,
                         const Configuration& configuration,
                         const EvaluationCloud& cloud,
                         const PlaneLabels& truth)
  {
    const ResultKey key = keyOf (task, truthName (cloud, plan_.truth), configuration);
    if (results_.has (key) || (configuration.needs_grid && !cloud.grid))
      return;
    NamedValues values;
    try {
      values = apps::inMemory (configuration.name, fewer_at_a_time, [&] {
        return valuesOf (configuration, cloud, truth, task);
      });
    }
    catch (const std::exception& error) {
      ++failed_runs_;
      note (configuration.name + " failed on " + key.cloud + ": " + error.what());
      return;
    }
    results_.add (key, values);
    ++new_rows_;
  }

  const EvaluationPlan& plan_;
  ResultsFile& results_;
  std::vector<CloudTask> tasks_;
  std::optional<apps::Progress> progress_;
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
