// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>

#include <gtest/gtest.h>

#include "fuzz_targets.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>

using namespace pcl_ops::fuzz;
namespace fs = std::filesystem;

namespace {

/** What fuzzing began with and what it found, a folder for each target. */
std::vector<fs::path>
corpus ()
{
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator (PCL_OPS_FUZZ_CORPUS))
    if (entry.is_regular_file())
      files.push_back (entry.path());
  std::sort (files.begin(), files.end());
  return files;
}

std::string
targetOf (const fs::path& file)
{
  return file.parent_path().filename().string();
}

std::string
nameOf (const testing::TestParamInfo<fs::path>& info)
{
  std::string name = targetOf (info.param) + "_" + info.param.filename().string();
  std::replace_if (
      name.begin(),
      name.end(),
      [] (unsigned char character) { return std::isalnum (character) == 0; },
      '_');
  return name;
}

} // namespace

class Replay : public testing::TestWithParam<fs::path> {};

TEST_P (Replay, KeepsAllPromises)
{
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  std::ifstream file (GetParam(), std::ios::binary);
  ASSERT_TRUE (file);
  const Bytes bytes ((std::istreambuf_iterator<char> (file)), {});
  EXPECT_NO_THROW (allTargets().at (targetOf (GetParam())) (bytes));
}

INSTANTIATE_TEST_SUITE_P (Corpus, Replay, testing::ValuesIn (corpus()), nameOf);
