// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/export.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops {

/** \brief A warning that a result may be wrong. */
struct ResultWarning {
  /** \brief Identifier for programs, for example "thick-planes". It does not change. */
  std::string code;
  /** \brief Text for users, one line: what may be wrong, then what to do about it. */
  std::string text;
};

/** \brief Names of parameters in warning texts: command line options or Python. */
enum class ParameterNames { CommandLine, Python };

/** \brief Where the up axis comes from. */
enum class UpKnowledge {
  /** \brief It is the default: neither a user nor a file gave it. */
  Assumed,
  /** \brief A user or the file format gave it, or the planes told it reliably. */
  Known,
  /** \brief It was to be estimated from the planes, but they could not tell it. */
  NotFound
};

/** \brief Unit of the coordinates by the coordinate reference system of a file. */
enum class CoordinateUnit { Unknown, Meter, Foot, Degree };

/** \brief Numbers of walls and wall planes of a floor plan. */
struct PlanCounts {
  /** \brief Walls of the plan. */
  std::size_t walls = 0;
  /** \brief Number of planes that are walls, before and after filters. */
  std::size_t wall_planes_found = 0;
  std::size_t wall_planes_kept = 0;
  /** \brief Whether a plane is a floor, before filters. */
  bool has_floor = false;
};

/** \brief How a survey was searched that is too large for one cloud: in tiles. */
struct TiledSearch {
  /** \brief Edge of the voxels [m], the only parameter of the search users can set. */
  double voxel_size = 0.0;
  /** \brief The cloud is a sample with this share of the survey's points: above 0, up
   * to 1. */
  double sampled_share = 1.0;
  /** \brief Small clouds of points of the survey that are on no plane, around some such
   * points of the sample: all points there, or many. They tell whether a finer search
   * finds planes there. Empty ones tell nothing. */
  std::vector<CloudView> places_on_none;
};

/** \brief Further information for \ref resultWarnings. Optional members that are not
 * set give no warnings. */
struct ResultContext {
  /** \brief Origin of the cloud's frame in the frame of the planes [m]. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  /** \brief Position of the sensor given by a user or a file, in the frame of the cloud
   * [m]. */
  std::optional<Eigen::Vector3d> viewpoint;
  CoordinateUnit unit = CoordinateUnit::Unknown;
  /** \brief Whether the user gave the length of a meter. If so, the unit is known. */
  bool has_meter = false;
  UpKnowledge up_knowledge = UpKnowledge::Known;
  /** \brief The direction against gravity that was used. */
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /** \brief Another up axis, estimated reliably from the planes, if \ref up is the
   * default. */
  std::optional<Eigen::Vector3d> suggested_up;
  /** \brief Whether kinds of planes or a floor plan were requested. Both need the up
   * axis. */
  bool uses_kinds = false;
  /** \brief Whether the poses look like those of KITTI's camera, but are used as those
   * of a lidar. */
  bool has_camera_poses = false;
  /** \brief Numbers of the floor plan, if one was requested. */
  std::optional<PlanCounts> plan;
  /** \brief Parameters of the search for planes. In clouds of up to 100,000 points with
   * many points on no plane, other values are tried by more searches. Not set: none
   * are tried. */
  std::optional<OrientedPointSamplingParameters> search;
  /** \brief The search of the whole survey, if the cloud is a sample of a survey. */
  std::optional<TiledSearch> tiles;
  ParameterNames names = ParameterNames::CommandLine;
  /** \brief Largest number of warnings; less important ones are left out. */
  std::size_t max_warnings = 3;
};

/** \brief Returns warnings about a result, the most important first
 * (src/doc/command_line.md has the list). The order of the points does not matter.
 * \param[in] cloud the input cloud of the detection
 * \param[in] planes the planes that a detector returned
 * \param[in] context further information
 * \throw std::invalid_argument if an inlier is not an index into the cloud */
PCL_OPS_EXPORT std::vector<ResultWarning>
resultWarnings (const CloudView& cloud,
                const std::vector<PlaneSegment>& planes,
                const ResultContext& context = ResultContext());

} // namespace pcl_ops
