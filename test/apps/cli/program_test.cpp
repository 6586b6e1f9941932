// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <cli/program.h>
#include <support/text.h>

#include <csignal>

using namespace pcl_ops::apps;

TEST (Program, MapsWhatIsThrownToExitCodesAndOneLine)
{
  // The exit code, and what is on standard error.
  const auto run = [] (const std::function<int()>& body) {
    testing::internal::CaptureStderr();
    const int code = runProgram ("detect", body);
    return std::to_string (code) + " " + testing::internal::GetCapturedStderr();
  };
  const auto warned = [] {
    warn ("a.pcd: is\nodd");
    return ExitCode::done;
  };
  EXPECT_EQ (run ([] { return ExitCode::done; }), "0 ");
  EXPECT_EQ (run (warned), "0 detect: a.pcd: is odd\n") << "the program goes on";
  EXPECT_EQ (run ([] () -> int { throw UsageError ("--k", "is odd"); }),
             "2 detect: --k: is odd\n");
  EXPECT_EQ (run ([] () -> int { throw WorkError ("a.pcd", "is\nempty"); }),
             "1 detect: a.pcd: is empty\n");
  EXPECT_EQ (run ([] () -> int { throw std::bad_alloc(); }),
             "1 detect: not enough memory; try a smaller cloud\n");
}

TEST (Program, SaysWhatItNeedsMoreMemoryFor)
{
  const auto complaint = [] (const std::function<int()>& work) {
    return complaintOf ([&] { inMemory ("a.pcd", "give less", work); });
  };
  EXPECT_EQ (inMemory ("a.pcd", "give less", [] { return 7; }), 7);
  EXPECT_EQ (complaint ([] () -> int { throw std::bad_alloc(); }),
             "a.pcd: needs more memory than there is; give less");
  EXPECT_EQ (complaint ([] () -> int { throw std::length_error ("vector"); }),
             "a.pcd: needs more memory than there can be; give less");
  EXPECT_EQ (complaint ([] () -> int { throw WorkError ("b.pcd", "is odd"); }),
             "b.pcd: is odd");
}

namespace {

/** \brief Has EXPECT_EXIT run its statement in a newly started process instead of a
 * fork of this one, which would lack this program's other threads. */
class InterruptedProgram : public testing::Test {
protected:
  InterruptedProgram() { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
};

} // namespace

TEST_F (InterruptedProgram, GoesOnAfterTwoSignalsAtOnce)
{
  const auto interrupted_twice = [] { // as timeout sends them
    noteInterruptions();
    std::raise (SIGTERM);
    std::raise (SIGTERM);
    std::exit (isInterrupted() ? 0 : 1);
  };
  EXPECT_EXIT (interrupted_twice(), testing::ExitedWithCode (0), "");
}

TEST_F (InterruptedProgram, IsEndedByALaterSignal)
{
  const auto interrupted_again = [] {
    noteInterruptions();
    // Until a signal comes more than half a second after the first, and ends the
    // program.
    while (true)
      std::raise (SIGINT);
  };
  EXPECT_EXIT (interrupted_again(), testing::KilledBySignal (SIGINT), "");
}

TEST_F (InterruptedProgram, EndsByTheSignalThatInterruptedIt)
{
  const auto ended = [] {
    noteInterruptions();
    std::raise (SIGTERM);
    endAsInterrupted();
    std::exit (0);
  };
  EXPECT_EXIT (ended(), testing::KilledBySignal (SIGTERM), "");
}
