// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>
#include <pcl/types.h>

#include <Eigen/Core>

#include <io/cloud_file.h>

#include <cstddef>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief A mesh of faces with a color per point, or lines without color. */
struct PolyData {
  /** \brief Whether \ref cells are lines instead of faces. */
  bool are_lines;
  /** \brief Whether coordinates are written as doubles. PCL's point types cannot read
   * these, but single precision loses digits far from zero. */
  bool is_double;
  std::vector<Eigen::Vector3d> points = {};
  /** \brief Of each point; empty for lines. */
  std::vector<pcl::RGB> colors = {};
  /** \brief The faces or lines, as indices into \ref points. */
  std::vector<pcl::Indices> cells = {};
  /** \brief For lines: ids of the two planes that meet in each line. */
  std::vector<pcl::Indices> planes_of_lines = {};
  /** \brief For lines: number of corners, which come first in \ref points. A .vtk has
   * a vertex for each. */
  std::size_t corner_count = 0;
};

/** \brief Writes a .ply, .vtk or .obj in text. A .ply or .obj is in the frame of the
 * input file. A .vtk is moved by the pose of the sensor, as pcl_viewer moves clouds by
 * that pose but not meshes.
 * \param[in] cloud the input, which has the pose of the sensor
 * \throws WorkError if the file cannot be written */
void
savePolyData (const std::string& file, const FileCloud& cloud, PolyData data);

} // namespace pcl_ops::apps
