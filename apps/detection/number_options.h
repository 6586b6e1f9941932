// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"
#include <cli/command_line.h>
#include <numbers/angles.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <optional>
#include <string>
#include <type_traits>

namespace pcl_ops::apps {

/** \brief What there is to say about a parameter that is a number, besides the name of
 * its option; in reports that has '_' for '-'. */
struct NumberOption {
  const char* placeholder;
  Range range;
  const char* help;
};

constexpr double points_of_a_plane = 3;

/** \brief Calls \p visit (name, number, option) for what all detectors have. */
template <typename Visit>
void
visitOwn (PlaneDetectorParameters& p, const Visit& visit)
{
  visit ("threshold",
         p.distance_threshold,
         {"M", Range::above (0), "farthest point of a plane (0.05; ops: auto)"});
  visit ("merge-distance",
         p.merging.distance_threshold,
         {"M", Range::from (0), "planes this near are one (--threshold; ops: auto)"});
  const double usual = toDegrees (p.angle_tolerance);
  double degrees = usual;
  visit ("angle-tolerance",
         degrees,
         {"DEG",
          Range::from (0).upTo (90),
          "largest tilt of horizontal and vertical planes (7)"});
  if (degrees != usual)
    p.angle_tolerance = toRadians (degrees);
  visit ("seed", p.seed, {"S", Range::from (0), "same seed, same result (42)"});
  visit (
      "threads",
      p.threads,
      {"T", Range::from (0).upTo (1024), "0 for all; the result stays the same (1)"});
}

/** \brief The same for what one detector has alone; the values of the presets follow in
 * the help. */
template <typename Visit>
void
visitOwn (OrientedPointSamplingParameters& p, const Visit& visit)
{
  visit ("sampling-rate",
         p.sampling_rate,
         {"R", Range::above (0).upTo (1), "share of the points that get a normal"});
  visit ("k",
         p.k,
         {"K", Range::from (2), "neighbors of a normal; on surfels the fewest points"});
  visit ("min-inliers",
         p.min_inliers,
         {"N", Range::from (1), "a plane has more sampled points than this"});
  visit ("probability",
         p.paper_only.probability,
         {"P", Range::above (0).below (1), "of drawing a point of the largest plane"});
  double edge = p.surfels.voxel_size.value_or (0.0);
  visit ("cell",
         edge,
         {"M", Range::from (0), "edge of a voxel; 0: by the number of points"});
  p.surfels.voxel_size = edge == 0.0 ? std::nullopt : std::make_optional (edge);
}

template <typename Visit>
void
visitOwn (FastSamplingPlaneFilteringParameters& p, const Visit& visit)
{
  FastSamplingPlaneFilteringParameters::Local& local = p.local;
  visit ("inner-radius",
         local.inner_radius,
         {"M", Range::above (0), "three points this near make a hypothesis"});
  visit ("outer-radius",
         local.outer_radius,
         {"M", Range::above (0), "it is tested on points this near"});
  visit ("local-samples",
         local.local_samples,
         {"N", Range::from (points_of_a_plane), "it is tested on so many of them"});
  visit ("min-inlier-share",
         local.min_inlier_fraction,
         {"R", Range::from (0).below (1), "a larger share of these must be inliers"});
  visit ("inliers-per-point",
         local.max_inliers_per_point,
         {"R", Range::above (0), "sampling ends at so many inliers"});
}

template <typename Visit>
void
visitOwn (KernelHoughTransformParameters& p, const Visit& visit)
{
  auto& clusters = p.clusters;
  visit (
      "phi-num", p.phi_num, {"N", Range::from (2).upTo (1000), "steps of half a turn"});
  visit ("rho-num",
         p.rho_num,
         {"N", Range::from (2).upTo (10000), "steps out to the farthest point"});
  visit ("min-samples",
         clusters.min_samples,
         {"N", Range::from (points_of_a_plane), "smaller octree nodes are left out"});
  visit ("s-level",
         clusters.first_level,
         {"N", Range::from (0).upTo (20), "first level of the octree that is tested"});
  visit ("s-alpha",
         clusters.s_alpha,
         {"R", Range::above (0), "larger: a node must be thinner to count as flat"});
  visit ("s-beta",
         clusters.s_beta,
         {"R", Range::above (0), "larger: it may be more elongated"});
}

/** \brief The same for all that a detector has. */
template <typename Parameters, typename Visit>
void
visitAll (Parameters& parameters, const Visit& visit)
{
  visitOwn (parameters, visit);
  visitOwn (static_cast<PlaneDetectorParameters&> (parameters), visit);
}

/** \brief The number that the text of an option says, for one like \p number.
 * \throws UsageError if it is none or out of range */
template <typename Number>
auto
parsed (const std::string& name,
        const std::string& text,
        const NumberOption& option,
        const Number& /* number */)
{
  using Value = std::conditional_t<std::is_arithmetic_v<Number>, Number, double>;
  return parseNumber<Value> ("--" + name, text, option.range);
}

template <typename Number>
Settings
settingOf (const Number& number)
{
  if constexpr (std::is_arithmetic_v<Number>)
    return number;
  else
    return number ? Settings (*number) : Settings ("auto");
}

/** \brief Sets the parameters whose options were given.
 * \throws UsageError as \ref parsed */
template <typename Parameters>
void
apply (const GivenNumbers& given, Parameters& parameters)
{
  visitAll (parameters,
            [&] (const char* name, auto& number, const NumberOption& option) {
              if (const auto text = given.find (name); text != given.end())
                number = parsed (name, text->second, option, number);
            });
}

/** \brief Declares the options of what these parameters have alone.
 * \param[in] notes what follows the help of an option, by its name
 * \param[out] given those on the parsed line, checked */
template <typename Parameters>
void
declare (Parameters parameters,
         const std::map<std::string, std::string>& notes,
         CommandLine& line,
         GivenNumbers& given)
{
  visitOwn (parameters,
            [&] (const char* name, auto number, const NumberOption& option) {
              const auto note = notes.find (name);
              line.add (std::string (name) + " " + option.placeholder,
                        [=, &given] (const std::string& text) {
                          parsed (name, text, option, number);
                          given[name] = text;
                        })
                  .help (option.help +
                         (note == notes.end() ? "" : " (" + note->second + ")"));
            });
}

} // namespace pcl_ops::apps
