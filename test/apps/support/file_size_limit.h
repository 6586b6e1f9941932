// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/resource.h>

#include <csignal>

/** \brief Files cannot get longer than this, as on a full disk. */
class FileSizeLimit {
public:
  explicit FileSizeLimit (rlim_t bytes)
  {
    std::signal (SIGXFSZ, SIG_IGN);
    ::getrlimit (RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit (RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit (const FileSizeLimit&) = delete;
  FileSizeLimit&
  operator= (const FileSizeLimit&) = delete;
  ~FileSizeLimit() { ::setrlimit (RLIMIT_FSIZE, &before_); }

private:
  rlimit before_{};
};
