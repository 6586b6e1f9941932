// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.h"
#include <cli/progress.h>

#include <functional>
#include <string>

namespace pcl_ops::apps {

/** \brief Gives what was found in a cloud, in the cloud's frame, its ids.
 * \param[in] sensor where it was or, if that is not known, a place among the points */
using GiveIds = std::function<void (const Eigen::Vector3d& sensor, Report& report)>;

std::string
nameOfInput (const Task& task);

/** \brief Reads a cloud, finds its planes and writes its outputs.
 * \param[in] give_ids where it is missing, planes are numbered by falling size
 * \param[in] lines what tells the stages; nullptr for none
 * \throws UsageError or WorkError if the cloud cannot be read or an output cannot be
 * written, Interrupted before anything is written */
Report
segmentCloud (const SegmentOptions& given,
              const Task& task,
              const GiveIds& give_ids,
              StageLines* lines);

} // namespace pcl_ops::apps
