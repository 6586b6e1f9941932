// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_run.h"

#include <pcl/common/io.h>

#include <cli/errors.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <detection/methods.h>
#include <io/labeled_pcd.h>
#include <io/output_file.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <mutex>
#include <sstream>

namespace pcl_ops::evaluation {

using namespace apps;

namespace {

namespace fs = std::filesystem;

constexpr const char* fewer_at_a_time = "give a smaller cloud or fewer --jobs";

NamedValues
namedValues (const Metrics& metrics = compareLabels ({}, {}, {}),
             const DetectorRun& run = {})
{
  NamedValues values{{"points", double (metrics.points)},
                     {"truth_planes", double (metrics.truth_planes)},
                     {"result_planes", double (metrics.result_planes)},
                     {"planes_before_merging", double (run.planes_before_merging)}};
  // Those of points off planes came later: their column is behind the times.
  const auto last = metrics.named.end() - 1;
  values.insert (values.end(), metrics.named.begin(), last);
  for (const auto& [stage, duration] : detection_stages)
    values.emplace_back (std::string (stage) + "_ms", run.durations.*duration);
  values.push_back (*last);
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

/** Its calls may be made by several threads. */
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
      throw WorkError (
          file,
          "has other columns than this version writes; give another output folder");
    while (std::getline (rows, line))
      lines_.insert (line);
    stream_.open (file, std::ios::app);
    if (complete == 0)
      stream_ << headerLine() << '\n';
    if (!stream_.flush())
      throw OutputError (file, "cannot be written; give another output folder");
  }

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
      throw OutputError (
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

struct LoadedCloud {
  const CloudSource& source;
  EvaluationCloud loaded = {};
  PlaneLabels truth = {};
};

struct Evaluation {
  const EvaluationPlan& plan;
  ResultsFile results;
  Progress progress;
  EvaluationSummary summary = {};
  std::mutex counting = {};

  void
  count (std::size_t EvaluationSummary::*what, const std::string& message = "")
  {
    const std::lock_guard<std::mutex> lock (counting);
    ++(summary.*what);
    if (!message.empty())
      progress.note (errorLine (message));
  }

  std::string
  keyOf (const CloudSource& source, bool has_truth, const Configuration& configuration)
  {
    const std::string truth =
        has_truth ? "exact" : "grown-k" + std::to_string (plan.truth.neighbors);
    return csvCell (source.data_set) + csvCell (source.name) + csvCell (truth) +
           csvCell (configuration.name) + csvCell (std::to_string (plan.settings.seed));
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
    LoadedCloud cloud{source};
    try {
      inMemory (source.name, fewer_at_a_time, [&] {
        cloud.loaded = source.load();
        cloud.truth = truthOf (cloud.loaded, plan.truth);
      });
    }
    catch (const OutputError&) {
      throw;
    }
    catch (const std::exception& error) {
      return count (&EvaluationSummary::broken_clouds,
                    std::string ("left out: ") + error.what());
    }
    saveLabels (cloud, "truth", cloud.truth);
    for (const Configuration& configuration : all)
      if (!configuration.needs_image || cloud.loaded.image)
        evaluateConfiguration (cloud, configuration);
    count (&EvaluationSummary::clouds);
  }

  void
  saveLabels (const LoadedCloud& cloud,
              const std::string& name,
              const PlaneLabels& labels) const
  {
    if (plan.labels_folder.empty())
      return;
    pcl::PointCloud<pcl::PointXYZL> labeled;
    pcl::copyPointCloud (*cloud.loaded.cloud, labeled);
    for (std::size_t i = 0; i < labels.size(); ++i)
      labeled[i].label = labels[i];
    const fs::path folder =
        fs::path (plan.labels_folder) / cloud.source.data_set / cloud.source.name;
    makeFolder (folder.string());
    saveLabeledPcd ((folder / (name + ".pcd")).string(), labeled);
  }

  /** Of a run that was stopped none but how long it took, so that it is not tried
   * again. */
  NamedValues
  valuesOf (const LoadedCloud& cloud, const Configuration& configuration)
  {
    const EvaluationCloud& loaded = cloud.loaded;
    RunSettings settings = plan.settings;
    settings.up = loaded.up;
    settings.image = loaded.image;
    if (const std::optional<DetectorRun> run =
            runLimited (configuration, loaded.cloud, settings, plan.time_limit)) {
      saveLabels (cloud, configuration.name, run->labels);
      return namedValues (
          compareLabels (*loaded.cloud, cloud.truth, run->labels, {loaded.up}), *run);
    }
    count (&EvaluationSummary::stopped_runs,
           configuration.name + " on " + cloud.source.name + ": stopped after " +
               std::to_string (plan.time_limit) + " s; more by --time-limit");
    NamedValues values = namedValues();
    for (auto& [column, value] : values)
      value = column == "detection_ms" ? 1e3 * plan.time_limit
                                       : std::numeric_limits<double>::quiet_NaN();
    return values;
  }

  void
  evaluateConfiguration (const LoadedCloud& cloud, const Configuration& configuration)
  {
    const std::string key =
        keyOf (cloud.source, cloud.loaded.truth.has_value(), configuration);
    if (results.has (key))
      return;
    NamedValues values;
    try {
      values = inMemory (configuration.name, fewer_at_a_time, [&] {
        return valuesOf (cloud, configuration);
      });
    }
    catch (const std::exception& error) {
      return count (&EvaluationSummary::failed_runs,
                    configuration.name + " failed on " + cloud.source.name + ": " +
                        error.what());
    }
    results.add (key, values);
    count (&EvaluationSummary::new_rows);
  }
};

} // namespace

EvaluationSummary
evaluate (const EvaluationPlan& plan, std::ostream& messages, bool is_terminal)
{
  Evaluation evaluation{plan,
                        ResultsFile (plan.file),
                        {plan.clouds.size(), messages, progressStyleOf (is_terminal)}};
  runInParallel (plan.clouds.size(), plan.jobs, [&] (std::size_t i) {
    evaluation.evaluateCloud (plan.clouds[i]);
    evaluation.progress.step();
  });
  return evaluation.summary;
}

} // namespace pcl_ops::evaluation
