// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/ply_io.h>

#include "segment_program.h"

#include <filesystem>
#include <utility>

namespace {

/** \brief The program in a pipe, with a folder of its own for temporary files. */
class SegmentPipe : public Segment {
protected:
  /** \brief Pipes what a command prints into the program. */
  Outcome
  pipe (const std::string& command, const std::string& arguments) const
  {
    return run (arguments, command + " | TMPDIR='" + temporary_.path() + "'");
  }

  TemporaryFolder temporary_{"_temporary"};
};

/** \brief Without what differs from run to run. */
nlohmann::json
withoutTimes (const std::string& text)
{
  nlohmann::json json = nlohmann::json::parse (text);
  json.erase ("timing_ms");
  return json;
}

} // namespace

TEST_F (SegmentPipe, PrintsTheJsonOfEveryKindOfCloudPipedIn)
{
  const InputCloud cloud = floorAndWall();
  pcl::io::savePCDFileASCII (folder_ / "ascii.pcd", cloud);
  pcl::io::savePCDFileBinaryCompressed (folder_ / "compressed.pcd", cloud);
  pcl::io::savePLYFileBinary (folder_ / "binary.ply", cloud);
  for (const std::string file :
       {"in.pcd", "ascii.pcd", "compressed.pcd", "binary.ply"}) {
    ASSERT_EQ (run (file + " --planes p.json --quiet").exit_code, 0) << file;
    const Outcome piped = pipe ("cat " + file, "-");
    EXPECT_EQ (piped.exit_code, 0) << piped.err;
    EXPECT_EQ (piped.err, "");
    EXPECT_EQ (withoutTimes (piped.out), withoutTimes (contentOf (folder_ / "p.json")))
        << file;
    EXPECT_EQ (temporary_.fileCount(), 0u) << file;
  }
}

TEST_F (SegmentPipe, NamesTmpdirWhereItIsNoFolder)
{
  const Outcome piped = run ("-", "cat in.pcd | TMPDIR=missing_folder");
  EXPECT_EQ (piped.exit_code, 1);
  EXPECT_EQ (piped.out, "");
  EXPECT_EQ (piped.err,
             "pcl_ops_segment: TMPDIR: is no folder; set it to one for temporary "
             "files\n");
}

TEST_F (SegmentPipe, LeavesNoTemporaryFileWhenInterrupted)
{
  // More than fits into the pipe, then silence.
  const Outcome done = runAndTerminate (
      "mkfifo feed; { head -c 3000000 /dev/zero; sleep 5; } >feed & TMPDIR='" +
          temporary_.path() + "'",
      "- <feed",
      "[ -n \"$(ls '" + temporary_.path() + "')\" ]");
  EXPECT_EQ (done.exit_code, 128 + 15);
  EXPECT_EQ (temporary_.fileCount(), 0u);
}

TEST_F (SegmentPipe, WritesFilesBesidesTheJson)
{
  const Outcome done = pipe ("cat in.pcd", "- out.pcd --rest rest.pcd --quiet");
  EXPECT_EQ (done.exit_code, 0) << done.err;
  EXPECT_EQ (withoutTimes (done.out)["planes"].size(), 2u);
  LabelledCloud cloud;
  ASSERT_EQ (pcl::io::loadPCDFile (folder_ / "out.pcd", cloud), 0);
  EXPECT_EQ (labelsOf (cloud), labelsOf (label ("in.pcd")));
}

TEST_F (SegmentPipe, PrintsATableWhereThePlanesGoToAFile)
{
  const Outcome done = pipe ("cat in.pcd", "- --planes p.csv");
  EXPECT_EQ (done.exit_code, 0) << done.err;
  EXPECT_EQ (done.out.find ("standard input: 5001 points, 2 planes"), 0u) << done.out;
  EXPECT_EQ (lines (contentOf (folder_ / "p.csv")), 3u);
}

TEST_F (SegmentPipe, PutsAdviceIntoTheJsonWhereNothingIsFound)
{
  const Outcome done = pipe ("cat in.pcd", "- --preset paper --sampling-rate 0.001");
  EXPECT_EQ (done.exit_code, 0) << done.err;
  const nlohmann::json json = withoutTimes (done.out);
  EXPECT_EQ (json["planes"].size(), 0u);
  EXPECT_TRUE (contains (json["advice"], "--sampling-rate")) << json["advice"];
}
