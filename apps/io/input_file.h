// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_ops::apps {

/** \brief Finds out whether a file can be read.
 * \param[in] kind of the file wanted, "a .json file", for the message
 * \throws WorkError if it does not exist or is a folder or a device */
void
checkReadable (const std::string& file, const std::string& kind);

/** \brief The content of a file that is text.
 * \throws WorkError as \ref checkReadable, or if it cannot be read */
std::string
readTextFile (const std::string& file, const std::string& kind);

} // namespace pcl_ops::apps
