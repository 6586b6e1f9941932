// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"

namespace pcl_ops::apps {

/** \brief Fast Sampling Plane Filtering. */
Method
fspfMethod ();

} // namespace pcl_ops::apps
