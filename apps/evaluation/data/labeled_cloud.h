// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/labels/labels.h>

#include <string>

namespace pcl_ops::evaluation {

/** \brief A cloud file with its field `label`. */
struct LabeledCloud {
  /** \brief Every point in the file's order; zero of the file's frame is at -\ref
   * shift. */
  XyzCloud::Ptr cloud;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  PlaneLabels labels;
};

/** \brief Reads a file of \ref apps::loadCloud whose points have an integer field
 * `label`, or a text whose column of that name has whole numbers; without such a field
 * there are no labels. \throw apps::WorkError if that fails */
LabeledCloud
loadLabeledCloud (const std::string& file);

/** \brief Two labelings of a cloud. */
struct LabeledClouds {
  LabeledCloud truth, result;
};

/** \brief Reads two files that label the same points in the same order.
 * \param[in] min_plane_points true planes with fewer points become none
 * \throw apps::WorkError naming the file that has no labels, or \p result_file if the
 * number of points or their coordinates differ */
LabeledClouds
loadLabeledClouds (const std::string& truth_file,
                   const std::string& result_file,
                   std::size_t min_plane_points);

} // namespace pcl_ops::evaluation
