// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.h"
#include <cli/progress.h>

#include <functional>
#include <string>

namespace pcl_ops::apps {

/** \brief Function that sets Report::ids and Report::whole_plane_ids of the planes of a
 * cloud.
 * \param[in] sensor position of the sensor in the frame of the file. If the file has
 * none, it is ShiftedCloud::shift: a position near the points, or zero. */
using GiveIds = std::function<void (const Eigen::Vector3d& sensor, Report& report)>;

/** \brief Returns the name of a task's input for messages: its file, or "standard
 * input". */
std::string
nameOfInput (const Task& task);

/** \brief Reads a cloud, finds its planes and writes its outputs.
 * \param[in] given_options if they leave out the reference system or the unit, those of
 * a LAS file are used
 * \param[in] give_ids empty: ids are 1, 2, ... by falling size of the planes
 * \param[in] progress is told each stage that begins; nullptr: no progress is printed
 * \throws UsageError or WorkError if the cloud cannot be read or an output cannot be
 * written, Interrupted, which leaves no half-written file */
Report
segmentCloud (const SegmentOptions& given_options,
              const Task& task,
              const GiveIds& give_ids,
              StageLines* progress);

} // namespace pcl_ops::apps
