// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"
#include <cli/command_line.h>
#include <numbers/angles.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <map>
#include <optional>
#include <string>
#include <type_traits>

namespace pcl_ops::apps {

// The command line options for the parameters of detectors. The overloads of visitOwn
// list them: each calls a function with each parameter of a detector and its option.

using OpsParameters = OrientedPointSamplingParameters;
using FspfParameters = FastSamplingPlaneFilteringParameters;
using KhtParameters = KernelHoughTransformParameters;

/** \brief How users write a number on the command line: as the parameters hold it; in
 * degrees instead of radians; or so that 0 means an automatic value. */
enum class Written { AsItIs, InDegrees, ZeroForAutomatic };

/** \brief The option for a parameter. */
struct NumberOption {
  /** \brief Name of the option and kind of its value, for the help: "threshold M". M is
   * a length in the unit of the cloud, N, K, S and T are whole numbers, R and P numbers
   * without unit, DEG is an angle. */
  const char* usage;
  /** \brief Allowed values, as users write them. */
  Range range;
  const char* help;
  Written written = Written::AsItIs;
  /** \brief A name that is still accepted; empty for none. */
  const char* old_name = "";
};

/** \brief Converts a number from the parameters to the form that users write. */
template <typename Number>
Number
toWritten (Number number, const NumberOption& option)
{
  if constexpr (std::is_same_v<Number, double>)
    if (option.written == Written::InDegrees)
      return toDegrees (number);
  if constexpr (std::is_same_v<Number, std::optional<double>>)
    if (option.written == Written::ZeroForAutomatic)
      return number.value_or (0.0);
  return number;
}

/** \brief Converts a number that a user wrote to the form that the parameters hold. */
template <typename Number>
Number
fromWritten (Number number, const NumberOption& option)
{
  if constexpr (std::is_same_v<Number, double>)
    if (option.written == Written::InDegrees)
      return toRadians (number);
  if constexpr (std::is_same_v<Number, std::optional<double>>)
    if (option.written == Written::ZeroForAutomatic && number == 0.0)
      return std::nullopt;
  return number;
}

/** \brief The fewest points that define a plane. */
constexpr double points_of_a_plane = 3;

/** \brief Calls \p visit (number, NumberOption) for each parameter that all detectors
 * have. The help of these parameters has the default values. */
template <typename Visit>
void
visitOwn (PlaneDetectorParameters& parameters, const Visit& visit)
{
  visit (parameters.distance_threshold,
         {"threshold M", above (0), "farthest point of a plane (0.05; ops: auto)"});
  visit (parameters.merging.distance_threshold,
         {"merge-distance M",
          from (0),
          "planes this near are one (--threshold; ops: auto)"});
  visit (parameters.angle_tolerance,
         {"angle-tolerance DEG",
          from (0).upTo (90),
          "largest tilt of horizontal and vertical planes (7)",
          Written::InDegrees});
  visit (parameters.seed, {"seed S", from (0), "same seed, same result (42)"});
  visit (
      parameters.threads,
      {"threads T", from (0).upTo (1024), "0 for all; the result stays the same (1)"});
}

/** \brief The same for the parameters that OPS alone has. To the help of these
 * parameters and of the following ones the values of both presets are appended. */
template <typename Visit>
void
visitOwn (OpsParameters& parameters, const Visit& visit)
{
  visit (
      parameters.sampling_rate,
      {"sampling-rate R", above (0).upTo (1), "share of the points that get a normal"});
  visit (parameters.k,
         {"k K", from (2), "neighbors of a normal; others scale with it"});
  visit (parameters.min_samples,
         {"min-inliers N",
          from (1),
          "smallest plane, in samples; --min-points counts points"});
  visit (parameters.paper_only.probability,
         {"probability P",
          above (0).below (1),
          "of drawing a point of the largest plane; only with --preset paper"});
  visit (parameters.surfels.voxel_size,
         {"voxel-size M",
          from (0),
          "edge of a voxel; 0: no voxels, but neighborhoods",
          Written::ZeroForAutomatic,
          "cell"});
}

/** \brief The same for the parameters that FSPF alone has. */
template <typename Visit>
void
visitOwn (FspfParameters& parameters, const Visit& visit)
{
  FspfParameters::Local& local = parameters.local;
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

/** \brief The same for the parameters that 3D-KHT alone has. */
template <typename Visit>
void
visitOwn (KhtParameters& parameters, const Visit& visit)
{
  auto& clusters = parameters.clusters;
  visit (parameters.phi_num,
         {"phi-num N", from (2).upTo (1000), "steps of half a turn"});
  visit (parameters.rho_num,
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

/** \brief The same for all parameters of a detector: its own and those that all
 * detectors have. */
template <typename Parameters, typename Visit>
void
visitAll (Parameters& parameters, const Visit& visit)
{
  visitOwn (parameters, visit);
  visitOwn (static_cast<PlaneDetectorParameters&> (parameters), visit);
}

/** \brief Type of the number that users write for a parameter of type \p Number: double
 * if that is an std::optional<double>. */
template <typename Number>
using ValueOf = std::conditional_t<std::is_arithmetic_v<Number>, Number, double>;

/** \brief Sets the parameters of a detector to the numbers that users gave; the others
 * do not change. */
template <typename Parameters>
void
setGiven (const GivenNumbers& given, Parameters& parameters)
{
  visitAll (parameters, [&] (auto& number, const NumberOption& option) {
    using Number = std::decay_t<decltype (number)>;
    const auto found = given.find (nameOf (option.usage));
    if (found == given.end())
      return;
    const double written = found->second;
    number = fromWritten (Number (ValueOf<Number> (written)), option);
  });
}

/** \brief Declares the options of the parameters that visitOwn visits for this type.
 * \param[in] notes texts to append to the help of options, by the names of these
 * \param[out] given gets the numbers when the command line is parsed */
template <typename Parameters>
void
declareOptions (Parameters parameters,
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
        .help (option.help + (note == notes.end() ? "" : " (" + note->second + ")"))
        .onceCalled (option.old_name);
  });
}

} // namespace pcl_ops::apps
