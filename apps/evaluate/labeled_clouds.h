// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <metrics/metrics.h>

#include <string>
#include <utility>

namespace pcl_ops::evaluation {

/** Every point in the file's order. */
struct LabeledCloud : apps::ShiftedCloud {
  PlaneLabels labels = {};
};

/** The numbers of a field of a cloud, which is integer or, of a text, a column of that
 * name.
 * \throw apps::WorkError naming the file that has no such field */
std::vector<double>
labelNumbersIn (const pcl::PCLPointCloud2& cloud,
                const std::string& file,
                const std::string& name = "label");

/** The same as whole numbers from 0 on.
 * \throw apps::WorkError naming the file that has no such field, or other numbers */
PlaneLabels
labelsIn (const pcl::PCLPointCloud2& cloud,
          const std::string& file,
          const std::string& name = "label");

/** By \ref apps::loadCloud and \ref labelsIn.
 * \param[in] needs_labels whether a cloud without labels is refused */
LabeledCloud
loadLabeledCloud (const std::string& file, bool needs_labels);

/** \param[in] min_plane_points true planes with fewer points become none
 * \throw apps::WorkError naming the file that has no labels, or \p result_file if the
 * points or their order differ */
std::pair<LabeledCloud, LabeledCloud>
loadLabeledClouds (const std::string& truth_file,
                   const std::string& result_file,
                   std::size_t min_plane_points);

} // namespace pcl_ops::evaluation
