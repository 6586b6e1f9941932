// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <io/las_file.h>
#include <segment/segment_program.h>

#include <csignal>
#include <functional>
#include <optional>
#include <sstream>

namespace fs = std::filesystem;

namespace {

/** \brief A row of outputs.tsv. */
struct Row {
  std::string name;
  /** \brief Has OUT in place of the output. */
  std::string command;
  std::string output;
  /** \brief The file that a failure has to leave as it was. */
  std::string kept;

  friend std::ostream&
  operator<< (std::ostream& stream, const Row& row)
  {
    return stream << row.command;
  }
};

/** \brief The first word of a command. */
std::string
programIn (const std::string& command)
{
  return command.substr (0, command.find (' '));
}

/** \brief Content of the kept file before a run. */
constexpr const char* precious = "precious";
constexpr int exit_code_if_killed = 128 + SIGKILL; // as of the shell

/** \brief A folder in which a command is run and made to fail. */
class Failing : public ProgramFolder {
protected:
  explicit Failing (const Row& row = {"", "", "out/a.pcd", "out/a.pcd"})
  : ProgramFolder (PCL_OPS_SEGMENT_PROGRAM)
  , command_ (row.command)
  , output_ (row.output)
  , kept_ (row.kept)
  {
    fs::create_directories (folder_ / "clouds");
    for (const char* file : {"in.pcd", "clouds/scene.pcd"})
      pcl::io::savePCDFileBinary (folder_ / file, floorAndWall());
    folder_.write ("in.las", lasBytes (floorAndWallInLas()));
    folder_.write ("in.xyz", squareText (points_of_side, 100));
    folder_.write ("poses.txt", "0 0 0 0 0 0 0 1\n");
    resetOutputs();
  }

  /** \brief Removes all outputs but the kept file, which gets its first content. */
  void
  resetOutputs () const
  {
    fs::remove_all (folder_ / "out");
    fs::create_directories (folder_ / "out");
    folder_.write (kept_, precious);
  }

  /** \brief Runs the command so that it fails. The outcome has no lines of progress.
   * \param[in] failure variable of failing_calls.cpp, as "NAME=number"; empty: none
   * \param[in] before commands of the shell that are run before the command
   * \param[in] output to put in place of OUT; not given: that of the row */
  Outcome
  runFailing (const std::string& failure,
              const std::string& before = "",
              const std::optional<std::string>& output = {}) const
  {
    std::string command = command_;
    command.replace (command.find ("OUT"), 3, "'" + output.value_or (output_) + "'");
    const std::string preload =
        failure.empty() ? "" : "env LD_PRELOAD='" PCL_OPS_FAILING_CALLS "' " + failure;
    const std::string script =
        streams_.write ("run.sh", before + "\n" + preload + " " + command);
    Outcome done = shell ("sh '" + script + "'");
    done.err = withoutProgress (done.err);
    return done;
  }

  /** \brief Whether the kept file has its first content. */
  bool
  isKeptFileAsBefore () const
  {
    return contentOf (folder_ / kept_) == precious;
  }

  /** \brief Fails the test unless a run that failed had this exit code, wrote one line
   * on standard error with a culprit and a fix (behind a semicolon), left the kept file
   * as it was, and left no temporary file (whose name begins with a dot). */
  void
  expectReportedWithoutHarm (const Outcome& done,
                             const std::string& culprit,
                             int exit_code = 1) const
  {
    EXPECT_EQ (done.exit_code, exit_code) << done.err;
    EXPECT_EQ (done.err.rfind (programIn (command_) + ": ", 0), 0u) << done.err;
    EXPECT_EQ (lines (done.err), 1u) << done.err;
    EXPECT_TRUE (contains (done.err, culprit));
    EXPECT_TRUE (contains (done.err, ";")) << "no fix";
    EXPECT_FALSE (contains (done.err, ".pcl_ops")) << "the name of a temporary file";
    EXPECT_TRUE (isKeptFileAsBefore()) << kept_;
    for (const auto& entry : fs::recursive_directory_iterator (folder_.path()))
      EXPECT_NE (entry.path().filename().string().front(), '.') << entry.path();
  }

  /** \brief Raises the memory limit of the command until a run succeeds. Each run
   * before must report that it needs more memory. */
  void
  expectReportsOfTooLittleMemory () const
  {
    constexpr int step = 4'000, max_limit = 1'000'000; // [kB]
    int limit = step;                                  // [kB]
    const auto runWithLimit = [&] {
      return runFailing ("", "ulimit -v " + std::to_string (limit));
    };
    // With too little memory the loader cannot start the program: exit code 127.
    constexpr int not_loaded = 127;
    while (runWithLimit().exit_code == not_loaded && limit < max_limit)
      limit += step;
    // The last run may have succeeded, and a run of many files would skip what it has
    // written: so outputs are removed.
    for (resetOutputs(); limit < max_limit; limit += step) {
      SCOPED_TRACE (std::to_string (limit) + " kB");
      const Outcome done = runWithLimit();
      if (done.exit_code == 0)
        break;
      expectReportedWithoutHarm (done, "memory");
      if (HasFailure())
        return;
    }
    EXPECT_LT (limit, max_limit);
  }

  std::string command_, output_, kept_;

private:
  /** \brief A text without the lines on the progress of a run of many clouds. */
  static std::string
  withoutProgress (const std::string& text)
  {
    std::istringstream stream (text);
    std::string other_lines;
    for (std::string line; std::getline (stream, line);)
      if (!contains (line, " clouds, "))
        other_lines += line + "\n";
    return other_lines;
  }
};

/** \brief The rows of outputs.tsv whose programs and formats are in this build. */
std::vector<Row>
allOutputs ()
{
  std::vector<Row> rows;
  for (const std::vector<std::string>& columns : tableIn (PCL_OPS_OUTPUTS)) {
    // The output is kept unless a fourth column names another file.
    const Row row = {columns.at (0), columns.at (1), columns.at (2), columns.back()};
    const bool has_program =
        fs::exists (PCL_OPS_PROGRAMS "/" + programIn (row.command));
    const bool has_format = row.name != "Laz" || pcl_ops::apps::hasLaszip();
    if (has_program && has_format)
      rows.push_back (row);
  }
  return rows;
}

/** \brief A command of the table writes fewer times. */
constexpr int max_writes = 100;

/** \brief Failures at the output of one row. */
class Failures : public Failing, public testing::WithParamInterface<Row> {
protected:
  Failures() : Failing (GetParam()) {}

  /** \brief Runs the command with a failure at the first write, then at the second and
   * so on, until a run succeeds. Calls expect (outcome) for each run that fails.
   * \param[in] failure variable of failing_calls.cpp without its number, as "NAME=" */
  void
  expectAtEveryWrite (const std::string& failure,
                      const std::function<void (const Outcome&)>& expect) const
  {
    int write = 1;
    for (; write < max_writes; ++write) {
      SCOPED_TRACE (failure + std::to_string (write));
      const Outcome done = runFailing (failure + std::to_string (write));
      if (done.exit_code == 0)
        break;
      expect (done);
      if (HasFailure())
        return;
    }
    EXPECT_GT (write, 1) << "nothing was written";
    EXPECT_LT (write, max_writes);
  }

  /** \brief A path for the output with the extension of the row's output. The name of
   * the file, or of the folder if there is no extension, has this many characters. */
  std::string
  nameOfLength (std::size_t length) const
  {
    const std::string extension = fs::path (output_).extension().string();
    return (extension.empty() ? "" : "out/") +
           std::string (length - extension.size(), 'n') + extension;
  }
};

INSTANTIATE_TEST_SUITE_P (All,
                          Failures,
                          testing::ValuesIn (allOutputs()),
                          [] (const auto& info) { return info.param.name; });

} // namespace

TEST_P (Failures, ADiskThatIsFullAtAnyWriteIsReportedAndHarmsNothing)
{
  expectAtEveryWrite ("FULL_AT_WRITE=", [this] (const Outcome& done) {
    expectReportedWithoutHarm (done, output_);
    resetOutputs(); // else the next run of many files would resume this one
  });
}

TEST_P (Failures, ARunKilledAtAnyWriteLeavesTheKeptFileAndALaterRunReplacesIt)
{
  expectAtEveryWrite ("KILLED_AT_WRITE=", [this] (const Outcome& done) {
    EXPECT_EQ (done.exit_code, exit_code_if_killed) << done.err;
    EXPECT_TRUE (isKeptFileAsBefore());
  });
  EXPECT_FALSE (isKeptFileAsBefore()) << "the last run succeeded";
}

TEST_P (Failures, AFolderThatCannotBeWrittenToIsNamed)
{
  expectReportedWithoutHarm (runFailing ("READ_ONLY=1"), output_);
}

TEST_P (Failures, ANameThatIsTooLongIsReportedAndTheLongestPossibleOneIsTaken)
{
  constexpr std::size_t longest = 255; // name that Linux takes
  const std::string name = nameOfLength (longest + 1);
  const Outcome done = runFailing ("", "", name);
  expectReportedWithoutHarm (done, name);
  EXPECT_TRUE (contains (done.err, "too long"));
  EXPECT_EQ (runFailing ("", "", nameOfLength (longest)).exit_code, 0);
}

TEST_P (Failures, AnEmptyNameIsWrongUsage)
{
  constexpr int wrong_usage = 2;
  expectReportedWithoutHarm (runFailing ("", "", ""), "is empty", wrong_usage);
}

TEST_P (Failures, TooLittleMemoryIsReportedAndHarmsNothing)
{
  expectReportsOfTooLittleMemory();
}

TEST_P (Failures, ARunThatCanStartNoThreadSucceeds)
{
  const Outcome done = runFailing ("THREADS_TO_START=0");
  EXPECT_EQ (done.exit_code, 0) << done.err;
  EXPECT_FALSE (isKeptFileAsBefore());
}

TEST_F (Failing, TooLittleMemoryIsNotTakenForADamagedCloud)
{
  command_ = "pcl_ops_segment in.pcd OUT --quiet";
  constexpr int points_of_large_side = 250;
  pcl::io::savePCDFileBinary (folder_ / "in.pcd", floorAndWall (points_of_large_side));
  expectReportsOfTooLittleMemory();
}

TEST_F (Failing, AnOutputAboveTheSizeLimitOfFilesIsReported)
{
  command_ = "pcl_ops_segment in.pcd OUT";
  // The limit is 1 block: 512 or 1024 bytes, as the shell has it.
  expectReportedWithoutHarm (runFailing ("", "ulimit -f 1"), "a.pcd");
}

TEST_F (Failing, StandardInputWithoutRoomForItsTemporaryFileIsNamed)
{
  command_ = "pcl_ops_segment - OUT <in.pcd";
  // In the folder of the test a temporary file that is left behind would be noticed.
  expectReportedWithoutHarm (runFailing ("FULL_AT_WRITE=1", "export TMPDIR=."),
                             "standard input");
}
