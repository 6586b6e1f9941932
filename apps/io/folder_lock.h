// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace pcl_ops::apps {

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
