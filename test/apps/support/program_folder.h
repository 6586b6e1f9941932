// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <support/temporary_folder.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

struct Outcome {
  int exit_code;
  std::string out, err;
};

/** \brief Arguments of wrong runs, and what each has to say. */
using Complaints = std::vector<std::pair<std::string, std::string>>;

inline std::size_t
lines (const std::string& text)
{
  return static_cast<std::size_t> (std::count (text.begin(), text.end(), '\n'));
}

inline bool
contains (const std::string& text, const std::string& part)
{
  return text.find (part) != std::string::npos;
}

/** \brief A folder to run programs in. */
class ProgramFolder : public testing::Test {
protected:
  /** \brief Runs a command of the shell in the folder. */
  Outcome
  shell (const std::string& command) const
  {
    const std::string line = "cd '" + folder_.path() + "' && " + command + " >'" +
                             streams_ / "out" + "' 2>'" + streams_ / "err" + "'";
    const int status = std::system (line.c_str());
    return {WEXITSTATUS (status),
            contentOf (streams_ / "out"),
            contentOf (streams_ / "err")};
  }

  TemporaryFolder folder_;
  TemporaryFolder streams_{"_streams"};
};
