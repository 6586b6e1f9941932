// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_detector.h>

#include <array>
#include <utility>

namespace pcl_ops::apps {

using Stage = std::pair<const char*, double StageDurations::*>;

/** \brief The durations of a detector by name; the last is that of them all. */
constexpr std::array<Stage, 6> detection_stages = {
    {{"search", &StageDurations::search},
     {"normals", &StageDurations::normals},
     {"extraction", &StageDurations::extraction},
     {"assignment", &StageDurations::assignment},
     {"merging", &StageDurations::merging},
     {"detection", &StageDurations::detection}}};

} // namespace pcl_ops::apps
