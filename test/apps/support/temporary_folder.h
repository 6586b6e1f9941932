// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

/** \brief An empty folder for one test, removed after it. */
class TemporaryFolder {
public:
  /** \brief Its path has no links: programs name outputs without them.
   * \param[in] suffix tells the folders of one test apart */
  explicit TemporaryFolder (const std::string& suffix = "")
  : path_ (std::filesystem::canonical (testing::TempDir()) /
           ("pcl_ops_" + std::to_string (::getpid()) + "_" + testName() + suffix))
  {
    std::filesystem::remove_all (path_);
    std::filesystem::create_directories (path_);
  }
  TemporaryFolder (const TemporaryFolder&) = delete;
  TemporaryFolder&
  operator= (const TemporaryFolder&) = delete;
  ~TemporaryFolder() { std::filesystem::remove_all (path_); }

  std::string
  path () const
  {
    return path_.string();
  }

  /** \brief Path of a file with this name in the folder. */
  std::string
  operator/ (const std::string& name) const
  {
    return (path_ / name).string();
  }

  /** \brief Writes a file and returns its path. */
  std::string
  write (const std::string& name, const std::string& content) const
  {
    std::ofstream (path_ / name, std::ios::binary) << content;
    return (path_ / name).string();
  }

  /** \brief Number of files and folders in the folder. */
  std::size_t
  fileCount () const
  {
    using Iterator = std::filesystem::directory_iterator;
    return static_cast<std::size_t> (std::distance (Iterator (path_), Iterator()));
  }

private:
  /** \brief Name of the running test. A slash, as in the names of parametrized tests,
   * becomes an underscore. */
  static std::string
  testName ()
  {
    std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    std::replace (name.begin(), name.end(), '/', '_');
    return name;
  }

  std::filesystem::path path_;
};

/** \brief The bytes of a file; empty if it cannot be read. */
inline std::string
contentOf (const std::string& file)
{
  std::ifstream stream (file, std::ios::binary);
  return std::string (std::istreambuf_iterator<char> (stream), {});
}
