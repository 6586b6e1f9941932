// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <support/program_folder.h>

#include <algorithm>
#include <csignal>
#include <map>

namespace {

#ifndef PCL_OPS_MPIEXEC
#define PCL_OPS_MPIEXEC ""
#endif

namespace fs = std::filesystem;

const std::string tiles = "pcl_ops_tiles town --output-dir out --tile 40";

/** \brief A simulated town of four files, and the folder "whole" of a run that was not
 * stopped. */
class TilesRestart : public ProgramFolder {
protected:
  static constexpr int max_writes = 200;                 // a run has fewer
  static constexpr int code_when_killed = 128 + SIGKILL; // as of the shell

  TilesRestart() : ProgramFolder (PCL_OPS_TILES_PROGRAM)
  {
    expectSuccess ("pcl_ops_simulate town --scene town --points 20000 --tiles 4");
    expectSuccess ("pcl_ops_tiles town --output-dir whole --tile 40");
  }

  void
  expectSuccess (const std::string& command) const
  {
    const Outcome done = shell (command);
    EXPECT_EQ (done.exit_code, 0) << command << '\n' << done.err;
  }

  void
  expectFailure (const std::string& command, const std::string& complaint) const
  {
    const Outcome done = shell (command);
    EXPECT_EQ (done.exit_code, 1) << command;
    EXPECT_TRUE (contains (done.err, complaint));
  }

  /** \brief A command that runs \p command and kills it before its n-th write to a
   * file, from 1 on (failing_calls.cpp). */
  static std::string
  killedAt (int write, const std::string& command)
  {
    return "env LD_PRELOAD='" PCL_OPS_FAILING_CALLS "' KILLED_AT_WRITE=" +
           std::to_string (write) + " " + command;
  }

  /** \brief Runs a command without the folder "out", and kills it soon after \p file is
   * there. Trials tell at which write to kill it. */
  void
  stopOnceThereIs (const std::string& file, const std::string& command) const
  {
    constexpr int uncertain = 2; // writes, as threads write in another order each time
    static std::map<std::string, int> writes; // about the same in all tests
    int& first = writes[command + " > " + file];
    if (first == 0)
      first = firstWrite ([&] (int write) {
        return hasEndedAt (write, command) || fs::exists (folder_ / file);
      });
    int write = std::max (1, first - uncertain);
    while (write < max_writes &&
           (hasEndedAt (write, command) || !fs::exists (folder_ / file)))
      ++write;
    ASSERT_LT (write, max_writes) << file;
  }

  /** \brief Removes the folder "out" and runs a command, which is killed before the
   * n-th write. Returns whether the command succeeds, because it has fewer writes. */
  bool
  hasEndedAt (int write, const std::string& command) const
  {
    fs::remove_all (folder_ / "out");
    return shell (killedAt (write, command)).exit_code == 0;
  }

  /** \brief The first write that is late enough, by bisection; max_writes or more if
   * none below that is. All later writes must be late enough, too. */
  template <typename IsLateEnough>
  static int
  firstWrite (const IsLateEnough& is_late_enough)
  {
    int after = 1;
    while (after < max_writes && !is_late_enough (after))
      after *= 2;
    for (int before = after / 2; after - before > 1;) {
      const int middle = (before + after) / 2;
      (is_late_enough (middle) ? after : before) = middle;
    }
    return after;
  }

  /** \brief When each file of points of cells (.cells) was written. */
  std::map<std::string, fs::file_time_type>
  timesOfCells () const
  {
    std::map<std::string, fs::file_time_type> times;
    for (const fs::directory_entry& entry :
         fs::directory_iterator (folder_ / "out/work/cells"))
      if (entry.path().extension() == ".cells")
        times[entry.path().string()] = entry.last_write_time();
    return times;
  }

  /** \brief Overwrites bytes of all files in out/work/planes with an extension.
   * \param[in] position of the first of these bytes in each file */
  void
  overwrite (const std::string& extension,
             std::streamoff position,
             const std::string& bytes) const
  {
    for (const fs::directory_entry& entry :
         fs::directory_iterator (folder_ / "out/work/planes")) {
      if (entry.path().extension() != extension)
        continue;
      std::fstream file (entry.path(), std::ios::binary | std::ios::in | std::ios::out);
      file.seekp (position);
      file << bytes;
    }
  }

  /** \brief Fails unless a folder has the same files with the same bytes as "whole".
   * Files whose names begin with a dot do not count: a killed run was writing them. */
  void
  expectSameAsWhole (const std::string& folder = "out") const
  {
    const Outcome done = shell ("diff -r -x '.*' whole " + folder);
    EXPECT_EQ (done.exit_code, 0) << done.out;
  }
};

/** \brief \ref TilesRestart with several processes (ranks of MPI). */
class TilesRanks : public TilesRestart {
protected:
  void
  SetUp () override
  {
    if (*PCL_OPS_MPIEXEC == '\0')
      GTEST_SKIP() << "needs MPI";
  }

  static std::string
  byRanks (int ranks, const std::string& command)
  {
    return "env OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1 "
           "'" PCL_OPS_MPIEXEC "' --oversubscribe -n " +
           std::to_string (ranks) + " " + withPathOfShell (command);
  }

  /** \brief A command that finds programs as the shell does. Open MPI, started by its
   * full path, looks for them beside itself first, where others may be installed. */
  static std::string
  withPathOfShell (const std::string& command)
  {
    return "env PATH=\"$PATH\" " + command;
  }
};

} // namespace

TEST_F (TilesRestart, KilledAgainAndAgainALittleLaterEndsWithTheSameBytes)
{
  int write = 1;
  while (write < max_writes && shell (killedAt (write, tiles)).exit_code != 0)
    ++write;
  EXPECT_LT (write, max_writes) << "has never ended";
  EXPECT_GT (write, 11) << "is killed before and behind the first file of five phases";
  expectSameAsWhole();
}

TEST_F (TilesRestart, KeepsWhatIsDone)
{
  stopOnceThereIs ("out/work/planes/planes.json", tiles);
  const auto before = timesOfCells();
  EXPECT_FALSE (before.empty());
  EXPECT_EQ (shell (killedAt (5, tiles)).exit_code, code_when_killed);
  EXPECT_EQ (timesOfCells(), before);
  expectSuccess (tiles);
  expectSameAsWhole();
}

TEST_F (TilesRestart, RemovesItsCellsAtTheEnd)
{
  stopOnceThereIs ("out/work/cells/3.cells", tiles);
  expectSuccess (tiles);
  EXPECT_FALSE (fs::exists (folder_ / "out/work/cells/3.cells")) << "of the last input";
}

TEST_F (TilesRestart, WritesAFileThatWasRemovedFromAFinishedRunAgain)
{
  expectSuccess (tiles);
  fs::remove (folder_ / "out/town_000_000.las");
  expectSuccess (tiles);
  expectSameAsWhole();
}

TEST_F (TilesRestart, WritesFilesThatWereRemovedFromAStoppedRunAgain)
{
  stopOnceThereIs ("out/work/labelled/0", tiles);
  expectSuccess ("rm out/*.las");
  expectSuccess (tiles);
  expectSameAsWhole();
}

TEST_F (TilesRestart, NamesAFileThatClaimsMoreNumbersThanItsBytes)
{
  stopOnceThereIs ("out/work/planes/planes.json", tiles);
  overwrite (".numbers", 0, std::string (8, '\377')); // how many numbers follow
  expectFailure (tiles, ".numbers: is damaged; remove its folder and run it again\n");
}

TEST_F (TilesRestart, NamesAFileOfLabelsWithoutAPlane)
{
  stopOnceThereIs ("out/work/planes/planes.json", tiles);
  overwrite (".labels", 4, std::string (4, '\177')); // the second label
  expectFailure (tiles, ".labels: is damaged; remove its folder and run it again\n");
}

TEST_F (TilesRestart, NamesAFileOfCellsTooShortForItsIndex)
{
  stopOnceThereIs ("out/work/planes/planes.json", tiles);
  folder_.write ("out/work/cells/0.cells", "1234");
  expectFailure (tiles, ".cells: is damaged; remove its folder and run it again\n");
}

TEST_F (TilesRestart, RefusesTheOptionsOfAnotherPlan)
{
  stopOnceThereIs ("out/work/cells/3.cells", tiles + " --plan a.json");
  expectFailure (
      "pcl_ops_tiles town --output-dir out --tile 30 --plan b.json",
      "pcl_ops_tiles: out/work/plan.json: is the plan of another run (--tile "
      "was another one); remove its folder or give another --output-dir\n");
}

TEST_F (TilesRestart, GoesOnWithItsOwnPlan)
{
  stopOnceThereIs ("out/work/cells/3.cells", tiles + " --plan a.json");
  const auto before = timesOfCells();
  EXPECT_EQ (shell (killedAt (2, "pcl_ops_tiles town --output-dir out --plan a.json"))
                 .exit_code,
             code_when_killed);
  EXPECT_EQ (timesOfCells(), before);
  expectSuccess (tiles + " --plan a.json");
  expectSameAsWhole();
}

TEST_F (TilesRestart, StartsAnewWithoutItsPlan)
{
  // Else the results of the run with tiles of 30 m would be used.
  stopOnceThereIs ("out/work/cells/3.cells",
                   "pcl_ops_tiles town --output-dir out --tile 30");
  fs::remove (folder_ / "out/work/plan.json");
  expectSuccess (tiles);
  expectSameAsWhole();
}

TEST_F (TilesRestart, StartsAnewWithAnotherSizeOfVoxelsWithoutItsPlan)
{
  expectSuccess (tiles);
  fs::remove (folder_ / "out/work/plan.json");
  expectSuccess ("pcl_ops_tiles town --output-dir out --voxel-size 3");
  EXPECT_TRUE (
      contains (contentOf (folder_ / "out/planes.json"), "\"voxel_size\": 3.0,"));
}

TEST_F (TilesRestart, LeavesAFolderToTheRunThatWorksInIt)
{
  fs::create_directory (folder_ / "out");
  expectFailure (
      "flock out " + tiles,
      "pcl_ops_tiles: out: another run works in it; wait until it has ended, "
      "or give another --output-dir\n");
  expectSuccess (tiles);
  expectSameAsWhole();
}

TEST_F (TilesRanks, WriteTheSameBytesWhateverTheirNumber)
{
  for (const int ranks : {1, 2, 3, 4, 8}) {
    SCOPED_TRACE (ranks);
    const std::string folder = "ranks" + std::to_string (ranks);
    expectSuccess (
        byRanks (ranks, "pcl_ops_tiles town --tile 40 --output-dir " + folder));
    expectSameAsWhole (folder);
  }
}

TEST_F (TilesRanks, EndSoonAfterOneIsLostAndTheNextRunGoesOn)
{
  constexpr int code_of_timeout = 124;
  const Outcome done = shell ("timeout 20 " + byRanks (1, tiles) + " : -n 1 " +
                              withPathOfShell (killedAt (3, tiles)));
  EXPECT_NE (done.exit_code, 0);
  EXPECT_NE (done.exit_code, code_of_timeout);
  EXPECT_FALSE (fs::exists (folder_ / "out/planes.json"));
  expectSuccess (byRanks (2, tiles));
  expectSameAsWhole();
}

TEST_F (TilesRanks, SayOnceWhatIsWrong)
{
  const Outcome done =
      shell (byRanks (2, "pcl_ops_tiles missing.las --output-dir out"));
  EXPECT_NE (done.exit_code, 0);
  const std::string complaint = "pcl_ops_tiles: missing.las: does not exist";
  const std::size_t first = done.err.find (complaint);
  EXPECT_NE (first, std::string::npos) << done.err;
  EXPECT_EQ (done.err.find (complaint, first + 1), std::string::npos) << done.err;
}
