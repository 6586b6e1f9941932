// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "options.h"
#include "report.h"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief What gives the planes of a cloud their ids, which are in the cloud's frame,
 * and gets to know where the sensor was or, where that is not known, a place among the
 * points. */
using IdsOfPlanes = std::function<std::vector<std::uint32_t> (
    const std::vector<PlaneSegment>& planes, const Eigen::Vector3d& sensor)>;

/** \brief What is told of each stage of the work on a cloud, when it begins. */
using StageListener = std::function<void (const std::string& stage)>;

/** \brief Reads a cloud, finds its planes and writes its outputs.
 * \param[in] ids_of where it is missing, planes are numbered by falling size
 * \throws UsageError or WorkError if the cloud cannot be read or an output cannot be
 * written, Interrupted before anything is written */
Report
segmentCloud (const SegmentOptions& options,
              const Task& task,
              const IdsOfPlanes& ids_of = {},
              const StageListener& begin_stage = {});

} // namespace pcl_ops::apps
