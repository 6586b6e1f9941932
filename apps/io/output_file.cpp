// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "output_file.h"

#include <boost/algorithm/string/case_conv.hpp>
#include <boost/algorithm/string/join.hpp>

#include <cli/errors.h>
#include <cli/program.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <locale>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Throws an OutputError with the reason in errno. */
[[noreturn]] void
failToWrite (const std::string& file)
{
  throw OutputError (file,
                     std::string ("cannot be written (") + std::strerror (errno) +
                         "); make room or give another name");
}

/** \brief Creates a file that does not exist yet in a folder, and returns its path. Its
 * name is short: one that begins with the name of the output could be too long.
 * \param[in] output the file that error messages name */
fs::path
newFileIn (const fs::path& folder, const std::string& output)
{
  static std::atomic<unsigned> created{0};
  constexpr mode_t permissions = 0666; // the user's umask removes some
  for (;;) {
    fs::path path = folder / (".pcl_ops." + std::to_string (::getpid()) + "." +
                              std::to_string (++created));
    const int descriptor =
        ::open (path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, permissions);
    if (descriptor >= 0) {
      ::close (descriptor);
      return path;
    }
    if (errno != EEXIST)
      failToWrite (output);
  }
}

/** \brief Throws a WorkError about \p subject with the reason in errno.
 * \param[in] name of the temporary file */
[[noreturn]] void
failToFillTemporary (const std::string& subject, const std::string& name)
{
  throw WorkError (subject,
                   "cannot be copied to " + name + " (" + std::strerror (errno) +
                       "); set TMPDIR to a folder with more space");
}

/** \brief Creates a file in the folder for temporary files and returns its name.
 * \param[in] extension, subject as of \ref TemporaryFile */
std::string
newTemporaryFile (const std::string& extension, const std::string& subject)
{
  std::error_code error;
  const fs::path folder = fs::temp_directory_path (error);
  if (error)
    throw WorkError ("TMPDIR", "is no folder; set it to one for temporary files");
  std::string name = folder / ("pcl_ops_XXXXXX" + extension);
  const int descriptor = ::mkstemps (name.data(), static_cast<int> (extension.size()));
  if (descriptor < 0)
    failToFillTemporary (subject, name);
  ::close (descriptor);
  return name;
}

/** \brief Replaces the content of a file by what \p write writes.
 * \return false if not all bytes were written; errno tells why */
bool
fillFile (const fs::path& path, const std::function<void (std::ostream& stream)>& write)
{
  std::ofstream stream (path, std::ios::binary);
  write (stream);
  stream.close();
  return bool (stream);
}

} // namespace

std::string
resolvedName (const std::string& file)
{
  std::error_code error;
  fs::path path = fs::absolute (file, error);
  // weakly_canonical does not follow a link to a file that does not exist yet.
  constexpr int max_links = 40; // Linux follows no more
  for (int i = 0; i < max_links && fs::is_symlink (path, error); ++i)
    path = path.parent_path() / fs::read_symlink (path, error);
  const fs::path canonical = fs::weakly_canonical (path, error);
  return (error ? path : canonical).string();
}

void
checkWritable (const std::string& file)
{
  const fs::path target = resolvedName (file);
  const fs::path folder = target.parent_path();
  std::error_code error;
  std::error_code ignored;
  const fs::file_status status = fs::status (target, error);
  struct Problem {
    bool exists;
    const char* what_and_fix;
  };
  const bool file_exists = fs::exists (status);
  const Problem problems[] = {
      {!target.has_filename(), "is no file name; give one to write to"},
      {error == std::errc::filename_too_long,
       "has a name that is too long; give a shorter one"},
      {error == std::errc::too_many_symbolic_link_levels,
       "is a link that leads nowhere; give another name"},
      {fs::is_directory (status), "is a folder; give the name of a file in it"},
      {file_exists && !fs::is_regular_file (status),
       "is no regular file; give another name"},
      {file_exists && ::access (target.c_str(), W_OK) != 0,
       "is write-protected; give another name"},
      {!fs::is_directory (folder, ignored),
       "its folder does not exist; create it or give another name"},
      {::access (folder.c_str(), W_OK | X_OK) != 0,
       "its folder cannot be written to; choose another one"}};
  for (const Problem& problem : problems)
    if (problem.exists)
      throw WorkError (file, problem.what_and_fix);
}

void
writeFile (const std::string& file,
           const std::function<void (std::ostream& stream)>& write)
{
  checkWritable (file);
  // Renaming onto a link would replace the link, not the file it leads to.
  const fs::path target = resolvedName (file);
  const TemporaryPath temporary (newFileIn (target.parent_path(), file));
  if (!fillFile (temporary.path, write))
    failToWrite (file);
  std::error_code error;
  if (fs::exists (target, error))
    fs::permissions (temporary.path, fs::status (target).permissions(), error);
  if (std::rename (temporary.path.c_str(), target.c_str()) != 0)
    failToWrite (file);
}

void
writeTextFile (const std::string& file, const std::string& text)
{
  writeFile (file, [&] (std::ostream& stream) { stream << text; });
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
  return boost::algorithm::to_lower_copy (fs::path (file).extension().string(),
                                          std::locale::classic());
}

bool
hasExtension (const std::string& file, const std::vector<std::string>& extensions)
{
  return std::find (extensions.begin(), extensions.end(), extensionOf (file)) !=
         extensions.end();
}

void
checkExtension (const std::string& option,
                const std::string& file,
                const std::vector<std::string>& extensions)
{
  if (!file.empty() && !hasExtension (file, extensions))
    throw UsageError (option,
                      file + " has an unknown extension; give a file " +
                          boost::algorithm::join (extensions, " or "));
}

bool
isSameFile (const std::string& first, const std::string& second)
{
  std::error_code error;
  return fs::equivalent (first, second, error) ||
         resolvedName (first) == resolvedName (second);
}

TemporaryFile::TemporaryFile (const std::string& extension, std::string subject)
: subject_ (std::move (subject)), file_ (newTemporaryFile (extension, subject_))
{}

void
TemporaryFile::fill (const std::function<void (std::ostream& stream)>& write) const
{
  if (!fillFile (file_.path, write))
    failToFillTemporary (subject_, name());
}

FolderLock::FolderLock (const std::string& folder)
: folder_ (::open (folder.c_str(), O_RDONLY | O_CLOEXEC))
{}

FolderLock::~FolderLock() { ::close (folder_); }

void
FolderLock::wait() const
{
  while (::flock (folder_, LOCK_EX) != 0 && errno == EINTR)
    stopIfInterrupted();
}

bool
FolderLock::take() const
{
  return ::flock (folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

} // namespace pcl_ops::apps
