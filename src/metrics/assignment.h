// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

namespace pcl_ops::evaluation {

/** The largest sum of benefits of a pairing of rows with columns, each used at most
 * once: the Hungarian method by shortest augmenting paths (Kuhn 1955; Jonker &
 * Volgenant 1987), O(rows^2 columns).
 * \param[in] benefit from 0, no more rows than columns */
double
maximumAssignment (const Eigen::MatrixXd& benefit);

} // namespace pcl_ops::evaluation
