// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>
#include <pcl/types.h>

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Of coordinates: PCL's point types cannot read doubles, and single precision
 * loses places far from zero. */
enum class Precision { Single, Double };

/** \brief What makes lines of cells. */
struct Wires {
  /** \brief The first so many points are shown by themselves, too. */
  std::size_t corners;
  /** \brief Of each line the numbers of its planes. */
  std::vector<std::array<std::size_t, 2>> planes;
};

/** \brief Polygons with a color for each corner, or lines. */
struct PolyData {
  /** \brief One line, in a .vtk. */
  std::string title;
  Precision precision;
  std::vector<Eigen::Vector3d> points;
  /** \brief Of each point of polygons. */
  std::vector<pcl::RGB> colors;
  /** \brief The points of each polygon or line. */
  std::vector<pcl::Indices> cells;
  /** \brief Not given: cells are polygons. */
  std::optional<Wires> wires;
};

/** \brief Writes an ASCII file in one step (\ref writeFile).
 * \param[in] file a .vtk for pcl_viewer, else a .ply in the file's frame
 * \param[in] sensor_pose where pcl_viewer moves the labelled cloud to; it does not know
 * of meshes' poses, so that a .vtk is written moved
 * \throws WorkError if it cannot be written */
void
savePolyData (const std::string& file,
              const Eigen::Isometry3d& sensor_pose,
              PolyData data);

} // namespace pcl_ops::apps
