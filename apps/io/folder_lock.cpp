// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "folder_lock.h"

#include <cli/interruption.h>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace pcl_ops::apps {

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
