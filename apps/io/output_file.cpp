// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output_file.h"

#include "temporary_path.h"
#include <cli/errors.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Where a name leads through symbolic links, so that renaming replaces the file
 * and not the link to it. */
fs::path
resolved (const std::string& file)
{
  std::error_code error;
  const fs::path path = fs::weakly_canonical (fs::absolute (file, error), error);
  return error ? fs::path (file) : path;
}

/** \brief Where a file is written before it takes its name: in the same folder. */
fs::path
temporaryName (const fs::path& target)
{
  return target.parent_path() /
         ("." + target.stem().string() + "." + std::to_string (::getpid()) +
          target.extension().string());
}

} // namespace

void
checkWritable (const std::string& file)
{
  const fs::path target = resolved (file);
  const fs::path folder = target.parent_path();
  std::error_code error;
  if (file.empty() || !target.has_filename())
    throw WorkError ("'" + file + "'", "is no file name; give one to write to");
  const fs::file_status status = fs::status (target, error);
  if (fs::is_directory (status))
    throw WorkError (file, "is a folder; give the name of a file in it");
  if (fs::exists (status) && !fs::is_regular_file (status))
    throw WorkError (file, "is no regular file; give another name");
  if (!fs::is_directory (folder, error))
    throw WorkError (file, "its folder does not exist; create it or give another name");
  if (::access (folder.c_str(), W_OK | X_OK) != 0)
    throw WorkError (file, "its folder cannot be written to; choose another one");
  if (fs::exists (status) && ::access (target.c_str(), W_OK) != 0)
    throw WorkError (file, "is write-protected; give another name");
}

void
writeFile (const std::string& file,
           const std::function<void (const std::string& path)>& write)
{
  checkWritable (file);
  const fs::path target = resolved (file);
  const TemporaryPath temporary (temporaryName (target));
  write (temporary.path().string());

  std::error_code error;
  if (fs::exists (target))
    fs::permissions (temporary.path(), fs::status (target).permissions(), error);
  fs::rename (temporary.path(), target, error);
  if (error)
    throw WorkError (file,
                     "cannot be written (" + error.message() + "); give another name");
}

void
writeTextFile (const std::string& file, const std::string& text)
{
  writeFile (file, [&] (const std::string& path) {
    std::ofstream stream (path, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
      throw WorkError (file, "cannot be written; is the disk full?");
  });
}

void
makeFolder (const std::string& folder)
{
  std::error_code error;
  if (fs::exists (folder, error) && !fs::is_directory (folder, error))
    throw WorkError (folder, "is no folder; give another name");
  fs::create_directories (folder, error);
  if (error)
    throw WorkError (folder,
                     "cannot be created (" + error.message() + "); give another name");
  if (::access (folder.c_str(), W_OK | X_OK) != 0)
    throw WorkError (folder, "cannot be written to; choose another folder");
}

std::string
extensionOf (const std::string& file)
{
  std::string extension = fs::path (file).extension().string();
  std::transform (extension.begin(), extension.end(), extension.begin(), [] (char c) {
    return static_cast<char> (std::tolower (static_cast<unsigned char> (c)));
  });
  return extension;
}

std::string
resolvedName (const std::string& file)
{
  return resolved (file).string();
}

bool
isSameFile (const std::string& first, const std::string& second)
{
  std::error_code error;
  return fs::equivalent (first, second, error) || resolved (first) == resolved (second);
}

} // namespace pcl_ops::apps
