// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "data_sets.h"

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief Which depth image of a SUN RGB-D frame. */
enum class SunRgbdDepth {
  /** \brief As measured (folder "depth"). */
  Raw,
  /** \brief Refined, with holes filled (folder "depth_bfx"): the toolbox's default. */
  Refined
};

/** \brief An image of one 16-bit value per pixel, row by row from the top. */
struct DepthImage {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<std::uint16_t> values;
};

/** \brief The points of a SUN RGB-D depth image (Song, Lichtenberg & Xiao, CVPR 2015)
 * in a frame with its origin at the camera, x to the right and z against gravity [m].
 * Pixels without a reading give no point; as in the data set's toolbox, depths beyond 8
 * m are set to 8 m.
 * \param[in] image pixel values as stored, millimeters rotated right by 3 bits
 * \param[in] intrinsics pinhole camera matrix [pixel]
 * \param[in] extrinsics takes the camera's axes (x right, y down, z forward) to the
 * same axes with y along gravity */
XyzCloud::Ptr
sunRgbdCloud (const DepthImage& image,
              const Eigen::Matrix3d& intrinsics,
              const Eigen::Matrix3d& extrinsics);

/** \brief Reads the frame in \p folder: the PNG file of its depth folder,
 * intrinsics.txt (3 x 3) and the last file of its folder extrinsics by name (3 x 4).
 * \throw apps::WorkError that names the missing, damaged or malformed file */
EvaluationCloud
readSunRgbdFrame (const std::string& folder, SunRgbdDepth depth);

/** \brief All frames below \p folder, by name.
 * \throw apps::WorkError if there is none */
DataSet
sunRgbdDataSet (const std::string& folder, SunRgbdDepth depth);

} // namespace pcl_ops::evaluation
