// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

namespace pcl_ops::python {

/** \brief What is done with lists of planes: merging, filtering, matching, tracking,
 * their edges, and which way is up. */
void
defineListFunctions (pybind11::module_& module);

} // namespace pcl_ops::python
