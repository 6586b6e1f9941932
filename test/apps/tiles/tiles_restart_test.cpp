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
    for (int write = 1; !fs::exists (folder_ / file); ++write)
      ASSERT_NE (run ("town --output-dir out " + options, killedAt (write)).exit_code,
                 0);
  }

  /** \brief When each file of a folder was written, by its name. */
  std::map<std::string, fs::file_time_type>
  timesIn (const std::string& folder) const
  {
    std::map<std::string, fs::file_time_type> times;
    for (const auto& file : fs::directory_iterator (folder_ / folder))
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
  stopOnce (joined, "--tile 40");
  const std::string cells = folder_ / "out/work/cells/0.cells";
  const auto before = timesIn ("out/work/cells");
  // At a write at which some inputs would be sorted, were they sorted again.
  ASSERT_NE (run ("town --output-dir out --tile 40", killedAt (8)).exit_code, 0);
  EXPECT_EQ (timesIn ("out/work/cells"), before);
  expectDone ("town --output-dir out --tile 40");
  EXPECT_EQ (outputsIn ("out"), expected);
  EXPECT_FALSE (fs::exists (cells)) << "no longer needed";
  fs::remove (folder_ / "out/town_000_000.las");
  expectDone ("town --output-dir out --tile 40");
  EXPECT_EQ (outputsIn ("out"), expected) << "an output was removed";
}

TEST_F (TilesRestart, NamesAFileOfItsOwnThatIsDamaged)
{
  undisturbed();
  stopOnce (joined, "--tile 40");
  // More numbers than there are bytes, then labels without a plane.
  const std::tuple<const char*, std::size_t, std::string> damages[] = {
      {".numbers", 0, std::string (8, '\xff')}, {".labels", 4, "\x7f\x7f\x7f\x7f"}};
  for (const auto& [extension, place, bytes] : damages) {
    std::map<fs::path, std::string> contents;
    for (const auto& file : fs::directory_iterator (folder_ / "out/work/planes"))
      if (file.path().extension() == extension)
        contents[file.path()] = contentOf (file.path());
    for (const auto& [file, content] : contents)
      std::ofstream (file, std::ios::binary)
          << std::string (content).replace (place, bytes.size(), bytes);
    const Outcome done = run ("town --output-dir out --tile 40");
    EXPECT_EQ (done.exit_code, 1);
    EXPECT_TRUE (contains (
        done.err,
        extension +
            std::string (": is damaged; remove its folder and run it again\n")));
    for (const auto& [file, content] : contents)
      std::ofstream (file, std::ios::binary) << content;
  }
}

TEST_F (TilesRestart, LabelsAgainWhatWasRemoved)
{
  const auto expected = undisturbed();
  stopOnce ("out/work/labelled/0", "--tile 40");
  for (const auto& [name, content] : outputsIn ("out"))
    fs::remove (folder_ / ("out/" + name));
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
  fs::remove (folder_ / "out/work/plan.json");
  expectDone ("town --output-dir out --tile 40");
  EXPECT_EQ (outputsIn ("out"), expected) << "what a stopped run left was taken";
  fs::remove (folder_ / "out/work/plan.json");
  expectDone ("town --output-dir out --cell 3 --plan a.json");
  EXPECT_EQ (listIn ("out").at ("cell"), 3) << "the end of another run was taken";
}

TEST_F (TilesRestart, LeavesTheFolderToTheRunThatWorksInIt)
{
  const auto expected = undisturbed();
  fs::create_directory (folder_ / "out");
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
  EXPECT_FALSE (fs::exists (folder_ / "out/planes.json"));
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
