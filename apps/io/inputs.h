// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief The files that names on a command line stand for. */
struct InputFiles {
  /** \brief In the order of the names; the files of a folder or pattern are sorted by
   * their own names. Each file is listed once. */
  std::vector<std::string> files;
  /** \brief Messages on names that lead to no cloud: "name: what is wrong; the fix". */
  std::vector<std::string> problems;
};

/** \brief Looks up names of files, of folders, which stand for the clouds in them (\ref
 * isCloudFile), and of shell patterns. A file that exists is listed whatever its
 * extension is. A file that does not exist is listed only if it has the extension of a
 * cloud: then \ref loadCloud reports that it is missing. */
InputFiles
findInputs (const std::vector<std::string>& names);

/** \brief Checks that a name can stand for one cloud in a file.
 * \throws UsageError with the fix if it is a folder, a pattern or a pipe */
void
checkIsOneCloud (const std::string& name);

/** \brief Checks that a file exists and is a regular one.
 * \param[in] kind of the file wanted, "a .json file", for the message
 * \throws WorkError if the file does not exist, is in a folder that may not be
 * searched, or is a folder or a device */
void
checkReadable (const std::string& file, const std::string& kind);

/** \brief Returns the content of a file.
 * \param[in] kind as of \ref checkReadable
 * \throws WorkError as \ref checkReadable, or if the file cannot be read */
std::string
readTextFile (const std::string& file, const std::string& kind);

} // namespace pcl_ops::apps
