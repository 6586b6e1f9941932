// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report.h"
#include <cli/progress.h>

#include <functional>
#include <string>

namespace pcl_ops::apps {

/** \brief Sets Report::ids and Report::ids_of_whole of the planes of a cloud.
 * \param[in] sensor its position in the frame of the cloud or, if that is not known, a
 * place among the points */
using GiveIds = std::function<void (const Eigen::Vector3d& sensor, Report& report)>;

/** \brief The file of a task, or what messages call the standard input. */
std::string
nameOfInput (const Task& task);

/** \brief Reads a cloud, finds its planes and writes its outputs.
 * \param[in] given the options; a reference system and a unit that they leave out are
 * those of the file
 * \param[in] give_ids empty: planes are numbered by falling size
 * \param[in] lines prints each stage as it begins; nullptr for none
 * \throws UsageError or WorkError if the cloud cannot be read or an output cannot be
 * written, Interrupted before anything is written */
Report
segmentCloud (const SegmentOptions& given,
              const Task& task,
              const GiveIds& give_ids,
              StageLines* lines);

} // namespace pcl_ops::apps
