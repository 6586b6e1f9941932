// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ablation.h"

#include "detector_run.h"
#include <pcl_ops/oriented_point_sampling.h>

namespace pcl_ops::evaluation {

namespace {

using Parameters = OrientedPointSamplingParameters;

struct Ingredient {
  const char* name;
  void (*switch_off) (Parameters& parameters);
};

constexpr double no_limit = 1e6;

const Ingredient ingredients[] = {
    {"resolutions", [] (Parameters& p) { p.surfels.resolutions = 1; }},
    {"least-cells", [] (Parameters& p) { p.surfels.least_average_voxels = 0.0; }},
    {"normal-test", [] (Parameters& p) { p.surfels.angle_threshold = M_PI_2; }},
    {"noise-bands", [] (Parameters& p) { p.surfels.noise_factor = no_limit; }},
    {"absorption", [] (Parameters& p) { p.surfels.absorption_noise_factor = 0.0; }},
    {"merging", [] (Parameters& p) { p.merging.enabled = false; }},
    {"noise-in-assignment",
     [] (Parameters& p) { p.surfels.assignment_noise_factor = no_limit; }},
    {"measured-threshold", [] (Parameters& p) { p.distance_threshold = 0.05; }}};

} // namespace

void
addAblation (std::vector<Configuration>& configurations)
{
  for (const Ingredient& ingredient : ingredients) {
    Parameters parameters;
    ingredient.switch_off (parameters);
    configurations.push_back (configurationOf<OrientedPointSampling<pcl::PointXYZ>> (
        std::string ("ops-without-") + ingredient.name, {"ablation"}, parameters));
  }
}

} // namespace pcl_ops::evaluation
