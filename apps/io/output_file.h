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
 * \throws WorkError that names the file, what is in the way and the fix, e.g. if its
 * folder does not exist or the name is that of a folder, a device or a protected file
 */
void
checkWritable (const std::string& file);

/** \brief Writes a file in one step: \p write fills a temporary file in the same
 * folder, which takes the name \p file once every byte is known to be there. If
 * anything fails, the temporary file is removed and an existing \p file stays as it
 * was. All outputs go this way: \p write gets no name, so that it cannot write past the
 * check. \param[in] write need not look at the state of the stream \throws WorkError as
 * \ref checkWritable or if the disk is full, and whatever \p write throws */
void
writeFile (const std::string& file,
           const std::function<void (std::ostream& stream)>& write);

/** \brief \ref writeFile with a text. */
void
writeTextFile (const std::string& file, const std::string& text);

/** \brief Makes a folder, with those it lies in, unless it is there.
 * \throws WorkError that names the folder if files cannot be written there */
void
makeFolder (const std::string& folder);

/** \brief The lower case extension with its dot, e.g. ".pcd"; empty if there is none.
 */
std::string
extensionOf (const std::string& file);

/** \brief Whether that is one of these. */
bool
hasExtension (const std::string& file, const std::vector<std::string>& extensions);

/** \brief Refuses a file, unless its name is empty, whose extension is none of these.
 * \param[in] option or argument that names it \throws UsageError */
void
checkExtension (const std::string& option,
                const std::string& file,
                const std::vector<std::string>& extensions);

/** \brief The absolute name of a file, through links in its folder and its own; the
 * file need not exist. */
std::string
resolvedName (const std::string& file);

/** \brief Whether both names lead to the same file, also through links and other
 * spellings of the folder; the files need not exist. */
bool
isSameFile (const std::string& first, const std::string& second);

/** \brief Removes a file, or a folder with all in it, at the end of its life, unless
 * that has been renamed by then. */
class TemporaryPath {
public:
  explicit TemporaryPath (std::filesystem::path path) : path_ (std::move (path)) {}
  TemporaryPath (const TemporaryPath&) = delete;
  TemporaryPath&
  operator= (const TemporaryPath&) = delete;
  ~TemporaryPath()
  {
    std::error_code ignored;
    std::filesystem::remove_all (path_, ignored);
  }

  const std::filesystem::path&
  path () const
  {
    return path_;
  }

private:
  std::filesystem::path path_;
};

/** \brief A new file in the folder for temporary files ($TMPDIR), removed at the end of
 * its life: on its way into or out of what takes files only. */
class Spool {
public:
  /** \param[in] extension of the file, with its dot
   * \param[in] subject what complaints are about
   * \throws WorkError if there can be none */
  Spool (const std::string& extension, std::string subject);

  /** \brief Writes all of it.
   * \param[in] write need not look at the state of the stream
   * \throws WorkError if not all is there, and whatever \p write throws */
  void
  fill (const std::function<void (std::ostream& stream)>& write) const;

  std::string
  name () const
  {
    return file_.path().string();
  }

private:
  std::string subject_;
  TemporaryPath file_;
};

/** \brief A folder that one run has to itself until it ends, however it ends. Where the
 * file system knows no locks, it is as if this were the only run. */
class FolderLock {
public:
  /** \param[in] folder that is there */
  explicit FolderLock (const std::string& folder);
  FolderLock (const FolderLock&) = delete;
  FolderLock&
  operator= (const FolderLock&) = delete;
  ~FolderLock();

  /** \brief Waits until no other run has it. \throws Interrupted while it waits */
  void
  wait () const;

  /** \return whether no other run has it */
  bool
  take () const;

private:
  int folder_;
};

} // namespace pcl_ops::apps
