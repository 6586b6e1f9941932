// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <cli/program.h>
#include <support/text.h>

#include <csignal>

using namespace pcl_ops::apps;

TEST (Program, TurnsExceptionsIntoAnExitCodeAndOneLineOnStandardError)
{
  // Returns "EXIT_CODE TEXT", with the text on standard error.
  const auto run = [] (const std::function<int()>& body) {
    testing::internal::CaptureStderr();
    const int code = runProgram ("detect", body);
    return std::to_string (code) + " " + testing::internal::GetCapturedStderr();
  };
  const auto warnAndSucceed = [] {
    warn ("a.pcd: is\nodd");
    return ExitCode::done;
  };
  EXPECT_EQ (run ([] { return ExitCode::done; }), "0 ");
  EXPECT_EQ (run (warnAndSucceed), "0 detect: a.pcd: is odd\n")
      << "the program goes on";
  EXPECT_EQ (run ([] () -> int { throw UsageError ("--k", "is odd"); }),
             "2 detect: --k: is odd\n");
  EXPECT_EQ (run ([] () -> int { throw WorkError ("a.pcd", "is\nempty"); }),
             "1 detect: a.pcd: is empty\n");
  EXPECT_EQ (run ([] () -> int { throw std::bad_alloc(); }),
             "1 detect: not enough memory; try a smaller cloud\n");
}

TEST (Program, NamesTheFileThatNeedsMoreMemoryThanThereIs)
{
  const auto complaint = [] (const std::function<int()>& work) {
    return complaintOf ([&] { inMemory ("a.pcd", "give less", work); });
  };
  constexpr int result = 7;
  EXPECT_EQ (inMemory ("a.pcd", "give less", [] { return result; }), result);
  EXPECT_EQ (complaint ([] () -> int { throw std::bad_alloc(); }),
             "a.pcd: needs more memory than there is; give less");
  EXPECT_EQ (complaint ([] () -> int { throw std::length_error ("vector"); }),
             "a.pcd: needs more memory than there can be; give less");
  EXPECT_EQ (complaint ([] () -> int { throw WorkError ("b.pcd", "is odd"); }),
             "b.pcd: is odd");
}

namespace {

/** \brief A test whose EXPECT_EXIT starts a new process for its statement. A fork of
 * the test process would lack the other threads of that process. */
class InterruptedProgram : public testing::Test {
protected:
  InterruptedProgram() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

} // namespace

TEST_F (InterruptedProgram, GoesOnAfterTwoSignalsAtOnce)
{
  // The command timeout sends its signal twice, too: to the program and to its group.
  const auto beInterruptedTwice = [] {
    noteInterruptions();
    std::raise (SIGTERM);
    std::raise (SIGTERM);
    std::exit (isInterrupted() ? 0 : 1);
  };
  EXPECT_EXIT (beInterruptedTwice(), testing::ExitedWithCode (0), "");
}

TEST_F (InterruptedProgram, IsEndedByALaterSignal)
{
  const auto beInterruptedWithoutEnd = [] {
    noteInterruptions();
    // The first signal more than half a second after the noted one ends the program.
    while (true)
      std::raise (SIGINT);
  };
  EXPECT_EXIT (beInterruptedWithoutEnd(), testing::KilledBySignal (SIGINT), "");
}

TEST_F (InterruptedProgram, EndsByTheSignalThatInterruptedIt)
{
  const auto beInterruptedAndEnd = [] {
    noteInterruptions();
    std::raise (SIGTERM);
    endAsInterrupted();
    std::exit (0);
  };
  EXPECT_EXIT (beInterruptedAndEnd(), testing::KilledBySignal (SIGTERM), "");
}
