// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detector_run.h"

#include <pcl/common/angles.h>

namespace pcl_ops::apps {

void
overrideCommon (const DetectorOptions& options, PlaneDetectorParameters& parameters)
{
  override (options.threshold, parameters.distance_threshold);
  override (options.up, parameters.up_axis);
  override (options.seed, parameters.seed);
  override (options.threads, parameters.threads);
  parameters.merging.enabled = parameters.merging.enabled && options.merging;
  if (options.angle_tolerance)
    parameters.angle_tolerance = pcl::deg2rad (*options.angle_tolerance);
}

nlohmann::ordered_json
describe (const std::string& preset,
          const nlohmann::ordered_json& own,
          const PlaneDetectorParameters& parameters)
{
  const Eigen::Vector3f& up = parameters.up_axis;
  nlohmann::ordered_json json;
  json["preset"] = preset;
  json.update (own);
  if (parameters.distance_threshold)
    json["threshold"] = *parameters.distance_threshold;
  else
    json["threshold"] = "auto";
  json["angle_tolerance"] = pcl::rad2deg (parameters.angle_tolerance);
  json["up"] = {up.x(), up.y(), up.z()};
  json["seed"] = parameters.seed;
  json["threads"] = parameters.threads;
  return json;
}

} // namespace pcl_ops::apps
