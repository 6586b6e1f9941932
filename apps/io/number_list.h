// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_ops::apps {

// A number for each point of a cloud, without the points. The readers throw a WorkError
// that says what is wrong in the file.

/** \brief Reads an array of NumPy, of shape (N,), (N, 1) or (1, N). */
std::vector<double>
readNpyNumbers (const std::string& file);

/** \brief Reads a text with a number in each line, but empty ones and those that begin
 * with #. */
std::vector<double>
readTextNumbers (const std::string& file);

} // namespace pcl_ops::apps
