// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "method_options.h"

#include <cli/errors.h>
#include <cli/option_value.h>

#include <vector>

namespace pcl_ops::apps {

namespace {

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

/** \brief The options all methods share. */
void
declareSharedOptions (CommandLine& line, DetectorOptions& detector)
{
  constexpr double most_threads = 1024;
  constexpr double right_angle = 90;
  line.addChoice ("preset",
                  {"default", "paper"},
                  detector.preset,
                  "recommended parameters, or the paper's best ones");
  line.addNumber ("threshold",
                  "M",
                  Range::above (0),
                  detector.threshold,
                  "farthest point of a plane (0.05; ops: auto)");
  line.addNumber ("angle-tolerance",
                  "DEG",
                  Range::from (0).upTo (right_angle),
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
                  Range::from (0).upTo (most_threads),
                  detector.threads,
                  "0 for all; the result stays the same (1)");
}

} // namespace

void
declareMethodOptions (CommandLine& line, std::string& method, DetectorOptions& options)
{
  line.addChoice ("method", methodNames(), method, "the detector (ops)");
  declareSharedOptions (line, options);
  for (const Method& known : allMethods()) {
    line.beginBriefGroup (groupOf (known));
    known.declare_options (line, options);
  }
}

void
checkMethodOptions (const CommandLine& line, const Method& chosen)
{
  for (const Method& method : allMethods()) {
    const std::vector<std::string> given = line.givenOf (groupOf (method));
    if (method.name != chosen.name && !given.empty())
      throw UsageError ("--" + given.front(),
                        "is an option of --method " + method.name + ", not of " +
                            chosen.name + "; leave it out");
  }
}

} // namespace pcl_ops::apps
