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

enum class LabelField { Required, Optional };

/** \brief Reads a file of \ref apps::loadCloud whose points have an integer field
 * `label`, or a text whose column of that name has whole numbers; none leaves the
 * labels empty where the field is optional. \throw apps::WorkError if that fails or the
 * field is required and missing */
LabeledCloud
loadLabeledCloud (const std::string& file, LabelField field = LabelField::Required);

/** \brief Makes sure that two files label the same points in the same order.
 * \throw apps::WorkError naming \p result_file if their number or coordinates differ */
void
requireSamePoints (const LabeledCloud& truth,
                   const LabeledCloud& result,
                   const std::string& result_file);

} // namespace pcl_ops::evaluation
