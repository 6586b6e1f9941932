// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tiles_program.h"

#include <chrono>
#include <fstream>

namespace {

/** \brief Ends a program at one of its writes. */
std::string
killedAt (int write)
{
  return "env LD_PRELOAD='" PCL_OPS_FAILING_CALLS "' KILLED_AT_WRITE=" +
         std::to_string (write);
}

/** \brief There when all inputs are sorted into cells. */
const std::string sorted = "out/work/cells/3.cells";

class TilesRestart : public Tiles {
protected:
  /** \brief What a run that nobody stopped writes. */
  std::map<std::string, std::size_t>
  undisturbed () const
  {
    makeTown ("--points 20000 --tiles 4");
    expectDone ("town --output-dir whole --tile 40");
    return outputsIn ("whole");
  }

  /** \brief Leaves a run in the folder out that was stopped once a file was there. */
  void
  stopOnce (const std::string& file, const std::string& options) const
  {
    for (int write = 1; !std::filesystem::exists (folder_ / file); ++write)
      ASSERT_NE (run ("town --output-dir out " + options, killedAt (write)).exit_code,
                 0);
  }

  /** \brief When each file of a folder was written, by its name. */
  std::map<std::string, std::filesystem::file_time_type>
  timesIn (const std::string& folder) const
  {
    std::map<std::string, std::filesystem::file_time_type> times;
    for (const auto& file : std::filesystem::directory_iterator (folder_ / folder))
      if (file.path().extension() == ".cells")
        times[file.path().filename().string()] = file.last_write_time();
    return times;
  }
};

TEST_F (TilesRestart, AfterBeingKilledAgainAndAgainGivesTheSameBytes)
{
  const auto expected = undisturbed();
  int kills = 0;
  // Each time a little farther: in every phase, before and behind its first file.
  for (int write = 1;
       run ("town --output-dir out --tile 40", killedAt (write)).exit_code != 0;
       ++write)
    ASSERT_LT (++kills, 200);
  constexpr int phases = 5;
  EXPECT_GT (kills, 2 * phases);
  EXPECT_EQ (outputsIn ("out"), expected);
}

TEST_F (TilesRestart, DoesNotDoAgainWhatIsDone)
{
  const auto expected = undisturbed();
  stopOnce ("out/work/planes/numbers", "--tile 40");
  const std::string cells = folder_ / "out/work/cells/0.cells";
  const auto before = timesIn ("out/work/cells");
  // At a write at which some inputs would be sorted, were they sorted again.
  ASSERT_NE (run ("town --output-dir out --tile 40", killedAt (8)).exit_code, 0);
  EXPECT_EQ (timesIn ("out/work/cells"), before);
  expectDone ("town --output-dir out --tile 40");
  EXPECT_EQ (outputsIn ("out"), expected);
  EXPECT_FALSE (std::filesystem::exists (cells)) << "no longer needed";
  std::filesystem::remove (folder_ / "out/town_000_000.las");
  expectDone ("town --output-dir out --tile 40");
  EXPECT_EQ (outputsIn ("out"), expected) << "an output was removed";
}

TEST_F (TilesRestart, NamesAFileOfItsOwnThatIsDamaged)
{
  const auto expected = undisturbed();
  stopOnce ("out/work/planes/numbers", "--tile 40");
  const std::filesystem::path planes = folder_ / "out/work/planes";
  const std::string numbers = contentOf (planes / "numbers");
  const std::string mend = ": is damaged; remove its folder and run it again\n";
  const std::string all_set (sizeof (std::uint64_t), '\xff');
  // One tile fewer; one tile that is another; more numbers than there are bytes.
  const std::pair<std::size_t, std::string> damages[] = {
      {0, std::string (8, '\0')}, {8, all_set}, {24, all_set}};
  for (const auto& [place, bytes] : damages) {
    folder_.write ("out/work/planes/numbers",
                   std::string (numbers).replace (place, bytes.size(), bytes));
    expectRefused ("town --output-dir out --tile 40",
                   "out/work/planes/numbers" + mend.substr (0, mend.size() - 1));
  }
  folder_.write ("out/work/planes/numbers", numbers);
  for (const auto& file : std::filesystem::directory_iterator (planes)) {
    if (file.path().extension() != ".labels")
      continue;
    const std::string labels = contentOf (file.path());
    std::ofstream (file.path(), std::ios::binary)
        << labels.substr (0, labels.size() / 2)
        << std::string (labels.size() - labels.size() / 2, '\x7f');
  }
  const Outcome done = run ("town --output-dir out --tile 40");
  EXPECT_EQ (done.exit_code, 1);
  EXPECT_TRUE (contains (done.err, ".labels" + mend));
}

TEST_F (TilesRestart, LabelsAgainWhatWasRemoved)
{
  const auto expected = undisturbed();
  stopOnce ("out/work/labelled/0", "--tile 40");
  for (const auto& [name, content] : outputsIn ("out"))
    std::filesystem::remove (folder_ / ("out/" + name));
  expectDone ("town --output-dir out --tile 40");
  EXPECT_EQ (outputsIn ("out"), expected);
}

TEST_F (TilesRestart, GoesOnWithItsOwnPlanOnly)
{
  const auto expected = undisturbed();
  stopOnce (sorted, "--tile 40 --plan a.json");
  expectRefused ("town --output-dir out --tile 30 --plan b.json",
                 "out/work/plan.json: is the plan of another run (--tile was another "
                 "one); remove its folder or give another --output-dir");
  const auto before = timesIn ("out/work/cells");
  ASSERT_NE (run ("town --output-dir out --plan a.json", killedAt (2)).exit_code, 0);
  EXPECT_EQ (timesIn ("out/work/cells"), before);
  expectDone ("town --output-dir out --tile 40 --plan a.json");
  EXPECT_EQ (outputsIn ("out"), expected);
}

TEST_F (TilesRestart, StartsAnewOnceThePlanWasRemoved)
{
  const auto expected = undisturbed();
  stopOnce (sorted, "--tile 30");
  std::filesystem::remove (folder_ / "out/work/plan.json");
  expectDone ("town --output-dir out --tile 40");
  EXPECT_EQ (outputsIn ("out"), expected) << "what a stopped run left was taken";
  std::filesystem::remove (folder_ / "out/work/plan.json");
  expectDone ("town --output-dir out --cell 3 --plan a.json");
  EXPECT_EQ (listIn ("out").at ("cell"), 3) << "the end of another run was taken";
}

TEST_F (TilesRestart, LeavesTheFolderToTheRunThatWorksInIt)
{
  const auto expected = undisturbed();
  std::filesystem::create_directory (folder_ / "out");
  expectRefused ("town --output-dir out --tile 40",
                 "out: another run works in it; wait until it has ended, or give "
                 "another --output-dir",
                 1,
                 "flock out");
  expectDone ("town --output-dir out --tile 40");
  EXPECT_EQ (outputsIn ("out"), expected);
}

#ifdef PCL_OPS_MPIEXEC

std::string
ranks (int number)
{
  return "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
         "'" PCL_OPS_MPIEXEC "' --oversubscribe -n " +
         std::to_string (number);
}

TEST_F (TilesRestart, GivesTheSameBytesForAnyNumberOfRanks)
{
  const auto expected = undisturbed();
  for (const int number : {1, 2, 3, 4, 8}) {
    const std::string out = "out" + std::to_string (number);
    expectDone ("town --tile 40 --output-dir " + out, ranks (number));
    EXPECT_EQ (outputsIn (out), expected) << number << " ranks";
  }
}

TEST_F (TilesRestart, ARankThatIsLostEndsTheRunSoonAndTheNextOneGoesOn)
{
  const auto expected = undisturbed();
  const auto start = std::chrono::steady_clock::now();
  const std::string program =
      "'" PCL_OPS_TILES_PROGRAM "' town --tile 40 --output-dir out";
  const Outcome lost =
      shell (ranks (1) + " " + program + " : -n 1 " + killedAt (3) + " " + program);
  EXPECT_NE (lost.exit_code, 0);
  EXPECT_FALSE (std::filesystem::exists (folder_ / "out/planes.json"));
  EXPECT_LT (std::chrono::steady_clock::now() - start, std::chrono::seconds (20));
  expectDone ("town --tile 40 --output-dir out", ranks (2));
  EXPECT_EQ (outputsIn ("out"), expected);
}

TEST_F (TilesRestart, OneRankOfSeveralSaysWhatIsWrong)
{
  const Outcome done = run ("missing.las --output-dir out", ranks (2));
  EXPECT_NE (done.exit_code, 0);
  const std::string complaint = "pcl_ops_tiles: missing.las: does not exist";
  const auto first = done.err.find (complaint);
  EXPECT_NE (first, std::string::npos) << done.err;
  EXPECT_EQ (done.err.find (complaint, first + 1), std::string::npos) << "said twice";
}

#endif

} // namespace
