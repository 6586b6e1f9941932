// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

namespace pcl_ops::evaluation {

/** \brief The default preset with one ingredient off at a time: group ablation. */
void
addAblation (std::vector<Configuration>& configurations);

} // namespace pcl_ops::evaluation
