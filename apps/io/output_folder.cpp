// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output_folder.h"

#include "output_file.h"
#include <cli/errors.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <set>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

using IsOurs = std::function<bool (const std::string& name)>;

/** \brief Returns the names of the files in a folder that are outputs by their names.
 */
std::set<std::string>
outputsIn (const fs::path& folder, const IsOurs& is_ours)
{
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator (folder))
    if (const std::string name = entry.path().filename().string();
        entry.is_regular_file() && is_ours (name))
      names.insert (name);
  return names;
}

/** \brief Creates a folder in a folder and returns its path. */
fs::path
newFolderIn (const std::string& folder)
{
  std::string name = (fs::path (folder) / ".pcl_ops.XXXXXX").string();
  if (::mkdtemp (name.data()) == nullptr)
    throw fs::filesystem_error (folder,
                                std::error_code (errno, std::generic_category()));
  return name;
}

/** \brief Moves the outputs of a run from \p written_folder into \p folder, and removes
 * from \p folder the outputs that this run has not written again. */
void
replaceOutputs (const fs::path& folder,
                const fs::path& written_folder,
                const IsOurs& is_ours)
{
  // Other runs that replace outputs of the same folder wait for this one.
  const FolderLock lock (folder);
  lock.wait();
  std::set<std::string> stale = outputsIn (folder, is_ours);
  const std::set<std::string> written = outputsIn (written_folder, is_ours);
  // All names are checked before the first file is moved: rename fails on a folder.
  for (const std::string& name : written)
    if (fs::is_directory (folder / name))
      throw fs::filesystem_error (name,
                                  std::make_error_code (std::errc::is_a_directory));
  for (const std::string& name : written) {
    fs::rename (written_folder / name, folder / name);
    stale.erase (name);
  }
  for (const std::string& name : stale)
    fs::remove (folder / name);
}

} // namespace

void
fillFolder (const std::string& folder,
            const IsOurs& is_ours,
            const std::function<void (const fs::path& folder)>& write)
{
  makeFolder (folder);
  try {
    const TemporaryPath written (newFolderIn (folder));
    write (written.path);
    replaceOutputs (folder, written.path, is_ours);
  }
  catch (const fs::filesystem_error& error) {
    throw OutputError (folder,
                       "cannot be written to (" + error.code().message() +
                           "); choose another folder");
  }
  catch (const OutputError& error) {
    throw OutputError (folder, error.problem); // the error names a temporary file
  }
}

} // namespace pcl_ops::apps
