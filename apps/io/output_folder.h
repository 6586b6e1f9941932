// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace pcl_ops::apps {

/** \brief Writes files that belong together into a folder, which is created if missing.
 * They replace the outputs of an earlier run of a program. \p write fills a temporary
 * folder within it first, and nothing else in the folder changes until \p write has
 * returned. If several runs end at once, one after the other replaces the files.
 * \param[in] is_ours whether a name is that of an output: only such files are moved
 * into the folder, and removed from it if \p write did not write them again
 * \param[in] write fills a temporary folder with the files
 * \throws WorkError that names the folder, also in place of an OutputError of \p write,
 * and whatever else \p write throws */
void
fillFolder (const std::string& folder,
            const std::function<bool (const std::string& name)>& is_ours,
            const std::function<void (const std::filesystem::path& folder)>& write);

} // namespace pcl_ops::apps
