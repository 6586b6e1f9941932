// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/console/print.h>

#include "fuzz_targets.h"

// The entry points that libFuzzer calls. PCL_OPS_FUZZ_TARGET, which CMake defines, is
// the name of the target in allTargets.

extern "C" int
LLVMFuzzerInitialize (int*, char***)
{
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS); // hides errors of misuse
  return 0;
}

extern "C" int
LLVMFuzzerTestOneInput (const std::uint8_t* data, std::size_t size)
{
  static void (*const target) (const pcl_ops::fuzz::Bytes&) =
      pcl_ops::fuzz::allTargets().at (PCL_OPS_FUZZ_TARGET);
  target (pcl_ops::fuzz::Bytes (data, data + size));
  return 0;
}
