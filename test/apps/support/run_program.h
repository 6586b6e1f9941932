// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

/** \brief What a program said, on both its streams, and how it ended. */
struct ProgramRun {
  /** \brief -1 if it crashed. */
  int exit_code = -1;
  std::string text;
};

inline ProgramRun
runProgram (const std::string& program, const std::string& arguments)
{
  ProgramRun run;
  const std::string command = "'" + program + "' " + arguments + " 2>&1";
  FILE* const pipe = popen (command.c_str(), "r");
  if (pipe == nullptr)
    return run;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = fread (buffer.data(), 1, buffer.size(), pipe))
    run.text.append (buffer.data(), count);
  const int status = pclose (pipe);
  if (WIFEXITED (status))
    run.exit_code = WEXITSTATUS (status);
  return run;
}
