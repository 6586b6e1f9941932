// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inputs.h"

#include "cloud_file.h"
#include <cli/errors.h>
#include <glob.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <set>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

bool
isPattern (const std::string& name)
{
  return name.find_first_of ("*?[") != std::string::npos;
}

/** \brief Adds the clouds in a folder, sorted by name. Hidden ones and subfolders, even
 * with the extension of a cloud, are left out. */
void
addFolder (const std::string& folder, InputFiles& found)
{
  std::error_code error;
  std::vector<std::string> clouds;
  for (fs::directory_iterator entry (folder, error), end; entry != end && !error;
       entry.increment (error)) {
    const fs::path& path = entry->path();
    const bool is_hidden = path.filename().string().front() == '.';
    std::error_code ignored;
    const bool is_folder = entry->is_directory (ignored);
    if (!is_hidden && !is_folder && isCloudFile (path.string()))
      clouds.push_back (path.string());
  }
  if (error)
    found.problems.push_back (folder + ": cannot be read (" + error.message() +
                              "); check its permissions");
  else if (clouds.empty())
    found.problems.push_back (
        folder + ": has no " + folderExtensions() +
        " file; give a folder with clouds (subfolders are not searched), or a pattern");
  std::sort (clouds.begin(), clouds.end());
  found.files.insert (found.files.end(), clouds.begin(), clouds.end());
}

/** \brief Adds the matches of a shell pattern. A folder that matches stands for the
 * clouds in it. Any other match is added as a file, even a broken link, or a file whose
 * own name looks like a pattern. */
void
addPattern (const std::string& pattern, InputFiles& found)
{
  glob_t matches{};
  if (::glob (pattern.c_str(), 0, nullptr, &matches) != 0)
    found.problems.push_back (pattern + ": matches no file; check the pattern");
  for (std::size_t i = 0; i < matches.gl_pathc; ++i) {
    const std::string match = matches.gl_pathv[i];
    std::error_code error;
    if (fs::is_directory (match, error))
      addFolder (match, found);
    else
      found.files.push_back (match);
  }
  ::globfree (&matches);
}

/** \brief Says why a file that does not seem to exist cannot be found.
 * \param[in] error of fs::status */
std::string
reasonNotFound (const std::error_code& error)
{
  if (error == std::errc::filename_too_long)
    return "has a name that is too long; check it";
  if (error == std::errc::permission_denied) // of a folder above it
    return "cannot be read; check its permissions";
  return "does not exist; check the name";
}

/** \brief Adds the files that a name given by the user stands for. */
void
addName (const std::string& name, InputFiles& found)
{
  std::error_code error;
  const fs::file_status status = fs::status (name, error);
  if (fs::is_directory (status))
    addFolder (name, found);
  else if (!fs::exists (status) && isPattern (name))
    addPattern (name, found);
  else if (!fs::exists (status) && !hasCloudExtension (name))
    found.problems.push_back (name + ": " + reasonNotFound (error));
  else
    found.files.push_back (name);
}

} // namespace

InputFiles
findInputs (const std::vector<std::string>& names)
{
  InputFiles found;
  for (const std::string& name : names)
    addName (name, found);
  std::set<std::string> listed;
  const auto is_repeated = [&] (const std::string& file) {
    const std::string absolute_name = fs::absolute (file).lexically_normal().string();
    return !listed.insert (absolute_name).second;
  };
  found.files.erase (
      std::remove_if (found.files.begin(), found.files.end(), is_repeated),
      found.files.end());
  return found;
}

void
checkIsOneCloud (const std::string& name)
{
  std::error_code error;
  const fs::file_status status = fs::status (name, error);
  if (fs::is_directory (status))
    throw UsageError (name,
                      "is a folder; to segment the clouds in it give --output-dir DIR");
  if (fs::is_fifo (status))
    throw UsageError (name, "is a pipe; give it as the standard input: - <" + name);
  if (!fs::exists (status) && isPattern (name))
    throw UsageError (
        name, "is no file; to segment what the pattern matches give --output-dir DIR");
}

void
checkReadable (const std::string& file, const std::string& kind)
{
  std::error_code error;
  const fs::file_status status = fs::status (file, error);
  if (!fs::exists (status))
    throw WorkError (file, reasonNotFound (error));
  if (fs::is_directory (status))
    throw WorkError (file, "is a folder; give " + kind);
  if (!fs::is_regular_file (status))
    throw WorkError (file, "is no regular file; give " + kind);
}

std::string
readTextFile (const std::string& file, const std::string& kind)
{
  checkReadable (file, kind);
  std::ifstream stream (file, std::ios::binary);
  std::string text;
  std::array<char, 65536> part{};
  do {
    stream.read (part.data(), part.size());
    text.append (part.data(), static_cast<std::size_t> (stream.gcount()));
  }
  while (stream);
  if (!stream.eof())
    throw WorkError (file, "cannot be read; check its permissions");
  return text;
}

} // namespace pcl_ops::apps
