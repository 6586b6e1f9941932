// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/** \brief What programs may call: everything else stays inside the library. */
#if defined(_WIN32)
#define PCL_OPS_EXPORT
#else
#define PCL_OPS_EXPORT __attribute__ ((visibility ("default")))
#endif
