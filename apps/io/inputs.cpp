// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inputs.h"

#include "cloud_file.h"
#include <cli/errors.h>
#include <glob.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
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

/** \brief The files a pattern matches, sorted. */
std::vector<std::string>
matchesOf (const std::string& pattern)
{
  glob_t found{};
  std::vector<std::string> names;
  if (::glob (pattern.c_str(), 0, nullptr, &found) == 0)
    names.assign (found.gl_pathv, found.gl_pathv + found.gl_pathc);
  ::globfree (&found);
  return names;
}

/** \brief Collects files, each once. */
class InputSearch {
public:
  void
  add (const std::string& name)
  {
    std::error_code error;
    const fs::file_status status = fs::status (name, error);
    if (fs::is_directory (status))
      addFolder (name);
    else if (!fs::exists (status) && isPattern (name))
      addPattern (name);
    else if (!fs::exists (status) && !hasCloudExtension (name))
      fail (name, "does not exist; check the name");
    else
      addFile (name);
  }

  InputFiles
  take ()
  {
    return std::move (inputs_);
  }

private:
  void
  addFile (const std::string& file)
  {
    const fs::path absolute = fs::absolute (file).lexically_normal();
    if (seen_.insert (absolute.string()).second)
      inputs_.files.push_back (file);
  }

  void
  addFolder (const std::string& folder)
  {
    std::error_code error;
    std::vector<std::string> clouds;
    for (fs::directory_iterator entry (folder, error), end; entry != end && !error;
         entry.increment (error)) {
      const fs::path& path = entry->path();
      const bool is_hidden = path.filename().string().front() == '.';
      if (!is_hidden && isCloudFile (path.string()))
        clouds.push_back (path.string());
    }
    if (error)
      fail (folder, "cannot be read (" + error.message() + "); check its permissions");
    else if (clouds.empty())
      fail (folder,
            std::string ("has no ") + folder_extensions +
                " file; give a folder with clouds (subfolders are not searched), or a "
                "pattern");
    std::sort (clouds.begin(), clouds.end());
    for (const std::string& cloud : clouds)
      addFile (cloud);
  }

  /** \brief A match is no pattern, whatever its name and even if it is a link to
   * nowhere. */
  void
  addMatch (const std::string& name)
  {
    std::error_code error;
    if (fs::is_directory (name, error))
      addFolder (name);
    else
      addFile (name);
  }

  void
  addPattern (const std::string& pattern)
  {
    const std::vector<std::string> matches = matchesOf (pattern);
    if (matches.empty())
      fail (pattern, "matches no file; check the pattern");
    for (const std::string& match : matches)
      addMatch (match);
  }

  void
  fail (const std::string& name, const std::string& problem)
  {
    inputs_.problems.push_back (name + ": " + problem);
  }

  InputFiles inputs_;
  std::set<std::string> seen_;
};

} // namespace

InputFiles
findInputs (const std::vector<std::string>& names)
{
  InputSearch search;
  for (const std::string& name : names)
    search.add (name);
  return search.take();
}

void
checkIsOneCloud (const std::string& name)
{
  std::error_code error;
  const fs::file_status status = fs::status (name, error);
  if (fs::is_directory (status))
    throw UsageError (name,
                      "is a folder; to segment the clouds in it give --output-dir DIR");
  if (!fs::exists (status) && isPattern (name))
    throw UsageError (
        name, "is no file; to segment what the pattern matches give --output-dir DIR");
}

void
checkReadable (const std::string& file, const std::string& kind)
{
  std::error_code error;
  const fs::file_status status = fs::status (file, error);
  if (error == std::errc::filename_too_long)
    throw WorkError (file, "has a name that is too long; check it");
  if (!fs::exists (status))
    throw WorkError (file, "does not exist; check the name");
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
  std::string text{std::istreambuf_iterator<char> (stream),
                   std::istreambuf_iterator<char>()};
  if (!stream)
    throw WorkError (file, "cannot be read; check its permissions");
  return text;
}

} // namespace pcl_ops::apps
