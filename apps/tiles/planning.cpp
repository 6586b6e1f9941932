// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "planning.h"

#include "phases.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <io/inputs.h>
#include <io/output_file.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>
#include <utility>
#include <vector>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

bool
isUtf8 (const std::string& text)
{
  try {
    return !nlohmann::json (text).dump().empty();
  }
  catch (const nlohmann::json::type_error&) {
    return false;
  }
}

/** \brief Refuses a name that the lists of inputs and of planes could not have. */
void
checkName (const std::string& file)
{
  const fs::path path = fs::absolute (file);
  if (!isUtf8 (path.filename().string()))
    throw WorkError (file, "its name is not UTF-8; rename it");
  if (!isUtf8 (path.lexically_normal().string()))
    throw WorkError (file, "the name of a folder it is in is not UTF-8; rename it");
}

/** \brief Leaves out links to files that are there already, as their points would count
 * twice. A file goes before links to it, whatever the order of the names. */
std::vector<std::string>
eachFileOnce (std::vector<std::string> names)
{
  std::error_code ignored;
  std::sort (names.begin(), names.end());
  std::stable_partition (names.begin(), names.end(), [&] (const std::string& name) {
    return !fs::is_symlink (name, ignored);
  });
  std::map<std::pair<dev_t, ino_t>, std::string> seen;
  std::vector<std::string> files;
  for (const std::string& name : names) {
    struct stat status {};
    const bool is_there = ::stat (name.c_str(), &status) == 0;
    const auto [known, is_new] =
        seen.emplace (std::pair (status.st_dev, status.st_ino), name);
    if (is_there && !is_new)
      warn (name + ": is the same file as " + known->second + "; it is left out");
    else
      files.push_back (name);
  }
  return files;
}

std::vector<std::string>
inputsOf (const TilesOptions& options)
{
  InputFiles found = findInputs (options.inputs);
  if (!found.problems.empty())
    throw WorkError ("INPUT", found.problems.front());
  for (const std::string& file : found.files)
    checkName (file);
  return eachFileOnce (std::move (found.files));
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
checkClashes (const Plan& plan, const RunFolder& folder, const TilesOptions& options)
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
  input_of.emplace (resolvedName (folder.output (planes_file)), "");
  for (const auto& [option, file] :
       {std::pair ("--planes", options.planes), std::pair ("--image", options.image)}) {
    if (file.empty())
      continue;
    const std::string resolved = resolvedName (file);
    if (inputs.count (resolved) > 0 || !input_of.emplace (resolved, "").second)
      throw UsageError (
          file, std::string ("is an input or another output; give another ") + option);
    checkWritable (file);
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
  checkClashes (plan, folder, options);
  if (!has_own)
    folder.startAnew();
  for (const PlanFile& file : {named, own})
    if (!isThere (file.name))
      savePlan (file.name, plan);
}

} // namespace pcl_ops::apps
