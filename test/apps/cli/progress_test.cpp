// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/progress.h>
#include <support/temporary_folder.h>
#include <sys/stat.h>

#include <atomic>
#include <sstream>
#include <stdexcept>
#include <vector>

using namespace pcl_ops::apps;

namespace {

// Least times from one message to the next.
constexpr std::chrono::milliseconds seldom = std::chrono::seconds (10), always{0};
/** \brief The characters that erase the current line of a terminal. */
const std::string erased = "\r\033[K";

/** \brief The output of a run that would have two steps, but ends after \p steps of
 * them and a note.
 * \param[in] between least time from one message to the next */
std::string
saidAfter (int steps, ProgressStyle style, std::chrono::milliseconds between = seldom)
{
  std::ostringstream stream;
  {
    Progress progress (2, stream, style, "tiles", between);
    for (int i = 0; i < steps; ++i)
      progress.step();
    progress.note ("a.pcd: done");
  }
  return stream.str();
}

} // namespace

TEST (Progress, SaysHowFarItIsInAWayThatFitsTheStream)
{
  using Style = ProgressStyle;
  const std::string note = "a.pcd: done\n";
  const std::string half = "1 of 2 tiles, 50 %, 0 s left";
  const std::string half_bar = std::string (15, '=') + std::string (15, ' ');
  const std::string bar = erased + "[" + half_bar + "] " + half;
  EXPECT_EQ (saidAfter (1, Style::Bar), bar + erased + note + bar + erased)
      << "drawn again below the note, and erased as the run ends before it is full";
  EXPECT_EQ (saidAfter (2, Style::Lines, always),
             half + "\n2 of 2 tiles, 100 %, took 0 s\n" + note);
  EXPECT_EQ (saidAfter (2, Style::Lines), note) << "soon done";
  EXPECT_EQ (saidAfter (2, Style::None, always), note);
}

TEST (StageLines, TellTheStageOnceInAWhile)
{
  const TemporaryFolder folder;
  const std::string pipe = folder / "terminal";
  ASSERT_EQ (::mkfifo (pipe.c_str(), 0600), 0);
  std::fstream reader (pipe);
  std::ofstream terminal (pipe);
  StageLines lines (terminal, std::chrono::milliseconds (1));
  lines.begin ("a.pcd: finding planes");
  std::string line;
  while (line != "a.pcd: finding planes, 0 s so far") // or the test times out
    ASSERT_TRUE (std::getline (reader, line));
}

TEST (StageLines, AreSilentWhereTheStageEndsFirst)
{
  std::ostringstream terminal;
  StageLines lines (terminal);
  lines.begin ("a.pcd: reading");
  lines.end();
  EXPECT_EQ (terminal.str(), "");
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
