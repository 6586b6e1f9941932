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

using Settings = nlohmann::ordered_json;

/** \brief By the names of their options. */
using GivenNumbers = std::map<std::string, double>;

struct DetectorOptions {
  std::string preset = "default";
  std::optional<Eigen::Vector3f> up;
  /** \brief --up auto */
  bool finds_up = false;
  /** \brief --up camera */
  bool up_is_camera = false;
  /** \brief Whether a sequence was asked for \ref up, and how sure it is, if it is. */
  bool sequence_has_up = false;
  std::optional<double> up_confidence;
  GivenNumbers numbers;
  /** \brief Whether \ref Detected::stages are asked for. */
  bool keeps_stages = false;
};

struct Detected {
  /** \brief By falling size, in the frame of the cloud. */
  std::vector<PlaneSegment> planes;
  /** \brief What each is among all that were found; empty where nobody asked. */
  std::vector<PlaneKind> kinds;
  /** \brief Their convex outlines, in the frame of the cloud's file; empty where nobody
   * asked. */
  std::vector<PlaneExtent> extents;
  /** \brief How each was moved by regularizePlanes; empty where none was. */
  std::vector<PlaneMove> moves;
  /** \brief What each stage of the engine on neighborhoods made of the points; empty
   * where nobody asked, and of other engines. */
  std::vector<StageResult> stages;
  /** \brief Where \ref planes are pieces: for each the position of the plane it lies on
   * in \ref whole_planes, which have no inliers; else empty. */
  std::vector<std::size_t> lies_on;
  std::vector<PlaneSegment> whole_planes;
  StageDurations timing;
  /** \brief Processor time of all threads that worked on it [ms]. */
  double processor_time = 0.0;
  UsedLengths used;
  /** \brief Under the names of their options. */
  Settings settings;
  /** \brief What they were searched for with, of the engine on neighborhoods. */
  std::optional<OrientedPointSamplingParameters> search;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::string up_note;
  /** \brief Another one that the planes are sure of, where none was given. */
  std::optional<Eigen::Vector3d> suggested_up;
  /** \brief On options that most likely serve the user better. */
  std::vector<std::string> hints;
  std::string advice;
};

/** \brief The key of an option in reports. */
inline std::string
keyOf (const std::string& option)
{
  return boost::replace_all_copy (option, "-", "_");
}

/** \brief For each point the id of its plane, 0 for none.
 * \param[in] ids of the planes; empty: 1, 2, ... */
std::vector<std::uint32_t>
labelsOf (const std::vector<PlaneSegment>& planes,
          std::size_t points,
          const std::vector<std::uint32_t>& ids = {});

struct Method {
  std::string name;
  /** \brief Over its options in the help. */
  std::string title;
  /** \brief Those no other method has. */
  std::function<void (CommandLine&, GivenNumbers&)> declare_options;
  /** \throws UsageError if options contradict each other, std::bad_alloc */
  std::function<Detected (const DetectorOptions&, const XyzCloud::ConstPtr&)> detect;
};

/** \brief Every method of --method; the first is the default. */
const std::vector<Method>&
allMethods ();

const Method&
methodCalled (const std::string& name);

/** \brief The last is that of them all. */
constexpr std::pair<const char*, double StageDurations::*> detection_stages[] = {
    {"search", &StageDurations::search},
    {"normals", &StageDurations::normals},
    {"extraction", &StageDurations::extraction},
    {"assignment", &StageDurations::assignment},
    {"merging", &StageDurations::merging},
    {"detection", &StageDurations::detection}};

/** \brief The up axis of the planes of the default preset; nothing where they cannot
 * tell or the cloud was not seen from its origin. */
std::optional<UpAxis>
findUpAxis (const DetectorOptions& options, const XyzCloud& cloud);

/** \brief The planes a method finds; by `--up auto` with the up axis of the planes of
 * the default preset, on which the confidence was measured, or the default axis where
 * they cannot tell. A hint names another one where none was asked for. */
Detected
runMethod (const Method& method,
           const DetectorOptions& options,
           const XyzCloud::ConstPtr& cloud);

void
declareMethodOptions (CommandLine& line, std::string& method, DetectorOptions& options);

/** \throws UsageError if options were given that only other methods understand */
void
checkMethodOptions (const CommandLine& line, const Method& chosen);

/** \brief Whether they ask for the engine on neighborhoods, which alone has stages. */
bool
hasStages (const Method& method, const DetectorOptions& options);

/** \brief Of what voxels begin at whole multiples; 0 where their size is not given. */
double
voxelStepOf (const DetectorOptions& options);

} // namespace pcl_ops::apps
