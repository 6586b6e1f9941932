// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation_run.h"

#include <pcl/common/io.h>

#include "results_file.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <detection/methods.h>
#include <detection/thickness.h>
#include <evaluation/data/changed_clouds.h>
#include <io/labeled_pcd.h>
#include <io/output_file.h>
#include <metrics/partitions.h>
#include <numbers/statistics.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>

namespace pcl_ops::evaluation {

using namespace apps;

namespace {

namespace fs = std::filesystem;

/** What a user can do if the memory is too small for a cloud. */
constexpr const char* memory_advice = "give a smaller cloud or fewer --jobs";

/** How many points of a cloud are on found planes, and on thick ones of these. A plane
 * is thick by factor if its Thickness::factor is above \ref thick_factor, and thick by
 * length if the rms distance of its points is above thick_length. */
struct ThicknessSummary {
  // Shares of the cloud's points.
  double on_planes = 0.0;
  double on_thick_by_factor = 0.0;
  double on_thick_by_length = 0.0;
  double rms_largest = 0.0;  // rms distance of the largest plane [m]
  double thick_length = 0.0; // EvaluationCloud::thick_length [m]
};

ThicknessSummary
thicknessSummary (const EvaluationCloud& cloud, const PlaneLabels& labels)
{
  const std::vector<PlaneSegment> planes =
      planesOf (*cloud.cloud, planeIds (labels), {cloud.up});
  const std::vector<Thickness> thicknesses = thicknessOf (*cloud.cloud, planes);
  ThicknessSummary summary;
  summary.thick_length = cloud.thick_length;
  std::size_t largest_size = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const std::size_t size = planes[i].inliers.size();
    const double share = fraction (size, cloud.cloud->size(), 0.0);
    summary.on_planes += share;
    if (thicknesses[i].factor() > thick_factor)
      summary.on_thick_by_factor += share;
    if (thicknesses[i].rms > cloud.thick_length)
      summary.on_thick_by_length += share;
    if (size > largest_size)
      summary.rms_largest = thicknesses[i].rms;
    largest_size = std::max (largest_size, size);
  }
  return summary;
}

/** Adds the metrics that compare a result with the truth. */
void
addMetrics (const Metrics& metrics, RowNumbers& row)
{
  row["truth_planes"] = double (metrics.truth_planes);
  for (const auto& [name, value] : metrics.named)
    row[name] = value;
  for (const auto& [name, count] : namedCounts (metrics))
    row[name] = count;
}

/** Adds the durations of a run and its number of planes before merging. */
void
addRun (const DetectorRun& run, RowNumbers& row)
{
  row["planes_before_merging"] = double (run.planes_before_merging);
  for (const auto& [stage, duration] : detection_stages)
    row[std::string (stage) + "_ms"] = run.durations.*duration;
}

void
addThickness (const ThicknessSummary& summary, RowNumbers& row)
{
  row["on_planes_share"] = summary.on_planes;
  row["thick_factor_share"] = summary.on_thick_by_factor;
  row["thick_length_share"] = summary.on_thick_by_length;
  row["thick_length"] = summary.thick_length;
  row["rms_largest"] = summary.rms_largest;
}

bool
hasTruth (const EvaluationCloud& cloud)
{
  return cloud.truth || cloud.grows_truth;
}

/** Shifts the points, the image and their sensor origins; labels stay the same. */
EvaluationCloud
shifted (EvaluationCloud cloud, const Eigen::Vector3f& shift)
{
  if (shift.isZero())
    return cloud;
  const auto moved = [&shift] (const XyzCloud& points) {
    const XyzCloud::Ptr result (new XyzCloud (points));
    for (pcl::PointXYZ& point : *result)
      point.getVector3fMap() += shift;
    result->sensor_origin_.head<3>() += shift;
    return result;
  };
  cloud.cloud = moved (*cloud.cloud);
  if (cloud.image)
    cloud.image = moved (*cloud.image);
  return cloud;
}

/** Returns what \ref sampled and \ref shifted do to clouds, as the end of the name of a
 * data set: "-6-points-shifted-0.5_0_0"; empty if they do nothing. */
std::string
nameOfChange (const EvaluationPlan& plan)
{
  std::string name;
  if (plan.most_points)
    name += "-" + std::to_string (*plan.most_points) + "-points";
  if (plan.shift.isZero())
    return name;
  const char* separator = "-shifted-";
  for (const float length : plan.shift) {
    // The shortest text that no other number has.
    std::array<char, 32> digits{};
    char* const begin = digits.data();
    name += separator;
    name.append (begin, std::to_chars (begin, begin + digits.size(), length).ptr);
    separator = "_";
  }
  return name;
}

/** Returns some points of a cloud, drawn at random, with their truth.
 * \param[in] most_points number of points; a smaller cloud, and nullopt: all points */
EvaluationCloud
sampled (EvaluationCloud cloud, std::optional<std::size_t> most_points)
{
  if (!most_points || *most_points >= cloud.cloud->size())
    return cloud;
  const pcl::Indices points = drawIndices (cloud.cloud->size(), *most_points);
  const XyzCloud::ConstPtr all = cloud.cloud;
  cloud.cloud.reset (new XyzCloud);
  pcl::copyPointCloud (*all, points, *cloud.cloud);
  if (cloud.truth)
    cloud.truth = selectLabels (*cloud.truth, points);
  if (!cloud.is_ignored.empty()) {
    std::vector<char> is_ignored;
    for (const pcl::index_t point : points)
      is_ignored.push_back (cloud.is_ignored[point]);
    cloud.is_ignored = is_ignored;
  }
  cloud.image = nullptr;
  return cloud;
}

struct LoadedCloud {
  const CloudSource& source;
  EvaluationCloud loaded = {};
  PlaneLabels truth = {}; // truthOf (loaded)
};

/** A run over all clouds of a plan; its functions may run on several clouds at once. */
struct Evaluation {
  const EvaluationPlan& plan;
  ResultsFile results;
  Progress progress;
  EvaluationSummary summary = {};
  std::mutex summary_mutex = {};

  /** Adds 1 to a number of the summary, and prints a message if one is given. */
  void
  count (std::size_t EvaluationSummary::*number, const std::string& message = "")
  {
    const std::lock_guard<std::mutex> lock (summary_mutex);
    ++(summary.*number);
    if (!message.empty())
      progress.note (errorLine (message));
  }

  /** Returns the name of truth by \ref growRegions. */
  std::string
  nameOfGrownTruth () const
  {
    return "grown-k" + std::to_string (plan.truth.neighbors);
  }

  std::string
  truthNameOf (const EvaluationCloud& cloud) const
  {
    if (cloud.truth)
      return "exact";
    return cloud.grows_truth ? nameOfGrownTruth() : "none";
  }

  /** Returns the name of a cloud's data set in results: results of samples and of
   * shifted clouds are not those of the data set itself. */
  std::string
  dataSetOf (const CloudSource& source) const
  {
    return source.data_set + nameOfChange (plan);
  }

  /** Returns the first cells of a row, which no other row has. */
  std::string
  keyOf (const CloudSource& source,
         const std::string& truth,
         const Configuration& configuration) const
  {
    return csvCell (dataSetOf (source)) + csvCell (source.name) + csvCell (truth) +
           csvCell (configuration.name) + csvCell (std::to_string (plan.settings.seed));
  }

  /** Whether the file has a row with any kind of truth, as the kind is known only once
   * the cloud is loaded. False for \ref ownLabels, which are always read again. */
  bool
  hasRow (const CloudSource& source, const Configuration& configuration) const
  {
    if (configuration.is_own)
      return false;
    const std::string truths[] = {nameOfGrownTruth(), "exact", "none"};
    return std::any_of (
        std::begin (truths), std::end (truths), [&] (const std::string& truth) {
          return results.has (keyOf (source, truth, configuration));
        });
  }

  /** Whether all rows of a cloud are there and no truth is to be saved alone. */
  bool
  isDone (const CloudSource& source) const
  {
    const std::vector<Configuration>& all = plan.configurations;
    const bool saves_truth_alone = all.empty() && !plan.labels_folder.empty();
    return !saves_truth_alone && std::all_of (all.begin(),
                                              all.end(),
                                              [&] (const Configuration& configuration) {
                                                return hasRow (source, configuration);
                                              });
  }

  /** \return nullopt if the cloud cannot be loaded, which is reported and counted */
  std::optional<LoadedCloud>
  load (const CloudSource& source)
  {
    LoadedCloud cloud{source};
    try {
      inMemory (source.name, memory_advice, [&] {
        cloud.loaded = shifted (sampled (source.load(), plan.most_points), plan.shift);
        cloud.truth = truthOf (cloud.loaded, plan.truth);
      });
      return cloud;
    }
    catch (const OutputError&) {
      throw;
    }
    catch (const std::exception& error) {
      count (&EvaluationSummary::broken_clouds,
             std::string ("left out: ") + error.what());
      return std::nullopt;
    }
  }

  void
  evaluateCloud (const CloudSource& source)
  {
    if (!isDone (source)) {
      const std::optional<LoadedCloud> cloud = load (source);
      if (!cloud)
        return;
      saveLabels (*cloud, "truth", cloud->truth);
      for (const Configuration& configuration : plan.configurations)
        if (!configuration.needs_image || cloud->loaded.image)
          evaluateConfiguration (*cloud, configuration);
    }
    count (&EvaluationSummary::clouds);
  }

  /** Writes a labeled cloud to EvaluationPlan::labels_folder, if one is given.
   * \param[in] name of the file, without its extension */
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
        fs::path (plan.labels_folder) / dataSetOf (cloud.source) / cloud.source.name;
    makeFolder (folder.string());
    saveLabeledPcd ((folder / (name + ".pcd")).string(), labeled);
  }

  /** Returns the numbers of a row: counts, durations, metrics if there is a truth, and
   * thickness. */
  RowNumbers
  numbersOf (const LoadedCloud& cloud, const DetectorRun& run) const
  {
    const EvaluationCloud& loaded = cloud.loaded;
    const Metrics metrics = compareLabels (
        *loaded.cloud, cloud.truth, run.labels, {loaded.up}, loaded.is_ignored);
    RowNumbers row;
    row["points"] = double (metrics.points);
    row["result_planes"] = double (metrics.result_planes);
    addRun (run, row);
    if (hasTruth (loaded))
      addMetrics (metrics, row);
    addThickness (thicknessSummary (loaded, run.labels), row);
    return row;
  }

  /** Adds how far the labels of changed copies agree with the labels of the cloud. A
   * run that was stopped adds no number. */
  void
  addAgreements (const LoadedCloud& cloud,
                 const Configuration& configuration,
                 RunSettings settings,
                 const PlaneLabels& labels,
                 RowNumbers& row) const
  {
    settings.image = nullptr;
    for (const CloudChange& change : cloud_changes) {
      const ChangedCloud changed =
          changedCloud (*cloud.loaded.cloud, cloud.loaded.up, change);
      settings.up = changed.up;
      const std::optional<DetectorRun> run =
          runLimited (configuration, changed.cloud, settings, plan.time_limit);
      if (run)
        row[agreementColumn (change)] =
            agreementOf (selectLabels (labels, changed.points), run->labels);
    }
  }

  /** Runs a detector and returns the numbers of its row. A stopped run has only its
   * time; as it has a row, it is not tried again. */
  RowNumbers
  runDetector (const LoadedCloud& cloud, const Configuration& configuration)
  {
    RunSettings settings = plan.settings;
    settings.up = cloud.loaded.up;
    settings.image = cloud.loaded.image;
    settings.data_set = dataSetOf (cloud.source);
    settings.cloud_name = cloud.source.name;
    const std::optional<DetectorRun> run =
        runLimited (configuration, cloud.loaded.cloud, settings, plan.time_limit);
    if (!run) {
      count (&EvaluationSummary::stopped_runs,
             configuration.name + " on " + cloud.source.name + ": stopped after " +
                 std::to_string (plan.time_limit) + " s; more by --time-limit");
      return {{"detection_ms", 1e3 * plan.time_limit}};
    }
    saveLabels (cloud, configuration.name, run->labels);
    RowNumbers row = numbersOf (cloud, *run);
    if (plan.runs_on_changes && !configuration.is_own && !configuration.needs_image)
      addAgreements (cloud, configuration, settings, run->labels, row);
    return row;
  }

  void
  evaluateConfiguration (const LoadedCloud& cloud, const Configuration& configuration)
  {
    const std::string key =
        keyOf (cloud.source, truthNameOf (cloud.loaded), configuration);
    if (!configuration.is_own && results.has (key))
      return;
    RowNumbers row;
    try {
      row = inMemory (configuration.name, memory_advice, [&] {
        return runDetector (cloud, configuration);
      });
    }
    catch (const std::exception& error) {
      count (&EvaluationSummary::failed_runs,
             configuration.name + " failed on " + cloud.source.name + ": " +
                 error.what());
      return;
    }
    results.add (key, row);
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
