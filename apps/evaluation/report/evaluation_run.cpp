// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_run.h"

#include <pcl/common/io.h>

#include <cli/errors.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <detection/methods.h>
#include <evaluation/metrics/metrics.h>
#include <io/labeled_pcd.h>
#include <io/output_file.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <mutex>
#include <set>
#include <sstream>

namespace pcl_ops::evaluation {

namespace {

namespace fs = std::filesystem;

constexpr const char* fewer_at_a_time = "give a smaller cloud or fewer --jobs";

/** The numbers of a row and their columns. */
NamedValues
namedValues (const Metrics& metrics = compareLabels ({}, {}, {}),
             const DetectorRun& run = {})
{
  NamedValues values{{"points", double (metrics.points)},
                     {"truth_planes", double (metrics.truth_planes)},
                     {"result_planes", double (metrics.result_planes)},
                     {"planes_before_merging", double (run.planes_before_merging)}};
  values.insert (values.end(), metrics.named.begin(), metrics.named.end());
  for (const auto& [stage, duration] : apps::detection_stages)
    values.emplace_back (std::string (stage) + "_ms", run.durations.*duration);
  values.emplace_back (off_planes_name, metrics.points_off_planes_called_planes);
  const NamedValues counts = namedCounts (metrics);
  values.insert (values.end(), counts.begin(), counts.end());
  return values;
}

std::string
headerLine ()
{
  std::string line = "data_set,cloud,truth,configuration,seed";
  for (const auto& named : namedValues())
    line += ',' + named.first;
  return line;
}

/** A cell of RFC 4180, quoted where it has to be, and a comma. A name's line break
 * becomes a space, so that a row is always a line. */
std::string
csvCell (std::string text)
{
  std::replace (text.begin(), text.end(), '\n', ' ');
  std::ostringstream cell;
  if (text.find_first_of (",\"") == std::string::npos)
    cell << text << ',';
  else
    cell << std::quoted (text, '"', '"') << ',';
  return cell.str();
}

/** A CSV file that grows row by row. Its calls may be made by several threads. */
class ResultsFile {
public:
  explicit ResultsFile (const std::string& file) : file_ (file)
  {
    std::ifstream before (file, std::ios::binary);
    const std::string text (std::istreambuf_iterator<char> (before), {});
    const std::size_t complete = text.rfind ('\n') + 1; // 0 where there is no line
    if (complete < text.size())
      fs::resize_file (file, complete);
    std::istringstream rows (text.substr (0, complete));
    std::string line;
    if (std::getline (rows, line) && line != headerLine())
      throw apps::WorkError (
          file,
          "has other columns than this version writes; give another output folder");
    while (std::getline (rows, line))
      lines_.insert (line);
    stream_.open (file, std::ios::app);
    if (complete == 0)
      stream_ << headerLine() << '\n';
    if (!stream_.flush())
      throw apps::OutputError (file, "cannot be written; give another output folder");
  }

  /** \param[in] cells that the row begins with */
  bool
  has (const std::string& cells) const
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    const auto line = lines_.lower_bound (cells);
    return line != lines_.end() && line->rfind (cells, 0) == 0;
  }

  void
  add (const std::string& cells, const NamedValues& values)
  {
    constexpr int digits = 7;
    std::ostringstream line;
    line.precision (digits);
    line << cells;
    for (const auto& named : values)
      line << (&named == values.data() ? "" : ",") << named.second;
    const std::lock_guard<std::mutex> lock (mutex_);
    const std::uintmax_t size = fs::file_size (file_);
    if (!(stream_ << line.str() + '\n') || !stream_.flush()) {
      stream_.close();
      std::error_code ignored;
      fs::resize_file (file_, size, ignored); // without the part of a row that had room
      throw apps::OutputError (
          file_,
          "cannot be written; make room and run it again, which goes on from here");
    }
    lines_.insert (line.str());
  }

private:
  std::string file_;
  std::ofstream stream_;
  std::set<std::string> lines_;
  mutable std::mutex mutex_;
};

/** One evaluation: what its threads share. */
struct Evaluation {
  const EvaluationPlan& plan;
  ResultsFile results;
  apps::Progress progress;
  EvaluationSummary summary = {};
  std::mutex counting = {};

  void
  count (std::size_t EvaluationSummary::*what, const std::string& message = "")
  {
    const std::lock_guard<std::mutex> lock (counting);
    ++(summary.*what);
    if (!message.empty())
      progress.note (apps::errorLine (message));
  }

  std::string
  keyOf (const CloudSource& source, bool has_truth, const Configuration& configuration)
  {
    return csvCell (source.data_set) + csvCell (source.name) +
           csvCell (truthName (has_truth, plan.truth)) + csvCell (configuration.name) +
           csvCell (std::to_string (plan.settings.seed));
  }

  void
  evaluateCloud (const CloudSource& source)
  {
    // Known without loading the cloud only where its rows say which truth it has.
    const auto is_there = [&] (const Configuration& configuration) {
      return results.has (keyOf (source, false, configuration)) ||
             results.has (keyOf (source, true, configuration));
    };
    const std::vector<Configuration>& all = plan.configurations;
    if (std::all_of (all.begin(), all.end(), is_there))
      return count (&EvaluationSummary::clouds);
    EvaluationCloud cloud;
    PlaneLabels truth;
    try {
      apps::inMemory (source.name, fewer_at_a_time, [&] {
        cloud = source.load();
        truth = truthOf (cloud, plan.truth);
      });
    }
    catch (const apps::OutputError&) {
      throw;
    }
    catch (const std::exception& error) {
      return count (&EvaluationSummary::broken_clouds,
                    std::string ("left out: ") + error.what());
    }
    saveLabels (source, "truth", *cloud.cloud, truth);
    for (const Configuration& configuration : all)
      if (!configuration.needs_image || cloud.image)
        evaluateConfiguration (source, configuration, cloud, truth);
    count (&EvaluationSummary::clouds);
  }

  void
  saveLabels (const CloudSource& source,
              const std::string& name,
              const XyzCloud& cloud,
              const PlaneLabels& labels) const
  {
    if (plan.labels_folder.empty())
      return;
    pcl::PointCloud<pcl::PointXYZL> labeled;
    pcl::copyPointCloud (cloud, labeled);
    for (std::size_t i = 0; i < labels.size(); ++i)
      labeled[i].label = labels[i];
    const fs::path folder =
        fs::path (plan.labels_folder) / source.data_set / source.name;
    apps::makeFolder (folder.string());
    apps::saveLabeledPcd ((folder / (name + ".pcd")).string(), labeled);
  }

  /** All numbers, or of a run that was stopped none but how long it took, so that it is
   * not tried again. */
  NamedValues
  valuesOf (const CloudSource& source,
            const Configuration& configuration,
            const EvaluationCloud& cloud,
            const PlaneLabels& truth)
  {
    RunSettings settings = plan.settings;
    settings.up = cloud.up;
    settings.clock = Clock::Processor;
    settings.image = cloud.image;
    if (const std::optional<DetectorRun> run =
            runLimited (configuration, cloud.cloud, settings, plan.time_limit)) {
      saveLabels (source, configuration.name, *cloud.cloud, run->labels);
      return namedValues (compareLabels (*cloud.cloud, truth, run->labels, {cloud.up}),
                          *run);
    }
    count (&EvaluationSummary::stopped_runs,
           configuration.name + " on " + source.name + ": stopped after " +
               std::to_string (plan.time_limit) + " s; more by --time-limit");
    NamedValues values = namedValues();
    for (auto& [column, value] : values)
      value = column == "detection_ms" ? 1e3 * plan.time_limit
                                       : std::numeric_limits<double>::quiet_NaN();
    return values;
  }

  void
  evaluateConfiguration (const CloudSource& source,
                         const Configuration& configuration,
                         const EvaluationCloud& cloud,
                         const PlaneLabels& truth)
  {
    const std::string key = keyOf (source, cloud.truth.has_value(), configuration);
    if (results.has (key))
      return;
    NamedValues values;
    try {
      values = apps::inMemory (configuration.name, fewer_at_a_time, [&] {
        return valuesOf (source, configuration, cloud, truth);
      });
    }
    catch (const std::exception& error) {
      return count (&EvaluationSummary::failed_runs,
                    configuration.name + " failed on " + source.name + ": " +
                        error.what());
    }
    results.add (key, values);
    count (&EvaluationSummary::new_rows);
  }
};

} // namespace

EvaluationSummary
evaluate (const EvaluationPlan& plan,
          const std::string& file,
          std::ostream& messages,
          bool is_terminal)
{
  Evaluation evaluation{
      plan,
      ResultsFile (file),
      {plan.clouds.size(), messages, apps::progressStyleOf (is_terminal)}};
  apps::runInParallel (plan.clouds.size(), plan.jobs, [&] (std::size_t i) {
    evaluation.evaluateCloud (plan.clouds[i]);
    evaluation.progress.step();
  });
  return evaluation.summary;
}

} // namespace pcl_ops::evaluation
