// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief The pairing of rows with columns, each used at most once, with the largest
 * sum of benefits: the Hungarian method by shortest augmenting paths (Kuhn 1955; Jonker
 * & Volgenant 1987), O(min(rows, columns)^2 max(rows, columns)).
 * \param[in] benefit any
 * finite numbers, any shape
 * \return the column of each row, or -1 where there are fewer
 * columns than rows and the row is left over */
std::vector<std::ptrdiff_t>
maximumAssignment (const Eigen::MatrixXd& benefit);

} // namespace pcl_ops::evaluation
