// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/data/cloud_source.h>
#include <evaluation/detectors/detectors.h>
#include <evaluation/report/text_table.h>

namespace pcl_ops::evaluation {

/** \brief Pictures in the manner of the paper's Figure 4: the truth and what each
 * configuration makes of a cloud, each a PNG with a colour per plane on the left and
 * one per orientation class on the right.
 * \param[in] name of the cloud; its pictures
 * are named after it
 * \param[in] truth labels of its points
 * \param[in] folder where the
 * pictures go
 * \return a row per picture for a Markdown page in that folder: title and
 * image
 * \throw apps::WorkError if a picture cannot be written */
TextTable
writePictures (const EvaluationCloud& cloud,
               const std::string& name,
               const PlaneLabels& truth,
               const std::vector<Configuration>& configurations,
               std::uint32_t seed,
               const std::string& folder);

} // namespace pcl_ops::evaluation
