// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"

namespace pcl_ops::apps {

/** \brief The planes a method finds; by `--up auto` named, and for the paper's strategy
 * 2 found, with the up axis of the cloud's own planes.
 *
 * The axis is that of the default preset's planes, whatever the method: its confidence
 * was measured on those. Where they cannot tell, the default axis is used.
 *
 * Where no axis was asked for and planes of the default preset are sure of another one
 * than the default, a hint names it. */
Detected
runMethod (const Method& method,
           const DetectorOptions& options,
           const XyzCloud::ConstPtr& cloud);

} // namespace pcl_ops::apps
