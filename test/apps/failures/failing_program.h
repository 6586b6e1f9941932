// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <support/temporary_folder.h>
#include <support/text.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

/** \brief A program that writes one file of its many, and what is known of that. */
struct Output {
  std::string name;
  std::string program;
  /** \brief OUT stands for the name of the output. */
  std::string arguments;
  /** \brief What OUT stands for. */
  std::string file;
  /** \brief A file that has to be as it was after a failure; empty for none. */
  std::string kept;
};

inline std::ostream&
operator<< (std::ostream& stream, const Output& output)
{
  return stream << output.name;
}

constexpr const char* precious = "precious";
constexpr int killed = 128 + 9;

/** \brief How a run of a program ended. */
struct Ending {
  int exit_code;
  std::string errors;
};

/** \brief Runs programs in a folder of their own where things fail. */
class FailingProgram {
public:
  explicit FailingProgram (const Output& output) : output_ (output) {}

  /** \brief Runs it.
   * \param[in] trouble variables of failing_calls.cpp, as "NAME=number"
   * \param[in] before commands of the shell
   * \param[in] file the output's name, if another one */
  Ending
  run (const std::string& trouble,
       const std::string& before = "",
       const std::optional<std::string>& file = {}) const
  {
    std::string arguments = output_.arguments;
    arguments.replace (
        arguments.find ("OUT"), 3, "'" + file.value_or (output_.file) + "'");
    const std::string preload =
        trouble.empty() ? "" : "env LD_PRELOAD='" PCL_OPS_FAILING_CALLS "' " + trouble;
    const std::string script =
        streams_.write ("run.sh",
                        "cd '" + folder_.path() + "'\n" + before + "\n" + preload +
                            " '" + output_.program + "' " + arguments + " >'" +
                            streams_ / "out" + "' 2>'" + streams_ / "err" + "'\n");
    const int status = std::system (("sh '" + script + "' 2>/dev/null").c_str());
    return {WEXITSTATUS (status), ownLines (contentOf (streams_ / "err"))};
  }

  /** \brief Puts the file there that a failure has to leave alone. */
  void
  protect () const
  {
    if (!output_.kept.empty())
      folder_.write (output_.kept, precious);
  }

  bool
  isAsBefore () const
  {
    return output_.kept.empty() || contentOf (folder_ / output_.kept) == precious;
  }

  /** \brief What a run left behind that is no output. */
  std::vector<std::string>
  remains () const
  {
    std::vector<std::string> names;
    using Iterator = std::filesystem::recursive_directory_iterator;
    for (const auto& entry : Iterator (folder_.path()))
      if (entry.path().filename().string().front() == '.')
        names.push_back (entry.path().filename().string());
    return names;
  }

  /** \brief The promise of every program about every output: an exit code, one line
   * that names the culprit, the old file as it was, and nothing left behind. */
  void
  expectPromise (const Ending& ending,
                 const std::string& culprit,
                 int exit_code = 1) const
  {
    const std::string start =
        std::filesystem::path (output_.program).filename().string() + ": ";
    EXPECT_EQ (ending.exit_code, exit_code) << ending.errors;
    EXPECT_EQ (ending.errors.rfind (start, 0), 0u) << ending.errors;
    EXPECT_EQ (std::count (ending.errors.begin(), ending.errors.end(), '\n'), 1)
        << ending.errors;
    EXPECT_NE (ending.errors.find (culprit), std::string::npos) << ending.errors;
    EXPECT_NE (ending.errors.find (';'), std::string::npos)
        << "no mend: " << ending.errors;
    EXPECT_EQ (ending.errors.find (".pcl_ops"), std::string::npos)
        << "a temporary name: " << ending.errors;
    EXPECT_TRUE (isAsBefore()) << output_.kept;
    EXPECT_EQ (remains(), std::vector<std::string>());
  }

  const TemporaryFolder&
  folder () const
  {
    return folder_;
  }

private:
  /** \brief Without the lines that say how far a long run is. */
  static std::string
  ownLines (const std::string& text)
  {
    std::istringstream stream (text);
    std::string lines;
    for (std::string line; std::getline (stream, line);)
      if (line.find (" clouds, ") == std::string::npos)
        lines += line + "\n";
    return lines;
  }

  Output output_;
  TemporaryFolder folder_;
  TemporaryFolder streams_{"_streams"};
};
