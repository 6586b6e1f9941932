// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_ops::apps {

struct InputFiles {
  /** \brief By the names, those of a folder or pattern sorted. Each once. */
  std::vector<std::string> files;
  /** \brief What is wrong with names that stand for no cloud, "name: what; fix". */
  std::vector<std::string> problems;
};

/** \brief Looks up names of files, of folders, which stand for the clouds in them (\ref
 * isCloudFile), and of patterns of the shell. A file is taken as it is, even one that
 * does not exist if it has the extension of a cloud. */
InputFiles
findInputs (const std::vector<std::string>& names);

/** \brief Where one cloud is needed, says what to do with a name of several.
 * \throws UsageError if it is a folder or a pattern */
void
checkIsOneCloud (const std::string& name);

/** \param[in] kind of the file wanted, "a .json file", for the message
 * \throws WorkError if it does not exist or is a folder or a device */
void
checkReadable (const std::string& file, const std::string& kind);

/** \throws WorkError as \ref checkReadable, or if it cannot be read */
std::string
readTextFile (const std::string& file, const std::string& kind);

} // namespace pcl_ops::apps
