// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "targets.h"

#include "machine.h"

#include <algorithm>
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

std::vector<TargetRow>
timeRows (const CloudFigures& figures)
{
  const auto over = [&] (const char* numerator, const char* denominator) {
    return ratio (figures, numerator, denominator);
  };
  return {{{"default_over_kdtree",
            "default preset over KdTreeFLANN's construction",
            "",
            true,
            0.30,
            0.12},
           over (default_preset, kdtree_construction)},
          {{"sac_loop_over_default",
            "SACSegmentation loop over default preset",
            "",
            false,
            80.0,
            200.0},
           over (sac_loop, default_preset)},
          {{"efficient_ransac_over_default",
            "CGAL Efficient RANSAC with its normals over default preset",
            "",
            false,
            60.0,
            150.0},
           over (efficient_ransac, default_preset)},
          {{"sparse_over_dense_paper",
            "paper preset at 0.3 % / 10 NN over 3 % / 30 NN",
            "",
            true,
            0.4,
            0.25},
           over (sparse_paper_preset, paper_preset)}};
}

} // namespace

std::vector<TargetRow>
rowsOf (const CloudFigures& figures, const SharedFigures& shared)
{
  std::vector<TargetRow> rows = timeRows (figures);
  rows.push_back ({{"growth",
                    "time per point at 10 M points over that at 300 k",
                    "",
                    true,
                    1.5,
                    1.2},
                   shared.growth});
  rows.push_back ({{"two_threads",
                    "speed-up of default preset by two threads",
                    "",
                    false,
                    1.6,
                    1.8},
                   threadSpeedup (figures, shared)});
  rows.push_back ({{"peak_memory",
                    "peak memory over the cloud's own size, " +
                        std::to_string (shared.peak.points) + " points",
                    "",
                    true,
                    3.0,
                    2.0},
                   shared.peak.overCloud()});
  rows.push_back ({{"hough_time_per_point", "3D-KHT, per point", "us", true, 0.5, 0.2},
                   microsecondsPerPoint (figures, hough_preset)});
  rows.push_back (
      {{"fspf_over_kdtree",
        "FSPF 0.07/0.14 over KdTreeFLANN's construction and radius searches",
        "",
        true,
        1.5,
        nan},
       ratio (figures, sphere_preset, kdtree_with_searches)});
  return rows;
}

Reached
reachedBy (const TargetRow& row)
{
  const auto reaches = [&] (double bound) {
    return row.target.less_is_better ? row.value <= bound : row.value >= bound;
  };
  if (std::isnan (row.value))
    return Reached::Unknown;
  if (reaches (row.target.hoped_for))
    return Reached::HopedFor;
  return reaches (row.target.target) ? Reached::Target : Reached::Neither;
}

std::string
toString (Reached reached)
{
  switch (reached) {
  case Reached::HopedFor:
    return "hoped for";
  case Reached::Target:
    return "target";
  case Reached::Neither:
    return "no";
  default:
    return "-";
  }
}

std::vector<TargetRow>
mediansOf (const std::vector<std::vector<TargetRow>>& rows_of_clouds)
{
  if (rows_of_clouds.empty())
    return {};
  std::vector<TargetRow> medians = rows_of_clouds.front();
  for (std::size_t i = 0; i < medians.size(); ++i) {
    std::vector<double> values;
    for (const std::vector<TargetRow>& rows : rows_of_clouds)
      if (!std::isnan (rows[i].value))
        values.push_back (rows[i].value);
    const auto middle =
        values.begin() + static_cast<std::ptrdiff_t> (values.size() / 2);
    std::nth_element (values.begin(), middle, values.end());
    medians[i].value = values.empty() ? nan : *middle;
  }
  return medians;
}

} // namespace pcl_ops::benchmark
