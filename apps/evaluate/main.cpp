// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cli/program.h>
#include <evaluate/commands.h>

int
main (int argc, char** argv)
{
  using namespace pcl_ops;
  return apps::runProgram ("pcl_ops_evaluate", [&] {
    return evaluation::runCommand (evaluation::commandsForResults(), argc, argv);
  });
}
