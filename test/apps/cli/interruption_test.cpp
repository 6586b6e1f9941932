// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/interruption.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <thread>

using namespace pcl_ops::apps;

namespace {

/** \brief Each test signals a process of its own. */
class Interruption : public testing::Test {
protected:
  void
  SetUp () override
  {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
  }
};

} // namespace

TEST_F (Interruption, IsOneForTwoSignalsAtOnce)
{
  // As timeout sends them.
  const auto interrupted_twice = [] {
    noteInterruptions();
    std::raise (SIGTERM);
    std::raise (SIGTERM);
    std::exit (isInterrupted() ? 0 : 1);
  };
  EXPECT_EXIT (interrupted_twice(), testing::ExitedWithCode (0), "");
}

TEST_F (Interruption, ThatIsRepeatedEndsTheProgramAsEver)
{
  const auto interrupted_again = [] {
    noteInterruptions();
    std::raise (SIGINT);
    std::this_thread::sleep_for (std::chrono::milliseconds (600));
    std::raise (SIGINT);
    std::exit (0);
  };
  EXPECT_EXIT (interrupted_again(), testing::KilledBySignal (SIGINT), "");
}

TEST_F (Interruption, EndsAsTheSignalWouldHave)
{
  const auto interrupted = [] {
    noteInterruptions();
    std::raise (SIGTERM);
    endAsInterrupted();
    std::exit (0);
  };
  EXPECT_EXIT (interrupted(), testing::KilledBySignal (SIGTERM), "");
}
