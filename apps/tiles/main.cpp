// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"
#include "ranks.h"
#include "tile_run.h"
#include <cli/interruption.h>
#include <cli/program.h>
#include <unistd.h>

#include <iostream>

namespace pcl_ops::apps {

namespace {

int
findInTiles (int argc, const char* const* argv, const Ranks& ranks)
{
  TilesOptions options;
  if (readOptions (argc, argv, options))
    runTiles (options, ranks, std::cout, std::cerr, ::isatty (STDERR_FILENO) == 1);
  return ExitCode::done;
}

} // namespace

} // namespace pcl_ops::apps

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  noteInterruptions();
  const Ranks ranks;
  const int code =
      runProgram (program_name, [&] { return findInTiles (argc, argv, ranks); });
  if (code != ExitCode::done) {
    ranks.endAll (code);
    endAsInterrupted();
  }
  return code;
}
