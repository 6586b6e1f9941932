// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <cli/program.h>

#include <functional>
#include <new>
#include <stdexcept>
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

TEST (Program, SaysWhatItNeedsMoreMemoryFor)
{
  const auto complaint = [] (const std::function<int()>& work) -> std::string {
    try {
      return std::to_string (inMemory ("a.pcd", "give less", work));
    }
    catch (const WorkError& error) {
      return error.what();
    }
  };
  EXPECT_EQ (complaint ([] { return 7; }), "7");
  EXPECT_EQ (complaint ([] () -> int { throw std::bad_alloc(); }),
             "a.pcd: needs more memory than there is; give less");
  EXPECT_EQ (complaint ([] () -> int { throw std::length_error ("vector"); }),
             "a.pcd: needs more memory than there can be; give less");
  EXPECT_EQ (complaint ([] () -> int { throw WorkError ("b.pcd", "is odd"); }),
             "b.pcd: is odd");
}

TEST (Program, WarnsInALineWithItsNameAndGoesOn)
{
  testing::internal::CaptureStderr();
  EXPECT_EQ (runProgram ("detect",
                         [] {
                           warn ("a.pcd: is\nodd");
                           return ExitCode::done;
                         }),
             0);
  EXPECT_EQ (testing::internal::GetCapturedStderr(), "detect: a.pcd: is odd\n");
}
