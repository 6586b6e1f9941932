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

// Shortest times from one line to the next. No test lasts as long as the first.
constexpr std::chrono::milliseconds longer_than_a_test = std::chrono::seconds (10);
constexpr std::chrono::milliseconds no_time{0};
/** \brief The characters that erase the current line of a terminal. */
const std::string erase_line = "\r\033[K";

/** \brief The output of a run of two steps that does only the first \p steps of them,
 * writes a note and ends.
 * \param[in] between shortest time from one line to the next */
std::string
outputAfter (int steps,
             ProgressStyle style,
             std::chrono::milliseconds between = longer_than_a_test)
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

TEST (Progress, IsABarOrLinesOrNothing)
{
  using Style = ProgressStyle;
  const std::string note = "a.pcd: done\n";
  const std::string half_done = "1 of 2 tiles, 50 %, 0 s left";
  const std::string half_bar = std::string (15, '=') + std::string (15, ' ');
  const std::string bar = erase_line + "[" + half_bar + "] " + half_done;
  EXPECT_EQ (outputAfter (1, Style::Bar), bar + erase_line + note + bar + erase_line)
      << "the bar is drawn again below the note, and erased at the end";
  EXPECT_EQ (outputAfter (2, Style::Lines, no_time),
             half_done + "\n2 of 2 tiles, 100 %, took 0 s\n" + note);
  EXPECT_EQ (outputAfter (2, Style::Lines), note)
      << "done before it is time for a line";
  EXPECT_EQ (outputAfter (2, Style::None, no_time), note);
}

TEST (StageLines, SayTheStageAndItsTime)
{
  const TemporaryFolder folder;
  // Reading from a pipe waits until another thread has written a line.
  const std::string pipe = folder / "terminal";
  ASSERT_EQ (::mkfifo (pipe.c_str(), 0600), 0);
  // Also open for writing: else opening would wait for the other end of the pipe.
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

TEST (DurationText, IsInTheUnitsThatSuitTheDuration)
{
  EXPECT_EQ (durationText (42.4), "42 s");
  EXPECT_EQ (durationText (187), "3 min 07 s");
  EXPECT_EQ (durationText (7500), "2 h 05 min");
}

TEST (RunInParallel, DoesEachPieceOfWorkOnce)
{
  constexpr unsigned all_processors = 0;
  for (const unsigned jobs : {all_processors, 1U, 3U, 100U}) {
    std::vector<std::atomic<int>> calls (10);
    runInParallel (calls.size(), jobs, [&] (std::size_t i) { ++calls[i]; });
    for (const std::atomic<int>& count : calls)
      EXPECT_EQ (count, 1) << jobs;
  }
}

TEST (RunInParallel, PassesOnWhatTheWorkThrows)
{
  const auto failAtThirdCall = [] (std::size_t i) {
    if (i == 2)
      throw std::runtime_error ("third");
  };
  constexpr std::size_t calls = 5;
  constexpr unsigned jobs = 2;
  EXPECT_THROW (runInParallel (calls, jobs, failAtThirdCall), std::runtime_error);
}
