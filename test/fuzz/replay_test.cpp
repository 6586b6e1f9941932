// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>

#include "apps/support/temporary_folder.h"
#include "fuzz_targets.h"

using namespace pcl_ops::fuzz;
namespace fs = std::filesystem;

// CMake unpacks the corpus of each target into a folder of the target's name. The
// inputs are those that fuzzing begins with and those that once broke a promise.
TEST (Replay, KeepsAllPromises)
{
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); // hides errors of misuse
  for (const auto& [name, target] : allTargets()) {
    std::size_t inputs = 0;
    for (const auto& entry :
         fs::directory_iterator (PCL_OPS_FUZZ_CORPUS / fs::path (name))) {
      SCOPED_TRACE (entry.path().string());
      const std::string bytes = contentOf (entry.path());
      EXPECT_NO_THROW (target (Bytes (bytes.begin(), bytes.end())));
      ++inputs;
    }
    EXPECT_GT (inputs, 0u) << name;
  }
}
