// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <ostream>
#include <string>

namespace pcl_ops::apps {

/** \brief Finds out before the work whether \ref writeFile can succeed later.
 * \throws WorkError that names the file, what is in the way and the fix, e.g. if its
 * folder does not exist or the name is that of a folder, a device or a protected file
 */
void
checkWritable (const std::string& file);

/** \brief Writes a file in one step: \p write fills a temporary file in the same
 * folder, which takes the name \p file once every byte is known to be there. If
 * anything fails, the temporary file is removed and an existing \p file stays as it
 * was. All outputs go this way: \p write gets no name, so that it cannot write past the
 * check. \param[in] write need not look at the state of the stream \throws WorkError as
 * \ref checkWritable or if the disk is full, and whatever \p write throws */
void
writeFile (const std::string& file,
           const std::function<void (std::ostream& stream)>& write);

/** \brief \ref writeFile with a text. */
void
writeTextFile (const std::string& file, const std::string& text);

/** \brief Makes a folder, with those it lies in, unless it is there.
 * \throws WorkError that names the folder if files cannot be written there */
void
makeFolder (const std::string& folder);

/** \brief The lower case extension with its dot, e.g. ".pcd"; empty if there is none.
 */
std::string
extensionOf (const std::string& file);

/** \brief The absolute name of a file, through links in its folder and its own; the
 * file need not exist. */
std::string
resolvedName (const std::string& file);

/** \brief Whether both names lead to the same file, also through links and other
 * spellings of the folder; the files need not exist. */
bool
isSameFile (const std::string& first, const std::string& second);

} // namespace pcl_ops::apps
