// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning.h"

#include "phases.h"
#include <cli/errors.h>
#include <io/inputs.h>
#include <io/output_file.h>

#include <map>
#include <set>
#include <vector>

namespace pcl_ops::apps {

namespace {

std::vector<std::string>
inputsOf (const TilesOptions& options)
{
  InputFiles found = findInputs (options.inputs);
  if (!found.problems.empty())
    throw WorkError ("INPUT", found.problems.front());
  return std::move (found.files);
}

PlanFile
namedBy (const TilesOptions& options)
{
  return {options.plan_file, "remove it or give another --plan"};
}

Plan
earlierPlan (const PlanFile& file, const TilesOptions& options)
{
  Plan plan = loadPlan (file);
  checkIsFor (plan, file, inputsOf (options), options.plan);
  return plan;
}

/** \brief Refuses outputs that would be written over each other or over an input. */
void
checkClashes (const Plan& plan, const RunFolder& folder)
{
  std::map<std::string, std::string> input_of;
  std::set<std::string> inputs;
  for (const PlannedInput& input : plan.inputs)
    inputs.insert (resolvedName (input.file));
  checkWritable (folder.output (planes_file));
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    const std::string output = outputOf (plan, folder, i);
    const std::string resolved = resolvedName (output);
    if (inputs.count (resolved) > 0)
      throw UsageError (output, "is an input, too; give another --output-dir");
    const auto [first, is_new] = input_of.emplace (resolved, plan.inputs[i].file);
    if (!is_new)
      throw UsageError (first->second + " and " + plan.inputs[i].file,
                        "would both be written to " + output + "; rename one");
    checkWritable (output);
  }
}

} // namespace

Plan
newPlan (const TilesOptions& options)
{
  return makePlan (inputsOf (options), options.plan);
}

PlanFile
planFileOf (const RunFolder& folder)
{
  return {folder.plan(), "remove its folder or give another --output-dir"};
}

void
preparePlan (const TilesOptions& options, const RunFolder& folder)
{
  const PlanFile own = planFileOf (folder);
  const PlanFile named = options.plan_file.empty() ? own : namedBy (options);
  const bool has_own = isThere (own.name);
  const Plan plan = isThere (named.name) ? earlierPlan (named, options)
                    : has_own            ? earlierPlan (own, options)
                                         : newPlan (options);
  if (has_own && !isSame (loadPlan (own), plan))
    throw WorkError (own.name, "is another plan than " + named.name + "; " + own.mend);
  checkClashes (plan, folder);
  if (!has_own)
    folder.startAnew();
  for (const PlanFile& file : {named, own})
    if (!isThere (file.name))
      savePlan (file.name, plan);
}

} // namespace pcl_ops::apps
