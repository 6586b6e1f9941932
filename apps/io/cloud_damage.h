// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud_fields.h"

#include <string>

namespace pcl_ops::apps {

/** \brief What makes a cloud look damaged though it can be read, with the fix: most of
 * its points are at one place, or some are a thousand times as far away as the rest is
 * wide. Empty where nothing does. Places are those of the file. Some thousand of the
 * points tell. */
std::string
damageOf (const ShiftedCloud& shifted);

} // namespace pcl_ops::apps
