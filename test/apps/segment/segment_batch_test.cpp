// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"

#include <filesystem>
#include <utility>

namespace fs = std::filesystem;

namespace {

/** \brief A folder scans with the clouds a.pcd and b.pcd. */
class SegmentBatch : public Segment {
protected:
  SegmentBatch()
  {
    fs::create_directory (folder_ / "scans");
    addScan ("a.pcd");
    addScan ("b.pcd");
  }

  void
  addScan (const std::string& name) const
  {
    fs::copy_file (folder_ / "in.pcd", folder_ / ("scans/" + name));
  }
};

using Names = std::set<std::string>;

} // namespace

TEST_F (SegmentBatch, LabelsEveryCloudOfAFolderAndListsItsPlanes)
{
  const Outcome done = expectDone ("scans --output-dir out");
  EXPECT_EQ (done.out,
             "scans/a.pcd -> out/a.pcd: 5001 points, 2 planes\n"
             "scans/b.pcd -> out/b.pcd: 5001 points, 2 planes\n");
  EXPECT_EQ (namesIn ("out"), (Names{"a.json", "a.pcd", "b.json", "b.pcd"}));
  LabelledCloud cloud;
  ASSERT_EQ (pcl::io::loadPCDFile (folder_ / "out/b.pcd", cloud), 0);
  EXPECT_EQ (labelsOf (cloud), labelsOf (label ("in.pcd")));
  const auto json = jsonIn ("out/b.json");
  EXPECT_EQ (json["planes"].size(), 2u);
}

TEST_F (SegmentBatch, WritesTheFormatAskedForAndIsSilentWhereAskedToBe)
{
  const Outcome done = expectDone ("scans --output-dir out --format ply --quiet");
  EXPECT_EQ (done.out + done.err, "");
  EXPECT_EQ (namesIn ("out"), (Names{"a.json", "a.ply", "b.json", "b.ply"}));
}

TEST_F (SegmentBatch, LooksIntoNoSubfolderNorAtOtherOrHiddenFiles)
{
  fs::create_directory (folder_ / "scans/deeper");
  addScan ("deeper/c.pcd");
  addScan (".hidden.pcd");
  folder_.write ("scans/notes.txt", "no cloud");
  expectDone ("scans --output-dir out --quiet");
  EXPECT_EQ (namesIn ("out"), (Names{"a.json", "a.pcd", "b.json", "b.pcd"}));
}

TEST_F (SegmentBatch, TakesFilesFoldersAndPatternsAndEachCloudOnce)
{
  const Outcome done =
      expectDone ("in.pcd scans 'scans/[ab].p?d' ./in.pcd --output-dir out");
  EXPECT_EQ (lines (done.out), 3u) << done.out;
  EXPECT_EQ (done.out.find ("in.pcd -> out/in.pcd"), 0u) << done.out;
}

TEST_F (SegmentBatch, GoesOnAfterABadFile)
{
  folder_.write ("scans/aa.pcd", "no cloud");
  folder_.write ("scans/ab.ply", "");
  const Outcome done = run ("scans --output-dir out");
  EXPECT_EQ (done.exit_code, 1);
  EXPECT_EQ (lines (done.out), 2u) << done.out;
  EXPECT_EQ (lines (done.err), 3u) << done.err;
  EXPECT_TRUE (contains (done.err, "pcl_ops_segment: scans/aa.pcd: is no valid PCD"));
  EXPECT_TRUE (contains (done.err, "pcl_ops_segment: scans/ab.ply: is empty"));
  EXPECT_TRUE (contains (done.err, "2 failed: 2 of 4 inputs are done"));
  EXPECT_EQ (namesIn ("out"), (Names{"a.json", "a.pcd", "b.json", "b.pcd"}));
}

TEST_F (SegmentBatch, SaysWhichCloudLooksDamagedAndDoesItAnyway)
{
  InputCloud damaged = floorAndWall();
  for (std::size_t i = points_of_plane; i < damaged.size(); ++i)
    damaged[i].getVector3fMap().setZero();
  pcl::io::savePCDFileBinary (folder_ / "scans/b.pcd", damaged);
  const std::string warning = "pcl_ops_segment: scans/b.pcd: looks damaged: 50 % of "
                              "its points are at (0, 0, 0); "
                              "leave missing readings out or write them as NaN\n";
  for (const char* inputs : {"scans --output-dir out --quiet", "scans/b.pcd b.pcd"}) {
    const Outcome done = expectDone (inputs);
    EXPECT_EQ (done.err, warning);
  }
  EXPECT_EQ (namesIn ("out"), (Names{"a.json", "a.pcd", "b.json", "b.pcd"}));
}

TEST_F (SegmentBatch, SaysWhichNamesStandForNoCloudAndDoesTheOthers)
{
  fs::create_directory (folder_ / "empty");
  const Outcome done = run ("empty 'no*.pcd' gone.pcd in.pcd --output-dir out");
  EXPECT_EQ (done.exit_code, 1);
  EXPECT_TRUE (
      contains (done.err, "empty: has no .pcd, .ply, .las, .xyz or .pts file"));
  EXPECT_TRUE (contains (done.err, "no*.pcd: matches no file"));
  EXPECT_TRUE (contains (done.err, "gone.pcd: does not exist"));
  EXPECT_EQ (lines (done.err), 4u) << done.err;
  EXPECT_EQ (namesIn ("out"), (Names{"in.json", "in.pcd"}));
}

TEST_F (SegmentBatch, NamesFurtherOutputsAfterTheirInputs)
{
  expectDone ("scans --output-dir out --planes {}_list.csv --image "
              "{}.png --rest {}_rest.pcd --planes-dir {}");
  EXPECT_EQ (namesIn ("out"),
             (Names{"a",
                    "a.pcd",
                    "a.png",
                    "a_list.csv",
                    "a_rest.pcd",
                    "b",
                    "b.pcd",
                    "b.png",
                    "b_list.csv",
                    "b_rest.pcd"}));
  EXPECT_EQ (namesIn ("out/b").size(), 2u);
}

TEST_F (SegmentBatch, GivesTheSameForAnyNumberOfJobs)
{
  for (const char* name : {"c.pcd", "d.pcd", "e.pcd"})
    addScan (name);
  folder_.write ("scans/bad.pcd", "no cloud");
  const Outcome one = run ("scans --output-dir one --rest {}_rest.pcd");
  const Outcome many = run ("scans --output-dir two --rest {}_rest.pcd --jobs 4");
  EXPECT_EQ (many.err, one.err);
  EXPECT_EQ (lines (many.out), 5u);
  EXPECT_EQ (namesIn ("two"), namesIn ("one"));
  std::size_t at = 0;
  for (const char* name : {"a", "b", "c", "d", "e"}) {
    const std::string file = name + std::string (".pcd");
    EXPECT_EQ (contentOf (folder_ / ("two/" + file)),
               contentOf (folder_ / ("one/" + file)));
    at = many.out.find ("two/" + file, at);
    ASSERT_NE (at, std::string::npos) << "not in the order of the inputs: " << many.out;
  }
  EXPECT_EQ (run ("scans --output-dir three --jobs 0").exit_code, 1);
  EXPECT_EQ (namesIn ("three").size(), 10u);
}

TEST_F (SegmentBatch, LeavesNothingHalfDoneWhenInterrupted)
{
  constexpr int scans = 40, dense_side = 200;
  pcl::io::savePCDFileBinary (folder_ / "dense.pcd", floorAndWall (dense_side));
  for (int i = 0; i < scans; ++i)
    fs::create_hard_link (folder_ / "dense.pcd",
                          folder_ / ("scans/s" + std::to_string (i) + ".pcd"));
  const Outcome done = runAndTerminate (
      "", "scans --output-dir out --jobs 2 2>said", "[ -e out/s0.json ]");
  EXPECT_EQ (done.exit_code, 128 + 15) << "as a shell says it";
  const std::string said = contentOf (folder_ / "said");
  EXPECT_EQ (said.find ("pcl_ops_segment: interrupted: "), 0u) << said;
  EXPECT_EQ (lines (said), 1u) << said;
  std::size_t clouds = 0;
  for (const std::string& name : namesIn ("out")) {
    EXPECT_NE (name.front(), '.') << "a temporary file is left: " << name;
    if (fs::path (name).extension() != ".pcd")
      continue;
    ++clouds;
    LabelledCloud cloud;
    EXPECT_EQ (pcl::io::loadPCDFile (folder_ / ("out/" + name), cloud), 0) << name;
    EXPECT_TRUE (
        fs::exists (folder_ / ("out/" + fs::path (name).stem().string() + ".json")))
        << name;
  }
  EXPECT_LT (clouds, scans + 2u) << "it ended before its work was done";
  EXPECT_TRUE (contains (said, " " + std::to_string (clouds) + " of 42 inputs"));
}
