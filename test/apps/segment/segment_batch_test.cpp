// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/io/ply_io.h>

#include "segment_program.h"

#include <filesystem>
#include <iomanip>
#include <sstream>
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

TEST_F (SegmentBatch, LabelsEveryCloudOfAFolderAndListsItsPlanes)
{
  const Outcome done = expectDone ("scans --output-dir out");
  EXPECT_EQ (done.out,
             "scans/a.pcd -> out/a.pcd: 5001 points, 2 planes\n"
             "scans/b.pcd -> out/b.pcd: 5001 points, 2 planes\n");
  EXPECT_EQ (namesIn ("out"), (Names{"a.json", "a.pcd", "b.json", "b.pcd"}));
  EXPECT_EQ (labelsOf (loaded ("out/b.pcd")), labelsOf (label ("in.pcd")));
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
    loaded ("out/" + name);
    EXPECT_TRUE (
        fs::exists (folder_ / ("out/" + fs::path (name).stem().string() + ".json")))
        << name;
  }
  EXPECT_LT (clouds, scans + 2u) << "it ended before its work was done";
  EXPECT_TRUE (contains (said, " " + std::to_string (clouds) + " of 42 inputs"));
}

constexpr const char* track = "scans --output-dir out --track ";

/** \brief A floor, a wall, and the larger wall of the second scan and the third, whose
 * planes would be numbered otherwise; of the third the sensor has moved by 1 m in x. */
class SegmentTrack : public Segment {
protected:
  SegmentTrack()
  {
    std::filesystem::create_directory (folder_ / "scans");
    const InputCloud first = floorAndWall();
    pcl::io::savePCDFileBinary (folder_ / "scans/a.pcd", first);
    const InputCloud second = withLargerWall();
    pcl::io::savePCDFileBinary (folder_ / "scans/b.pcd", second);
    InputCloud third = second;
    for (auto& point : third)
      point.x -= 1.0f;
    pcl::io::savePCDFileBinary (folder_ / "scans/c.pcd", third);
    folder_.write ("poses.txt",
                   "# timestamp tx ty tz qx qy qz qw\n"
                   "0.0 0 0 0 0 0 0 1\n"
                   "\n"
                   "0.1 0 0 0 0 0 0 1\n"
                   "0.2 1 0 0 0 0 0 1\n");
  }

  static InputCloud
  withLargerWall ()
  {
    InputCloud cloud = floorAndWall();
    constexpr float step = 0.04f;
    for (int y = 0; y < points_of_side; ++y)
      for (int z = points_of_side; z < points_of_side + 20; ++z)
        cloud.push_back (
            {3.0f, step * static_cast<float> (y), step * static_cast<float> (z), 0.0f});
    return cloud;
  }

  /** \brief The number of the floor in a labelled scan. */
  std::uint32_t
  floorIn (const std::string& file) const
  {
    const auto labels = distinct (loaded ("out/" + file), 0, points_of_plane);
    return labels.size() == 1 ? *labels.begin() : 0;
  }
};

TEST_F (SegmentTrack, GivesAPlaneTheSameLabelAndIdInAllClouds)
{
  expectDone ("scans --output-dir out");
  const std::uint32_t before = floorIn ("a.pcd");
  EXPECT_NE (floorIn ("b.pcd"), before) << "by size";
  expectDone (std::string (track) + "--poses poses.txt");
  for (const char* scan : {"a", "b", "c"}) {
    EXPECT_EQ (floorIn (std::string (scan) + ".pcd"), before) << scan;
    const auto json = jsonIn ("out/" + std::string (scan) + ".json");
    for (const auto& plane : json["planes"])
      EXPECT_EQ (plane["id"] == before, plane["orientation"] == "horizontal") << scan;
  }
}

TEST_F (SegmentTrack, TakesUpInTheFrameThatPosesShare)
{
  // The second camera lies on its side: its y is up, which is z of the others.
  InputCloud turned = withLargerWall();
  for (pcl::PointXYZI& point : turned)
    point.getVector3fMap() = Eigen::Vector3f (point.x, point.z, -point.y);
  turned.sensor_origin_ = Eigen::Vector4f (0.5f, 1.5f, -1.0f, 0.0f);
  pcl::io::savePCDFileBinary (folder_ / "scans/b.pcd", turned);
  folder_.write ("turned.txt",
                 "0 0 0 0 0 0 0 1\n0 0 0 0 0.70710678 0 0 0.70710678\n"
                 "0 1 0 0 0 0 0 1\n");
  for (const char* up : {"", " --up 0,0,1"}) {
    expectDone (track + std::string ("--poses turned.txt") + up);
    const auto json = jsonIn ("out/b.json");
    ASSERT_EQ (json["planes"].size(), 2u);
    EXPECT_NEAR (json["parameters"]["up"][1].get<double>(), 1.0, 1e-6);
    for (const auto& plane : json["planes"])
      EXPECT_EQ (plane["orientation"],
                 std::abs (plane["normal"][1].get<double>()) > 0.9 ? "horizontal"
                                                                   : "vertical");
  }
}

TEST_F (SegmentTrack, GivesAPlaneTheSameColorAndFileInAllClouds)
{
  expectDone (std::string (track) + "--poses poses.txt --planes-dir {}");
  EXPECT_EQ (loaded ("out/a.pcd")[0].rgba, loaded ("out/c.pcd")[0].rgba);
  const std::string floor =
      "/plane_00" + std::to_string (floorIn ("a.pcd")) + "_horizontal.pcd";
  for (const char* scan : {"a", "b", "c"})
    EXPECT_TRUE (std::filesystem::exists (folder_ / ("out/" + (scan + floor)))) << scan;
}

TEST_F (SegmentTrack, TakesTheSensorToStandStillWithoutPoses)
{
  expectDone (track);
  EXPECT_EQ (floorIn ("b.pcd"), floorIn ("a.pcd"));
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
  const auto json = jsonOf ("a.xyz b.xyz c.xyz --output-dir out --track", "out/c.json");
  ASSERT_EQ (json["planes"].size(), 1u);
  EXPECT_EQ (json["planes"][0]["id"], 3) << "half a meter above the floor";
}

TEST_F (SegmentTrack, GivesTheSameBytesForAnyNumberOfJobs)
{
  // The first takes so long that the others are through before it.
  pcl::io::savePCDFileBinary (folder_ / "scans/a.pcd", floorAndWall (300));
  const std::string options = std::string (track) + "--poses poses.txt";
  expectDone (options);
  const std::string alone = contentOf (folder_ / "out/c.pcd");
  std::filesystem::remove_all (folder_ / "out");
  expectDone (options + " --jobs 3");
  EXPECT_EQ (contentOf (folder_ / "out/c.pcd"), alone);
}

TEST_F (SegmentTrack, GoesOnAfterABadCloud)
{
  folder_.write ("scans/b.pcd", "no cloud");
  const Outcome done = run (std::string (track) + "--poses poses.txt --jobs 3");
  EXPECT_EQ (done.exit_code, 1);
  EXPECT_EQ (floorIn ("c.pcd"), floorIn ("a.pcd"));
}

TEST_F (SegmentTrack, NamesTheLineThatIsNoPose)
{
  const std::string options = std::string (track) + "--poses bad.txt";
  const std::string good = "0 0 0 0 0 0 0 1\n";
  for (const auto& [line, complaint] : std::vector<std::pair<std::string, std::string>>{
           {"1 2 3", "has 3 numbers"},
           {"0 0 0 0 0 0 0 1 5", "has more than 8 numbers"},
           {"0 0 x 0 0 0 0 1", "has something that is no number in place 3"},
           {"0 0 nan 0 0 0 0 1", "has something that is no number in place 3"},
           {"0 0 1e300 0 0 0 0 1", "has a place more than 1e9 m from zero"},
           {"0 0 0 0 0 0 0 0",
            "has a quaternion qx qy qz qw that is not of length 1"}}) {
    folder_.write ("bad.txt", "# a comment\n" + good + line + "\n" + good);
    expectRefused (options, "bad.txt: line 3 " + complaint, 1);
  }
  folder_.write ("bad.txt", good + good);
  expectRefused (options, "bad.txt: has 2 poses for 3 clouds", 1);
  expectRefused (std::string (track) + "--poses none.txt",
                 "none.txt: does not exist; check the name",
                 1);
  expectRefused (std::string (track) + "--poses scans", "scans: is a folder", 1);
  EXPECT_FALSE (std::filesystem::exists (folder_ / "out/a.pcd"));
}

/** \brief The program in a pipe, with a folder of its own for temporary files. */
class SegmentPipe : public Segment {
protected:
  /** \brief Pipes a file into the program. */
  Outcome
  pipe (const std::string& file, const std::string& arguments) const
  {
    return expectDone (arguments,
                       "cat " + file + " | TMPDIR='" + temporary_.path() + "'");
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

TEST_F (SegmentPipe, PrintsTheJsonOfEveryKindOfCloudPipedIn)
{
  const InputCloud cloud = floorAndWall();
  pcl::io::savePCDFileASCII (folder_ / "ascii.pcd", cloud);
  pcl::io::savePCDFileBinaryCompressed (folder_ / "compressed.pcd", cloud);
  pcl::io::savePLYFileBinary (folder_ / "binary.ply", cloud);
  for (const std::string file :
       {"in.pcd", "ascii.pcd", "compressed.pcd", "binary.ply"}) {
    expectDone (file + " --planes p.json --quiet");
    const Outcome piped = pipe (file, "-");
    EXPECT_EQ (piped.err, "");
    EXPECT_EQ (withoutTimes (piped.out), withoutTimes (contentOf (folder_ / "p.json")))
        << file;
    EXPECT_EQ (temporary_.fileCount(), 0u) << file;
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

TEST_F (SegmentPipe, WritesFilesBesidesTheJson)
{
  const Outcome done = pipe ("in.pcd", "- out.pcd --rest rest.pcd --quiet");
  EXPECT_EQ (withoutTimes (done.out)["planes"].size(), 2u);
  EXPECT_EQ (labelsOf (loaded ("out.pcd")), labelsOf (label ("in.pcd")));
}

TEST_F (SegmentPipe, PrintsATableWhereThePlanesGoToAFile)
{
  const Outcome done = pipe ("in.pcd", "- --planes p.csv");
  EXPECT_EQ (done.out.find ("standard input: 5001 points, 2 planes"), 0u) << done.out;
  EXPECT_EQ (lines (contentOf (folder_ / "p.csv")), 3u);
}

TEST_F (SegmentPipe, PutsAdviceIntoTheJsonWhereNothingIsFound)
{
  const Outcome done = pipe ("in.pcd", "- --preset paper --sampling-rate 0.001");
  const nlohmann::json json = withoutTimes (done.out);
  EXPECT_EQ (json["planes"].size(), 0u);
  EXPECT_TRUE (contains (json["advice"], "--sampling-rate")) << json["advice"];
}

} // namespace
