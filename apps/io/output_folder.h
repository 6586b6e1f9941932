// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace pcl_ops::apps {

/** \brief Writes files that belong together into a folder, which is made, in place of
 * those of an earlier run. Nothing changes there until all are written; other runs that
 * do the same there wait.
 * \param[in] is_ours whether a file of that name is written, or removed if it is not
 * \param[in] write fills another folder with them
 * \throws WorkError that names the folder, what \p write does */
void
fillFolder (const std::string& folder,
            const std::function<bool (const std::string& name)>& is_ours,
            const std::function<void (const std::filesystem::path& folder)>& write);

} // namespace pcl_ops::apps
