// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "methods.h"

#include <pcl/common/angles.h>

#include "advice.h"
#include <common/program.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>

namespace pcl_ops::apps {

namespace {

/** \brief Stores an option that was given. */
template <typename Option, typename Parameter>
void
override (const std::optional<Option>& option, Parameter& parameter)
{
  if (option)
    parameter = *option;
}

void
overrideCommon (const DetectorOptions& options, PlaneDetectorParameters& parameters)
{
  override (options.threshold, parameters.distance_threshold);
  override (options.up, parameters.up_axis);
  override (options.seed, parameters.seed);
  override (options.threads, parameters.threads);
  if (options.angle_tolerance)
    parameters.angle_tolerance = pcl::deg2rad (*options.angle_tolerance);
}

void
describeCommon (const PlaneDetectorParameters& parameters, nlohmann::ordered_json& json)
{
  const Eigen::Vector3f& up = parameters.up_axis;
  json["threshold"] = parameters.distance_threshold;
  json["angle_tolerance"] = pcl::rad2deg (parameters.angle_tolerance);
  json["up"] = {up.x(), up.y(), up.z()};
  json["seed"] = parameters.seed;
  json["threads"] = parameters.threads;
}

/** \brief The call all detectors share. */
template <typename Detector>
Detected
run (const typename Detector::Parameters& parameters, const PositionsPtr& cloud)
{
  Detector detector;
  detector.setParameters (parameters);
  detector.setInputCloud (cloud);
  Detected detected;
  if (!detector.segment (detected.planes))
    throw WorkError (Detector::className(), problemOf (parameters) + "; see --help");
  detected.timing = detector.getStageDurations();
  detected.up = parameters.up_axis;
  return detected;
}

OrientedPointSamplingParameters
opsParameters (const DetectorOptions& options)
{
  using Parameters = OrientedPointSamplingParameters;
  Parameters parameters =
      options.preset == "paper" ? Parameters::paper() : Parameters();
  overrideCommon (options, parameters);
  override (options.sampling_rate, parameters.sampling_rate);
  override (options.min_inliers, parameters.min_inliers);
  override (options.probability, parameters.probability);
  override (options.k, parameters.normals.k);
  return parameters;
}

nlohmann::ordered_json
describeOps (const DetectorOptions& options,
             const OrientedPointSamplingParameters& parameters)
{
  const bool on_cells = parameters.sampling == Sampling::Cells;
  nlohmann::ordered_json json;
  json["preset"] = options.preset;
  json["sampling"] = on_cells ? "cells" : "points";
  json["sampling_rate"] = parameters.sampling_rate;
  json["k"] = parameters.normals.k;
  json["min_inliers"] = parameters.min_inliers;
  json["probability"] = parameters.probability;
  describeCommon (parameters, json);
  if (parameters.distance_threshold == 0.0)
    json["threshold"] = "auto";
  return json;
}

Detected
detectByOps (const DetectorOptions& options, const PositionsPtr& cloud)
{
  const OrientedPointSamplingParameters parameters = opsParameters (options);
  Detected detected = run<OrientedPointSampling<pcl::PointXYZ>> (parameters, cloud);
  detected.parameters = describeOps (options, parameters);
  detected.advice = adviceForOps (parameters, *cloud);
  return detected;
}

} // namespace

const std::vector<Method>&
allMethods ()
{
  static const std::vector<Method> kMethods = {
      {"ops", {"sampling-rate", "k", "min-inliers", "probability"}, detectByOps}};
  return kMethods;
}

const Method&
methodCalled (const std::string& name)
{
  const auto& methods = allMethods();
  return *std::find_if (methods.begin(), methods.end(), [&] (const Method& method) {
    return method.name == name;
  });
}

} // namespace pcl_ops::apps
