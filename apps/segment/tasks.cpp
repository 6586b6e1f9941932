// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tasks.h"

#include "parts.h"
#include <cli/errors.h>
#include <io/inputs.h>
#include <io/laz_file.h>
#include <io/output_file.h>

#include <filesystem>
#include <map>
#include <utility>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

struct Claim {
  std::string name;
  const Task* task;
};

/** \brief Who writes what, by absolute names. */
using Claims = std::map<std::string, Claim>;

void
claim (const std::string& output, const Task& task, Claims& claims)
{
  const auto [first, is_new] =
      claims.emplace (resolvedName (output), Claim{output, &task});
  if (is_new)
    return;
  if (first->second.task == &task)
    throw UsageError (output, "is the name of two outputs; give each its own");
  throw UsageError (first->second.task->input + " and " + task.input,
                    "would both be written to " + output +
                        "; rename one or give them in two runs");
}

/** \brief Refuses outputs that would be taken for planes of an earlier run. */
void
checkPlaneNames (const Claims& files, const Claims& folders)
{
  for (const auto& [name, output] : files) {
    const fs::path path = name;
    if (folders.count (path.parent_path().string()) > 0 &&
        isPlaneFile (path.filename().string()))
      throw UsageError (output.name,
                        "has the name of a plane in --planes-dir; give it another name "
                        "or folder");
  }
}

/** \brief Refuses outputs that would be written over each other or over an input.
 * \param[in] poses an input, too; empty for none */
void
checkClashes (const std::vector<Task>& tasks,
              const std::string& poses,
              const std::string& mend)
{
  Claims files, folders;
  for (const Task& task : tasks) {
    for (const std::string& file : task.outputs.files()) {
      claim (file, task, files);
      if (isSameFile (task.input, file))
        throw UsageError (file, "is the input, too; " + mend);
    }
    if (!task.outputs.planes_dir.empty())
      claim (task.outputs.planes_dir, task, folders);
  }
  checkPlaneNames (files, folders);
  if (const auto file = files.find (resolvedName (poses)); file != files.end())
    throw UsageError (file->second.name, "is the file of --poses, too; " + mend);
  for (const Task& task : tasks) {
    const fs::path input = resolvedName (task.input);
    const auto file = files.find (input.string());
    if (file != files.end())
      throw UsageError (file->second.name, "is an input, too; " + mend);
    if (folders.count (input.parent_path().string()) > 0)
      throw UsageError ("--planes-dir",
                        "the input " + task.input + " lies in it; give another folder");
  }
}

std::string
inFolder (const std::string& folder, std::string pattern, const std::string& name)
{
  const std::string placeholder = name_of_input;
  for (std::size_t i = 0; (i = pattern.find (placeholder, i)) != std::string::npos;
       i += name.size())
    pattern.replace (i, placeholder.size(), name);
  return pattern.empty() ? "" : (fs::path (folder) / pattern).string();
}

Task
batchTask (const SegmentOptions& options, const std::string& input)
{
  const std::string name = fs::path (input).stem().string();
  const auto output = [&] (const std::string& pattern) {
    return inFolder (options.output_dir, pattern, name);
  };
  const Outputs& given = options.outputs;
  Task task{input, {}};
  const bool stays_las = isLasName (input) && options.format.empty();
  task.outputs.cloud =
      output ("{}" + (stays_las ? extensionOf (input) : options.fileFormat()));
  task.outputs.planes = output (given.planes.empty() ? "{}.json" : given.planes);
  task.outputs.image = output (given.image);
  task.outputs.mesh = output (given.mesh);
  task.outputs.edges = output (given.edges);
  task.outputs.rest = output (given.rest);
  task.outputs.planes_dir = output (given.planes_dir);
  return task;
}

} // namespace

Task
taskOf (const SegmentOptions& options)
{
  Task task{options.inputs[0], options.outputs};
  checkClashes ({task}, "", "give the output another name");
  if (!task.outputs.planes_dir.empty())
    makeFolder (task.outputs.planes_dir);
  for (const std::string& file : task.outputs.files())
    checkWritable (file);
  return task;
}

Batch
batchOf (const SegmentOptions& options)
{
  InputFiles inputs = findInputs (options.inputs);
  Batch batch;
  batch.problems = std::move (inputs.problems);
  for (const std::string& input : inputs.files)
    batch.tasks.push_back (batchTask (options, input));
  checkClashes (batch.tasks, options.track.poses, "give another --output-dir");
  if (!batch.tasks.empty())
    makeFolder (options.output_dir);
  return batch;
}

} // namespace pcl_ops::apps
