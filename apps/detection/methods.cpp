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

/** \brief Refuses options of OPS that contradict each other or the cloud.
 * \param[in] given the options
 * \param[in] points number of points of the cloud
 * \throws UsageError about one of the options */
void
checkAndComplete (const GivenNumbers& given,
                  std::size_t points,
                  OpsParameters& parameters)
{
  if (given.count ("voxel-size") > 0 && parameters.sampling == Sampling::Points)
    throw UsageError ("--voxel-size", "has no meaning to --preset paper; leave it out");
  // A detection with a k above the number of points would take as long as that of a
  // cloud of k points.
  const int k = parameters.k;
  if (k > OpsParameters().k && std::size_t (k) > points)
    throw UsageError ("--k",
                      concatenate (k,
                                   " is more than the points of the cloud, ",
                                   points,
                                   "; give a smaller number"));
}

/** \brief If only one radius is given, sets the other one, so that the outer radius is
 * twice the inner one: with this ratio FSPF is most accurate (Sun & Mordohai, Table I).
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

/** \brief Refuses options of 3D-KHT that contradict each other.
 * \throws UsageError about one of the options */
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

/** \brief Returns the position of the sensor in the frame of the cloud. */
Eigen::Vector3d
sensorOf (const XyzCloud& cloud)
{
  return cloud.sensor_origin_.head<3>().cast<double>();
}

/** \brief Adds a hint that --min-inliers counts samples, not points, if a value above
 * the default finds 5 planes or fewer, and at most a quarter of those that the default
 * value finds. */
void
addHintOnMinInliers (const GivenNumbers& given,
                     OpsParameters parameters,
                     const XyzCloud& cloud,
                     Detected& detected)
{
  // Both are chosen by hand. More planes are enough for a room: then no second
  // detection is needed.
  constexpr std::size_t max_planes = 5;
  // The default value has to find at least so many times as many planes.
  constexpr std::size_t min_ratio = 4;
  const unsigned default_value = OpsParameters().min_samples;
  const unsigned value = parameters.min_samples;
  const std::size_t planes = detected.planes.size();
  if (given.count ("min-inliers") == 0 || value <= default_value || planes > max_planes)
    return;
  parameters.min_samples = default_value;
  const std::size_t default_planes =
      detectPlanes (cloud, parameters, sensorOf (cloud)).size();
  if (planes != default_planes && min_ratio * planes <= default_planes)
    detected.hints.push_back (concatenate ("--min-inliers ",
                                           value,
                                           " counts samples, not points, and leaves ",
                                           planes,
                                           " of ",
                                           default_planes,
                                           " planes: --min-points ",
                                           value,
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

/** \brief Returns Detected::settings: all parameters that options change, and some that
 * no option changes. */
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

/** \brief Returns a number for a report; null for none. */
Settings
numberOrNull (const std::optional<double>& number)
{
  return number ? Settings (*number) : Settings();
}

/** \brief Adds the lengths that were used, as the parameters may be "auto". */
void
addUsedLengths (const UsedLengths& used, Settings& settings)
{
  settings["threshold_used"] = numberOrNull (used.distance_threshold);
  if (settings.contains ("voxel_size"))
    settings["voxel_size_used"] = numberOrNull (used.voxel_size);
}

/** \brief Adds a hint if --sampling-rate has no effect beside --voxel-size. */
void
addHintOnSamplingRate (const GivenNumbers& given, Detected& detected)
{
  const auto voxel_size = given.find ("voxel-size");
  const bool is_on_voxels = voxel_size != given.end() && voxel_size->second > 0.0;
  if (is_on_voxels && given.count ("sampling-rate") > 0)
    detected.hints.push_back (
        "--sampling-rate has no effect beside --voxel-size, which gives "
        "the voxels their size: leave one of them out");
}

/** \brief Adds a hint if --probability has no effect. */
void
addHintOnProbability (const GivenNumbers& given,
                      const OpsParameters& parameters,
                      Detected& detected)
{
  if (given.count ("probability") > 0 && parameters.sampling != Sampling::Points)
    detected.hints.push_back (
        "--probability has an effect only with --preset paper: leave it out");
}

/** \brief Returns what a clock of processor time shows [ms]. */
double
millisecondsOf (clockid_t clock)
{
  timespec time{};
  ::clock_gettime (clock, &time);
  return 1e3 * static_cast<double> (time.tv_sec) +
         1e-6 * static_cast<double> (time.tv_nsec);
}

/** \brief Returns the parameters for a detection that stores its stages.
 * \param[in] keeps_stages if false, or for other detectors than OPS, the parameters are
 * returned unchanged
 * \param[out] stages are added during the detection */
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

/** \brief Adds hints on the options of OPS, and sets Detected::search_parameters if the
 * detection was on neighborhoods. */
void
addHints (const GivenNumbers& given,
          const OpsParameters& parameters,
          const XyzCloud& cloud,
          Detected& detected)
{
  addHintOnMinInliers (given, parameters, cloud, detected);
  addHintOnSamplingRate (given, detected);
  addHintOnProbability (given, parameters, detected);
  const bool is_on_neighborhoods =
      parameters.sampling != Sampling::Points && !parameters.surfels.voxel_size;
  if (!is_on_neighborhoods)
    return;
  detected.search_parameters = parameters;
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
  auto result = detectPlanesInDetail (
      *cloud,
      withObserver (parameters, options.keeps_stages, detected.stages),
      sensorOf (*cloud));
  detected.processor_time = millisecondsOf (clock) - start;
  detected.planes = std::move (result.planes);
  detected.timing = result.durations;
  detected.used = result.used;
  detected.settings = settingsOf (options.preset, parameters);
  addUsedLengths (detected.used, detected.settings);
  detected.up = parameters.up_axis;
  detected.advice = adviceFor (parameters, *cloud, detected.planes);
  if constexpr (std::is_same_v<Parameters, OpsParameters>)
    addHints (options.numbers, parameters, *cloud, detected);
  return detected;
}

/** \brief Returns by option name what the help says of the value: "20", or, where the
 * presets differ, "20; paper 40". */
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

/** \brief Returns the detector of these parameters. */
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

/** \brief Returns Detected::up_note.
 * \param[in] found the estimated axis, if there is one
 * \param[in] is_seen whether the cloud was seen from its sensor origin
 * \param[in] used the axis that was used */
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

/** \brief If the planes show reliably that up is another axis than Detected::up, adds a
 * hint and sets Detected::suggested_up.
 * \param[in,out] detected by the default preset of OPS, as \ref findUpAxis requires */
void
addHintOnUp (const DetectorOptions& options, const XyzCloud& cloud, Detected& detected)
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

/** \brief Returns the next larger number with one significant digit; 0.002 for lengths
 * up to 0.001. */
double
roundedUp (double length)
{
  constexpr double min_length = 1e-3; // [unit of the cloud]; chosen by hand
  const double at_least = std::max (length, min_length);
  const double unit = std::pow (10.0, std::floor (std::log10 (at_least)));
  constexpr double rounding = 1e-9; // e.g. 0.3 / 0.1 is a little below 3
  return unit * (std::floor (at_least / unit + rounding) + 1.0);
}

/** \brief If two planes may be one surface (\ref findOverlapping), adds a hint with the
 * --merge-distance that merges them. A second detection checks that this distance does.
 */
void
addHintOnOverlap (const Method& method,
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
  DetectorOptions merging_options = options;
  merging_options.keeps_stages = false;
  const double distance = roundedUp (pair->distance);
  merging_options.numbers[option] = distance;
  const std::vector<std::uint32_t> labels =
      labelsOf (method.detect (merging_options, cloud).planes, cloud->size());
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

/** \brief Returns the title in the help of the group of a method's options. */
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
    // With planes of other methods or presets the up axis would seem too reliable.
    const bool is_default =
        method.name == allMethods().front().name && options.preset == "default";
    if (!options.up && is_default)
      addHintOnUp (options, *cloud, detected);
    addHintOnOverlap (method, options, cloud, detected);
    if (options.is_up_of_sequence_estimated)
      detected.settings["up_confidence"] = numberOrNull (options.up_confidence);
    return detected;
  }
  const std::optional<UpAxis> found = findUpAxis (options, *cloud);
  const bool is_seen = found || isSeenFromItsOrigin (*cloud);
  DetectorOptions options_with_up = options;
  if (found)
    options_with_up.up = found->direction.cast<float>();
  Detected detected = method.detect (options_with_up, cloud);
  addHintOnOverlap (method, options_with_up, cloud, detected);
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
