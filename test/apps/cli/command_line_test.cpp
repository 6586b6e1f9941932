// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/command_line.h>
#include <cli/errors.h>
#include <support/text.h>

using namespace pcl_ops::apps;

namespace {

using Arguments = std::vector<const char*>;

/** \brief Parses the arguments of a call of a program "detect".
 * \return whether the program is to go on; false after --help or --version */
bool
parse (CommandLine& line, Arguments arguments)
{
  arguments.insert (arguments.begin(), "detect");
  return line.parse (static_cast<int> (arguments.size()), arguments.data());
}

/** \brief The values that the command line of a program "detect" sets. */
struct DetectCall {
  std::string input;
  double threshold = 0.05;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  bool quiet = false;
  /** \brief What \ref parse returned. */
  bool proceeds = false;
  /** \brief The error message of the command line; empty without an error. */
  std::string complaint;

  explicit DetectCall (const Arguments& arguments)
  {
    CommandLine line ("detect", "Detects.", "1.2.3");
    line.addArgument ("INPUT", input, "a cloud");
    line.add ("threshold M", threshold, above (0)).help ("distance");
    line.addUpAxis (up).help ("axis");
    line.add ("quiet", quiet).help ("no table");
    complaint = complaintOf ([&] { proceeds = parse (line, arguments); });
  }
};

} // namespace

TEST (CommandLine, TakesOptionsWithOneDashOrTwoAnEqualsSignOrAnAbbreviatedName)
{
  for (const Arguments& arguments : {Arguments{"in.pcd", "-threshold", "0.02"},
                                     Arguments{"in.pcd", "--threshold", "0.02"},
                                     Arguments{"-threshold=0.02", "in.pcd"},
                                     Arguments{"--threshold=0.02", "in.pcd"},
                                     Arguments{"--thresh=0.02", "--", "in.pcd"}}) {
    const DetectCall call (arguments);
    EXPECT_EQ (call.complaint, "") << arguments[0];
    EXPECT_EQ (call.threshold, 0.02) << arguments[0];
    EXPECT_EQ (call.input, "in.pcd") << arguments[0];
  }
}

TEST (CommandLine, AsksWhetherASimilarOptionIsMeant)
{
  const auto complaintAbout = [] (const char* option) {
    return DetectCall ({"in.pcd", option}).complaint;
  };
  const std::string unknown = "is no option of this program; ";
  EXPECT_EQ (complaintAbout ("--queit"),
             "--queit: " + unknown + "did you mean --quiet?");
  EXPECT_EQ (complaintAbout ("-thresholds=1"),
             "--thresholds: " + unknown + "did you mean --threshold?");
  EXPECT_EQ (complaintAbout ("--color"), "--color: " + unknown + "see --help");
}

TEST (CommandLine, StoresEachValueOfAnOptionThatMayBeRepeated)
{
  std::string joined;
  CommandLine line ("detect", "Detects.", "1.2.3");
  line.add ("add TEXT", [&joined] (const std::string& text) { joined += text; })
      .repeated();
  EXPECT_TRUE (parse (line, {"--add", "a", "--add=b"}));
  EXPECT_EQ (joined, "ab");
}

TEST (CommandLine, TakesTheFormerNameOfAnOptionAndDoesNotListIt)
{
  double size = 0.0;
  CommandLine line ("detect", "Detects.", "1.2.3");
  line.add ("voxel-size M", size, above (0)).help ("edge").onceCalled ("cell");
  EXPECT_TRUE (parse (line, {"--cell", "0.5"}));
  EXPECT_EQ (size, 0.5);
  EXPECT_TRUE (line.isGiven ("voxel-size"));
  constexpr bool is_full = true;
  EXPECT_EQ (line.help (is_full).find ("cell"), std::string::npos);
}

TEST (CommandLine, TakesNegativeNumbersAndTheCameraForUp)
{
  EXPECT_EQ (DetectCall ({"in.pcd", "--up", "-1,0,-0.5"}).up,
             Eigen::Vector3f (-1, 0, -0.5));
  EXPECT_EQ (DetectCall ({"in.pcd", "--up", "camera"}).up, Eigen::Vector3f (0, -1, 0));
}

TEST (CommandLine, PrintsHelpOrVersionAfterWhichTheProgramIsToEnd)
{
  for (const char* question : {"--help", "-help", "-h", "--version"}) {
    testing::internal::CaptureStdout();
    const DetectCall call ({question});
    EXPECT_EQ (call.complaint, "") << question;
    EXPECT_FALSE (testing::internal::GetCapturedStdout().empty()) << question;
    EXPECT_FALSE (call.proceeds) << question;
  }
}

TEST (CommandLine, PrintsHelpInTwoColumnsAndBreaksLinesBetweenWords)
{
  std::string ignored;
  CommandLine line ("detect", "Detects.", "1.0");
  constexpr std::size_t begin_of_help = 24; // column of the texts on options
  // With "more" the line would have more than 79 columns.
  const std::string full_line =
      "as many words as a line of 79 columns can hold, and no";
  line.addArgument ("INPUT", ignored, "a cloud");
  line.addArgument ("OUTPUT.pcd", ignored, "the same with labels");
  line.add ("detector FILE", ignored).help (full_line + " more");
  EXPECT_TRUE (contains (line.help(),
                         "\nArguments:\n  INPUT        a cloud\n  OUTPUT.pcd   the"));
  EXPECT_TRUE (contains (line.help(),
                         "\n  --detector FILE       " + full_line + "\n" +
                             std::string (begin_of_help, ' ') + "more\n"));
}
