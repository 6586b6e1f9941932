// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detectors.h"

#include <boost/interprocess/anonymous_shared_memory.hpp>

#include "peers.h"
#include <cli/errors.h>
#include <cli/text.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_pieces.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <type_traits>

namespace pcl_ops::evaluation {

namespace {

using Ops = OrientedPointSampling<pcl::PointXYZ>;
using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;
using Kht = KernelHoughTransform<pcl::PointXYZ>;

/** Returns the name of a row of the paper's tables by two of its parameters, such as
 * ops-3-30. */
std::string
rowName (const char* prefix, double first_parameter, double second_parameter)
{
  return apps::concatenate (prefix, '-', first_parameter, '-', second_parameter);
}

/** Returns the clock for \ref timed: that of the thread, if there is one thread. */
clockid_t
clockFor (const RunSettings& settings)
{
  return settings.threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_MONOTONIC;
}

/** Adds a configuration of a detector of this project. Up axis, seed, threads and, if
 * given, the sampling rate come from the settings of a run. */
template <typename Detector>
void
addConfiguration (std::vector<Configuration>& all,
                  const std::string& name,
                  const std::string& group,
                  const typename Detector::Parameters& of_configuration)
{
  const auto run = [of_configuration] (const XyzCloud::ConstPtr& cloud,
                                       const RunSettings& settings) {
    typename Detector::Parameters parameters = of_configuration;
    parameters.up_axis = settings.up.cast<float>();
    parameters.seed = settings.seed;
    parameters.threads = settings.threads;
    if constexpr (std::is_same_v<Detector, Ops>)
      parameters.sampling_rate =
          settings.sampling_rate.value_or (parameters.sampling_rate);
    DetectorRun result;
    double detection = 0.0; // [ms]
    const auto detect = [&] {
      Detector detector;
      detector.setParameters (parameters);
      detector.setInputCloud (cloud);
      std::vector<pcl::PointIndices> planes;
      detector.extract (planes);
      result = {labelsOf (planes, cloud->size()),
                detector.getNumberOfPlanesBeforeMerging(),
                detector.getStageDurations()};
    };
    timed (detection, detect, clockFor (settings));
    result.durations.detection = detection;
    return result;
  };
  all.push_back ({name, {group}, run});
  for (const char* best_in_paper : {"ops-3-30", "fspf-0.07-0.14", "kht-80-800"})
    if (name == best_in_paper)
      all.back().groups.insert ("table4");
}

/** Adds ops-pieces: the default, which no seed changes, but each connected component is
 * a plane. */
void
addPieces (std::vector<Configuration>& all)
{
  const auto run = [] (const XyzCloud::ConstPtr& cloud, const RunSettings& settings) {
    Ops detector;
    Ops::Parameters parameters = detector.getParameters();
    parameters.up_axis = settings.up.cast<float>();
    parameters.threads = settings.threads;
    detector.setParameters (parameters);
    detector.setInputCloud (cloud);
    double detection = 0.0; // [ms]
    std::vector<pcl::PointIndices> inliers;
    const auto detect = [&] {
      std::vector<PlaneSegment> planes;
      detector.segment (planes);
      for (PlaneSegment& piece :
           findPlanePieces (*cloud, planes, {}, settings.threads).pieces)
        inliers.emplace_back().indices = std::move (piece.inliers);
    };
    timed (detection, detect, clockFor (settings));
    DetectorRun result{labelsOf (inliers, cloud->size()),
                       detector.getNumberOfPlanesBeforeMerging(),
                       detector.getStageDurations()};
    result.durations.detection = detection;
    return result;
  };
  all.push_back ({"ops-pieces", {"pieces"}, run});
}

/** Adds the detectors of this project: for each method the default preset and the rows
 * of the paper's tables, and for OPS also ops-voxels and ops-pieces. */
void
addOwnDetectors (std::vector<Configuration>& all)
{
  addConfiguration<Ops> (all, "ops", "presets", {});
  Ops::Parameters on_voxels;
  on_voxels.sampling = Sampling::Surfels;
  addConfiguration<Ops> (all, "ops-voxels", "sampling", on_voxels);
  addPieces (all);
  Ops::Parameters ops = Ops::Parameters::paper();
  const auto addRowsOfOps = [&] (const char* prefix, double percent) {
    ops.sampling_rate = percent / 100.0;
    for (ops.k = 10; ops.k <= 30; ops.k += 10)
      addConfiguration<Ops> (all, rowName (prefix, percent, ops.k), "table3", ops);
  };
  for (const double percent : {0.3, 0.5, 0.7, 1.0, 3.0})
    addRowsOfOps ("ops", percent);
  ops.paper_only.strategy = PaperParameters::Strategy::DetectThenDivide;
  addRowsOfOps ("ops-s1", 3.0);
  addConfiguration<Fspf> (all, "fspf", "presets", {});
  Fspf::Parameters fspf = Fspf::Parameters::paper();
  for (const double factor : {1.0, 2.0}) // of the outer over the inner radius
    for (const double radius : {0.03, 0.05, 0.07, 0.1, 0.3}) {
      fspf.local.inner_radius = radius;
      fspf.local.outer_radius = factor * radius;
      addConfiguration<Fspf> (
          all, rowName ("fspf", radius, factor * radius), "table1", fspf);
    }
  addConfiguration<Kht> (all, "kht", "presets", {});
  Kht::Parameters kht = Kht::Parameters::paper();
  for (const int phi_num : {30, 40, 60, 80}) {
    kht.phi_num = phi_num;
    kht.rho_num = 10 * phi_num;
    addConfiguration<Kht> (all, rowName ("kht", phi_num, 10 * phi_num), "table2", kht);
  }
}

/** Adds the default preset with one parameter switched off at a time (group ablation).
 * Parameters of surfels have no effect on neighborhoods, the default. */
void
addAblation (std::vector<Configuration>& all)
{
  using Parameters = Ops::Parameters;
  constexpr double no_limit = 1e6; // [noises]
  const struct {
    const char* name;
    void (*switch_off) (Parameters&);
  } ingredients[] = {
      {"resolutions", [] (Parameters& p) { p.surfels.resolutions = 1; }},
      {"min-average-voxels",
       [] (Parameters& p) { p.surfels.min_average_voxels = 0.0; }},
      {"normal-test", [] (Parameters& p) { p.surfels.angle_threshold = M_PI_2; }},
      {"noise-bands", [] (Parameters& p) { p.surfels.noise_factor = no_limit; }},
      {"absorption", [] (Parameters& p) { p.surfels.absorption_noise_factor = 0.0; }},
      {"merging", [] (Parameters& p) { p.merging.enabled = false; }},
      {"noise-in-assignment",
       [] (Parameters& p) { p.surfels.assignment_noise_factor = no_limit; }},
      {"measured-threshold",
       [] (Parameters& p) { p.distance_threshold = usual_peer_threshold; }}};
  for (const auto& [name, switch_off] : ingredients) {
    Parameters parameters;
    switch_off (parameters);
    addConfiguration<Ops> (
        all, std::string ("ops-without-") + name, "ablation", parameters);
  }
}

} // namespace

const std::vector<Configuration>&
allConfigurations ()
{
  static const std::vector<Configuration> all = [] {
    std::vector<Configuration> configurations;
    addOwnDetectors (configurations);
    addPeers (configurations);
    addAblation (configurations);
    return configurations;
  }();
  return all;
}

std::vector<Configuration>
selectConfigurations (const std::string& list)
{
  std::vector<Configuration> selected;
  std::set<std::string> selected_names;
  std::istringstream stream (list);
  for (std::string name; std::getline (stream, name, ',');) {
    bool is_known = name == "none";
    for (const Configuration& configuration : allConfigurations()) {
      const std::set<std::string>& groups = configuration.groups;
      const bool is_meant = name == configuration.name || groups.count (name) > 0 ||
                            (name == "all" && groups.count ("ablation") == 0);
      is_known = is_known || is_meant;
      const bool is_new = is_meant && selected_names.insert (configuration.name).second;
      if (is_new)
        selected.push_back (configuration);
    }
    if (!is_known)
      throw apps::UsageError (name,
                              "is no configuration; see pcl_ops_evaluate detectors");
  }
  return selected;
}

bool
runInChild (const std::function<void()>& work, unsigned seconds)
{
  constexpr std::size_t size_of_message = 4096;
  const auto memory = boost::interprocess::anonymous_shared_memory (size_of_message);
  char* const message = static_cast<char*> (memory.get_address()); // filled with zeros
  const pid_t child = fork();
  if (child == 0) {
    std::signal (SIGALRM, SIG_DFL); // the alarm ends the process
    alarm (seconds);
    try {
      work();
      _exit (0);
    }
    catch (const std::exception& error) {
      std::strncpy (message, error.what(), size_of_message - 1);
      _exit (1);
    }
  }
  int status = 0;
  if (child < 0 || waitpid (child, &status, 0) < 0)
    throw std::runtime_error ("no process for it");
  if (WIFSIGNALED (status) && WTERMSIG (status) == SIGALRM)
    return false;
  if (WIFSIGNALED (status))
    throw std::runtime_error ("ended by signal " + std::to_string (WTERMSIG (status)));
  if (WEXITSTATUS (status) != 0)
    throw std::runtime_error (message);
  return true;
}

std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds)
{
  if (!configuration.is_peer)
    return configuration.run (cloud, settings);
  struct SharedResult { // the labels follow it in memory
    StageDurations durations;
    std::size_t planes_before_merging = 0;
  };
  const auto memory = boost::interprocess::anonymous_shared_memory (
      sizeof (SharedResult) + cloud->size() * sizeof (std::uint32_t));
  auto* const result = static_cast<SharedResult*> (memory.get_address());
  auto* const labels = reinterpret_cast<std::uint32_t*> (result + 1);
  const auto detect = [&] {
    const DetectorRun run = configuration.run (cloud, settings);
    *result = {run.durations, run.planes_before_merging};
    std::copy (run.labels.begin(), run.labels.end(), labels);
  };
  if (!runInChild (detect, seconds))
    return std::nullopt;
  return DetectorRun{{labels, labels + cloud->size()},
                     result->planes_before_merging,
                     result->durations};
}

} // namespace pcl_ops::evaluation
