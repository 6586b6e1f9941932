// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <ostream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

/** \brief Checks before the work whether \ref writeFile can succeed later.
 * \throws WorkError that names the obstacle, such as a missing folder, and the fix */
void
checkWritable (const std::string& file);

/** \brief Writes a file in one step: \p write fills a temporary file in the same
 * folder, which is renamed to \p file once all bytes are written. If anything fails, an
 * existing \p file does not change. If nothing fails, the new file gets the permissions
 * of the existing one. If \p file is a link, the file that it leads to is written. All
 * outputs are written this way.
 * \param[in] write need not check the state of the stream
 * \throws WorkError as \ref checkWritable, OutputError if the bytes cannot be written,
 * and whatever \p write throws */
void
writeFile (const std::string& file,
           const std::function<void (std::ostream& stream)>& write);

void
writeTextFile (const std::string& file, const std::string& text);

/** \brief Creates a folder and its parents, unless they exist.
 * \throws WorkError that names the folder if files cannot be written there */
void
makeFolder (const std::string& folder);

/** \brief Returns the extension in lower case with its dot, ".pcd"; empty if there is
 * none. */
std::string
extensionOf (const std::string& file);

/** \param[in] extensions in lower case, with their dots */
bool
hasExtension (const std::string& file, const std::vector<std::string>& extensions);

/** \throws UsageError about \p option if the file has none of the extensions; an empty
 * name is allowed */
void
checkExtension (const std::string& option,
                const std::string& file,
                const std::vector<std::string>& extensions);

/** \brief Returns the absolute name of a file with its links resolved. The file need
 * not exist. */
std::string
resolvedName (const std::string& file);

/** \brief Whether both names lead to the same file, which need not exist. */
bool
isSameFile (const std::string& first, const std::string& second);

/** \brief A file, or a folder with its content, that the destructor removes. If it was
 * renamed, the file of the new name stays. */
struct TemporaryPath {
  explicit TemporaryPath (std::filesystem::path name) : path (std::move (name)) {}
  TemporaryPath (const TemporaryPath&) = delete;
  TemporaryPath&
  operator= (const TemporaryPath&) = delete;
  ~TemporaryPath()
  {
    std::error_code ignored;
    std::filesystem::remove_all (path, ignored);
  }

  const std::filesystem::path path;
};

/** \brief A new temporary file ($TMPDIR), for libraries that read or write files only.
 */
class TemporaryFile {
public:
  /** \param[in] extension with its dot, or empty
   * \param[in] subject the file or option that error messages name
   * \throws WorkError if the file cannot be created */
  TemporaryFile (const std::string& extension, std::string subject);

  /** \brief Fills the file by \p write, which need not check the state of the stream.
   * \throws WorkError if the disk is full, and whatever \p write throws */
  void
  fill (const std::function<void (std::ostream& stream)>& write) const;

  std::string
  name () const
  {
    return file_.path.string();
  }

private:
  std::string subject_;
  TemporaryPath file_;
};

/** \brief A lock on a folder for one run of a program. The destructor releases it, and
 * so does the end of the run in any way. Every run gets the lock of a folder that
 * cannot be opened, or is on a file system without locks. */
class FolderLock {
public:
  explicit FolderLock (const std::string& folder);
  FolderLock (const FolderLock&) = delete;
  FolderLock&
  operator= (const FolderLock&) = delete;
  ~FolderLock();

  /** \brief Waits until no other run has the lock, then takes it.
   * \throws Interrupted while it waits */
  void
  wait () const;

  /** \brief Takes the lock unless another run has it.
   * \return whether it was taken */
  bool
  take () const;

private:
  /** \brief File descriptor of the folder. */
  int folder_;
};

} // namespace pcl_ops::apps
