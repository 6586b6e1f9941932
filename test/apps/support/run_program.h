// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

/** \brief What a program said, on both its streams, and how it ended. */
struct ProgramRun {
  std::string program;
  /** \brief -1 if it crashed. */
  int exit_code = -1;
  std::string text = {};
};

inline ProgramRun
runProgram (const std::string& program, const std::string& arguments)
{
  ProgramRun run{std::filesystem::path (program).filename().string()};
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

/** \brief The program ended with this code after one line that names the
 * culprit. */
inline void
expectError (const ProgramRun& run, int exit_code, const std::string& culprit)
{
  EXPECT_EQ (run.exit_code, exit_code) << run.text;
  EXPECT_EQ (run.text.rfind (run.program + ": " + culprit + ": ", 0), 0u) << run.text;
  EXPECT_EQ (std::count (run.text.begin(), run.text.end(), '\n'), 1) << run.text;
}
