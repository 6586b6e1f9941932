// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>

#include <gtest/gtest.h>

#include "fuzz_targets.h"

#include <filesystem>
#include <fstream>
#include <iterator>

using namespace pcl_ops::fuzz;
namespace fs = std::filesystem;

// What fuzzing began with and what it found, a folder for each target.
TEST (Replay, KeepsAllPromises)
{
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  for (const auto& [name, target] : allTargets()) {
    std::size_t inputs = 0;
    for (const auto& entry :
         fs::directory_iterator (PCL_OPS_FUZZ_CORPUS / fs::path (name))) {
      SCOPED_TRACE (entry.path().string());
      std::ifstream file (entry.path(), std::ios::binary);
      ASSERT_TRUE (file);
      const Bytes bytes ((std::istreambuf_iterator<char> (file)), {});
      EXPECT_NO_THROW (target (bytes));
      ++inputs;
    }
    EXPECT_GT (inputs, 0u) << name;
  }
}
