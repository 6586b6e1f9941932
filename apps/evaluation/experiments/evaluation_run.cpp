// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_run.h"

#include <cli/errors.h>
#include <cli/parallel.h>
#include <cli/program.h>

#include <atomic>
#include <exception>

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
    return {clouds_, new_rows_, broken_clouds_, failed_runs_};
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
    for (const Configuration& configuration : plan_.configurations)
      evaluateConfiguration (task, configuration, cloud, truth);
    ++clouds_;
  }

  ResultRow
  emptyRow (const CloudTask& task, const std::string& truth) const
  {
    return {task.data_set, task.source->name, truth, "", plan_.seed, {}};
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
  evaluateConfiguration (const CloudTask& task,
                         const Configuration& configuration,
                         const EvaluationCloud& cloud,
                         const PlaneLabels& truth)
  {
    ResultRow row = emptyRow (task, truthName (cloud, plan_.truth));
    row.configuration = configuration.name;
    if (results_.has (row.key()))
      return;
    try {
      row.values = apps::inMemory (configuration.name, fewer_at_a_time, [&] {
        const DetectorRun run = configuration.run (cloud.cloud, cloud.up, plan_.seed);
        return valuesOf (compareLabels (*cloud.cloud, truth, run.labels, {cloud.up}),
                         run);
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
  std::atomic<std::size_t> clouds_{0}, new_rows_{0}, broken_clouds_{0}, failed_runs_{0};
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
