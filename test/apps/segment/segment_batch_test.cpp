// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/ply_io.h>

#include "segment_program.h"
#include <io/pose_file.h>

#include <filesystem>
#include <utility>

namespace fs = std::filesystem;

namespace {

/** \brief A folder scans with the clouds a.pcd and b.pcd. */
class SegmentBatch : public Segment {
protected:
  SegmentBatch()
  {
    fs::create_directories (folder_ / "scans/deeper");
    for (const char* name : {"a.pcd", "b.pcd", "deeper/c.pcd", ".hidden.pcd"})
      addScan (name);
    folder_.write ("scans/notes.txt", "no cloud");
  }

  void
  addScan (const std::string& name) const
  {
    fs::copy_file (folder_ / "in.pcd", folder_ / ("scans/" + name));
  }
};

using Names = std::set<std::string>;

TEST_F (SegmentBatch, DoesEveryCloudThereIsAndSaysWhatIsNone)
{
  for (const char* folder : {"empty", "bad"})
    fs::create_directory (folder_ / folder);
  folder_.write ("bad/aa.pcd", "no cloud");
  folder_.write ("bad/ab.ply", "");
  fs::copy_file (folder_ / "in.pcd", folder_ / "bad/b.pcd");
  const std::string a = "scans/a.pcd -> out/a.pcd: 5001 points, 2 planes\n",
                    b = "scans/b.pcd -> out/b.pcd: 5001 points, 2 planes\n",
                    in = "in.pcd -> out/in.pcd: 5001 points, 2 planes\n";
  const struct {
    std::string arguments, said;
    std::vector<std::string> complaints;
    Names written;
  } rows[] = {
      {"scans", a + b, {}, {"a.json", "a.pcd", "b.json", "b.pcd"}},
      {"scans --format ply --quiet", "", {}, {"a.json", "a.ply", "b.json", "b.ply"}},
      {"in.pcd scans 'scans/[ab].p?d' ./in.pcd --planes {}.csv --quiet",
       "",
       {},
       {"a.csv", "a.pcd", "b.csv", "b.pcd", "in.csv", "in.pcd"}},
      {"scans/a.pcd --planes {}_list.csv --image {}.png --rest {}_rest.pcd "
       "--planes-dir {}",
       a,
       {},
       {"a", "a.pcd", "a.png", "a_list.csv", "a_rest.pcd"}},
      {"bad",
       "bad/b.pcd -> out/b.pcd: 5001 points, 2 planes\n",
       {"bad/aa.pcd: is no valid PCD",
        "bad/ab.ply: is empty",
        "2 failed: 1 of 3 inputs are done"},
       {"b.json", "b.pcd"}},
      {"empty 'no*.pcd' gone.pcd in.pcd",
       in,
       {"empty: has no .pcd, .ply, .las, .xyz or .pts file",
        "no*.pcd: matches no file",
        "gone.pcd: does not exist",
        "3 failed: 1 of 4 inputs are done"},
       {"in.json", "in.pcd"}}};
  for (const auto& [arguments, said, complaints, written] : rows) {
    SCOPED_TRACE (arguments);
    const Outcome done = run (arguments + " --output-dir out");
    EXPECT_EQ (done.exit_code, complaints.empty() ? 0 : 1);
    EXPECT_EQ (done.out, said);
    EXPECT_EQ (lines (done.err), complaints.size()) << done.err;
    for (const std::string& complaint : complaints)
      EXPECT_TRUE (contains (done.err, "pcl_ops_segment: " + complaint));
    EXPECT_EQ (namesIn ("out"), written);
    fs::remove_all (folder_ / "out");
  }
}

TEST_F (SegmentBatch, SaysWhichCloudLooksDamagedAndDoesItAnyway)
{
  InputCloud damaged = floorAndWall();
  for (std::size_t i = points_of_plane; i < damaged.size(); ++i)
    damaged[i].getVector3fMap().setZero();
  save ("scans/b.pcd", damaged);
  for (const char* inputs : {"scans --output-dir out --quiet", "scans/b.pcd b.pcd"})
    EXPECT_EQ (expectDone (inputs).err,
               "pcl_ops_segment: scans/b.pcd: looks damaged: 50 % of its points are at "
               "(0, 0, 0); leave missing readings out or write them as NaN\n");
  EXPECT_EQ (namesIn ("out"), (Names{"a.json", "a.pcd", "b.json", "b.pcd"}));
}

TEST_F (SegmentBatch, GivesTheSameForAnyNumberOfJobs)
{
  for (const char* name : {"c.pcd", "d.pcd", "e.pcd"})
    addScan (name);
  folder_.write ("scans/bad.pcd", "no cloud");
  const Outcome one = run ("scans --output-dir out --rest {}_rest.pcd");
  fs::rename (folder_ / "out", folder_ / "one");
  for (const char* jobs : {"4", "0"}) {
    const Outcome many =
        run (std::string ("scans --output-dir out --rest {}_rest.pcd --jobs ") + jobs);
    EXPECT_EQ (many.err, one.err);
    EXPECT_EQ (many.out, one.out) << "in the order of the inputs";
    EXPECT_EQ (namesIn ("out"), namesIn ("one"));
    for (const char* file : {"/a.pcd", "/b.pcd", "/c.pcd", "/d.pcd", "/e.pcd"})
      EXPECT_EQ (contentOf (folder_ / "out" + file),
                 contentOf (folder_ / "one" + file));
  }
}

TEST_F (SegmentBatch, LeavesNothingHalfDoneWhenInterrupted)
{
  constexpr int scans = 40, dense_side = 200;
  save ("dense.pcd", floorAndWall (dense_side));
  for (int i = 0; i < scans; ++i)
    fs::create_hard_link (folder_ / "dense.pcd",
                          folder_ / ("scans/s" + std::to_string (i) + ".pcd"));
  const Outcome done = runAndTerminate (
      "", "scans --output-dir out --jobs 2 2>said", "[ -e out/s0.json ]");
  EXPECT_EQ (done.exit_code, 128 + 15) << "as a shell says it";
  const std::string said = contentOf (folder_ / "said");
  EXPECT_EQ (said.find ("pcl_ops_segment: interrupted: "), 0u) << said;
  EXPECT_EQ (lines (said), 1u) << said;
  const Names names = namesIn ("out");
  std::size_t clouds = 0;
  for (const std::string& name : names) {
    EXPECT_NE (name.front(), '.') << "a temporary file is left: " << name;
    if (fs::path (name).extension() != ".pcd")
      continue;
    ++clouds;
    loaded ("out/" + name);
    EXPECT_EQ (names.count (fs::path (name).stem().string() + ".json"), 1u) << name;
  }
  EXPECT_LT (clouds, scans + 2u) << "it ended before its work was done";
  EXPECT_TRUE (contains (said, " " + std::to_string (clouds) + " of 42 inputs"));
}

/** \brief A floor, a wall, and the larger wall of the second scan and the third, whose
 * planes would be numbered otherwise; of the third the sensor has moved by 1 m in x. */
class SegmentTrack : public Segment {
protected:
  SegmentTrack()
  {
    fs::create_directory (folder_ / "scans");
    save ("scans/a.pcd", floorAndWall());
    save ("scans/b.pcd", larger_);
    InputCloud third = larger_;
    for (auto& point : third)
      point.x -= 1.0f;
    save ("scans/c.pcd", third);
    folder_.write ("poses.txt",
                   "# timestamp tx ty tz qx qy qz qw\n0.0 0 0 0 0 0 0 1\n\n"
                   "0.1 0 0 0 0 0 0 1\n0.2 1 0 0 0 0 0 1\n");
  }

  static InputCloud
  withLargerWall ()
  {
    InputCloud cloud = floorAndWall();
    addGrid (cloud, {3, 0, 2}, {0, 0.04f, 0}, points_of_side, {0, 0, 0.04f}, 20);
    return cloud;
  }

  Outcome
  track (const std::string& options) const
  {
    return run ("scans --output-dir out --track " + options);
  }

  /** \brief The number of the floor in a labelled scan. */
  std::uint32_t
  floorIn (const std::string& scan) const
  {
    const auto labels =
        distinct (labelsOf (loaded ("out/" + scan + ".pcd")), 0, points_of_plane);
    return labels.size() == 1 ? *labels.begin() : 0;
  }

  const InputCloud larger_ = withLargerWall();
};

TEST_F (SegmentTrack, GivesAPlaneTheSameLabelIdColorAndFileInAllClouds)
{
  expectDone ("scans --output-dir out");
  const std::uint32_t before = floorIn ("a");
  EXPECT_NE (floorIn ("b"), before) << "by size";
  EXPECT_EQ (track ("--poses poses.txt --planes-dir {}").exit_code, 0);
  const std::string file = "plane_00" + std::to_string (before) + "_horizontal.pcd";
  for (const std::string scan : {"a", "b", "c"}) {
    EXPECT_EQ (floorIn (scan), before) << scan;
    EXPECT_EQ (namesIn ("out/" + scan).count (file), 1u) << scan;
    EXPECT_EQ (loaded ("out/" + scan + ".pcd")[0].rgba, loaded ("out/a.pcd")[0].rgba);
    const auto answer = jsonIn ("out/" + scan + ".json");
    for (const auto& plane : answer.at ("planes"))
      EXPECT_EQ (plane["id"] == before, plane["orientation"] == "horizontal") << scan;
  }
}

TEST_F (SegmentTrack, TakesUpInTheFrameThatPosesShare)
{
  // The second camera lies on its side: its y is up, which is z of the others.
  InputCloud turned = larger_;
  for (pcl::PointXYZI& point : turned)
    point.getVector3fMap() = Eigen::Vector3f (point.x, point.z, -point.y);
  turned.sensor_origin_ = Eigen::Vector4f (0.5f, 1.5f, -1.0f, 0.0f);
  save ("scans/b.pcd", turned);
  folder_.write ("turned.txt",
                 "0 0 0 0 0 0 0 1\n0 0 0 0 0.70710678 0 0 0.70710678\n"
                 "0 1 0 0 0 0 0 1\n");
  for (const char* up : {"", " --up 0,0,1"}) {
    EXPECT_EQ (track (std::string ("--poses turned.txt") + up).exit_code, 0);
    const auto json = jsonIn ("out/b.json");
    ASSERT_EQ (json["planes"].size(), 2u);
    EXPECT_NEAR (json["parameters"]["up"][1].get<double>(), 1.0, 1e-6);
    for (const auto& plane : json["planes"])
      EXPECT_EQ (plane["orientation"] == "horizontal",
                 std::abs (plane["normal"][1].get<double>()) > 0.9);
  }
}

TEST_F (SegmentTrack, TakesTheSensorToStandStillWithoutPoses)
{
  EXPECT_EQ (track ("").exit_code, 0);
  EXPECT_EQ (floorIn ("b"), floorIn ("a"));
  const auto json = jsonIn ("out/c.json");
  for (const auto& plane : json["planes"])
    if (plane["orientation"] == "vertical") {
      EXPECT_EQ (plane["id"], 3) << "a wall 1 m nearer is another";
    }
}

TEST_F (SegmentTrack, TellsPlanesApartInDoublePrecisionWhateverElseACloudHas)
{
  // The second square draws the middle of the cloud away from the floor.
  folder_.write ("a.xyz", squareText (50, 0.0));
  folder_.write ("b.xyz", squareText (50, 0.0) + squareText (75, 2.0));
  folder_.write ("c.xyz", squareText (50, 0.5));
  expectDone ("a.xyz b.xyz c.xyz --output-dir out --track");
  const auto planes = jsonIn ("out/c.json")["planes"];
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_EQ (planes[0]["id"], 3) << "half a meter above the floor";
}

TEST_F (SegmentTrack, GivesTheSameBytesForAnyNumberOfJobs)
{
  // The first takes so long that the others are through before it.
  save ("scans/a.pcd", floorAndWall (300));
  EXPECT_EQ (track ("--poses poses.txt").exit_code, 0);
  const std::string alone = contentOf (folder_ / "out/c.pcd");
  fs::remove_all (folder_ / "out");
  EXPECT_EQ (track ("--poses poses.txt --jobs 3").exit_code, 0);
  EXPECT_EQ (contentOf (folder_ / "out/c.pcd"), alone);
}

TEST_F (SegmentTrack, GoesOnAfterABadCloud)
{
  folder_.write ("scans/b.pcd", "no cloud");
  EXPECT_EQ (track ("--poses poses.txt --jobs 3").exit_code, 1);
  EXPECT_EQ (floorIn ("c"), floorIn ("a"));
}

TEST (PoseFile, NamesTheLineThatIsNoPose)
{
  const TemporaryFolder folder;
  for (const auto& [line, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"1 2 3", "has 3 numbers"},
           {"0 0 0 0 0 0 0 1 5", "has more than 8 numbers"},
           {"0 0 x 0 0 0 0 1", "has something that is no number in place 3"},
           {"0 0 nan 0 0 0 0 1", "has something that is no number in place 3"},
           {"0 0 1e300 0 0 0 0 1", "has a place more than 1e9 m from zero"},
           {"0 0 0 0 0 0 0 0",
            "has a quaternion qx qy qz qw that is not of length 1"}}) {
    const std::string file =
        folder.write ("bad.txt", "# a comment\n0 0 0 0 0 0 0 1\n" + line + "\n");
    EXPECT_EQ (complaintOf ([&] {
                 pcl_ops::apps::loadPoses (file);
               }).find (file + ": line 3 " + complaint),
               0u)
        << line;
  }
}

/** \brief The program in a pipe, with a folder of its own for temporary files. */
class SegmentPipe : public Segment {
protected:
  /** \brief Pipes a file into the program. */
  Outcome
  pipe (const std::string& file, const std::string& arguments) const
  {
    const Outcome done =
        expectDone (arguments, "cat " + file + " | TMPDIR='" + temporary_.path() + "'");
    EXPECT_EQ (temporary_.fileCount(), 0u) << file;
    return done;
  }

  TemporaryFolder temporary_{"_temporary"};
};

/** \brief Without what differs from run to run. */
nlohmann::json
withoutTimes (nlohmann::json json)
{
  json.erase ("timing_ms");
  return json;
}

TEST_F (SegmentPipe, LabelsEveryKindOfCloudAlikeFromAFileAndPipedIn)
{
  const InputCloud cloud = floorAndWall();
  pcl::io::savePCDFileASCII (folder_ / "ascii.pcd", cloud);
  pcl::io::savePCDFileBinaryCompressed (folder_ / "compressed.pcd", cloud);
  // A PLY loses the sensor's pose, which the labels do not depend on.
  pcl::io::savePLYFileASCII (folder_ / "ascii.ply", cloud);
  pcl::io::savePLYFileBinary (folder_ / "binary.ply", cloud);
  const std::vector<std::uint32_t> labels = labelsOf (label ("in.pcd", "--threads 4"));
  for (const char* file :
       {"in.pcd", "ascii.pcd", "compressed.pcd", "ascii.ply", "binary.ply"}) {
    SCOPED_TRACE (file);
    EXPECT_EQ (labelsOf (label (file, "--planes p.json")), labels);
    const Outcome piped = pipe (file, "- out.pcd --quiet");
    EXPECT_EQ (piped.err, "");
    EXPECT_EQ (withoutTimes (nlohmann::json::parse (piped.out)),
               withoutTimes (jsonIn ("p.json")));
    EXPECT_EQ (labelsOf (loaded ("out.pcd")), labels);
  }
}

TEST_F (SegmentPipe, NamesTmpdirWhereItIsNoFolder)
{
  expectRefused ("-",
                 "TMPDIR: is no folder; set it to one for temporary files\n",
                 1,
                 "cat in.pcd | TMPDIR=missing_folder");
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

} // namespace
