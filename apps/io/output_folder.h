// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace pcl_ops::apps {

/** \brief Writes files that belong together into a folder, which is created if missing,
 * in place of the outputs of an earlier run of a program. First \p write fills a
 * temporary folder within this folder. Until \p write has returned, nothing else in the
 * folder changes. If several runs end at the same time, they replace the files one
 * after the other.
 * \param[in] is_ours whether a file name is that of an output. Only files with such
 * names are moved into the folder, and only such files are removed from it: those that
 * \p write did not write again.
 * \param[in] write writes the files into the temporary folder that is its argument
 * \throws WorkError that names the folder, also in place of an OutputError of \p write,
 * and whatever else \p write throws */
void
fillFolder (const std::string& folder,
            const std::function<bool (const std::string& name)>& is_ours,
            const std::function<void (const std::filesystem::path& folder)>& write);

} // namespace pcl_ops::apps
