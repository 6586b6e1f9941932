// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/algorithm/string/replace.hpp>

#include <io/shifted_cloud.h>
#include <nlohmann/json.hpp>
#include <pcl_ops/buildings/plane_kinds.h>
#include <pcl_ops/buildings/plane_regularization.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_extent.h>
#include <pcl_ops/up_axis.h>

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

namespace pcl_ops::apps {

class CommandLine;

/** \brief A JSON object or value with parameters, for reports. */
using Settings = nlohmann::ordered_json;

/** \brief Numbers given on the command line, by the names of their options without
 * "--". */
using GivenNumbers = std::map<std::string, double>;

/** \brief Options of \ref declareMethodOptions, and what programs add to them. */
struct DetectorOptions {
  /** \brief "default" or "paper". */
  std::string preset = "default";
  /** \brief Direction against gravity; nothing: that of the default parameters. */
  std::optional<Eigen::Vector3f> up;
  /** \brief Whether the up axis is to be estimated: --up auto. */
  bool finds_up = false;
  /** \brief Whether the up axis is that of a level camera: --up camera. */
  bool up_is_camera = false;
  /** \brief Whether a program has estimated one up axis for all clouds of a sequence.
   * It is \ref up, if the clouds tell one. */
  bool is_up_of_sequence_estimated = false;
  /** \brief Confidence of the up axis of a sequence, 0 to 1; nothing if the clouds tell
   * no axis. */
  std::optional<double> up_confidence;
  /** \brief Numbers for parameters of the detector. */
  GivenNumbers numbers;
  /** \brief Whether to fill \ref Detected::stages. */
  bool keeps_stages = false;
};

/** \brief What a detector found in a cloud, and what programs add to it. */
struct Detected {
  /** \brief By falling size, in the frame of ShiftedCloud::cloud; pcl_ops_segment moves
   * them to the frame of the file. */
  std::vector<PlaneSegment> planes;
  /** \brief Kind of each plane, found before programs drop planes; empty if not asked
   * for. */
  std::vector<PlaneKind> kinds;
  /** \brief Convex outline of each plane, in the frame of the file; empty if not asked
   * for. */
  std::vector<PlaneExtent> extents;
  /** \brief How regularizePlanes moved each plane; empty if it was not called. */
  std::vector<PlaneMove> moves;
  /** \brief Result of each stage of OPS on neighborhoods for all points; empty if not
   * asked for, and for other detectors. */
  std::vector<StageResult> stages;
  /** \brief If \ref planes are connected pieces of planes: for each piece the index of
   * its plane in \ref whole_planes. Else empty. */
  std::vector<std::size_t> lies_on;
  /** \brief If \ref planes are pieces: the planes on which they lie, without inliers.
   * Else empty. */
  std::vector<PlaneSegment> whole_planes;
  /** \brief How long the stages of the detection took. */
  StageDurations timing;
  /** \brief Processor time of the detection [ms]. With --threads other than 1 it is
   * that of the whole process. */
  double processor_time = 0.0;
  /** \brief The lengths that were used, also where parameters are automatic. */
  UsedLengths used;
  /** \brief All parameters by the keys of their options (\ref keyOf), for reports. */
  Settings settings;
  /** \brief Parameters of the detection, if it was OPS on neighborhoods. */
  std::optional<OrientedPointSamplingParameters> search_parameters;
  /** \brief The direction against gravity that was used. */
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  /** \brief A line on the estimate of \ref up, also if it failed; empty if none was
   * asked for in this cloud. */
  std::string up_note;
  /** \brief If no up axis was given: the axis that the planes show, if this is reliable
   * and not \ref up. */
  std::optional<Eigen::Vector3d> suggested_up;
  /** \brief Sentences that suggest options likely to give a better result. */
  std::vector<std::string> hints;
  /** \brief Which option to change if hardly any point is on a plane, or why all planes
   * were dropped: the end of a sentence. Else empty. */
  std::string advice;
};

/** \brief Returns the key of an option in reports: min_points for min-points. */
inline std::string
keyOf (const std::string& option)
{
  return boost::replace_all_copy (option, "-", "_");
}

/** \brief Returns for each point the id of its plane; 0 for a point on no plane.
 * \param[in] points number of points of the cloud
 * \param[in] ids one for each plane; empty: the ids are 1, 2, ... */
std::vector<std::uint32_t>
labelsOf (const std::vector<PlaneSegment>& planes,
          std::size_t points,
          const std::vector<std::uint32_t>& ids = {});

/** \brief A detector with its options. */
struct Method {
  /** \brief Value of --method. */
  std::string name;
  /** \brief Heading of its options in the help. */
  std::string title;
  /** \brief Declares the options that no other method has. */
  std::function<void (CommandLine&, GivenNumbers&)> declare_options;
  /** \brief Finds the planes of a cloud.
   * \throws UsageError if options contradict each other, std::bad_alloc */
  std::function<Detected (const DetectorOptions&, const XyzCloud::ConstPtr&)> detect;
};

/** \brief Returns all values of --method; the first one, OPS, is the default. */
const std::vector<Method>&
allMethods ();

/** \param[in] name of a method in \ref allMethods */
const Method&
methodCalled (const std::string& name);

/** \brief The durations of a detection with their names in reports; the last one is
 * that of the whole detection. */
constexpr std::pair<const char*, double StageDurations::*> detection_stages[] = {
    {"search", &StageDurations::search},
    {"normals", &StageDurations::normals},
    {"extraction", &StageDurations::extraction},
    {"assignment", &StageDurations::assignment},
    {"merging", &StageDurations::merging},
    {"detection", &StageDurations::detection}};

/** \brief Estimates the up axis from the planes that the default preset of OPS finds,
 * with the seed and the number of threads of the options. Other options are not used.
 * \return nothing if the planes cannot tell, or the cloud was not seen from its sensor
 * origin */
std::optional<UpAxis>
findUpAxis (const DetectorOptions& options, const XyzCloud& cloud);

/** \brief Finds the planes of a cloud by a method. For `--up auto` it first calls \ref
 * findUpAxis, which uses OPS whatever \p method is, as the confidence of an axis was
 * measured with planes of OPS. If findUpAxis finds no axis, the default axis is used.
 * By default (OPS without --preset and --up) a hint may name a better axis. If two
 * planes may be one surface, a second detection looks for the --merge-distance that a
 * hint names. */
Detected
runMethod (const Method& method,
           const DetectorOptions& options,
           const XyzCloud::ConstPtr& cloud);

/** \brief Declares --method, --preset, --up and the parameters of all methods.
 * \param[out] method, options get the values when the command line is parsed */
void
declareMethodOptions (CommandLine& line, std::string& method, DetectorOptions& options);

/** \brief Checks that the options given are those of the chosen method.
 * \throws UsageError about an option that only another method has */
void
checkMethodOptions (const CommandLine& line, const Method& chosen);

/** \brief Whether the options choose OPS on neighborhoods, the only detector that fills
 * \ref Detected::stages. */
bool
hasStages (const Method& method, const DetectorOptions& options);

/** \brief Returns the edge of the largest voxels that --voxel-size asks for [unit of
 * the cloud]; 0 if the option is not given. A shift of the cloud by a multiple of this
 * edge leaves the same points together in each voxel. */
double
voxelStepOf (const DetectorOptions& options);

} // namespace pcl_ops::apps
