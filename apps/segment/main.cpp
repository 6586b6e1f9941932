// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch_run.h"
#include "segment_cloud.h"
#include <cli/program.h>
#include <cli/progress.h>
#include <detection/warning_lines.h>
#include <io/output_file.h>

#include <iostream>

namespace pcl_ops::apps {

namespace {

/** \brief Prints Report::file_notes and the warnings to the standard error. */
void
printFileNotesAndWarnings (const Report& report)
{
  for (const std::string& line : report.file_notes)
    warn (line);
  WarningLines warnings;
  warnings.add (report.input, report.warnings);
  for (const std::string& line : warnings.lines())
    warn (line);
}

/** \brief Segments one cloud and prints the result.
 * \return the exit code */
int
segmentOne (const SegmentOptions& options)
{
  const Task task = taskOf (options);
  std::optional<StageLines> progress;
  if (!options.quiet)
    progress.emplace (std::cerr);
  const Report report = inMemory (nameOfInput (task), "give a smaller cloud", [&] {
    return segmentCloud (options, task, {}, progress ? &*progress : nullptr);
  });
  progress.reset();           // so that no progress line is printed after the results
  if (!report.damage.empty()) // also with --quiet: its planes are probably wrong
    warn (report.input + ": " + report.damage);
  if (!options.quiet)
    printFileNotesAndWarnings (report);
  const bool stdout_is_json = task.outputs.planes == standard_stream;
  if (options.quiet || stdout_is_json)
    return ExitCode::done;
  printTable (report, std::cout);
  if (!task.outputs.image.empty())
    std::cout << task.outputs.image
              << ": left each plane in its color; right horizontal "
              << "green, vertical blue, other orange; no plane gray\n";
  return ExitCode::done;
}

int
segment (int argc, const char* const* argv)
{
  SegmentOptions options;
  if (!readOptions (argc, argv, options))
    return ExitCode::done;
  if (!options.isBatch())
    return segmentOne (options);
  // A closed pipe of the standard output must not end a batch, which writes files.
  ignoreClosedPipes();
  return runBatch (options, batchOf (options));
}

} // namespace

} // namespace pcl_ops::apps

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  noteInterruptions();
  const int code = runProgram (program_name, [&] { return segment (argc, argv); });
  if (code != ExitCode::done)
    endAsInterrupted(); // returns if no signal interrupted the program
  return code;
}
