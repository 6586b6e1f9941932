// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>

#include <nlohmann/json.hpp>
#include <support/temporary_folder.h>
#include <support/text.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <utility>

struct Outcome {
  int exit_code;
  std::string out, err;
};

inline Eigen::Vector3d
toVector (const nlohmann::json& array)
{
  return {array[0].get<double>(), array[1].get<double>(), array[2].get<double>()};
}

/** \brief A folder to run a program in. */
class ProgramFolder : public testing::Test {
protected:
  explicit ProgramFolder (std::string program) : program_ (std::move (program)) {}

  /** \brief Runs commands of the shell in the folder, which find all programs. */
  Outcome
  shell (const std::string& commands) const
  {
    const std::string programs = std::filesystem::path (program_).parent_path();
    const std::string line = "PATH='" + programs + "':\"$PATH\"; cd '" +
                             folder_.path() + "' && { " + commands + "\n} >'" +
                             streams_ / "out" + "' 2>'" + streams_ / "err" + "'";
    const int status = std::system (line.c_str());
    return {WEXITSTATUS (status),
            contentOf (streams_ / "out"),
            contentOf (streams_ / "err")};
  }

  /** \brief Runs the program. \param[in] before what is in front of it */
  Outcome
  run (const std::string& arguments, const std::string& before = "") const
  {
    return shell (before + " '" + program_ + "' " + arguments);
  }

  Outcome
  expectDone (const std::string& arguments, const std::string& before = "") const
  {
    const Outcome done = run (arguments, before);
    EXPECT_EQ (done.exit_code, 0) << arguments << done.out << done.err;
    return done;
  }

  /** \brief A run that ends with a code after one line that begins with a complaint. */
  void
  expectRefused (const std::string& arguments,
                 const std::string& complaint,
                 int exit_code = 1,
                 const std::string& before = "") const
  {
    const Outcome done = run (arguments, before);
    const std::string name = std::filesystem::path (program_).filename().string();
    EXPECT_EQ (done.exit_code, exit_code) << arguments;
    EXPECT_EQ (done.err.find (name + ": " + complaint), 0u) << done.err;
    EXPECT_EQ (lines (done.err), 1u) << done.err;
  }

  nlohmann::json
  jsonIn (const std::string& file) const
  {
    return nlohmann::json::parse (contentOf (folder_ / file));
  }

  std::string program_;
  TemporaryFolder folder_;
  TemporaryFolder streams_{"_streams"};
};
