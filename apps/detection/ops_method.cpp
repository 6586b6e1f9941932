// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops_method.h"

#include "method_table.h"
#include <cli/errors.h>
#include <cli/option_value.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <cmath>
#include <optional>
#include <string>

namespace pcl_ops::apps {

namespace {

constexpr const char* voxel_edge = "cell";

double&
givenOrZero (std::optional<double>& length)
{
  if (!length)
    length = 0.0;
  return *length;
}

// They take as long as if there were so many. The usual number is fine for any cloud.
void
refuseMoreNeighboursThanPoints (const OrientedPointSamplingParameters& parameters,
                                std::size_t points)
{
  const int usual = OrientedPointSamplingParameters().k;
  if (parameters.k > usual && static_cast<std::size_t> (parameters.k) > points)
    throw UsageError ("--k",
                      std::to_string (parameters.k) +
                          " is more than the points of the cloud, " +
                          std::to_string (points) + "; give a smaller number");
}

} // namespace

double
voxelStepOf (const DetectorOptions& options)
{
  OrientedPointSamplingParameters parameters;
  const auto text = options.own.find (voxel_edge);
  if (text == options.own.end())
    return 0.0;
  const auto edge = parseNumber<double> (text->first, text->second, Range::from (0));
  return std::ldexp (edge, parameters.surfels.resolutions - 1);
}

Method
opsMethod ()
{
  using Ops = OrientedPointSampling<pcl::PointXYZ>;
  using P = Ops::Parameters;
  MethodTable<Ops> table{"ops", "Oriented Point Sampling"};
  table.options = {{"sampling-rate",
                    "R",
                    Range::above (0).upTo (1),
                    [] (P& p) -> double& { return p.sampling_rate; },
                    "share of the points that get a normal"},
                   {"k",
                    "K",
                    Range::from (2),
                    [] (P& p) -> int& { return p.k; },
                    "neighbours of a normal; on surfels the fewest points"},
                   {"min-inliers",
                    "N",
                    Range::from (1),
                    [] (P& p) -> unsigned& { return p.min_inliers; },
                    "a plane has more sampled points than this"},
                   {"probability",
                    "P",
                    Range::above (0).below (1),
                    [] (P& p) -> double& { return p.probability; },
                    "of drawing a point of the largest plane"},
                   {voxel_edge,
                    "M",
                    Range::from (0),
                    [] (P& p) -> double& { return givenOrZero (p.surfels.voxel_size); },
                    "edge of a voxel; 0: by the number of points"}};
  table.relate = [] (const GivenNumbers& given, P& p) {
    if (p.surfels.voxel_size == 0.0)
      p.surfels.voxel_size.reset();
    if (given.count (voxel_edge) > 0 && p.sampling != Sampling::Surfels)
      throw UsageError ("--cell", "has no meaning to --preset paper; leave it out");
  };
  table.first_settings = [] (const P& p) -> Settings {
    const bool on_surfels = p.sampling == Sampling::Surfels;
    return {{"sampling", std::string (on_surfels ? "surfels" : "points")}};
  };
  table.check_points = refuseMoreNeighboursThanPoints;
  return methodOf (table);
}

} // namespace pcl_ops::apps
