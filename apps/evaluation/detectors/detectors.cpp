// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detectors.h"

#include <boost/interprocess/anonymous_shared_memory.hpp>

#include "peers.h"
#include <cli/errors.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <set>
#include <sstream>
#include <stdexcept>

namespace pcl_ops::evaluation {

namespace {

using Configurations = std::vector<Configuration>;

/** A number as a table shows it: 0.07, 3, 80. */
std::string
text (double number)
{
  std::ostringstream stream;
  stream << number;
  return stream.str();
}

using Ops = OrientedPointSampling<pcl::PointXYZ>;
using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;
using Kht = KernelHoughTransform<pcl::PointXYZ>;

/** \param[in] is_best whether it is a row of table 4, too */
template <typename Detector>
void
add (Configurations& all,
     const std::string& name,
     const std::string& group,
     const typename Detector::Parameters& parameters,
     bool is_best = false)
{
  const auto run = [parameters] (const XyzCloud::ConstPtr& cloud,
                                 const RunSettings& settings) {
    auto complete = parameters;
    complete.up_axis = settings.up.cast<float>();
    complete.seed = settings.seed;
    complete.threads = 1;
    return runDetector<Detector> (complete, cloud, settings.clock);
  };
  all.push_back ({name, {group}, run});
  if (is_best)
    all.back().groups.push_back ("table4");
}

void
addRowsOfPaper (Configurations& all)
{
  add<Ops> (all, "ops", "presets", {});
  const auto addOps = [&all] (const std::string& prefix, double percent, int k) {
    auto parameters = Ops::Parameters::paper();
    parameters.sampling_rate = percent / 100.0;
    parameters.k = k;
    const bool is_strategy_1 = prefix == "ops-s1-";
    if (is_strategy_1)
      parameters.paper_only.strategy = PaperParameters::Strategy::DetectThenDivide;
    add<Ops> (all,
              prefix + text (percent) + "-" + text (k),
              "table3",
              parameters,
              !is_strategy_1 && percent == 3.0 && k == 30);
  };
  for (const double percent : {0.3, 0.5, 0.7, 1.0, 3.0})
    for (const int k : {10, 20, 30})
      addOps ("ops-", percent, k);
  for (const int k : {10, 20, 30})
    addOps ("ops-s1-", 3.0, k);
  add<Fspf> (all, "fspf", "presets", {});
  for (const double factor : {1.0, 2.0})
    for (const double r1 : {0.03, 0.05, 0.07, 0.1, 0.3}) {
      auto parameters = Fspf::Parameters::paper();
      parameters.local.inner_radius = r1;
      parameters.local.outer_radius = factor * r1;
      const std::string name = "fspf-" + text (r1) + "-" + text (factor * r1);
      add<Fspf> (all, name, "table1", parameters, r1 == 0.07 && factor == 2.0);
    }
  add<Kht> (all, "kht", "presets", {});
  for (const int phi_num : {30, 40, 60, 80}) {
    auto parameters = Kht::Parameters::paper();
    parameters.phi_num = phi_num;
    parameters.rho_num = 10 * phi_num;
    const std::string name = "kht-" + text (phi_num) + "-" + text (10 * phi_num);
    add<Kht> (all, name, "table2", parameters, phi_num == 80);
  }
}

/** The default preset with one ingredient off at a time. */
void
addAblation (Configurations& all)
{
  using Parameters = Ops::Parameters;
  constexpr double no_limit = 1e6;
  const std::pair<const char*, void (*) (Parameters&)> ingredients[] = {
      {"resolutions", [] (Parameters& p) { p.surfels.resolutions = 1; }},
      {"least-cells", [] (Parameters& p) { p.surfels.min_average_voxels = 0.0; }},
      {"normal-test", [] (Parameters& p) { p.surfels.angle_threshold = M_PI_2; }},
      {"noise-bands", [] (Parameters& p) { p.surfels.noise_factor = no_limit; }},
      {"absorption", [] (Parameters& p) { p.surfels.absorption_noise_factor = 0.0; }},
      {"merging", [] (Parameters& p) { p.merging.enabled = false; }},
      {"noise-in-assignment",
       [] (Parameters& p) { p.surfels.assignment_noise_factor = no_limit; }},
      {"measured-threshold", [] (Parameters& p) { p.distance_threshold = 0.05; }}};
  for (const auto& [name, switch_off] : ingredients) {
    Parameters parameters;
    switch_off (parameters);
    add<Ops> (all, std::string ("ops-without-") + name, "ablation", parameters);
  }
}

bool
isCalled (const Configuration& configuration, const std::string& name)
{
  const std::vector<std::string>& groups = configuration.groups;
  const auto isIn = [&groups] (const std::string& group) {
    return std::find (groups.begin(), groups.end(), group) != groups.end();
  };
  return name == configuration.name || isIn (name) ||
         (name == "all" && !isIn ("ablation"));
}

/** What a detector's process hands over; the labels of the points are behind it. */
struct HandedOver {
  StageDurations durations;
  std::size_t planes_before_merging = 0;
};

} // namespace

const std::vector<Configuration>&
allConfigurations ()
{
  static const Configurations all = [] {
    Configurations configurations;
    addRowsOfPaper (configurations);
    addPeers (configurations);
    addAblation (configurations);
    return configurations;
  }();
  return all;
}

std::vector<Configuration>
selectConfigurations (const std::string& list)
{
  Configurations selected;
  std::set<std::string> names;
  std::istringstream stream (list);
  for (std::string name; std::getline (stream, name, ',');) {
    bool is_known = false;
    for (const Configuration& configuration : allConfigurations())
      if (isCalled (configuration, name)) {
        is_known = true;
        if (names.insert (configuration.name).second)
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
  char* const message = static_cast<char*> (memory.get_address()); // all zero
  const pid_t child = fork();
  if (child == 0) {
    std::signal (SIGALRM, SIG_DFL); // ends the process
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
  const auto memory = boost::interprocess::anonymous_shared_memory (
      sizeof (HandedOver) + cloud->size() * sizeof (std::uint32_t));
  auto* const handed_over = static_cast<HandedOver*> (memory.get_address());
  auto* const labels = reinterpret_cast<std::uint32_t*> (handed_over + 1);
  const auto detect = [&] {
    const DetectorRun run = configuration.run (cloud, settings);
    *handed_over = {run.durations, run.planes_before_merging};
    std::copy (run.labels.begin(), run.labels.end(), labels);
  };
  if (!runInChild (detect, seconds))
    return std::nullopt;
  return DetectorRun{{labels, labels + cloud->size()},
                     handed_over->planes_before_merging,
                     handed_over->durations};
}

} // namespace pcl_ops::evaluation
