// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "methods.h"

#include <boost/format.hpp>

#include "advice.h"
#include "overlap.h"
#include "parameter_options.h"
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

/** \brief Refuses options that contradict each other or the cloud.
 * \param[in] points number of points of the cloud
 * \throws UsageError */
void
checkAndComplete (const GivenNumbers& given,
                  std::size_t points,
                  OpsParameters& parameters)
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

/** \brief If only one radius is given, sets the other one: the outer radius is twice
 * the inner one, the ratio for which the paper finds FSPF most accurate (Table I).
 * \throws UsageError if the outer radius is smaller than the inner one */
void
checkAndComplete (const GivenNumbers& given,
                  std::size_t /*points*/,
                  FspfParameters& parameters)
{
  constexpr double outer_by_inner = 2.0;
  FspfParameters::Local& local = parameters.local;
  const bool has_inner = given.count ("inner-radius") > 0;
  const bool has_outer = given.count ("outer-radius") > 0;
  if (has_inner && !has_outer)
    local.outer_radius = outer_by_inner * local.inner_radius;
  if (has_outer && !has_inner)
    local.inner_radius = local.outer_radius / outer_by_inner;
  if (local.outer_radius < local.inner_radius)
    throw UsageError ("--outer-radius",
                      "is below --inner-radius; leave one of them out or raise it");
}

/** \brief Refuses options that contradict each other. \throws UsageError */
void
checkAndComplete (const GivenNumbers& given,
                  std::size_t /*points*/,
                  const KhtParameters& parameters)
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
 * the default leaves 5 planes or fewer, and at most a quarter of those that the default
 * value leaves. */
void
hintOnMinInliers (const GivenNumbers& given,
                  OpsParameters parameters,
                  const XyzCloud& cloud,
                  Detected& detected)
{
  // More planes are enough for a room, so that no second search is needed.
  constexpr std::size_t max_left = 5;
  // The default value has to leave at least so many times as many planes.
  constexpr std::size_t min_ratio = 4;
  const unsigned default_min = OpsParameters().min_samples;
  const unsigned asked = parameters.min_samples;
  const std::size_t left = detected.planes.size();
  if (given.count ("min-inliers") == 0 || asked <= default_min || left > max_left)
    return;
  parameters.min_samples = default_min;
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

/** \brief Returns all parameters by the names of their options, and some parameters
 * that no option changes. */
template <typename Parameters>
Settings
settingsOf (const std::string& preset, Parameters parameters)
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
addUsedLengths (const UsedLengths& used, Settings& settings)
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

/** \brief Returns the time of a clock [ms]. */
double
millisecondsOf (clockid_t clock)
{
  timespec time{};
  ::clock_gettime (clock, &time);
  return 1e3 * static_cast<double> (time.tv_sec) +
         1e-6 * static_cast<double> (time.tv_nsec);
}

/** \brief Returns the parameters, with an observer that stores the stages if they are
 * asked for. Further searches, which only serve hints, have no observer.
 * \param[out] stages is filled during the detection */
template <typename Parameters>
Parameters
withObserver (Parameters parameters,
              bool keeps_stages,
              std::vector<StageResult>& stages)
{
  if constexpr (std::is_same_v<Parameters, OpsParameters>)
    if (keeps_stages)
      parameters.on_stage = [&stages] (const StageResult& result) {
        stages.push_back (result);
      };
  return parameters;
}

/** \brief Adds hints on the options of OPS, and sets Detected::search. */
void
addHints (const GivenNumbers& given,
          const OpsParameters& parameters,
          const XyzCloud& cloud,
          Detected& detected)
{
  hintOnMinInliers (given, parameters, cloud, detected);
  hintOnSamplingRate (given, detected);
  const bool is_on_neighborhoods =
      parameters.sampling != Sampling::Points && !parameters.surfels.voxel_size;
  if (!is_on_neighborhoods)
    return;
  detected.search = parameters;
  const std::string hint = hintOnThickPlanes (cloud, detected.planes);
  if (!hint.empty())
    detected.hints.push_back (hint);
}

/** \brief Returns the parameters of a preset with the up axis and the given numbers.
 * \param[in] points number of points of the cloud
 * \throws UsageError if options contradict each other */
template <typename Parameters>
Parameters
parametersOf (const DetectorOptions& options, std::size_t points)
{
  Parameters parameters =
      options.preset == "paper" ? Parameters::paper() : Parameters();
  parameters.up_axis = options.up.value_or (parameters.up_axis);
  setGiven (options.numbers, parameters);
  checkAndComplete (options.numbers, points, parameters);
  const std::string problem = validate (parameters);
  if (!problem.empty())
    throw UsageError (Parameters::class_name, problem + "; see --help");
  return parameters;
}

/** \brief Finds planes by the detector of these parameters (Method::detect). */
template <typename Parameters>
Detected
detectBy (const DetectorOptions& options, const XyzCloud::ConstPtr& cloud)
{
  const auto parameters = parametersOf<Parameters> (options, cloud->size());
  const clockid_t clock =
      parameters.threads == 1 ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID;
  const double start = millisecondsOf (clock);
  Detected detected;
  auto found = detectPlanesInDetail (
      *cloud,
      withObserver (parameters, options.keeps_stages, detected.stages),
      sensorOf (*cloud));
  detected.processor_time = millisecondsOf (clock) - start;
  detected.planes = std::move (found.planes);
  detected.timing = found.durations;
  detected.used = found.used;
  detected.settings = settingsOf (options.preset, parameters);
  addUsedLengths (detected.used, detected.settings);
  detected.up = parameters.up_axis;
  detected.advice = adviceFor (parameters, *cloud, detected.planes);
  if constexpr (std::is_same_v<Parameters, OpsParameters>)
    addHints (options.numbers, parameters, *cloud, detected);
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
    declareOptions (Parameters(), presetNotes<Parameters>(), line, given);
  };
  return {name, title, declare_options, detectBy<Parameters>};
}

/** \brief Returns the default parameters of OPS with the given numbers. */
OpsParameters
defaultWith (const GivenNumbers& numbers)
{
  OpsParameters parameters;
  setGiven (numbers, parameters);
  return parameters;
}

/** \brief Returns a line on the up axis that was used.
 * \param[in] is_seen whether the cloud was seen from its sensor origin */
std::string
noteOnUp (const std::optional<UpAxis>& found, bool is_seen, const Eigen::Vector3f& used)
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

/** \brief Adds a hint if the planes show reliably that the up axis is another one.
 * \param[in,out] detected planes of the default preset, for which no second search is
 * needed */
void
hintOnUp (const DetectorOptions& options, const XyzCloud& cloud, Detected& detected)
{
  const std::optional<UpAxis> found =
      estimateUpAxis (detected.planes, sensorOf (cloud));
  if (!found)
    return;
  // The sign does not matter: upside down, planes have the same orientations.
  const double cosine =
      std::abs (found->direction.dot (detected.up.cast<double>().normalized()));
  const double min_cosine = std::cos (defaultWith (options.numbers).angle_tolerance);
  if (cosine >= min_cosine || !isSeenFromItsOrigin (cloud))
    return;
  detected.suggested_up = found->direction;
  // Adding 0 turns -0 into 0.
  const Eigen::Array3d rounded =
      (100.0 * found->direction.array()).round() / 100.0 + 0.0;
  detected.hints.push_back (
      str (boost::format ("planes suggest that up is %.2f, %.2f, %.2f: --up auto") %
           rounded.x() % rounded.y() % rounded.z()));
}

/** \brief Returns the most frequent label among the inliers of a plane.
 * \param[in] labels of all points, as \ref labelsOf gives them: 0 for no plane */
std::uint32_t
mostFrequentLabel (const PlaneSegment& plane, const std::vector<std::uint32_t>& labels)
{
  std::map<std::uint32_t, std::size_t> counts;
  for (const pcl::index_t index : plane.inliers)
    ++counts[labels[static_cast<std::size_t> (index)]];
  const auto most_frequent = std::max_element (
      counts.begin(), counts.end(), [] (const auto& a, const auto& b) {
        return a.second < b.second;
      });
  return most_frequent->first;
}

/** \brief Returns the next larger number with one significant digit; 0.002 for a length
 * up to 0.001. */
double
roundedUp (double length)
{
  constexpr double min_length = 1e-3;
  const double at_least = std::max (length, min_length);
  const double unit = std::pow (10.0, std::floor (std::log10 (at_least)));
  constexpr double rounding = 1e-9; // .3 / .1 is rounded to a number below 3
  return unit * (std::floor (at_least / unit + rounding) + 1.0);
}

/** \brief If two planes may be one surface (\ref findOverlapping), adds a hint with the
 * --merge-distance that merges them. A second search checks that it does. */
void
hintOnOverlap (const Method& method,
               const DetectorOptions& options,
               const XyzCloud::ConstPtr& cloud,
               Detected& detected)
{
  constexpr const char* option = "merge-distance";
  const bool can_merge = detected.settings.value ("merging", true);
  if (options.numbers.count (option) > 0 || !can_merge)
    return;
  const std::optional<OverlappingPlanes> pair =
      findOverlapping (*cloud, detected.planes);
  if (!pair)
    return;
  DetectorOptions merging = options;
  merging.keeps_stages = false;
  const double distance = roundedUp (pair->distance);
  merging.numbers[option] = distance;
  const std::vector<std::uint32_t> labels =
      labelsOf (method.detect (merging, cloud).planes, cloud->size());
  const std::uint32_t of_smaller =
      mostFrequentLabel (detected.planes[pair->smaller], labels);
  const std::uint32_t of_larger =
      mostFrequentLabel (detected.planes[pair->larger], labels);
  const bool are_merged = of_smaller != 0 && of_smaller == of_larger;
  if (!are_merged)
    return;
  detected.hints.push_back (str (
      boost::format ("planes %1% and %2% lie over or beside each other, %3$.2g apart: "
                     "--merge-distance %4% makes them one") %
      (pair->larger + 1) % (pair->smaller + 1) % pair->distance % distance));
}

/** \brief Returns the title of the options of a method in the help. */
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
    const bool is_default =
        method.name == allMethods().front().name && options.preset == "default";
    if (!options.up && is_default)
      hintOnUp (options, *cloud, detected);
    hintOnOverlap (method, options, cloud, detected);
    if (options.is_up_of_sequence_estimated)
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
  detected.up_note = noteOnUp (found, is_seen, detected.up);
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
  declareOptions (PlaneDetectorParameters(), {}, line, options.numbers);
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
