// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include <common/command_line.h>
#include <common/output_file.h>

#include <algorithm>
#include <vector>

namespace pcl_ops::apps {

namespace {

constexpr const char* kSummary =
    "Finds the planes of a point cloud and labels every point with its plane. Where "
    "there\n"
    "is none, it labels all points 0 and says which option to change; that is no "
    "failure.\n"
    "Lengths are in the unit of the cloud, metres by default; angles in degrees.";

std::vector<std::string>
methodNames ()
{
  std::vector<std::string> names;
  for (const Method& method : allMethods())
    names.push_back (method.name);
  return names;
}

std::string
groupOf (const Method& method)
{
  return "Options of --method " + method.name + ", " + method.title;
}

void
declareOutputs (CommandLine& line, SegmentOptions& options)
{
  line.addText ("planes", "FILE", options.planes, "write the planes as .json or .csv");
  line.addText ("image", "FILE.png", options.image, "write a picture of the planes");
  line.addFlag (
      "keep-color", options.keep_color, "keep the rgb of the input in OUTPUT");
  line.addFlag ("quiet", options.quiet, "print no table");
}

/** \brief The options all methods share. */
void
declareDetector (CommandLine& line, DetectorOptions& detector)
{
  constexpr double kMostThreads = 1024;
  constexpr double kRightAngle = 90;
  line.addChoice ("preset",
                  {"default", "paper"},
                  detector.preset,
                  "recommended parameters, or the paper's best ones");
  line.addNumber ("threshold",
                  "M",
                  Range::above (0),
                  detector.threshold,
                  "largest distance of a point to its plane (0.05; ops: auto)");
  line.addNumber ("angle-tolerance",
                  "DEG",
                  Range::from (0).upTo (kRightAngle),
                  detector.angle_tolerance,
                  "largest tilt of horizontal and vertical planes (7)");
  line.addValue ("up",
                 "x,y,z",
                 "direction against gravity, or auto to find it (0,0,1)",
                 [&detector] (const std::string& text) {
                   detector.finds_up = text == "auto";
                   if (!detector.finds_up)
                     detector.up = parseDirection ("--up", text);
                 });
  line.addNumber (
      "seed", "S", Range::from (0), detector.seed, "same seed, same result (42)");
  line.addNumber ("threads",
                  "T",
                  Range::from (0).upTo (kMostThreads),
                  detector.threads,
                  "0 for all; the result stays the same (1)");
}

/** \brief Refuses options that only other methods understand. */
void
checkMethod (const CommandLine& line, const Method& chosen)
{
  for (const Method& method : allMethods()) {
    const std::vector<std::string> given = line.givenOf (groupOf (method));
    if (method.name != chosen.name && !given.empty())
      throw UsageError ("--" + given.front(),
                        "is an option of --method " + method.name + ", not of " +
                            chosen.name + "; leave it out");
  }
}

void
checkExtension (const std::string& subject,
                const std::string& file,
                const std::vector<std::string>& extensions)
{
  if (file.empty())
    return;
  const std::string extension = extensionOf (file);
  if (std::find (extensions.begin(), extensions.end(), extension) == extensions.end()) {
    std::string list;
    for (const std::string& known : extensions)
      list += (list.empty() ? "" : " or ") + known;
    throw UsageError (subject, file + " has an unknown extension; give a file " + list);
  }
}

void
checkOutputs (const SegmentOptions& options)
{
  checkExtension ("OUTPUT", options.output, {".pcd"});
  checkExtension ("--planes", options.planes, {".json", ".csv"});
  checkExtension ("--image", options.image, {".png"});
  const bool has_output =
      !options.output.empty() || !options.planes.empty() || !options.image.empty();
  if (options.quiet && !has_output)
    throw UsageError (
        "--quiet", "leaves nothing to do; give OUTPUT.pcd, --planes or --image, too");
  if (options.keep_color && options.output.empty())
    throw UsageError ("--keep-color", "is about OUTPUT.pcd; give one");
  if (!options.output.empty() && isSameFile (options.input, options.output))
    throw UsageError (options.output,
                      "is the input, too; give the output another name");
  for (const std::string& file : {options.output, options.planes, options.image})
    if (!file.empty())
      checkWritable (file);
}

} // namespace

bool
readOptions (int argc, const char* const* argv, SegmentOptions& options)
{
  CommandLine line ("pcl_ops_segment", kSummary, PCL_OPS_VERSION);
  line.addArgument ("INPUT", options.input, "the cloud, a .pcd or .ply file");
  line.addOptionalArgument (
      "OUTPUT.pcd",
      options.output,
      "the same cloud with label (0: no plane, 1: largest) and rgb");
  declareOutputs (line, options);
  line.addChoice ("method", methodNames(), options.method, "the detector (ops)");
  declareDetector (line, options.detector);
  for (const Method& method : allMethods()) {
    line.beginGroup (groupOf (method));
    method.declare_options (line, options.detector);
  }
  if (!line.parse (argc, argv))
    return false;
  checkMethod (line, methodCalled (options.method));
  checkOutputs (options);
  return true;
}

} // namespace pcl_ops::apps
