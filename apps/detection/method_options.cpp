// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "method_options.h"

#include "shared_options.h"
#include <cli/command_line.h>
#include <cli/errors.h>

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

} // namespace

void
declareMethodOptions (CommandLine& line, std::string& method, DetectorOptions& options)
{
  line.addChoice ("method", methodNames(), method, "the detector (ops)");
  declareSharedOptions (line, options);
  for (const Method& known : allMethods()) {
    line.beginBriefGroup (groupOf (known));
    known.declare_options (line, options.own);
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
