// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shared_options.h"

#include <cli/command_line.h>
#include <numbers/angles.h>

namespace pcl_ops::apps {

namespace {

/** \brief Stores an option that was given. */
template <typename Option, typename Parameter>
void
set (Parameter& parameter, const std::optional<Option>& option)
{
  if (option)
    parameter = *option;
}

} // namespace

void
declareSharedOptions (CommandLine& line, DetectorOptions& options)
{
  constexpr double most_threads = 1024;
  constexpr double right_angle = 90;
  line.addChoice ("preset",
                  {"default", "paper"},
                  options.preset,
                  "recommended parameters, or the paper's best ones");
  line.addNumber ("threshold",
                  "M",
                  Range::above (0),
                  options.threshold,
                  "farthest point of a plane (0.05; ops: auto)");
  line.addNumber ("angle-tolerance",
                  "DEG",
                  Range::from (0).upTo (right_angle),
                  options.angle_tolerance,
                  "largest tilt of horizontal and vertical planes (7)");
  line.addValue ("up",
                 "x,y,z",
                 "direction against gravity, or auto to find it (0,0,1)",
                 [&options] (const std::string& text) {
                   options.finds_up = text == "auto";
                   if (!options.finds_up)
                     options.up = parseDirection ("--up", text);
                 });
  line.addNumber (
      "seed", "S", Range::from (0), options.seed, "same seed, same result (42)");
  line.addNumber ("threads",
                  "T",
                  Range::from (0).upTo (most_threads),
                  options.threads,
                  "0 for all; the result stays the same (1)");
}

void
applyShared (const DetectorOptions& options, PlaneDetectorParameters& parameters)
{
  set (parameters.distance_threshold, options.threshold);
  set (parameters.up_axis, options.up);
  set (parameters.seed, options.seed);
  set (parameters.threads, options.threads);
  parameters.merging.enabled = parameters.merging.enabled && options.merging;
  if (options.angle_tolerance)
    parameters.angle_tolerance = toRadians (*options.angle_tolerance);
}

Settings
sharedSettings (const PlaneDetectorParameters& parameters)
{
  const Eigen::Vector3d up = parameters.up_axis.cast<double>();
  SettingValue threshold = std::string ("auto");
  if (parameters.distance_threshold)
    threshold = *parameters.distance_threshold;
  return {{"threshold", threshold},
          {"angle_tolerance", toDegrees (parameters.angle_tolerance)},
          {"up", std::vector<double>{up.x(), up.y(), up.z()}},
          {"seed", std::int64_t (parameters.seed)},
          {"threads", std::int64_t (parameters.threads)}};
}

} // namespace pcl_ops::apps
