// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <io/shifted_cloud.h>
#include <nlohmann/json.hpp>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_detector.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

class CommandLine;

/** \brief What a detector was run with, in the order of a report. */
using Settings = nlohmann::ordered_json;

/** \brief The numbers that were given, by the names of their options. */
using GivenNumbers = std::map<std::string, double>;

/** \brief The options of all detectors; those not given keep the preset's value. */
struct DetectorOptions {
  std::string preset = "default";
  std::optional<Eigen::Vector3f> up;
  /** \brief Look for the up axis in the cloud; see runMethod. */
  bool finds_up = false;
  GivenNumbers numbers;
};

struct Detected {
  /** \brief By falling size, in the frame of the cloud it was given. */
  std::vector<PlaneSegment> planes;
  StageDurations timing;
  /** \brief The parameters used, under the names of their options. */
  Settings settings;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::string up_note;
  /** \brief Another up axis that the planes are sure of, where none was given. */
  std::optional<Eigen::Vector3d> suggested_up;
  /** \brief Lines on options that most likely serve the user better. */
  std::vector<std::string> hints;
  /** \brief That of \ref adviceFor. */
  std::string advice;
};

/** \brief For each point of a cloud the id of its plane, 0 for none.
 * \param[in] ids of the planes; empty: 1, 2, ... */
std::vector<std::uint32_t>
labelsOf (const std::vector<PlaneSegment>& planes,
          std::size_t points,
          const std::vector<std::uint32_t>& ids = {});

struct Method {
  std::string name;
  /** \brief The method in a few words, over its options in the help. */
  std::string title;
  /** \brief Declares the options no other method has. */
  std::function<void (CommandLine&, GivenNumbers&)> declare_options;
  /** \throws UsageError if options contradict each other, std::bad_alloc */
  std::function<Detected (const DetectorOptions&, const XyzCloud::ConstPtr&)> detect;
};

/** \brief Every method of --method; the first is the default. */
const std::vector<Method>&
allMethods ();

/** \param[in] name of one of \ref allMethods */
const Method&
methodCalled (const std::string& name);

using Stage = std::pair<const char*, double StageDurations::*>;

/** \brief The durations of a detector by name; the last is that of them all. */
constexpr std::array<Stage, 6> detection_stages = {
    {{"search", &StageDurations::search},
     {"normals", &StageDurations::normals},
     {"extraction", &StageDurations::extraction},
     {"assignment", &StageDurations::assignment},
     {"merging", &StageDurations::merging},
     {"detection", &StageDurations::detection}}};

/** \brief The planes a method finds; by `--up auto` with the up axis of the cloud's own
 * planes, or the default one where they cannot tell. Whatever the method, those planes
 * are of the default preset: the confidence was measured on them. Where no axis was
 * asked for and they are sure of another one than the default, a hint names it. */
Detected
runMethod (const Method& method,
           const DetectorOptions& options,
           const XyzCloud::ConstPtr& cloud);

void
declareMethodOptions (CommandLine& line, std::string& method, DetectorOptions& options);

/** \brief Refuses options on the parsed line that only other methods understand.
 * \throws UsageError */
void
checkMethodOptions (const CommandLine& line, const Method& chosen);

/** \brief Of what voxels of a given size begin at whole multiples; 0 where their size
 * is not given. */
double
voxelStepOf (const DetectorOptions& options);

} // namespace pcl_ops::apps
