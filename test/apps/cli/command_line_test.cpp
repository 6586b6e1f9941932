// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/command_line.h>
#include <cli/errors.h>
#include <support/text.h>

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

using namespace pcl_ops::apps;

namespace {

/** \brief A program with one option of each kind. */
struct Detector {
  std::string input, method = "ops", image;
  double threshold = 0.05;
  std::optional<int> k;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  bool quiet = false;
  bool proceeds = false;

  /** \return what the command line complains about, empty if nothing */
  std::string
  parse (const std::vector<std::string>& arguments)
  {
    CommandLine line ("detect", "Detects.", "1.2.3");
    line.addArgument ("INPUT", input, "a cloud");
    line.addChoice ("method", {"ops", "fspf"}, method, "the algorithm");
    line.addText ("image", "FILE", image, "a picture");
    line.addNumber ("threshold", "M", Range::above (0), threshold, "distance");
    line.addNumber ("k", "K", Range::from (3).upTo (100), k, "neighbors");
    line.addUpAxis (up, "axis");
    line.addFlag ("quiet", quiet, "no table");
    std::vector<const char*> argv{"detect"};
    for (const std::string& argument : arguments)
      argv.push_back (argument.c_str());
    return complaintOf ([&] {
      proceeds = line.parse (static_cast<int> (argv.size()), argv.data());
      line.forbidTogether ("quiet", "image");
    });
  }
};

} // namespace

TEST (CommandLine, TakesOneDashTwoDashesAndEquals)
{
  for (const char* dashes : {"-threshold", "--threshold"}) {
    Detector spaced, joined;
    EXPECT_EQ (spaced.parse ({"in.pcd", dashes, "0.02"}), "");
    EXPECT_EQ (joined.parse ({std::string (dashes) + "=0.02", "in.pcd"}), "");
    EXPECT_EQ (spaced.threshold, 0.02);
    EXPECT_EQ (joined.threshold, 0.02);
    EXPECT_EQ (joined.input, "in.pcd");
  }
}

TEST (CommandLine, TakesTheStartOfANameThatNoOtherHas)
{
  Detector detector;
  EXPECT_EQ (detector.parse ({"--thresh=0.02", "--", "-in.pcd"}), "");
  EXPECT_EQ (detector.threshold, 0.02);
  EXPECT_EQ (detector.input, "-in.pcd");
  EXPECT_EQ (detector.parse ({"a", "--", "--quiet"}),
             "--quiet: is one argument too many; see --help");
  EXPECT_EQ (detector.parse ({"--"}), "INPUT: is missing; see --help");
}

TEST (CommandLine, TakesNegativeNumbersForValues)
{
  Detector detector;
  EXPECT_EQ (detector.parse ({"in.pcd", "--up", "-1,0,-0.5"}), "");
  EXPECT_EQ (detector.up, Eigen::Vector3f (-1, 0, -0.5));
}

TEST (CommandLine, TakesTheCameraForUp)
{
  Detector detector;
  EXPECT_EQ (detector.parse ({"in.pcd", "--up", "camera"}), "");
  EXPECT_EQ (detector.up, Eigen::Vector3f (0, -1, 0));
}

TEST (CommandLine, TellsGivenOptionsFromDefaults)
{
  Detector with, without;
  EXPECT_EQ (with.parse ({"in.pcd", "-k", "30", "--quiet"}), "");
  EXPECT_EQ (without.parse ({"in.pcd"}), "");
  EXPECT_EQ (with.k, 30);
  EXPECT_TRUE (with.quiet);
  EXPECT_FALSE (without.k);
  EXPECT_FALSE (without.quiet);
}

TEST (CommandLine, RefusesOptionsThatContradictEachOther)
{
  EXPECT_EQ (Detector().parse ({"a", "--quiet", "--image", "x.png"}),
             "--quiet: contradicts --image; give only one of them");
}

TEST (CommandLine, RefusesWholeNumbersThatAreTooLargeForTheirType)
{
  const auto complaint = [] (auto type, const std::string& text) {
    return complaintOf (
        [&] { parseNumber<decltype (type)> ("n", text, Range::from (1)); });
  };
  const auto too_large = [] (const std::string& text) {
    return "n: " + text + " is out of range; give a whole number from 1 on";
  };
  // The largest of 64 bits is no double: the next one is 2^64.
  for (const std::string text : {"18446744073709551615", "18446744073709551616"})
    EXPECT_EQ (complaint (std::size_t{}, text), too_large (text));
  EXPECT_EQ (complaint (std::uint32_t{}, "4294967296"), too_large ("4294967296"));
  EXPECT_EQ (complaint (int{}, "2147483648"), too_large ("2147483648"));
  EXPECT_EQ (parseNumber<std::size_t> ("n", "9223372036854775808", Range::from (1)),
             9223372036854775808U);
  EXPECT_EQ (parseNumber<std::uint32_t> ("n", "4294967295", Range::from (1)),
             std::numeric_limits<std::uint32_t>::max());
  EXPECT_EQ (parseNumber<int> ("n", "-2147483648", Range::any()),
             std::numeric_limits<int>::lowest());
}

TEST (CommandLine, TellsTheOptionsOfAGroupThatWereGiven)
{
  CommandLine line ("detect", "Detects.", "1.0");
  std::optional<int> k, bins, samples, size;
  line.addNumber ("k", "K", Range::any(), k, "neighbors");
  line.beginGroup ("Hough");
  line.addNumber ("bins", "N", Range::any(), bins, "of the accumulator");
  line.addNumber ("samples", "N", Range::any(), samples, "of a cluster");
  line.addNumber ("size", "N", Range::any(), size, "of a cluster");
  const std::array<const char*, 5> arguments{"detect", "--k", "3", "--samples", "4"};
  ASSERT_TRUE (line.parse (static_cast<int> (arguments.size()), arguments.data()));
  EXPECT_EQ (samples, 4);
  EXPECT_EQ (line.givenOf ("Hough"), std::vector<std::string>{"samples"});
  const std::array<const char*, 3> ambiguous{"detect", "--s", "4"};
  EXPECT_THROW (line.parse (static_cast<int> (ambiguous.size()), ambiguous.data()),
                UsageError);
  EXPECT_TRUE (contains (line.help(), "\nHough:\n  --bins"));
}

TEST (CommandLine, ListsArgumentsLikeOptions)
{
  std::string input, output;
  CommandLine line ("detect", "Detects.", "1.0");
  line.addArgument ("INPUT", input, "a cloud");
  line.addArgument (
      "OUTPUT.pcd", output, "the same cloud with the plane of each point");
  EXPECT_TRUE (contains (line.help(),
                         "\nArguments:\n  INPUT        a cloud\n  OUTPUT.pcd   the"));
}

TEST (CommandLine, PrintsHelpAndVersion)
{
  for (const char* question : {"--help", "-help", "-h", "--version"}) {
    Detector detector;
    testing::internal::CaptureStdout();
    EXPECT_EQ (detector.parse ({question}), "");
    EXPECT_FALSE (testing::internal::GetCapturedStdout().empty());
    EXPECT_FALSE (detector.proceeds);
  }
}

TEST (CommandLine, BreaksLongMeaningsBetweenWords)
{
  std::string value;
  CommandLine line ("detect", "Detects.", "1.0");
  const std::string full = "as many words as a line of 79 columns can hold, and no";
  line.addText ("detector", "FILE", value, full + " more");
  EXPECT_TRUE (contains (line.help(),
                         "\n  --detector FILE       " + full + "\n" +
                             std::string (24, ' ') + "more\n"));
}
