// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <cli/program.h>

#include <functional>
#include <new>
#include <string>

using namespace pcl_ops::apps;

TEST (Program, MapsWhatIsThrownToExitCodesAndOneLine)
{
  const auto run = [] (const std::function<int()>& body) {
    testing::internal::CaptureStderr();
    const int code = runProgram ("detect", body);
    return std::to_string (code) + " " + testing::internal::GetCapturedStderr();
  };
  EXPECT_EQ (run ([] { return ExitCode::done; }), "0 ");
  EXPECT_EQ (run ([] () -> int { throw UsageError ("--k", "is odd"); }),
             "2 detect: --k: is odd\n");
  EXPECT_EQ (run ([] () -> int { throw WorkError ("a.pcd", "is\nempty"); }),
             "1 detect: a.pcd: is empty\n");
  EXPECT_EQ (run ([] () -> int { throw std::bad_alloc(); }),
             "1 detect: not enough memory; try a smaller cloud\n");
}
