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

/** \brief Finds out before the work whether \ref writeFile can succeed later.
 * \throws WorkError that names what is in the way, as a missing folder, and the fix */
void
checkWritable (const std::string& file);

/** \brief Writes a file in one step: \p write fills a temporary file in the same
 * folder, which takes the name \p file once every byte is known to be there; if
 * anything fails, an existing \p file stays as it was. All outputs go this way.
 * \param[in] write need not look at the state of the stream
 * \throws WorkError as \ref checkWritable or if the disk is full, what \p write does */
void
writeFile (const std::string& file,
           const std::function<void (std::ostream& stream)>& write);

void
writeTextFile (const std::string& file, const std::string& text);

/** \brief Makes a folder, with those it lies in, unless it is there.
 * \throws WorkError that names the folder if files cannot be written there */
void
makeFolder (const std::string& folder);

/** \brief In lower case with its dot, ".pcd"; empty if there is none. */
std::string
extensionOf (const std::string& file);

bool
hasExtension (const std::string& file, const std::vector<std::string>& extensions);

/** \throws UsageError about the option or argument that names a file with another
 * extension; an empty name is fine */
void
checkExtension (const std::string& option,
                const std::string& file,
                const std::vector<std::string>& extensions);

/** \brief The absolute name of a file, which need not exist, through links. */
std::string
resolvedName (const std::string& file);

/** \brief Whether both names lead to the same file, which need not exist. */
bool
isSameFile (const std::string& first, const std::string& second);

/** \brief A file, or a folder with all in it, that is removed at the end of its life
 * unless it has been renamed by then. */
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

/** \brief A new temporary file ($TMPDIR) for what takes files only. */
class Spool {
public:
  /** \param[in] subject what complaints are about
   * \throws WorkError if there can be none */
  Spool (const std::string& extension, std::string subject);

  /** \brief As \ref writeFile does. */
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

/** \brief A folder that one run has to itself until it ends, however it ends; where the
 * file system knows no locks, each has it. */
class FolderLock {
public:
  explicit FolderLock (const std::string& folder);
  FolderLock (const FolderLock&) = delete;
  FolderLock&
  operator= (const FolderLock&) = delete;
  ~FolderLock();

  /** \brief Waits until no other run has it. \throws Interrupted while it waits */
  void
  wait () const;

  /** \return false if another run has it */
  bool
  take () const;

private:
  int folder_;
};

} // namespace pcl_ops::apps
