// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <support/answers.h>
#include <support/labeled_floor.h>

namespace {

namespace fs = std::filesystem;

/** The rows of a CSV table without quotes, each as values by column name. */
using Rows = std::vector<std::map<std::string, std::string>>;

std::vector<std::string>
cellsOf (const std::string& line)
{
  std::istringstream stream (line);
  std::vector<std::string> cells;
  for (std::string cell; std::getline (stream, cell, ',');)
    cells.push_back (cell);
  return cells;
}

Rows
rowsOf (const std::string& text)
{
  std::istringstream stream (text);
  std::string line;
  std::getline (stream, line);
  const std::vector<std::string> names = cellsOf (line);
  Rows rows;
  while (std::getline (stream, line)) {
    const std::vector<std::string> cells = cellsOf (line);
    rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i)
      rows.back()[names.at (i)] = cells[i];
  }
  return rows;
}

/** The programs of the lab, the files of inputs and some clouds. */
class LabProgram : public AnswersFolder {
protected:
  LabProgram() : AnswersFolder (PCL_OPS_EVALUATE_PROGRAM)
  {
    ::setenv ("PYTHON", PCL_OPS_PYTHON3, 1);
    ::setenv ("REPORT", PCL_OPS_REPORT, 1);
    fs::copy (PCL_OPS_LAB "/inputs", folder_.path(), fs::copy_options::recursive);
    for (const char* folder : {"roofs", "scans", "real", "mine"})
      fs::create_directory (folder_ / folder);
    folder_.write ("floor.xyz", floorOfOnePlane());
    folder_.write ("halves.xyz", floorOfTwoPlanes());
    folder_.write ("corner.xyz", corner());
    folder_.write ("mine/halves.txt", repeated ("4\n", 60) + repeated ("9\n", 40));
    folder_.write ("real/room_small_1.xyz", floorOfInstances());
    folder_.write ("real/roof.xyz", floorOfInstances());
  }

  void
  expectSuccess (const std::string& command) const
  {
    const Outcome done = shell (command);
    EXPECT_EQ (done.exit_code, 0) << command << '\n' << done.err;
  }

  Rows
  resultsIn (const std::string& folder) const
  {
    return rowsOf (contentOf (folder_ / (folder + "/results.csv")));
  }

  static std::string
  repeated (const std::string& line, int times)
  {
    std::string text;
    for (int i = 0; i < times; ++i)
      text += line;
    return text;
  }

private:
  /** A floor and two walls with points 2 cm apart, seen from inside. */
  static std::string
  corner ()
  {
    std::ostringstream text;
    text << "x,y,z,label\n";
    for (int row = 0; row < 100; ++row)
      for (int column = 0; column < 100; ++column) {
        const double s = 0.02 * row - 0.99;
        const double t = 0.02 * column - 0.99;
        text << s << ',' << t << ",-1,1\n";
        text << "-1," << s << ',' << t << ",2\n";
        text << t << ",-1," << s << ",3\n";
      }
    return text.str();
  }

  /** A floor of 30 x 30 points, 2 cm apart, as one plane of two instances. The truth of
   * the first 90 points is unknown. */
  static std::string
  floorOfInstances ()
  {
    std::ostringstream text;
    text << "x,y,z,label,instance,ignore\n";
    for (int i = 0; i < 900; ++i) {
      const int instance = i < 450 ? 1 : 2;
      const int is_unknown = i < 90 ? 1 : 0;
      text << 0.02 * (i % 30) << ',' << 0.02 * (i / 30) << ",0,1," << instance << ','
           << is_unknown << '\n';
    }
    return text.str();
  }
};

INSTANTIATE_TEST_SUITE_P (All,
                          LabProgram,
                          testing::ValuesIn (answersIn (PCL_OPS_LAB "/answers.tsv")),
                          nameOfAnswers);

TEST_P (LabProgram, IsAsTheTableSays)
{
  expectAnswers ({{"a folder without files to report", fs::exists (PCL_OPS_PYTHON3)}});
}

/** \brief Returns the numbers in a text as "room.pcd: 17000 points, 12 planes". */
std::vector<std::size_t>
countsIn (const std::string& text)
{
  std::smatch numbers;
  EXPECT_TRUE (
      std::regex_search (text, numbers, std::regex ("(\\d+) points, (\\d+) planes")))
      << text;
  return {std::stoul (numbers[1]), std::stoul (numbers[2])};
}

std::size_t
linesWith (const std::string& part, const std::string& text)
{
  std::istringstream stream (text);
  std::size_t number = 0;
  for (std::string line; std::getline (stream, line);)
    if (line.find (part) != std::string::npos)
      ++number;
  return number;
}

TEST_F (LabProgram, SimulatesRoomsOfManyPointsAndPlanesWhateverTheSeed)
{
  for (int seed = 1; seed <= 10; ++seed) {
    const std::string options =
        "room.pcd --width 160 --height 120 --seed " + std::to_string (seed);
    SCOPED_TRACE (options);
    const auto counts = countsIn (shell ("pcl_ops_simulate " + options).out);
    EXPECT_GT (counts[0], 160u * 120u * 8 / 10);
    EXPECT_GE (counts[1], 5u);
  }
}

TEST_F (LabProgram, SimulatesADriveWhoseSensorIsLevelAndOnACar)
{
  expectSuccess ("pcl_ops_simulate drive --scene drive --sensor lidar-16 --frames 2");
  std::istringstream poses (contentOf (folder_ / "drive/poses.txt"));
  std::size_t frames = 0;
  for (std::string line; std::getline (poses, line);) {
    if (line[0] == '#')
      continue;
    SCOPED_TRACE (line);
    ++frames;
    const std::vector<double> numbers = numbersIn (line); // t x y z qx qy qz qw
    EXPECT_NEAR (numbers.at (3), 1.8, 0.11);              // 1.7 to 1.9 m above the road
    // The sine of half the tilt: of at most 3 degrees.
    EXPECT_LT (std::hypot (numbers.at (4), numbers.at (5)), 0.0262);
  }
  EXPECT_EQ (frames, 2u);
}

TEST_F (LabProgram, HasTheFifteenDetectorsOfTable3AndThreeOfStrategy1)
{
  EXPECT_EQ (linesWith (" table3", shell ("pcl_ops_evaluate detectors").out), 18u);
}

TEST_F (LabProgram, HasEveryPeerWithMeasuredValuesToo)
{
  const std::string detectors = shell ("pcl_ops_evaluate detectors").out;
  EXPECT_GT (linesWith (" peers,", detectors), 0u);
  EXPECT_EQ (linesWith (" peers,", detectors),
             linesWith (" peers-measured,", detectors));
}

TEST_F (LabProgram, RunsAllDetectorsButTheTwoThatNeedAnImage)
{
  expectSuccess ("pcl_ops_evaluate run all clouds:floor.xyz --detectors all,ablation");
  EXPECT_EQ (resultsIn ("all").size() + 2,
             lines (shell ("pcl_ops_evaluate detectors").out));
}

TEST_F (LabProgram, QuotesNamesAndKeepsARowALine)
{
  folder_.write ("roofs/b, \"c\"\nd.xyz", floorOfOnePlane());
  const std::string command = "pcl_ops_evaluate run named clouds:roofs --detectors ops";
  expectSuccess (command);
  EXPECT_TRUE (contains (contentOf (folder_ / "named/results.csv"),
                         "\nroofs,\"b, \"\"c\"\" d.xyz\",exact,ops,42,"));
  EXPECT_TRUE (contains (shell (command).out, " 0 new rows"));
}

TEST_F (LabProgram, LeavesResultsWithOtherColumnsAlone)
{
  const std::string old_results =
      "data_set,cloud,truth,configuration,seed,points\nroofs,a.pcd,exact,ops,42,9\n";
  fs::create_directory (folder_ / "old");
  folder_.write ("old/results.csv", old_results);
  const Outcome done =
      shell ("pcl_ops_evaluate run old clouds:floor.xyz --detectors ops");
  EXPECT_EQ (done.exit_code, 1);
  EXPECT_TRUE (contains (done.err, "old/results.csv: has other columns"));
  EXPECT_EQ (contentOf (folder_ / "old/results.csv"), old_results);
}

// The sensor position of an image is the viewpoint for finding planes.
TEST_F (LabProgram, FindsPlanesInImagesOfSimulatedCameras)
{
  expectSuccess ("pcl_ops_evaluate run out rooms:9-11 furniture:1 --detectors "
                 "pcl-organized,pcl-organized-measured");
  const Rows rows = resultsIn ("out");
  EXPECT_EQ (rows.size(), 8u);
  for (const auto& row : rows) {
    SCOPED_TRACE (row.at ("cloud") + " " + row.at ("configuration"));
    EXPECT_GE (std::stoi (row.at ("truth_planes")), 10);
    EXPECT_GE (std::stoi (row.at ("result_planes")), 5);
    EXPECT_GE (std::stod (row.at ("segmentation_accuracy")), 0.4);
  }
}

TEST_F (LabProgram, SaysHowThickPlanesAreWithoutATruth)
{
  expectSuccess ("pcl_ops_evaluate run out wild:real/roof.xyz@0.2 --detectors ops");
  const Rows rows = resultsIn ("out");
  ASSERT_EQ (rows.size(), 1u);
  EXPECT_EQ (rows[0].at ("truth"), "none");
  EXPECT_EQ (rows[0].at ("on_planes_share"), "1");
  EXPECT_EQ (rows[0].at ("thick_factor_share"), "0");
  EXPECT_EQ (rows[0].at ("thick_length_share"), "0");
  EXPECT_EQ (rows[0].at ("thick_length"), "0.2");
  EXPECT_LT (std::stod (rows[0].at ("rms_largest")), 0.001);
}

/** \brief A wrong file in a frame of SUN RGB-D, and the expected complaint. */
struct WrongFrame {
  std::string test, file, content, complaint;

  friend std::ostream&
  operator<< (std::ostream& stream, const WrongFrame& wrong)
  {
    return stream << wrong.file << ": " << wrong.content;
  }
};

class SunRgbdFrame : public ProgramFolder,
                     public testing::WithParamInterface<WrongFrame> {
protected:
  SunRgbdFrame() : ProgramFolder (PCL_OPS_EVALUATE_PROGRAM)
  {
    fs::copy (
        PCL_OPS_LAB "/inputs/frames", folder_ / "frames", fs::copy_options::recursive);
  }
};

// The intrinsics are the nine numbers of a camera matrix, the extrinsics a rotation and
// a translation, row by row.
INSTANTIATE_TEST_SUITE_P (
    RefusedFor,
    SunRgbdFrame,
    testing::Values (
        WrongFrame{"NoRotation",
                   "extrinsics/1.txt",
                   "2 0 0 0 0 1 0 0 0 0 1 0",
                   "extrinsics/1.txt: holds no rotation"},
        WrongFrame{
            "FiveNumbers", "intrinsics.txt", "1 0 0 0 1", "frame/intrinsics.txt: "},
        WrongFrame{
            "ALetter", "intrinsics.txt", "1 0 0 a 1 0 0 0 1", "frame/intrinsics.txt: "},
        WrongFrame{"TenNumbers",
                   "intrinsics.txt",
                   "1 0 0 0 1 0 0 0 1 7",
                   "frame/intrinsics.txt: "},
        WrongFrame{"NoFocalLength",
                   "intrinsics.txt",
                   "0 0 0 0 0 0 0 0 1",
                   "frame/intrinsics.txt: "},
        WrongFrame{
            "Nan", "intrinsics.txt", "nan 0 0 0 1 0 0 0 1", "frame/intrinsics.txt: "},
        WrongFrame{"NoNumbers", "intrinsics.txt", "", "frame/intrinsics.txt: "}),
    [] (const auto& info) { return info.param.test; });

TEST_P (SunRgbdFrame, NamesTheWrongFile)
{
  const WrongFrame& wrong = GetParam();
  folder_.write ("frames/kv2/room/frame/" + wrong.file, wrong.content + "\n");
  const Outcome done =
      shell ("pcl_ops_evaluate run wrong sunrgbd-raw:frames --detectors kht");
  EXPECT_EQ (done.exit_code, 1);
  EXPECT_TRUE (contains (done.err, wrong.complaint));
}

/** \brief A folder with results, and what report.py says of them: a simulated scan by
 * ops-3-30, the same row for rooms and for streets, and a run of pcl-sac in streets
 * that was stopped. */
class Report : public LabProgram {
protected:
  void
  SetUp () override
  {
    if (!fs::exists (PCL_OPS_PYTHON3))
      GTEST_SKIP() << "needs Python";
    expectSuccess ("pcl_ops_evaluate run . simulated:3000 --detectors ops-3-30");
    std::istringstream results (contentOf (folder_ / "results.csv"));
    std::string header;
    std::string row;
    std::getline (results, header);
    std::getline (results, row);
    const std::string rest = row.substr (row.find (','));
    std::string stopped = "streets,a,exact,pcl-sac,42";
    for (std::size_t i = 5; i < cellsOf (header).size(); ++i)
      stopped += ",nan";
    folder_.write ("results.csv",
                   header + '\n' + row + "\nrooms" + rest + '\n' + stopped +
                       "\nstreets" + rest + '\n');
    folder_.write ("scaling.csv",
                   "series,x,points,measure,cloud,detection_ms\nthreads,1,9,ops,a,2\n"
                   "threads,2,9,ops,a,1\npoints,9,9,ops,b,1\n");
    folder_.write ("steadiness.csv",
                   "detector,number,moved_tenth,turned_tenth,thinned_tenth,"
                   "jittered_tenth,rounded_tenth\nops,.6,.9,.9,.8,.8,.9\n"
                   "pcl-sac,.3,1,.8,.4,.5,.5\npcl-sac-measured,.2,1,.8,.4,.5,.5\n");
    expectSuccess ("pcl_ops_evaluate run strip simulated:3000 --detectors ops --labels "
                   "labels");
    expectSuccess ("pcl_ops_evaluate detectors >detectors.txt");
    report_ = shell ("\"$PYTHON\" \"$REPORT\" .");
    EXPECT_EQ (report_.exit_code, 0) << report_.err;
  }

  Outcome report_{};
};

TEST_F (Report, HasTheTablesOfThePaperAndTheirFigures)
{
  EXPECT_TRUE (contains (report_.out, "Table III"));
  EXPECT_TRUE (contains (report_.out, "87.39"));
  EXPECT_TRUE (contains (report_.out, "0.6455"));
  EXPECT_FALSE (contains (report_.out, "Table II,")) << "no detector of it was run";
}

TEST_F (Report, CountsTruePlanesByTheirWidth)
{
  EXPECT_TRUE (contains (report_.out, "below 0.03"));
}

TEST_F (Report, CountsTruePlanesOfAGrownTruthByTheirSmallest)
{
  EXPECT_FALSE (contains (report_.out, "by the points of the smallest"));
  std::string results = contentOf (folder_ / "results.csv");
  const std::string planes = rowsOf (results).at (0).at ("truth_planes");
  results.replace (results.find (",exact,"), 7, ",grown-k30,");
  folder_.write ("results.csv", results);
  const std::string report = shell ("\"$PYTHON\" \"$REPORT\" .").out;
  EXPECT_TRUE (contains (report, "by the points of the smallest (the paper: 25.38)"));
  EXPECT_TRUE (contains (report, "| simulated, truth grown-k30 | " + planes + ".0 |"));
}

TEST_F (Report, SaysWhichOfSeveralTruthsOfADataSetIsCompared)
{
  EXPECT_FALSE (contains (report_.err, "truth")) << report_.err;
  const std::string results = contentOf (folder_ / "results.csv");
  std::string with_other_truth = results.substr (results.find ("\nsimulated,") + 1);
  with_other_truth.resize (with_other_truth.find ('\n') + 1);
  with_other_truth.replace (with_other_truth.find (",exact,"), 7, ",grown-k30,");
  folder_.write ("results.csv", results + with_other_truth);
  EXPECT_TRUE (contains (shell ("\"$PYTHON\" \"$REPORT\" .").err,
                         "report.py: simulated: has the truths exact, grown-k30; "
                         "comparison.csv and figure.png have grown-k30 alone\n"));
}

TEST_F (Report, CountsRunsThatWereStopped)
{
  EXPECT_TRUE (contains (report_.out, "| ops-3-30 | 1 |"));
  EXPECT_TRUE (contains (report_.out, "| pcl-sac | 0 | 1 | - |"));
}

TEST_F (Report, IsPrintedAndWritten)
{
  EXPECT_EQ (contentOf (folder_ / "report.md"), report_.out);
}

TEST_F (Report, ComparesMethodsInARowForEachDataSet)
{
  const Rows rows = rowsOf (contentOf (folder_ / "comparison.csv"));
  const auto rowOf = [&rows] (const std::string& data_set, const std::string& method) {
    for (const auto& row : rows)
      if (row.at ("data_set") == data_set && row.at ("method") == method)
        return row;
    ADD_FAILURE() << data_set << ' ' << method;
    return Rows::value_type();
  };
  auto ops = rowOf ("rooms", "ops-3-30");
  EXPECT_TRUE (contains (ops["version"], "pcl_ops "));
  EXPECT_EQ (ops["values"], "paper");
  EXPECT_GT (std::stod (ops["seconds_per_million_points"]), 0.0);
  EXPECT_LT (std::stod (ops["seconds_per_million_points"]), 1000.0);
  auto stopped = rowOf ("streets", "pcl-sac");
  EXPECT_EQ (stopped["stopped"], "1");
  EXPECT_EQ (stopped["f_score"], "");
}

TEST_F (Report, DrawsPlotsWhereThereIsMatplotlib)
{
  if (report_.err.find ("no plots") != std::string::npos)
    GTEST_SKIP() << report_.err;
  for (const char* plot : {"simulated-exact/classification_accuracy_over_time",
                           "time_over_points",
                           "throughput",
                           "steadiness",
                           "figure",
                           "strip-simulated-scan-3000"})
    EXPECT_GT (contentOf (folder_ / (plot + std::string (".png"))).size(), 1000u)
        << plot;
}

/** \brief A folder "own" with the results of a detector of one's own, "my-loop", and of
 * ops: for a simulated scan, and the same rows for rooms and for clouds of one's own.
 */
class ReportOfOwnLabels : public LabProgram {
protected:
  void
  SetUp () override
  {
    if (!fs::exists (PCL_OPS_PYTHON3))
      GTEST_SKIP() << "needs Python";
    for (const char* folder : {"wrong", "right"})
      fs::create_directory (folder_ / folder);
    folder_.write ("wrong/scan-3000.txt", repeated ("0\n", 3000));
    folder_.write ("right/scan-3000.txt", repeated ("1\n", 3000));
    // The labels of the last run count.
    expectSuccess ("pcl_ops_evaluate run own simulated:3000 --results my-loop=wrong "
                   "--labels own/labels");
    expectSuccess ("pcl_ops_evaluate run own simulated:3000 --results my-loop=right "
                   "--detectors ops --labels own/labels");
    const std::string results = contentOf (folder_ / "own/results.csv");
    const std::string rows = results.substr (results.find ('\n') + 1);
    folder_.write ("own/results.csv",
                   results + ofDataSet ("rooms", rows) + ofDataSet ("my-clouds", rows));
    report_ = shell ("\"$PYTHON\" \"$REPORT\" own");
    EXPECT_EQ (report_.exit_code, 0) << report_.err;
  }

  /** \brief Rows of the simulated scan under another name. */
  static std::string
  ofDataSet (const std::string& name, const std::string& rows)
  {
    return std::regex_replace (rows, std::regex ("simulated"), name);
  }

  Outcome report_{};
};

TEST_F (ReportOfOwnLabels, HasARowWithoutTimes)
{
  EXPECT_TRUE (contains (report_.out, "| my-loop | 1 |"));
  EXPECT_TRUE (contains (report_.out, "| my-loop | - | - | - | - | - | - | - |"));
  EXPECT_FALSE (contains (report_.out, "nan"));
}

TEST_F (ReportOfOwnLabels, ComparesThemInARowForEachDataSet)
{
  std::size_t number = 0;
  for (auto& row : rowsOf (contentOf (folder_ / "own/comparison.csv"))) {
    if (row["method"] != "my-loop")
      continue;
    ++number;
    EXPECT_EQ (row["values"], "own");
    EXPECT_EQ (row["clouds"], "1");
    EXPECT_GT (std::stod (row["classification_accuracy"]), 0.0);
    EXPECT_EQ (row["seconds_per_million_points"], "");
  }
  EXPECT_EQ (number, 3u);
}

TEST_F (ReportOfOwnLabels, HasNoColumnsOfThePaperForCloudsOfOnesOwn)
{
  EXPECT_TRUE (contains (report_.out, "my-clouds"));
  std::istringstream stream (report_.out);
  for (std::string line; std::getline (stream, line);)
    EXPECT_FALSE (line.find ("my-clouds") != std::string::npos &&
                  line.find ("paper") != std::string::npos)
        << line;
}

TEST_F (ReportOfOwnLabels, DrawsPicturesWhereThereIsMatplotlib)
{
  if (report_.err.find ("no plots") != std::string::npos)
    GTEST_SKIP() << report_.err;
  for (const char* plot : {"own/figure.png", "own/strip-simulated-scan-3000.png"})
    EXPECT_GT (contentOf (folder_ / plot).size(), 1000u) << plot;
}

TEST_F (Report, OfCloudsOfOnesOwnAloneDoesNotSpeakOfThePaper)
{
  const std::string results = contentOf (folder_ / "results.csv");
  const std::size_t first_row = results.find ('\n') + 1;
  const std::size_t end = results.find ('\n', first_row) + 1;
  fs::create_directory (folder_ / "mine_only");
  folder_.write ("mine_only/results.csv",
                 std::regex_replace (results.substr (0, end),
                                     std::regex ("\nsimulated"),
                                     "\nmy-clouds"));
  const Outcome done = shell ("\"$PYTHON\" \"$REPORT\" mine_only");
  EXPECT_EQ (done.exit_code, 0) << done.err;
  EXPECT_TRUE (contains (done.out, "| ops-3-30 | 1 |"));
  EXPECT_FALSE (contains (done.out, "paper"));
  EXPECT_FALSE (contains (done.out, "Table "));
}

} // namespace
