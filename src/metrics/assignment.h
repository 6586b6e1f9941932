// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace pcl_ops::evaluation {

/** Returns the largest sum of benefits over all assignments of each row to a column of
 * its own. This is the Hungarian method by shortest augmenting paths (Kuhn 1955; Jonker
 * & Volgenant 1987), O(rows^2 columns).
 * \param[in] benefit finite values of any sign; no more rows than columns */
double
maximumAssignment (const Eigen::MatrixXd& benefit);

} // namespace pcl_ops::evaluation
