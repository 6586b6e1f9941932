// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"

namespace pcl_ops::apps {

/** \brief Declares the options all methods share. */
void
declareSharedOptions (CommandLine& line, DetectorOptions& options);

/** \brief Sets the parameters whose options were given. */
void
applyShared (const DetectorOptions& options, PlaneDetectorParameters& parameters);

/** \brief The parameters under the names of their options. */
Settings
sharedSettings (const PlaneDetectorParameters& parameters);

} // namespace pcl_ops::apps
