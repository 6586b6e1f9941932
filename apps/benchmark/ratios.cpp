// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ratios.h"

#include <numbers/quantile.h>

#include <cmath>

namespace pcl_ops::benchmark {

std::vector<Ratio>
ratiosOf (const CloudFigures& figures, const SharedFigures& shared)
{
  constexpr double microseconds_per_millisecond = 1000.0;
  const auto time = [&] (const char* name) { return bestOf (figures.times, name); };
  const double default_time = time (default_preset);
  const double two_threads = shared.cores > 1
                                 ? default_time / time (default_on_two_threads)
                                 : std::numeric_limits<double>::quiet_NaN();
  const double over_cloud =
      (shared.peak.cloud_bytes + shared.peak.extra_bytes) / shared.peak.cloud_bytes;
  return {
      {"default_over_kdtree",
       "default preset over KdTreeFLANN's construction",
       "",
       default_time / time (kdtree_construction)},
      {"sac_loop_over_default",
       "SACSegmentation loop over default preset",
       "",
       time (sac_loop) / default_time},
      {"efficient_ransac_over_default",
       "CGAL Efficient RANSAC with its normals over default preset",
       "",
       time (efficient_ransac) / default_time},
      {"sparse_over_dense_paper",
       "paper preset at 0.3 % / 10 NN over 3 % / 30 NN",
       "",
       time (sparse_paper_preset) / time (paper_preset)},
      {"growth", "time per point at 10 M points over that at 300 k", "", shared.growth},
      {"two_threads", "speed-up of default preset by two threads", "", two_threads},
      {"peak_memory",
       "peak memory over the cloud's own size, " + std::to_string (shared.peak.points) +
           " points",
       "",
       over_cloud},
      {"hough_time_per_point",
       "3D-KHT, per point",
       "us",
       microseconds_per_millisecond * time (hough_preset) /
           static_cast<double> (figures.points)},
      {"fspf_over_kdtree",
       "FSPF 0.07/0.14 over KdTreeFLANN's construction and radius searches",
       "",
       time (sphere_preset) / time (kdtree_with_searches)}};
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
