// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detectors.h"

#include "detector_run.h"
#include "peers.h"
#include <cli/errors.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <sstream>

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

void
addTable1 (Configurations& all)
{
  using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;
  all.push_back (configurationOf<Fspf> ("fspf", {"presets"}, {}));
  for (const double factor : {1.0, 2.0})
    for (const double r1 : {0.03, 0.05, 0.07, 0.1, 0.3}) {
      auto parameters = FastSamplingPlaneFilteringParameters::paper();
      parameters.local.inner_radius = r1;
      parameters.local.outer_radius = factor * r1;
      std::vector<std::string> groups{"table1"};
      if (r1 == 0.07 && factor == 2.0)
        groups.push_back ("table4");
      all.push_back (configurationOf<Fspf> (
          "fspf-" + text (r1) + "-" + text (factor * r1), groups, parameters));
    }
}

void
addTable2 (Configurations& all)
{
  using Kht = KernelHoughTransform<pcl::PointXYZ>;
  all.push_back (configurationOf<Kht> ("kht", {"presets"}, {}));
  for (const int phi_num : {30, 40, 60, 80}) {
    auto parameters = KernelHoughTransformParameters::paper();
    parameters.phi_num = phi_num;
    parameters.rho_num = 10 * phi_num;
    std::vector<std::string> groups{"table2"};
    if (phi_num == 80)
      groups.push_back ("table4");
    all.push_back (configurationOf<Kht> (
        "kht-" + text (phi_num) + "-" + text (10 * phi_num), groups, parameters));
  }
}

void
addTable3 (Configurations& all)
{
  using Ops = OrientedPointSampling<pcl::PointXYZ>;
  all.push_back (configurationOf<Ops> ("ops", {"presets"}, {}));
  const auto addRow = [&all] (const std::string& prefix, double percent, int k) {
    auto parameters = OrientedPointSamplingParameters::paper();
    parameters.sampling_rate = percent / 100.0;
    parameters.k = k;
    std::vector<std::string> groups{"table3"};
    if (prefix == "ops-s1-")
      parameters.paper_only.strategy = PaperParameters::Strategy::DetectThenDivide;
    else if (percent == 3.0 && k == 30)
      groups.push_back ("table4");
    all.push_back (configurationOf<Ops> (
        prefix + text (percent) + "-" + text (k), groups, parameters));
  };
  for (const double percent : {0.3, 0.5, 0.7, 1.0, 3.0})
    for (const int k : {10, 20, 30})
      addRow ("ops-", percent, k);
  for (const int k : {10, 20, 30})
    addRow ("ops-s1-", 3.0, k);
}

/** The default preset with one ingredient off at a time. */
void
addAblation (Configurations& all)
{
  using Parameters = OrientedPointSamplingParameters;
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
    all.push_back (configurationOf<OrientedPointSampling<pcl::PointXYZ>> (
        std::string ("ops-without-") + name, {"ablation"}, parameters));
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

} // namespace

const std::vector<Configuration>&
allConfigurations ()
{
  static const Configurations all = [] {
    Configurations configurations;
    addTable3 (configurations);
    addTable1 (configurations);
    addTable2 (configurations);
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
  std::istringstream names (list);
  for (std::string name; std::getline (names, name, ',');) {
    bool known = false;
    for (const Configuration& configuration : allConfigurations()) {
      if (!isCalled (configuration, name))
        continue;
      known = true;
      const auto has_its_name = [&] (const Configuration& other) {
        return other.name == configuration.name;
      };
      if (std::none_of (selected.begin(), selected.end(), has_its_name))
        selected.push_back (configuration);
    }
    if (!known)
      throw apps::UsageError (name,
                              "is no configuration; see pcl_ops_evaluate detectors");
  }
  return selected;
}

} // namespace pcl_ops::evaluation
