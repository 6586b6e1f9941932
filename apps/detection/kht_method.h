// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"

namespace pcl_ops::apps {

/** \brief The 3D Kernel-based Hough Transform. */
Method
khtMethod ();

} // namespace pcl_ops::apps
