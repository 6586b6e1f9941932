// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "methods.h"

#include <boost/format.hpp>

#include "advice.h"
#include "overlap.h"
#include "plane_list.h"
#include <cli/command_line.h>
#include <cli/text.h>
#include <numbers/angles.h>
#include <pcl_ops/detect_planes.h>
#include <pcl_ops/up_axis.h>
#include <pcl_ops/visibility.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <sstream>
#include <type_traits>
#include <utility>

namespace pcl_ops::apps {

namespace {

using OpsParameters = OrientedPointSamplingParameters;
using FspfParameters = FastSamplingPlaneFilteringParameters;
using KhtParameters = KernelHoughTransformParameters;

/** \brief How users write a number on the command line: as the parameters hold it, in
 * degrees instead of radians, or as 0 for an automatic value. */
enum class Written { AsItIs, InDegrees, ZeroForAutomatic };

struct NumberOption {
  const char* usage;
  Range range;
  const char* help;
  Written written = Written::AsItIs;
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

/** \brief The reverse of \ref toWritten. */
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

constexpr double points_of_a_plane = 3;

/** \brief Calls \p visit (number, option) for each parameter of all detectors. */
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
  visit (p.angle_tolerance,
         {"angle-tolerance DEG",
          from (0).upTo (90),
          "largest tilt of horizontal and vertical planes (7)",
          Written::InDegrees});
  visit (p.seed, {"seed S", from (0), "same seed, same result (42)"});
  visit (
      p.threads,
      {"threads T", from (0).upTo (1024), "0 for all; the result stays the same (1)"});
}

/** \brief The same for the parameters of one detector. The values of its presets follow
 * in the help. */
template <typename Visit>
void
visitOwn (OpsParameters& p, const Visit& visit)
{
  visit (
      p.sampling_rate,
      {"sampling-rate R", above (0).upTo (1), "share of the points that get a normal"});
  visit (p.k, {"k K", from (2), "neighbors of a normal; others scale with it"});
  visit (p.min_samples,
         {"min-inliers N",
          from (1),
          "smallest plane, in samples; --min-points counts points"});
  visit (p.paper_only.probability,
         {"probability P",
          above (0).below (1),
          "of drawing a point of the largest plane"});
  visit (p.surfels.voxel_size,
         {"voxel-size M",
          from (0),
          "edge of a voxel; 0: no voxels, but neighborhoods",
          Written::ZeroForAutomatic,
          "cell"});
}

template <typename Visit>
void
visitOwn (FspfParameters& p, const Visit& visit)
{
  FspfParameters::Local& local = p.local;
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
visitOwn (KhtParameters& p, const Visit& visit)
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
    using Number = std::decay_t<decltype (number)>;
    const auto found = given.find (nameOf (option.usage));
    if (found != given.end())
      number = fromWritten (Number (ValueOf<Number> (found->second)), option);
  });
}

/** \brief Declares the options of the parameters that visitOwn visits for this type.
 * \param[in] notes text to append to the help of an option, by its name */
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
        .help (option.help + (note == notes.end() ? "" : " (" + note->second + ")"))
        .onceCalled (option.old_name);
  });
}

// relate: sets parameters that follow from given options, and refuses contradictions.

void
relate (const GivenNumbers& given, std::size_t points, OpsParameters& parameters)
{
  if (given.count ("voxel-size") > 0 && parameters.sampling == Sampling::Points)
    throw UsageError ("--voxel-size", "has no meaning to --preset paper; leave it out");
  // A k above the number of points would cost the time of a cloud of k points.
  const int k = parameters.k;
  if (k > OpsParameters().k && std::size_t (k) > points)
    throw UsageError ("--k",
                      concatenate (k,
                                   " is more than the points of the cloud, ",
                                   points,
                                   "; give a smaller number"));
}

/** \brief If only one radius is given, sets the other by r2 = 2 r1, the ratio for which
 * the paper finds FSPF most accurate (Table I). */
void
relate (const GivenNumbers& given, std::size_t, FspfParameters& parameters)
{
  constexpr double ratio = 2.0;
  FspfParameters::Local& local = parameters.local;
  const bool has_inner = given.count ("inner-radius") > 0;
  const bool has_outer = given.count ("outer-radius") > 0;
  if (has_inner && !has_outer)
    local.outer_radius = ratio * local.inner_radius;
  if (has_outer && !has_inner)
    local.inner_radius = local.outer_radius / ratio;
  if (local.outer_radius < local.inner_radius)
    throw UsageError ("--outer-radius",
                      "is below --inner-radius; leave one of them out or raise it");
}

void
relate (const GivenNumbers& given, std::size_t, const KhtParameters& parameters)
{
  if (given.count ("merge-distance") > 0 && !parameters.merging.enabled)
    throw UsageError (
        "--merge-distance",
        "has no meaning to --preset paper of kht, which merges no planes; "
        "leave one of them out");
}

Eigen::Vector3d
sensorOf (const XyzCloud& cloud)
{
  return cloud.sensor_origin_.head<3>().cast<double>();
}

/** \brief Adds a hint that --min-inliers counts samples, not points, if a value above
 * the default leaves hardly a plane. */
void
hintOnMinInliers (const GivenNumbers& given,
                  OpsParameters parameters,
                  const XyzCloud& cloud,
                  Detected& detected)
{
  // More planes than `few` are enough for a room: no second search. The default has to
  // find min_ratio times as many.
  constexpr std::size_t few = 5;
  constexpr std::size_t min_ratio = 4;
  const unsigned usual = OpsParameters().min_samples;
  const unsigned asked = parameters.min_samples;
  parameters.min_samples = usual;
  const std::size_t left = detected.planes.size();
  if (given.count ("min-inliers") == 0 || asked <= usual || left > few)
    return;
  const std::size_t all = detectPlanes (cloud, parameters, sensorOf (cloud)).size();
  if (left != all && min_ratio * left <= all)
    detected.hints.push_back (concatenate ("--min-inliers ",
                                           asked,
                                           " counts samples, not points, and leaves ",
                                           left,
                                           " of ",
                                           all,
                                           " planes: --min-points ",
                                           asked,
                                           " counts points"));
}

std::string
samplingName (Sampling sampling)
{
  switch (sampling) {
  case Sampling::Points:
    return "points";
  case Sampling::Surfels:
    return "surfels";
  case Sampling::Neighborhoods:
    return "neighborhoods";
  case Sampling::Automatic:
    break;
  }
  return "automatic";
}

/** \brief Returns all parameters by option name, and some that no option changes. */
template <typename Parameters>
Settings
reportOf (const std::string& preset, Parameters parameters)
{
  Settings settings;
  settings["preset"] = preset;
  settings["up"] = Eigen::Vector3d (parameters.up_axis.template cast<double>());
  if constexpr (std::is_same_v<Parameters, OpsParameters>)
    settings["sampling"] = samplingName (parameters.sampling);
  if constexpr (std::is_same_v<Parameters, KhtParameters>) {
    settings["refit"] = parameters.refit.enabled;
    settings["merging"] = parameters.merging.enabled;
  }
  visitAll (parameters, [&] (const auto& number, const NumberOption& option) {
    const auto written = toWritten (number, option);
    Settings& setting = settings[keyOf (nameOf (option.usage))];
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype (number)>>)
      setting = written;
    else if (written)
      setting = *written;
    else
      setting = "auto"; // the value follows the cloud
  });
  return settings;
}

Settings
numberOrNull (const std::optional<double>& number)
{
  return number ? Settings (*number) : Settings();
}

/** \brief Adds the lengths that were used, as parameters may be automatic. */
void
reportUsed (const UsedLengths& used, Settings& settings)
{
  settings["threshold_used"] = numberOrNull (used.distance_threshold);
  if (settings.contains ("voxel_size"))
    settings["voxel_size_used"] = numberOrNull (used.voxel_size);
}

/** \brief Adds a hint if --sampling-rate has no effect beside --voxel-size. */
void
hintOnSamplingRate (const GivenNumbers& given, Detected& detected)
{
  const auto size = given.find ("voxel-size");
  if (size != given.end() && size->second > 0.0 && given.count ("sampling-rate") > 0)
    detected.hints.push_back (
        "--sampling-rate has no effect beside --voxel-size, which gives "
        "the voxels their size: leave one of them out");
}

double
millisecondsOf (clockid_t clock)
{
  timespec time{};
  ::clock_gettime (clock, &time);
  return 1e3 * static_cast<double> (time.tv_sec) +
         1e-6 * static_cast<double> (time.tv_nsec);
}

/** \brief Returns the parameters, with an observer that stores the stages if they are
 * asked for. The second searches for hints have no observer. */
template <typename Parameters>
Parameters
observed (Parameters parameters, bool keeps_stages, std::vector<StageResult>& stages)
{
  if constexpr (std::is_same_v<Parameters, OpsParameters>)
    if (keeps_stages)
      parameters.on_stage = [&stages] (const StageResult& result) {
        stages.push_back (result);
      };
  return parameters;
}

template <typename Parameters>
Detected
detectBy (const DetectorOptions& options, const XyzCloud::ConstPtr& cloud)
{
  Parameters parameters =
      options.preset == "paper" ? Parameters::paper() : Parameters();
  parameters.up_axis = options.up.value_or (parameters.up_axis);
  apply (options.numbers, parameters);
  relate (options.numbers, cloud->size(), parameters);
  const std::string problem = validate (parameters);
  if (!problem.empty())
    throw UsageError (Parameters::class_name, problem + "; see --help");
  const clockid_t clock =
      parameters.threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID;
  const double start = millisecondsOf (clock);
  Detected detected;
  auto found = detectPlanesInDetail (
      *cloud,
      observed (parameters, options.keeps_stages, detected.stages),
      sensorOf (*cloud));
  detected.processor_time = millisecondsOf (clock) - start;
  detected.planes = std::move (found.planes);
  detected.timing = found.durations;
  detected.used = found.used;
  detected.settings = reportOf (options.preset, parameters);
  reportUsed (detected.used, detected.settings);
  detected.up = parameters.up_axis;
  detected.advice = adviceFor (parameters, *cloud, detected.planes);
  if constexpr (std::is_same_v<Parameters, OpsParameters>) {
    hintOnMinInliers (options.numbers, parameters, *cloud, detected);
    hintOnSamplingRate (options.numbers, detected);
    if (parameters.sampling != Sampling::Points &&
        options.numbers.count ("voxel-size") == 0) {
      detected.search = parameters;
      const std::string hint = hintOnThickPlanes (*cloud, detected.planes);
      if (!hint.empty())
        detected.hints.push_back (hint);
    }
  }
  return detected;
}

/** \brief Returns the values of both presets as text for the help, by option name. */
template <typename Parameters>
std::map<std::string, std::string>
presetNotes ()
{
  std::map<std::string, std::string> notes;
  for (Parameters preset : {Parameters(), Parameters::paper()})
    visitOwn (preset, [&] (const auto& number, const NumberOption& option) {
      std::ostringstream value_text;
      if constexpr (std::is_arithmetic_v<std::decay_t<decltype (number)>>)
        value_text << toWritten (number, option);
      else
        value_text << toWritten (number, option).value_or (0.0);
      const std::string value = value_text.str();
      std::string& note = notes[nameOf (option.usage)];
      if (note.empty())
        note = value;
      else if (note != value)
        note += "; paper " + value;
    });
  return notes;
}

template <typename Parameters>
Method
methodOf (const std::string& name, const std::string& title)
{
  const auto declare_options = [] (CommandLine& line, GivenNumbers& given) {
    declare (Parameters(), presetNotes<Parameters>(), line, given);
  };
  return {name, title, declare_options, detectBy<Parameters>};
}

OpsParameters
defaultWith (const GivenNumbers& numbers)
{
  OpsParameters parameters;
  apply (numbers, parameters);
  return parameters;
}

std::string
noteOn (const std::optional<UpAxis>& found, bool is_seen, const Eigen::Vector3f& used)
{
  const std::string axis =
      str (boost::format ("%.4g,%.4g,%.4g") % used.x() % used.y() % used.z());
  if (found)
    return str (boost::format ("Up axis: %1%, confidence %2$.2f") % axis %
                found->confidence);
  return std::string ("Up axis: ") +
         (is_seen ? "the planes cannot tell, "
                  : "the cloud was not seen from its VIEWPOINT, ") +
         axis + " is used; give --up x,y,z";
}

/** \brief Suggests a different up axis if the planes are sure of it.
 * \param[in,out] detected planes of the default preset, so that no second search is
 * needed */
void
hintOnUp (const DetectorOptions& options, const XyzCloud& cloud, Detected& detected)
{
  const auto found = estimateUpAxis (detected.planes, sensorOf (cloud));
  if (!found)
    return;
  // The sign does not matter: upside down, planes have the same orientations.
  const double cosine =
      std::abs (found->direction.dot (detected.up.cast<double>().normalized()));
  if (cosine >= std::cos (defaultWith (options.numbers).angle_tolerance) ||
      !isSeenFromItsOrigin (cloud))
    return;
  detected.suggested_up = found->direction;
  // The sum turns -0 into 0.
  const Eigen::Array3d rounded =
      (100.0 * found->direction.array()).round() / 100.0 + 0.0;
  detected.hints.push_back (
      str (boost::format ("planes suggest that up is %.2f, %.2f, %.2f: --up auto") %
           rounded.x() % rounded.y() % rounded.z()));
}

/** \brief Returns the most frequent label among the inliers of a plane.
 * \param[in] labels of all points, as \ref labelsOf gives them: 0 for no plane */
std::size_t
planeWithMostOf (const PlaneSegment& plane, const std::vector<std::uint32_t>& labels)
{
  std::map<std::uint32_t, std::size_t> counts;
  for (const pcl::index_t index : plane.inliers)
    ++counts[labels[static_cast<std::size_t> (index)]];
  return std::max_element (
             counts.begin(),
             counts.end(),
             [] (const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

/** \brief Returns the next larger number with one significant digit; 0.002 for a length
 * up to 0.001. */
double
roundedUp (double length)
{
  constexpr double smallest = 1e-3;
  const double unit =
      std::pow (10.0, std::floor (std::log10 (std::max (length, smallest))));
  // .3 / .1 is rounded to a number below 3.
  constexpr double rounding = 1e-9;
  const double digit = std::floor (std::max (length, smallest) / unit + rounding);
  return unit * (digit + 1.0);
}

/** \brief If two planes may be one surface (\ref findOverlapping), adds a hint with the
 * --merge-distance that merges them. A second search checks that it does. */
void
hintOnOverlap (const Method& method,
               const DetectorOptions& options,
               const XyzCloud::ConstPtr& cloud,
               Detected& detected)
{
  constexpr const char* name = "merge-distance";
  if (options.numbers.count (name) > 0 || !detected.settings.value ("merging", true))
    return;
  const auto pair = findOverlapping (*cloud, detected.planes);
  if (!pair)
    return;
  DetectorOptions merging = options;
  merging.keeps_stages = false;
  const double distance = roundedUp (pair->distance);
  merging.numbers[name] = distance;
  const std::vector<std::uint32_t> labels =
      labelsOf (method.detect (merging, cloud).planes, cloud->size());
  const std::size_t merged = planeWithMostOf (detected.planes[pair->smaller], labels);
  if (merged == 0 || merged != planeWithMostOf (detected.planes[pair->larger], labels))
    return;
  detected.hints.push_back (str (
      boost::format ("planes %1% and %2% lie over or beside each other, %3$.2g apart: "
                     "--merge-distance %4% makes them one") %
      (pair->larger + 1) % (pair->smaller + 1) % pair->distance % distance));
}

std::string
groupOf (const Method& method)
{
  return "Options of --method " + method.name + ", " + method.title;
}

} // namespace

std::vector<std::uint32_t>
labelsOf (const std::vector<PlaneSegment>& planes,
          std::size_t points,
          const std::vector<std::uint32_t>& ids)
{
  std::vector<std::uint32_t> labels (points, 0);
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (const pcl::index_t index : planes[i].inliers)
      labels[index] = ids.empty() ? i + 1 : ids[i];
  return labels;
}

const std::vector<Method>&
allMethods ()
{
  static const std::vector<Method> methods = {
      methodOf<OpsParameters> ("ops", "Oriented Point Sampling"),
      methodOf<FspfParameters> ("fspf", "Fast Sampling Plane Filtering"),
      methodOf<KhtParameters> ("kht", "3D Kernel-based Hough Transform")};
  return methods;
}

const Method&
methodCalled (const std::string& name)
{
  const auto& methods = allMethods();
  return *std::find_if (methods.begin(), methods.end(), [&] (const Method& method) {
    return method.name == name;
  });
}

std::optional<UpAxis>
findUpAxis (const DetectorOptions& options, const XyzCloud& cloud)
{
  if (!isSeenFromItsOrigin (cloud))
    return std::nullopt;
  const OpsParameters given = defaultWith (options.numbers);
  OpsParameters parameters;
  parameters.seed = given.seed;
  parameters.threads = given.threads;
  const Eigen::Vector3d sensor = sensorOf (cloud);
  return estimateUpAxis (detectPlanes (cloud, parameters, sensor), sensor);
}

Detected
runMethod (const Method& method,
           const DetectorOptions& options,
           const XyzCloud::ConstPtr& cloud)
{
  if (!options.finds_up) {
    Detected detected = method.detect (options, cloud);
    // For planes of other methods or presets the confidence would be too high.
    if (!options.up && method.name == allMethods().front().name &&
        options.preset == "default")
      hintOnUp (options, *cloud, detected);
    hintOnOverlap (method, options, cloud, detected);
    if (options.sequence_has_up)
      detected.settings["up_confidence"] = numberOrNull (options.up_confidence);
    return detected;
  }
  const std::optional<UpAxis> found = findUpAxis (options, *cloud);
  const bool is_seen = found || isSeenFromItsOrigin (*cloud);
  DetectorOptions known = options;
  if (found)
    known.up = found->direction.cast<float>();
  Detected detected = method.detect (known, cloud);
  hintOnOverlap (method, known, cloud, detected);
  detected.up_note = noteOn (found, is_seen, detected.up);
  detected.settings["up_confidence"] =
      found ? Settings (found->confidence) : Settings();
  return detected;
}

void
declareMethodOptions (CommandLine& line, std::string& method, DetectorOptions& options)
{
  std::vector<std::string> names;
  for (const Method& known : allMethods())
    names.push_back (known.name);
  line.add ("method", method, names).help ("the detector (ops)");
  line.add ("preset", options.preset, {"default", "paper"})
      .help ("recommended parameters, or the paper's best ones");
  line.add ("up x,y,z",
            [&options] (const std::string& text) {
              options.finds_up = text == "auto";
              options.up_is_camera = text == "camera";
              if (!options.finds_up)
                options.up = parseUpAxis ("--up", text);
            })
      .help ("direction against gravity, camera or auto (0,0,1)");
  declare (PlaneDetectorParameters(), {}, line, options.numbers);
  for (const Method& known : allMethods()) {
    line.beginGroup (groupOf (known));
    known.declare_options (line, options.numbers);
  }
}

void
checkMethodOptions (const CommandLine& line, const Method& chosen)
{
  for (const Method& method : allMethods()) {
    const std::vector<std::string> given = line.givenOf (groupOf (method));
    if (method.name != chosen.name && !given.empty())
      throw UsageError ("--" + given.front(),
                        "is an option of --method " + method.name + ", not of " +
                            chosen.name + "; leave it out");
  }
}

bool
hasStages (const Method& method, const DetectorOptions& options)
{
  return method.name == allMethods().front().name && options.preset == "default" &&
         !defaultWith (options.numbers).surfels.voxel_size;
}

double
voxelStepOf (const DetectorOptions& options)
{
  const OpsParameters::Surfels surfels = defaultWith (options.numbers).surfels;
  return std::ldexp (surfels.voxel_size.value_or (0.0), surfels.resolutions - 1);
}

} // namespace pcl_ops::apps
