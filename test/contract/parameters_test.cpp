// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "python/parameter_names.h"
#include "scene.h"

#include <iomanip>
#include <sstream>

namespace {

using namespace pcl_ops::python;
using OpsParameters = pcl_ops::OrientedPointSamplingParameters;
using FspfParameters = pcl_ops::FastSamplingPlaneFilteringParameters;
using KhtParameters = pcl_ops::KernelHoughTransformParameters;

/** \brief What a parameter may be. */
struct Range {
  const char* name;
  /** \brief What validate has to speak of. */
  const char* words;
  std::vector<double> wrong;
  std::vector<double> right = {};
};

using Ranges = std::vector<Range>;

/** \brief Below zero, infinite, none at all, and others. */
std::vector<double>
notPositive (std::vector<double> others = {})
{
  others.insert (others.end(), {-1.0, HUGE_VAL, NAN});
  return others;
}

const Ranges of_all = {
    {"up", "up axis", {0.0, NAN, HUGE_VAL}, {1e-30, 1e30}},
    {"distance_threshold", "distance threshold", notPositive ({0.0})},
    {"angle_tolerance", "angle tolerance", notPositive ({2.0}), {0.0, 1.5}},
    {"merging_angle_threshold", "merging angle", notPositive ({2.0})},
    {"merging_distance_threshold", "merging distance", notPositive(), {0.0}},
    {"merging_noise_factor", "merging noise", notPositive(), {0.0}}};

const Ranges of_ops = {
    {"k", "k must be 2", {1, -5}, {2}},
    {"min_inliers", "", {}, {0}},
    {"sampling_rate", "sampling rate", notPositive ({0.0, 1.01}), {1.0}},
    {"normal_sigma", "sigma", notPositive ({0.0})},
    {"probability", "probability", notPositive ({0.0, 1.0})},
    {"surfels_resolutions", "resolutions", {0, 11}, {1, 10}},
    {"surfels_voxel_size", "voxel size", notPositive ({0.0, 1e-40, 1e40}), {1e-6}},
    {"surfels_min_average_voxels", "least average voxels", notPositive()},
    {"surfels_noise_factor", "noise factor of surfels", notPositive()},
    {"surfels_angle_threshold", "angle threshold", notPositive ({2.0})},
    {"surfels_sure_thickness", "thickness", notPositive(), {0.0}},
    {"surfels_max_thickness", "thickness", notPositive()},
    {"surfels_absorption_noise_factor", "of absorption", notPositive()},
    {"surfels_assignment_noise_factor", "of assignment", notPositive()}};

const Ranges of_fspf = {
    {"inner_radius", "outer radius", {0.3}},
    {"inner_radius", "inner radius", notPositive ({0.0, 1e-320})},
    {"outer_radius", "outer radius", notPositive ({0.0, 1e-320})},
    {"local_samples", "local samples", {2}, {3}},
    {"min_inlier_fraction", "inlier fraction", notPositive ({1.0})},
    {"max_inliers_per_point", "inliers per point", notPositive ({0.0})},
    {"max_hypotheses_per_point", "hypotheses", notPositive ({0.0})},
    {"max_visits_per_point", "visits", notPositive ({0.0})}};

const Ranges of_kht = {{"phi_num", "phi_num", {1, 1001}, {2, 1000}},
                       {"rho_num", "rho_num", {1, 10001}, {2, 10000}},
                       {"clusters_min_samples", "three samples", {2}, {3}},
                       {"clusters_first_level", "s_level", {-1}},
                       {"clusters_max_level", "s_level", {2}, {5, 60}},
                       {"clusters_max_level", "deepest level", {61}},
                       {"clusters_s_alpha", "s_alpha", {0.0, NAN}},
                       {"clusters_s_beta", "s_beta", {0.0, NAN}},
                       {"refit_min_share", "smallest share", {-0.1, 2.0, NAN}}};

const Ranges of_filter = {
    {"direction", "direction must", {0.0, NAN, HUGE_VAL}, {-7.0}},
    {"direction_tolerance", "direction tolerance", notPositive ({2.0}), {0.0}},
    {"up", "up axis", {0.0, NAN}, {7.0}},
    {"slope", "slope", notPositive ({0.05, 2.0}), {0.1, 1.5}},
    {"min_area", "smallest area", notPositive(), {0.0}},
    {"min_width", "smallest width", notPositive(), {0.0}},
    {"max_area", "largest area", notPositive ({0.9}), {1.0}},
    {"max_width", "largest width", notPositive ({0.9}), {1.0}},
    {"size", "size", notPositive(), {0.0}}};

const Ranges of_matching = {
    {"rotation_error", "rotation", notPositive ({2.0}), {0.0, 1.5}},
    {"translation_error", "translation", notPositive(), {0.0}},
    {"min_overlap", "overlap", notPositive ({1.1}), {0.0, 1.0}}};

const Ranges of_edges = {
    {"reach", "reach", notPositive(), {0.0}},
    {"max_gap", "gap", notPositive(), {0.0}},
    {"min_length", "smallest length", notPositive(), {0.0}},
    {"min_angle", "smallest angle", notPositive ({0.0, 2.0}), {1.5}}};

const Ranges of_up_axis = {
    {"angle_tolerance", "tolerance", notPositive ({0.0, 7.0}), {1.5}},
    {"min_share", "share", notPositive ({2.0}), {0.0, 1.0}},
    {"min_confidence", "confidence", notPositive ({2.0}), {0.0, 1.0}}};

template <typename T>
void
setTo (double value, T& number)
{
  if constexpr (std::is_assignable_v<T&, double>)
    number = static_cast<T> (value);
}
template <typename T>
void
setTo (double length, Eigen::Matrix<T, 3, 1>& direction)
{
  direction *= static_cast<T> (length);
}
void
setTo (double length, std::optional<Eigen::Vector3d>& direction)
{
  direction = {0.0, 0.0, length};
}
void
setTo (double largest, std::optional<std::array<double, 2>>& interval)
{
  interval = {0.1, largest};
}
void
setTo (double tolerance, std::optional<std::array<double, 3>>& size)
{
  size = {1.0, 2.0, tolerance};
}

/** \brief What validate says where one of good parameters has some value. */
template <typename Parameters>
std::string
problemWith (Parameters parameters, const std::string& changed, double value)
{
  visit_parameters (parameters, [&] (const std::string& name, auto& member) {
    if (name == changed)
      setTo (value, member);
  });
  return validate (parameters);
}

template <typename Parameters>
void
expectRanges (const Ranges& ranges, const Parameters& good)
{
  EXPECT_EQ (validate (good), "");
  for (const auto& [name, words, all_wrong, all_right] : ranges) {
    SCOPED_TRACE (name);
    for (const double wrong : all_wrong) {
      const std::string problem = problemWith (good, name, wrong);
      EXPECT_TRUE (!problem.empty() && problem.find (words) != std::string::npos)
          << "'" << problem << "' should speak of " << words << " at " << wrong;
    }
    for (const double right : all_right)
      EXPECT_EQ (problemWith (good, name, right), "") << " at " << right;
  }
}

/** \brief As a reader has it: an angle in degrees, an enumerator as its word. */
template <typename T>
void
print (const std::string& name, const T& value, std::ostream& out)
{
  if constexpr (std::is_enum_v<T>)
    for (const auto& [word, meaning] : std::get<Words<T>> (words))
      out << (meaning == value ? word : "");
  else if constexpr (std::is_arithmetic_v<T>)
    out << (name.find ("angle") < name.size() ? value * 180.0 / pi : value);
  else if constexpr (std::is_same_v<T, Eigen::Vector3f>)
    out << value.transpose();
  else if (value)
    print (name, *value, out);
  else
    out << "none";
}

/** \brief Each parameter with its value. */
template <typename Parameters>
std::vector<std::string>
valuesOf (Parameters parameters)
{
  std::vector<std::string> values;
  visit_parameters (parameters, [&] (const std::string& name, const auto& value) {
    std::ostringstream text;
    text << std::setprecision (12) << name << ' ';
    print (name, value, text);
    values.push_back (text.str());
  });
  return values;
}

/** \brief Those that are not among others. */
std::string
textOf (const std::vector<std::string>& values, const std::vector<std::string>& others)
{
  std::string text;
  for (const std::string& value : values)
    if (std::find (others.begin(), others.end(), value) == others.end())
      text += (text.empty() ? "" : ", ") + value;
  return text;
}

} // namespace

TEST (Parameters, OutOfRangeAreNamed)
{
  for (const OpsParameters& good : {OpsParameters(), OpsParameters::paper()}) {
    expectRanges (of_all, good);
    expectRanges (of_ops, good);
  }
  for (const FspfParameters& good : {FspfParameters(), FspfParameters::paper()})
    expectRanges (of_all, good);
  expectRanges (of_fspf, FspfParameters());
  for (const KhtParameters& good : {KhtParameters(), KhtParameters::paper()})
    expectRanges (of_all, good);
  expectRanges (of_kht, KhtParameters());
  pcl_ops::PlaneFilter filter;
  filter.min_area = filter.min_width = 1.0;
  expectRanges (of_filter, filter);
  expectRanges (of_matching, pcl_ops::PlaneMatchingParameters());
  expectRanges (of_edges, pcl_ops::PlaneEdgeParameters());
  expectRanges (of_up_axis, pcl_ops::UpAxisParameters());
}

TEST (Parameters, NeedADistanceThresholdButForSurfels)
{
  const auto problem = [] (auto parameters) {
    parameters.distance_threshold.reset();
    return validate (parameters);
  };
  const std::string message = "the distance threshold must be a length above 0";
  EXPECT_EQ (problem (OpsParameters()), "");
  EXPECT_EQ (problem (OpsParameters::paper()), message);
  EXPECT_EQ (problem (FspfParameters()), message);
  EXPECT_EQ (problem (KhtParameters()), message);
}

// Every field of every preset: a default that changes changes results.

TEST (Presets, DefaultsAreTheRecommendedParameters)
{
  const std::string shared = "seed 42, threads 1, merging_enabled 1, "
                             "merging_angle_threshold 7, "
                             "merging_distance_threshold none, "
                             "merging_noise_factor none, up 0 0 1, angle_tolerance 7";
  EXPECT_EQ (textOf (valuesOf (OpsParameters()), {}),
             "sampling surfels, sampling_rate 0.03, k 30, min_inliers 20, "
             "normal_sigma none, probability 0.99, strategy detect_then_divide, "
             "verification samples, assignment_rule first, local_optimization 1, "
             "surfels_voxel_size none, surfels_resolutions 3, "
             "surfels_min_average_voxels 6, surfels_noise_factor 2, "
             "surfels_angle_threshold 30, surfels_sure_thickness 0.24, "
             "surfels_max_thickness 0.3, surfels_absorption_noise_factor 3.5, "
             "surfels_assignment_noise_factor 5, distance_threshold none, " +
                 shared);
  EXPECT_EQ (textOf (valuesOf (FspfParameters()), {}),
             "inner_radius 0.1, outer_radius 0.2, local_samples 80, "
             "min_inlier_fraction 0.8, local_inliers sphere, max_inliers_per_point 2, "
             "max_hypotheses_per_point 1, max_visits_per_point 100, "
             "distance_threshold 0.05, " +
                 shared);
  EXPECT_EQ (
      textOf (valuesOf (KhtParameters()), {}),
      "phi_num 30, rho_num 300, clusters_min_samples 30, clusters_first_level 3, "
      "clusters_s_alpha 15, clusters_s_beta 6, clusters_max_level 20, "
      "refit_enabled 1, refit_min_share 0.001, distance_threshold 0.05, " +
          shared);
  EXPECT_EQ (textOf (valuesOf (pcl_ops::UpAxisParameters()), {}),
             "angle_tolerance 7, min_share 0.02, min_confidence 0.7");
}

TEST (Presets, PaperHasItsBestRowsAndElseTheDefaults)
{
  const auto changes = [] (const auto& preset) {
    return textOf (valuesOf (preset), valuesOf (std::decay_t<decltype (preset)>()));
  };
  // Table III of the paper; then Table IV; then 3D-KHT as it was published.
  EXPECT_EQ (changes (OpsParameters::paper()),
             "sampling points, strategy divide_then_detect, local_optimization 0, "
             "distance_threshold 0.05");
  EXPECT_EQ (changes (FspfParameters::paper()), "inner_radius 0.07, outer_radius 0.14");
  EXPECT_EQ (changes (KhtParameters::paper()),
             "phi_num 80, rho_num 800, clusters_first_level 5, clusters_s_alpha 25, "
             "refit_enabled 0, merging_enabled 0");
}
