// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ratios.h"

#include "machine.h"
#include <numbers/quantile.h>

#include <cmath>

namespace pcl_ops::benchmark {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double
ratio (const CloudFigures& figures, const char* numerator, const char* denominator)
{
  return bestOf (figures.times, numerator) / bestOf (figures.times, denominator);
}

double
threadSpeedup (const CloudFigures& figures, const SharedFigures& shared)
{
  return shared.arithmetic_speedup >= speedup_of_two_cores
             ? ratio (figures, default_preset, default_on_two_threads)
             : nan;
}

double
microsecondsPerPoint (const CloudFigures& figures, const char* detector)
{
  constexpr double microseconds_per_millisecond = 1000.0;
  return microseconds_per_millisecond * bestOf (figures.times, detector) /
         static_cast<double> (figures.points);
}

} // namespace

std::vector<Ratio>
ratiosOf (const CloudFigures& figures, const SharedFigures& shared)
{
  const auto over = [&] (const char* numerator, const char* denominator) {
    return ratio (figures, numerator, denominator);
  };
  return {
      {"default_over_kdtree",
       "default preset over KdTreeFLANN's construction",
       "",
       over (default_preset, kdtree_construction)},
      {"sac_loop_over_default",
       "SACSegmentation loop over default preset",
       "",
       over (sac_loop, default_preset)},
      {"efficient_ransac_over_default",
       "CGAL Efficient RANSAC with its normals over default preset",
       "",
       over (efficient_ransac, default_preset)},
      {"sparse_over_dense_paper",
       "paper preset at 0.3 % / 10 NN over 3 % / 30 NN",
       "",
       over (sparse_paper_preset, paper_preset)},
      {"growth", "time per point at 10 M points over that at 300 k", "", shared.growth},
      {"two_threads",
       "speed-up of default preset by two threads",
       "",
       threadSpeedup (figures, shared)},
      {"peak_memory",
       "peak memory over the cloud's own size, " + std::to_string (shared.peak.points) +
           " points",
       "",
       shared.peak.overCloud()},
      {"hough_time_per_point",
       "3D-KHT, per point",
       "us",
       microsecondsPerPoint (figures, hough_preset)},
      {"fspf_over_kdtree",
       "FSPF 0.07/0.14 over KdTreeFLANN's construction and radius searches",
       "",
       over (sphere_preset, kdtree_with_searches)}};
}

std::vector<Ratio>
mediansOf (const std::vector<std::vector<Ratio>>& ratios_of_clouds)
{
  if (ratios_of_clouds.empty())
    return {};
  std::vector<Ratio> medians = ratios_of_clouds.front();
  for (std::size_t i = 0; i < medians.size(); ++i) {
    std::vector<double> values;
    for (const std::vector<Ratio>& ratios : ratios_of_clouds)
      if (!std::isnan (ratios[i].value))
        values.push_back (ratios[i].value);
    medians[i].value = apps::quantile (values, 0.5);
  }
  return medians;
}

} // namespace pcl_ops::benchmark
