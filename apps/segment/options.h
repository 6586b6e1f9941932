// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <detection/methods.h>
#include <detection/plane_choice.h>
#include <detection/plane_list.h>
#include <pcl_ops/buildings/floor_plan.h>
#include <pcl_ops/plane_matching.h>
#include <pcl_ops/plane_pieces.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Where to write what is found in one cloud; empty where not asked for. */
struct Outputs {
  std::string cloud;
  /** \brief .json, .csv or .geojson; "-" for JSON on the standard output. */
  std::string planes;
  std::string image;
  /** \brief A page for a browser. */
  std::string view;
  std::string mesh;
  std::string edges;
  /** \brief A floor plan. */
  std::string plan;
  std::string rest;
  std::string planes_dir;
  /** \brief A folder for what each stage made. */
  std::string trace;

  /** \brief The files of all that are asked for but planes_dir, whose names depend on
   * what is found. */
  std::vector<std::string>
  files () const;
};

/** \brief How planes keep their numbers over the clouds of a sequence. */
struct TrackOptions {
  bool is_on = false;
  /** \brief A file of poses; empty where the sensor hardly moves. */
  std::string poses;
  /** \brief A calib.txt of KITTI: the poses are of its camera, clouds of its lidar. */
  std::string calibration;
  /** \brief Whether \ref poses are used as those of a lidar though they look like those
   * of KITTI's camera. */
  bool has_camera_poses = false;
  PlaneMatchingParameters matching;
};

struct SegmentOptions {
  /** \brief As given: a file or "-"; with \ref output_dir files, folders, patterns. */
  std::vector<std::string> inputs;
  /** \brief Where the outputs of several inputs go; empty for one input. */
  std::string output_dir;
  /** \brief With \ref output_dir, {} stands for the name of each input. */
  Outputs outputs;
  std::string method = "ops";
  /** \brief What outlines are drawn by: "convex" or "concave". */
  std::string hull = "convex";
  /** \brief Whether each connected piece of a plane has a label of its own, and the
   * widest gap within one. */
  bool pieces = false;
  PlanePiecesParameters of_pieces;
  FloorPlanParameters of_plan;
  /** \brief Whether the length of a meter was given, 1 or not. */
  bool has_meter = false;
  /** \brief Whether planes become exactly parallel, orthogonal and coplanar. */
  bool regularize = false;
  PlaneChoice choice;
  MapOptions map;
  DetectorOptions detector;
  TrackOptions track;
  /** \brief Inputs at a time; 0: as many as there are processors. */
  unsigned jobs = 1;
  bool keep_color = false;
  /** \brief Whether OUTPUT tells how far each point is from its plane. */
  bool distances = false;
  bool quiet = false;
  /** \brief "pcd" or "ply"; empty where --format is not given. */
  std::string format;

  /** \brief The extension of clouds that are not named one by one. */
  std::string
  fileFormat () const
  {
    return format.empty() ? ".pcd" : "." + format;
  }

  bool
  isBatch () const
  {
    return !output_dir.empty();
  }
};

/** \brief Reads the command line and checks it without a look at files.
 * \return false if --help or --version was answered: nothing is left to do
 * \throws UsageError */
bool
readOptions (int argc, const char* const* argv, SegmentOptions& options);

inline constexpr const char* program_name = "pcl_ops_segment";

struct Task {
  /** \brief A file, or "-" for the standard input. */
  std::string input;
  Outputs outputs;
};

struct Batch {
  std::vector<Task> tasks;
  /** \brief What is wrong with inputs that stand for no cloud. */
  std::vector<std::string> problems;
};

/** \brief The one task of a command line without --output-dir, checked down to whether
 * its outputs can be written.
 * \throws UsageError or, for an output, WorkError */
Task
taskOf (const SegmentOptions& options);

/** \brief The tasks of a command line with --output-dir, which is created.
 * \throws UsageError if two inputs would be written to one file or an input would be
 * written over, WorkError if nothing can be written to the folder */
Batch
batchOf (const SegmentOptions& options);

} // namespace pcl_ops::apps
