// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_ops::apps {

// These functions read a file that has no points but a number for each point of a
// cloud. They throw a WorkError that says what is wrong in the file.

/** \brief Reads a NumPy array of shape (N,), (N, 1) or (1, N). */
std::vector<double>
readNpyNumbers (const std::string& file);

/** \brief Reads a text with one number in each line. Empty lines and comments, which
 * begin with #, are skipped. */
std::vector<double>
readTextNumbers (const std::string& file);

} // namespace pcl_ops::apps
