// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tiles_program.h"

#include <chrono>
#include <fstream>

namespace fs = std::filesystem;

namespace {

/** \brief Ends a program at one of its writes. */
std::string
killedAt (int write)
{
  return "env LD_PRELOAD='" PCL_OPS_FAILING_CALLS "' KILLED_AT_WRITE=" +
         std::to_string (write);
}

/** \brief There when all inputs are sorted into cells, and when planes are joined. */
const std::string sorted = "out/work/cells/3.cells",
                  joined = "out/work/planes/planes.json";

const std::string start = "town --output-dir out --tile 40";

class TilesRestart : public Tiles {
protected:
  TilesRestart()
  {
    makeTown ("--points 20000 --tiles 4");
    expectDone ("town --output-dir whole --tile 40");
    expected_ = outputsIn ("whole");
  }

  /** \brief A run to its end, which gives what one that nobody stopped does. */
  void
  expectWhole (const std::string& arguments = start,
               const std::string& before = "") const
  {
    expectDone (arguments, before);
    EXPECT_EQ (outputsIn ("out"), expected_);
  }

  /** \brief Leaves a run in the folder out that was stopped once a file was there. */
  void
  stopOnce (const std::string& file, const std::string& arguments = start) const
  {
    for (int write = 1; !fs::exists (folder_ / file); ++write)
      ASSERT_NE (run (arguments, killedAt (write)).exit_code, 0);
  }

  /** \brief A run that is stopped at a write at which some inputs would be sorted, were
   * they sorted again. */
  void
  expectNotSortedAgain (const std::string& arguments, int write) const
  {
    const auto times = [this] {
      std::map<std::string, fs::file_time_type> all;
      for (const auto& file : fs::directory_iterator (folder_ / "out/work/cells"))
        if (file.path().extension() == ".cells")
          all[file.path().string()] = file.last_write_time();
      return all;
    };
    const auto before = times();
    ASSERT_NE (run (arguments, killedAt (write)).exit_code, 0);
    EXPECT_EQ (times(), before);
  }

  std::map<std::string, std::size_t> expected_;
};

TEST_F (TilesRestart, AfterBeingKilledAgainAndAgainGivesTheSameBytes)
{
  int kills = 0;
  // Each time a little farther: in every phase, before and behind its first file.
  for (int write = 1; run (start, killedAt (write)).exit_code != 0; ++write)
    ASSERT_LT (++kills, 200);
  constexpr int phases = 5;
  EXPECT_GT (kills, 2 * phases);
  EXPECT_EQ (outputsIn ("out"), expected_);
}

TEST_F (TilesRestart, DoesNotDoAgainWhatIsDone)
{
  stopOnce (joined);
  expectNotSortedAgain (start, 8);
  expectWhole();
  EXPECT_FALSE (fs::exists (folder_ / sorted)) << "no longer needed";
  fs::remove (folder_ / "out/town_000_000.las");
  expectWhole();
}

TEST_F (TilesRestart, NamesAFileOfItsOwnThatIsDamaged)
{
  stopOnce (joined);
  // More numbers than there are bytes, then labels without a plane.
  const std::tuple<const char*, std::size_t, std::string> damages[] = {
      {".numbers", 0, std::string (8, '\xff')}, {".labels", 4, "\x7f\x7f\x7f\x7f"}};
  fs::rename (folder_ / "out", folder_ / "stopped");
  for (const auto& [extension, place, bytes] : damages) {
    fs::remove_all (folder_ / "out");
    fs::copy (folder_ / "stopped", folder_ / "out", fs::copy_options::recursive);
    for (const auto& file : fs::directory_iterator (folder_ / "out/work/planes"))
      if (file.path().extension() == extension)
        folder_.write (file.path(),
                       contentOf (file.path()).replace (place, bytes.size(), bytes));
    const Outcome done = run (start);
    EXPECT_EQ (done.exit_code, 1);
    EXPECT_TRUE (contains (
        done.err,
        extension +
            std::string (": is damaged; remove its folder and run it again\n")));
  }
}

TEST_F (TilesRestart, LabelsAgainWhatWasRemoved)
{
  stopOnce ("out/work/labelled/0");
  for (const auto& [name, content] : outputsIn ("out"))
    fs::remove (folder_ / ("out/" + name));
  expectWhole();
}

TEST_F (TilesRestart, GoesOnWithItsOwnPlanOnly)
{
  stopOnce (sorted, start + " --plan a.json");
  expectRefused ("town --output-dir out --tile 30 --plan b.json",
                 "out/work/plan.json: is the plan of another run (--tile was another "
                 "one); remove its folder or give another --output-dir");
  expectNotSortedAgain ("town --output-dir out --plan a.json", 2);
  expectWhole (start + " --plan a.json");
}

TEST_F (TilesRestart, StartsAnewOnceThePlanWasRemoved)
{
  stopOnce (sorted, "town --output-dir out --tile 30");
  fs::remove (folder_ / "out/work/plan.json");
  expectWhole();
  fs::remove (folder_ / "out/work/plan.json");
  expectDone ("town --output-dir out --cell 3 --plan a.json");
  EXPECT_EQ (listIn ("out").at ("cell"), 3) << "the end of another run was taken";
}

TEST_F (TilesRestart, LeavesTheFolderToTheRunThatWorksInIt)
{
  fs::create_directory (folder_ / "out");
  expectRefused (start,
                 "out: another run works in it; wait until it has ended, or give "
                 "another --output-dir",
                 1,
                 "flock out");
  expectWhole();
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
  for (const int number : {1, 2, 3, 4, 8}) {
    SCOPED_TRACE (number);
    fs::remove_all (folder_ / "out");
    expectWhole (start, ranks (number));
  }
}

TEST_F (TilesRestart, ARankThatIsLostEndsTheRunSoonAndTheNextOneGoesOn)
{
  const auto begin = std::chrono::steady_clock::now();
  const std::string program = "'" PCL_OPS_TILES_PROGRAM "' " + start;
  const Outcome lost =
      shell (ranks (1) + " " + program + " : -n 1 " + killedAt (3) + " " + program);
  EXPECT_NE (lost.exit_code, 0);
  EXPECT_FALSE (fs::exists (folder_ / "out/planes.json"));
  EXPECT_LT (std::chrono::steady_clock::now() - begin, std::chrono::seconds (20));
  expectWhole (start, ranks (2));
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
