// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"

namespace pcl_ops::apps {

/** \brief Oriented Point Sampling. */
Method
opsMethod ();

} // namespace pcl_ops::apps
