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

/** \brief What is doubtful about a result. */
struct ResultWarning {
  /** \brief A word for programs, which stays the same: "thick-planes". */
  std::string code;
  /** \brief For people, one line: what is doubtful; what to do about it. */
  std::string text;
};

/** \brief How texts name parameters: as options of the programs or as Python does. */
enum class ParameterNames { CommandLine, Python };

/** \brief How it is known which way is up. */
enum class UpKnowledge {
  /** \brief Nobody said it; it is the default. */
  Assumed,
  /** \brief A user or the format of the file says it, or the planes are sure of it. */
  Known,
  /** \brief The planes were asked for it and could not tell. */
  NotFound
};

/** \brief What the coordinates are, as the reference system of a file says. */
enum class CoordinateUnit { Unknown, Meter, Foot, Degree };

/** \brief What became of the floor plan of a result. */
struct PlanCounts {
  /** \brief Walls of the plan. */
  std::size_t walls = 0;
  /** \brief Planes that are walls, before filters and after them. */
  std::size_t wall_planes_found = 0;
  std::size_t wall_planes_kept = 0;
  /** \brief Whether one of the planes before filters is a floor. */
  bool has_floor = false;
};

/** \brief How a survey was searched that is too large to be looked at as a whole. */
struct TiledSearch {
  /** \brief Edge of the voxels [m], all that a user can change. */
  double voxel_size = 0.0;
  /** \brief Share of the survey's points that the cloud has: above 0, up to 1. */
  double sampled_share = 1.0;
  /** \brief Small clouds of all points of the survey, each around a point of the sample
   * that is on no plane. */
  std::vector<CloudView> places_on_none;
};

/** \brief What is known beside a cloud and its planes. What is not set is not looked
 * at. */
struct ResultContext {
  /** \brief Zero of the cloud's frame in that of the planes. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  /** \brief Where a user or a file says that the sensor was, in the frame of the cloud.
   */
  std::optional<Eigen::Vector3d> viewpoint;
  CoordinateUnit unit = CoordinateUnit::Unknown;
  /** \brief Whether the user gave the length of a meter: then the unit is known. */
  bool has_meter = false;
  UpKnowledge up_knowledge = UpKnowledge::Known;
  /** \brief Against gravity, as it was used. */
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /** \brief Another axis that the planes are sure of, where \ref up is assumed. */
  std::optional<Eigen::Vector3d> suggested_up;
  /** \brief Whether kinds of planes or a floor plan were asked for: these need to know
   * which way is up. */
  bool uses_kinds = false;
  /** \brief Whether the poses look like those of KITTI's camera, but are used as those
   * of a lidar. */
  bool has_camera_poses = false;
  /** \brief Of the floor plan, where one was asked for. */
  std::optional<PlanCounts> plan;
  /** \brief How the planes were searched for. In clouds of up to 100,000 points other
   * values are tried, by more searches. */
  std::optional<OrientedPointSamplingParameters> search;
  /** \brief How they were searched for if the cloud is a sample of a survey. */
  std::optional<TiledSearch> tiles;
  ParameterNames names = ParameterNames::CommandLine;
  /** \brief Only the most important ones are told. */
  std::size_t max_warnings = 3;
};

/** \brief What is doubtful about planes, the most important first
 * (src/doc/command_line.md has the list). They depend on cloud, planes and context, not
 * on the order of the points.
 * \param[in] cloud the input cloud the planes were found in
 * \param[in] planes as a detector gives them
 * \param[in] context what else is known
 * \throw std::invalid_argument if an inlier is no point of the cloud */
PCL_OPS_EXPORT std::vector<ResultWarning>
resultWarnings (const CloudView& cloud,
                const std::vector<PlaneSegment>& planes,
                const ResultContext& context = ResultContext());

} // namespace pcl_ops
