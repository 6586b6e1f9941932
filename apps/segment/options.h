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

/** \brief Names of the output files and folders for one cloud; empty if not asked for.
 */
struct Outputs {
  /** \brief The labeled cloud. */
  std::string cloud;
  /** \brief The list of planes, .json, .csv, .geojson or .gpkg; "-" for JSON on the
   * standard output. */
  std::string planes;
  /** \brief A picture of the planes. */
  std::string image;
  /** \brief An HTML page for a browser. */
  std::string view;
  /** \brief The outlines of planes as a mesh. */
  std::string mesh;
  /** \brief Edges and corners, where planes meet. */
  std::string edges;
  /** \brief The floor plan. */
  std::string floor_plan;
  /** \brief The points on no plane. */
  std::string rest;
  /** \brief A folder for a cloud of each plane. */
  std::string planes_dir;
  /** \brief A folder for the results of each stage. */
  std::string trace;

  /** \brief Returns all files to be written, those in \ref trace too. Left out are the
   * standard output and files in \ref planes_dir, whose names depend on the planes. */
  std::vector<std::string>
  files () const;
};

/** \brief Options of --track: planes keep their numbers over a sequence of clouds. */
struct TrackOptions {
  bool is_on = false;
  /** \brief A file of sensor poses; empty: all poses are the identity. */
  std::string poses_file;
  /** \brief A calib.txt of KITTI, which converts poses of its camera to poses of its
   * lidar; empty: the poses are used as they are. */
  std::string calibration_file;
  /** \brief Whether \ref poses_file looks like poses of KITTI's camera, but is used as
   * poses of a lidar. */
  bool has_camera_poses = false;
  PlaneMatchingParameters matching;
};

/** \brief All options of a command line. */
struct SegmentOptions {
  /** \brief Without \ref output_dir one file, or "-" for the standard input; with it
   * files, folders and patterns. */
  std::vector<std::string> inputs;
  /** \brief Folder for the outputs of several inputs; empty for one input. */
  std::string output_dir;
  /** \brief Outputs as given. With \ref output_dir, {} in their names stands for the
   * name of each input. */
  Outputs outputs;
  /** \brief Name of the detector: Method::name. */
  std::string method = "ops";
  /** \brief The kind of hull that outlines are: "convex" or "concave". */
  std::string hull = "convex";
  /** \brief Whether each connected piece of a plane has a label of its own. */
  bool divides_into_pieces = false;
  /** \brief For \ref divides_into_pieces. */
  PlanePiecesParameters piece_parameters;
  FloorPlanParameters plan_parameters;
  /** \brief Whether --meter was given, even as 1, or a LAS file names a unit other than
   * the meter. */
  bool has_meter = false;
  /** \brief Whether to make nearly parallel, orthogonal or coplanar planes exactly so.
   */
  bool regularizes = false;
  /** \brief Which planes to keep. */
  PlaneChoice choice;
  MapOptions map;
  DetectorOptions detector;
  TrackOptions track;
  /** \brief Number of inputs to segment at a time; 0: one for each processor. */
  unsigned jobs = 1;
  /** \brief Whether OUTPUT has the colors of the input instead of those of planes. */
  bool keeps_color = false;
  /** \brief Whether OUTPUT has the signed distance of each point to its plane. */
  bool has_distances = false;
  /** \brief Whether to print no table, notes and warnings. Damage of the cloud is
   * always printed. */
  bool quiet = false;
  /** \brief Format of the clouds that the program names itself, in \ref output_dir and
   * Outputs::planes_dir: "pcd" or "ply"; empty if --format is not given. */
  std::string format;

  /** \brief Returns the extension of the clouds that the program names itself. */
  std::string
  cloudExtension () const
  {
    return format.empty() ? ".pcd" : "." + format;
  }

  /** \brief Whether --output-dir is given, for several inputs. */
  bool
  isBatch () const
  {
    return !output_dir.empty();
  }
};

/** \brief Reads the command line and checks it, without reading any file.
 * \return false if it printed --help or --version: nothing is left to do
 * \throws UsageError */
bool
readOptions (int argc, const char* const* argv, SegmentOptions& options);

inline constexpr const char* program_name = "pcl_ops_segment";

/** \brief One cloud to segment. */
struct Task {
  /** \brief A file, or "-" for the standard input. */
  std::string input;
  Outputs outputs;
};

/** \brief The clouds of a command line with --output-dir. */
struct Batch {
  std::vector<Task> tasks;
  /** \brief One message for each input argument that stands for no cloud. */
  std::vector<std::string> problems;
};

/** \brief Returns the one task of a command line without --output-dir. Creates output
 * folders and checks that the outputs can be written.
 * \throws UsageError if two names clash, WorkError if an output cannot be written */
Task
taskOf (const SegmentOptions& options);

/** \brief Returns the tasks of a command line with --output-dir. Creates that folder if
 * there is a task.
 * \throws UsageError if two inputs would be written to one file or an input would be
 * overwritten, WorkError if the folder cannot be written to */
Batch
batchOf (const SegmentOptions& options);

} // namespace pcl_ops::apps
