// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <io/shifted_cloud.h>
#include <metrics/metrics.h>

#include <string>

namespace pcl_ops::evaluation {

/** A cloud with a label for each point, in the order of the file. */
struct LabeledCloud : apps::ShiftedCloud {
  PlaneLabels labels = {};
};

/** Returns the number that each point has in a field. The type of the field is an
 * integer of up to 4 bytes or, as in text files, double.
 * \param[in] file name of the cloud in messages
 * \param[in] name of the field
 * \throw apps::WorkError naming the file if it has no such field, or of another type */
std::vector<double>
labelNumbersIn (const pcl::PCLPointCloud2& cloud,
                const std::string& file,
                const std::string& name = "label");

/** Returns the numbers of a field as labels. For the parameters see \ref
 * labelNumbersIn.
 * \throw apps::WorkError as \ref labelNumbersIn, or if a number is no whole number from
 * 0 to 2^32 - 1 */
PlaneLabels
labelsIn (const pcl::PCLPointCloud2& cloud,
          const std::string& file,
          const std::string& name = "label");

/** What \ref loadLabeledCloud does with a cloud without the field label. */
enum class WithoutLabels {
  Refuse,     // throws apps::WorkError
  LeaveEmpty, // LabeledCloud::labels is empty
};

/** Loads a cloud with the labels of its field label (\ref labelsIn), and warns if it
 * looks damaged. */
LabeledCloud
loadLabeledCloud (const std::string& file, WithoutLabels without_labels);

/** Two labelings of the same points. */
struct TruthAndResult {
  LabeledCloud truth, result;
};

/** Loads the truth and the result, two labelings of the same cloud.
 * \param[in] min_plane_points points of true planes with fewer points get label 0
 * \throw apps::WorkError naming the file that has no labels, or \p result_file if its
 * points or their order differ from the truth */
TruthAndResult
loadLabeledClouds (const std::string& truth_file,
                   const std::string& result_file,
                   std::size_t min_plane_points);

} // namespace pcl_ops::evaluation
