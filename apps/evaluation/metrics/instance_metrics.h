// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "confusion.h"

#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::evaluation {

using NamedValues = std::vector<std::pair<std::string, double>>;

/** \brief Planes as instances at one overlap threshold, each metric under its published
 * name; the page on accuracy defines them. Where both sides have no plane the result is
 * perfect, where one has none it has found nothing.
 * \param[in] threshold of the intersection over union, from which planes match one to
 * one, the largest first (at more than one half no plane has two candidates)
 * \param[in] suffix of the names */
NamedValues
instanceMetrics (const Confusion& confusion,
                 double threshold,
                 const std::string& suffix);

/** \brief Which true planes that matching finds, by their ids. */
std::vector<bool>
foundTruePlanes (const Confusion& confusion, double threshold);

} // namespace pcl_ops::evaluation
