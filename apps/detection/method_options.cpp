// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "method_options.h"

#include "number_options.h"
#include <cli/errors.h>

#include <cmath>
#include <vector>

namespace pcl_ops::apps {

namespace {

std::string
groupOf (const Method& method)
{
  return "Options of --method " + method.name + ", " + method.title;
}

void
declareShared (CommandLine& line, DetectorOptions& options)
{
  line.addChoice ("preset",
                  {"default", "paper"},
                  options.preset,
                  "recommended parameters, or the paper's best ones");
  line.addValue ("up",
                 "x,y,z",
                 "direction against gravity, camera or auto (0,0,1)",
                 [&options] (const std::string& text) {
                   options.finds_up = text == "auto";
                   if (!options.finds_up)
                     options.up = parseUpAxis ("--up", text);
                 });
  declare (PlaneDetectorParameters(), {}, line, options.numbers);
}

} // namespace

void
declareMethodOptions (CommandLine& line, std::string& method, DetectorOptions& options)
{
  std::vector<std::string> names;
  for (const Method& known : allMethods())
    names.push_back (known.name);
  line.addChoice ("method", names, method, "the detector (ops)");
  declareShared (line, options);
  for (const Method& known : allMethods()) {
    line.beginBriefGroup (groupOf (known));
    known.declare_options (line, options.numbers);
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

double
voxelStepOf (const DetectorOptions& options)
{
  OrientedPointSamplingParameters parameters;
  apply (options.numbers, parameters);
  const double edge = parameters.surfels.voxel_size.value_or (0.0);
  return std::ldexp (edge, parameters.surfels.resolutions - 1);
}

} // namespace pcl_ops::apps
