// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch.h"
#include "options.h"
#include "report.h"
#include "segment_cloud.h"
#include <cli/interruption.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <io/cloud_file.h>
#include <unistd.h>

#include <iostream>

namespace pcl_ops::apps {

namespace {

Report
segmentTold (const SegmentOptions& options, const Task& task)
{
  if (options.quiet)
    return segmentCloud (options, task);
  StageLines lines (std::cerr);
  return segmentCloud (options, task, idsBySize, [&] (const std::string& stage) {
    lines.begin (stage);
  });
}

int
segmentOne (const SegmentOptions& options)
{
  const Task task = taskOf (options);
  const Report report = segmentTold (options, task);
  if (!report.damage.empty())
    warn (report.input + ": " + report.damage);
  const bool prints_json = task.outputs.planes == standard_stream;
  if (options.quiet || prints_json)
    return ExitCode::done;
  printTable (report, std::cout);
  if (!task.outputs.image.empty())
    std::cout << task.outputs.image
              << ": left each plane in its colour; right horizontal "
              << "green, vertical blue, other orange; no plane grey\n";
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
  // A batch is about its files, whose writing a closed pipe must not cut short.
  ignoreClosedPipes();
  return runBatch (
      options, batchOf (options), std::cout, std::cerr, ::isatty (STDERR_FILENO) == 1);
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
    endAsInterrupted();
  return code;
}
