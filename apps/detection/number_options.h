// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"
#include <cli/command_line.h>
#include <numbers/angles.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <type_traits>

namespace pcl_ops::apps {

struct NumberOption {
  const char* usage;
  Range range;
  const char* help;
};

constexpr double points_of_a_plane = 3;

/** \brief Calls \p visit (number, option) for what all detectors have. */
template <typename Visit>
void
visitOwn (PlaneDetectorParameters& p, const Visit& visit)
{
  visit (p.distance_threshold,
         {"threshold M", above (0), "farthest point of a plane (0.05; ops: auto)"});
  visit (p.merging.distance_threshold,
         {"merge-distance M",
          from (0),
          "planes this near are one (--threshold; ops: auto)"});
  const double usual = toDegrees (p.angle_tolerance);
  double degrees = usual;
  visit (degrees,
         {"angle-tolerance DEG",
          from (0).upTo (90),
          "largest tilt of horizontal and vertical planes (7)"});
  if (degrees != usual)
    p.angle_tolerance = toRadians (degrees);
  visit (p.seed, {"seed S", from (0), "same seed, same result (42)"});
  visit (
      p.threads,
      {"threads T", from (0).upTo (1024), "0 for all; the result stays the same (1)"});
}

/** \brief For what one detector has; the help goes on with the presets' values. */
template <typename Visit>
void
visitOwn (OrientedPointSamplingParameters& p, const Visit& visit)
{
  visit (
      p.sampling_rate,
      {"sampling-rate R", above (0).upTo (1), "share of the points that get a normal"});
  visit (p.k, {"k K", from (2), "neighbors of a normal; on surfels the fewest points"});
  visit (p.min_inliers,
         {"min-inliers N", from (1), "a plane has more sampled points than this"});
  visit (p.paper_only.probability,
         {"probability P",
          above (0).below (1),
          "of drawing a point of the largest plane"});
  double edge = p.surfels.voxel_size.value_or (0.0);
  visit (edge, {"cell M", from (0), "edge of a voxel; 0: by the number of points"});
  p.surfels.voxel_size = edge == 0.0 ? std::nullopt : std::make_optional (edge);
}

template <typename Visit>
void
visitOwn (FastSamplingPlaneFilteringParameters& p, const Visit& visit)
{
  FastSamplingPlaneFilteringParameters::Local& local = p.local;
  visit (local.inner_radius,
         {"inner-radius M", above (0), "three points this near make a hypothesis"});
  visit (local.outer_radius,
         {"outer-radius M", above (0), "it is tested on points this near"});
  visit (
      local.local_samples,
      {"local-samples N", from (points_of_a_plane), "it is tested on so many of them"});
  visit (local.min_inlier_fraction,
         {"min-inlier-share R",
          from (0).below (1),
          "a larger share of these must be inliers"});
  visit (local.max_inliers_per_point,
         {"inliers-per-point R", above (0), "sampling ends at so many inliers"});
}

template <typename Visit>
void
visitOwn (KernelHoughTransformParameters& p, const Visit& visit)
{
  auto& clusters = p.clusters;
  visit (p.phi_num, {"phi-num N", from (2).upTo (1000), "steps of half a turn"});
  visit (p.rho_num,
         {"rho-num N", from (2).upTo (10000), "steps out to the farthest point"});
  visit (
      clusters.min_samples,
      {"min-samples N", from (points_of_a_plane), "smaller octree nodes are left out"});
  visit (clusters.first_level,
         {"s-level N", from (0).upTo (20), "first level of the octree that is tested"});
  visit (clusters.s_alpha,
         {"s-alpha R", above (0), "larger: a node must be thinner to count as flat"});
  visit (clusters.s_beta, {"s-beta R", above (0), "larger: it may be more elongated"});
}

template <typename Parameters, typename Visit>
void
visitAll (Parameters& parameters, const Visit& visit)
{
  visitOwn (parameters, visit);
  visitOwn (static_cast<PlaneDetectorParameters&> (parameters), visit);
}

template <typename Number>
using ValueOf = std::conditional_t<std::is_arithmetic_v<Number>, Number, double>;

template <typename Parameters>
void
apply (const GivenNumbers& given, Parameters& parameters)
{
  visitAll (parameters, [&] (auto& number, const NumberOption& option) {
    using Value = ValueOf<std::decay_t<decltype (number)>>;
    if (const auto found = given.find (nameOf (option.usage)); found != given.end())
      number = Value (found->second);
  });
}

/** \brief Declares the options of what these parameters have alone.
 * \param[in] notes what follows the help of an option, by its name */
template <typename Parameters>
void
declare (Parameters parameters,
         const std::map<std::string, std::string>& notes,
         CommandLine& line,
         GivenNumbers& given)
{
  visitOwn (parameters, [&] (auto& number, const NumberOption& option) {
    using Value = ValueOf<std::decay_t<decltype (number)>>;
    const std::string name = nameOf (option.usage);
    const auto note = notes.find (name);
    line.add (option.usage,
              [=, &given] (const std::string& text) {
                given[name] = parseNumber<Value> ("--" + name, text, option.range);
              })
        .help (option.help + (note == notes.end() ? "" : " (" + note->second + ")"));
  });
}

} // namespace pcl_ops::apps
