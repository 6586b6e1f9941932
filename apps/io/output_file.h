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

/** \brief Checks before the work whether \ref writeFile can write a file after it.
 * \throws WorkError that names the obstacle, such as a missing folder, and the fix */
void
checkWritable (const std::string& file);

/** \brief Writes a file in one step: \p write fills a temporary file in the same
 * folder, which is renamed to \p file once all bytes are written. If anything fails, an
 * existing \p file does not change. Else the new file gets the permissions of the
 * existing one. If \p file is a link, the file that the link leads to is written. All
 * outputs are written in this way.
 * \param[in] write need not check the state of the stream
 * \throws WorkError as \ref checkWritable, OutputError if the bytes cannot be written,
 * and whatever \p write throws */
void
writeFile (const std::string& file,
           const std::function<void (std::ostream& stream)>& write);

/** \brief Writes a text by \ref writeFile. */
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

/** \brief Whether a file has one of the extensions, in upper or lower case.
 * \param[in] extensions in lower case, with their dots */
bool
hasExtension (const std::string& file, const std::vector<std::string>& extensions);

/** \brief Checks that the value of an option is a file with one of the extensions, or
 * empty.
 * \param[in] option its name with "--", for the message
 * \param[in] extensions as of \ref hasExtension
 * \throws UsageError about the option if \p file has none of the extensions */
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

/** \brief Name of a file, or of a folder, that the destructor removes with its content.
 * What was renamed meanwhile stays. */
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

/** \brief A lock on a folder, which one run of a program can have at a time. The
 * destructor releases it, and so does the end of the run in any way. A folder that
 * cannot be opened, or is on a file system without locks, has no lock: \ref wait and
 * \ref take succeed at once. */
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
   * \return false if another run has it */
  bool
  take () const;

private:
  /** \brief File descriptor of the folder. */
  int folder_;
};

} // namespace pcl_ops::apps
