// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

/** \brief Names and what they mean in two columns, as Boost prints options; help2man
 * reads entries of a manual page in it. \param[in] entries name and meaning each
 * \param[in] width columns after which a meaning goes on in the next line */
std::string
listed (const std::vector<std::pair<std::string, std::string>>& entries,
        std::size_t width);

} // namespace pcl_ops::apps
