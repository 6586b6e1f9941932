// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <system_error>
#include <utility>

namespace pcl_ops::apps {

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

} // namespace pcl_ops::apps
