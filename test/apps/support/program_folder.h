// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <support/temporary_folder.h>
#include <support/text.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

/** \brief How a command ended, and what it wrote to its standard output and error. */
struct Outcome {
  /** \brief 128 plus its number if a signal ended the command. */
  int exit_code;
  std::string out, err;
};

/** \brief A test with an empty folder, in which it runs a program. */
class ProgramFolder : public testing::Test {
protected:
  /** \param[in] program path of the program; commands find all programs of that folder
   * by name */
  explicit ProgramFolder (std::string program) : program_ (std::move (program)) {}

  /** \brief Runs commands of the shell in the folder of the test. */
  Outcome
  shell (const std::string& commands) const
  {
    const std::string programs = std::filesystem::path (program_).parent_path();
    const std::string line = "PATH='" + programs + "':\"$PATH\"; cd '" +
                             folder_.path() + "' && { " + commands + "\n} >'" +
                             streams_ / "out" + "' 2>'" + streams_ / "err" + "'";
    const int status = std::system (line.c_str());
    return {WIFSIGNALED (status) ? 128 + WTERMSIG (status) : WEXITSTATUS (status),
            contentOf (streams_ / "out"),
            contentOf (streams_ / "err")};
  }

  /** \brief Runs the program, and fails the test unless its exit code is 0. */
  Outcome
  expectDone (const std::string& arguments) const
  {
    const Outcome done = shell ("'" + program_ + "' " + arguments);
    EXPECT_EQ (done.exit_code, 0) << arguments << done.out << done.err;
    return done;
  }

  std::string program_;
  TemporaryFolder folder_;
  TemporaryFolder streams_{"_streams"}; // of standard output and error
};
