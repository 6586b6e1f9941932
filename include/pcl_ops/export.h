// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/** \brief Marks functions and classes that the shared library exports. On Windows
 * none is marked: there the library has to be static. */
#if defined(_WIN32)
#define PCL_OPS_EXPORT
#else
#define PCL_OPS_EXPORT __attribute__ ((visibility ("default")))
#endif
