// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/progress.h>
#include <support/text.h>

#include <atomic>
#include <future>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

using namespace pcl_ops::apps;

namespace {

/** \brief Says when a text has been written to it. */
class WatchedBuffer : public std::stringbuf {
public:
  explicit WatchedBuffer (std::string awaited) : awaited_ (std::move (awaited)) {}

  void
  wait ()
  {
    written_.get_future().wait();
  }

private:
  int
  sync () override
  {
    if (!is_written_ && str().find (awaited_) != std::string::npos) {
      is_written_ = true;
      written_.set_value();
    }
    return 0;
  }

  std::string awaited_;
  bool is_written_ = false;
  std::promise<void> written_;
};

} // namespace

TEST (Progress, EstimatesTheTimeLeftOnATerminal)
{
  std::ostringstream stream;
  Progress progress (4, stream, ProgressStyle::Bar);
  progress.step();
  EXPECT_NE (stream.str().find ("1 of 4 clouds, 25 %, 0 s left"), std::string::npos);
}

TEST (Progress, DrawsTheBarAnewBelowALine)
{
  std::ostringstream terminal;
  Progress progress (2, terminal, ProgressStyle::Bar);
  progress.step();
  progress.note ("a.pcd: done");
  const std::string text = terminal.str();
  const std::size_t line = text.find ("\r\033[Ka.pcd: done\n");
  ASSERT_NE (line, std::string::npos) << text;
  EXPECT_TRUE (contains (text.substr (line), "1 of 2 clouds"));
}

TEST (Progress, LeavesNoBarWhereTheRunEndsBefore)
{
  std::ostringstream terminal;
  {
    Progress progress (2, terminal, ProgressStyle::Bar);
    progress.step();
  }
  const std::string text = terminal.str(), erased = "\r\033[K";
  EXPECT_EQ (text.substr (text.size() - erased.size()), erased);
}

TEST (Progress, SaysNothingWhereNoneIsAskedFor)
{
  std::ostringstream stream;
  Progress progress (2, stream, ProgressStyle::None);
  progress.step();
  progress.step();
  progress.erase();
  EXPECT_EQ (stream.str(), "");
}

TEST (StageLines, TellTheStageOnceInAWhile)
{
  WatchedBuffer buffer ("a.pcd: finding planes, 0 s so far\n");
  std::ostream terminal (&buffer);
  StageLines lines (terminal, std::chrono::milliseconds (1));
  lines.begin ("a.pcd: finding planes");
  buffer.wait(); // or the test runs out of its time
}

TEST (StageLines, AreSilentWhereAllIsDoneBefore)
{
  std::ostringstream terminal;
  StageLines lines (terminal);
  lines.begin ("a.pcd: reading");
  lines.end();
  EXPECT_EQ (terminal.str(), "");
}

TEST (Progress, WritesALineOnceInAWhile)
{
  std::ostringstream file;
  Progress progress (
      2, file, ProgressStyle::Lines, "tiles", std::chrono::milliseconds (0));
  progress.step();
  progress.step();
  EXPECT_EQ (file.str(),
             "1 of 2 tiles, 50 %, 0 s left\n2 of 2 tiles, 100 %, took 0 s\n");
}

TEST (Progress, WritesNoLineOfWhatIsDoneSoon)
{
  std::ostringstream file;
  Progress progress (2, file, ProgressStyle::Lines);
  progress.step();
  progress.step();
  EXPECT_EQ (file.str(), "");
}

TEST (Progress, SaysDurationsAsAPersonDoes)
{
  EXPECT_EQ (durationText (42.4), "42 s");
  EXPECT_EQ (durationText (187), "3 min 07 s");
  EXPECT_EQ (durationText (7500), "2 h 05 min");
}

TEST (RunInParallel, DoesEachPieceOfWorkOnce)
{
  for (const unsigned jobs : {0U, 1U, 3U, 100U}) {
    std::vector<std::atomic<int>> calls (10);
    runInParallel (calls.size(), jobs, [&] (std::size_t i) { ++calls[i]; });
    for (const std::atomic<int>& count : calls)
      EXPECT_EQ (count, 1) << jobs;
  }
}

TEST (RunInParallel, PassesOnWhatTheWorkThrows)
{
  const auto fail = [] (std::size_t i) {
    if (i == 2)
      throw std::runtime_error ("third");
  };
  EXPECT_THROW (runInParallel (5, 2, fail), std::runtime_error);
}
