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

struct CorpusFile {
  FuzzTarget target;
  fs::path path;
};

/** What fuzzing began with and what it found, by target and name. */
std::vector<CorpusFile>
corpus ()
{
  std::vector<CorpusFile> files;
  for (const FuzzTarget& target : allTargets())
    for (const fs::directory_entry& entry :
         fs::directory_iterator (fs::path (PCL_OPS_FUZZ_CORPUS) / target.name))
      files.push_back ({target, entry.path()});
  std::sort (files.begin(), files.end(), [] (const auto& a, const auto& b) {
    return a.path < b.path;
  });
  return files;
}

std::string
nameOf (const testing::TestParamInfo<CorpusFile>& info)
{
  std::string name = info.param.target.name + "_" + info.param.path.filename().string();
  std::replace_if (
      name.begin(),
      name.end(),
      [] (unsigned char character) { return std::isalnum (character) == 0; },
      '_');
  return name;
}

} // namespace

class Replay : public testing::TestWithParam<CorpusFile> {};

TEST_P (Replay, KeepsAllPromises)
{
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  std::ifstream file (GetParam().path, std::ios::binary);
  ASSERT_TRUE (file);
  const Bytes bytes ((std::istreambuf_iterator<char> (file)), {});
  EXPECT_NO_THROW (GetParam().target.run (bytes));
}

INSTANTIATE_TEST_SUITE_P (Corpus, Replay, testing::ValuesIn (corpus()), nameOf);
