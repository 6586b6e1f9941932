// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detector_run.h"

namespace pcl_ops::apps {

namespace {

using Ops = OrientedPointSampling<pcl::PointXYZ>;

void
declareOptions (CommandLine& line, DetectorOptions& detector)
{
  const Ops::Parameters usual;
  const Ops::Parameters paper = Ops::Parameters::paper();
  OpsOptions& options = detector.ops;
  line.addNumber ("sampling-rate",
                  "R",
                  Range::above (0).upTo (1),
                  options.sampling_rate,
                  withPresets ("share of the points that get a normal",
                               usual.sampling_rate,
                               paper.sampling_rate));
  line.addNumber ("k",
                  "K",
                  Range::from (2),
                  options.k,
                  withPresets ("neighbours of a normal; on surfels the fewest points",
                               usual.k,
                               paper.k));
  line.addNumber ("min-inliers",
                  "N",
                  Range::from (1),
                  options.min_inliers,
                  withPresets ("a plane has more sampled points than this",
                               usual.min_inliers,
                               paper.min_inliers));
  line.addNumber ("probability",
                  "P",
                  Range::above (0).below (1),
                  options.probability,
                  withPresets ("of drawing a point of the largest plane",
                               usual.probability,
                               paper.probability));
}

Ops::Parameters
parametersOf (const DetectorOptions& options)
{
  auto parameters = presetOf<Ops::Parameters> (options);
  override (options.ops.sampling_rate, parameters.sampling_rate);
  override (options.ops.k, parameters.k);
  override (options.ops.min_inliers, parameters.min_inliers);
  override (options.ops.probability, parameters.probability);
  return parameters;
}

nlohmann::ordered_json
describeOwn (const Ops::Parameters& parameters)
{
  const bool on_surfels = parameters.sampling == Sampling::Surfels;
  nlohmann::ordered_json json;
  json["sampling"] = on_surfels ? "surfels" : "points";
  json["sampling_rate"] = parameters.sampling_rate;
  json["k"] = parameters.k;
  json["min_inliers"] = parameters.min_inliers;
  json["probability"] = parameters.probability;
  return json;
}

Detected
detect (const DetectorOptions& options, const XyzCloud::ConstPtr& cloud)
{
  const Ops::Parameters parameters = parametersOf (options);
  return detectBy<Ops> (parameters,
                        describe (options.preset, describeOwn (parameters), parameters),
                        cloud);
}

} // namespace

Method
opsMethod ()
{
  return {"ops", "Oriented Point Sampling", declareOptions, detect};
}

} // namespace pcl_ops::apps
