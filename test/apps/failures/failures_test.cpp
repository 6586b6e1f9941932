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

/** \brief A row of outputs.tsv: name, command, output, and in some rows another file
 * that a failure has to leave as it was. */
using Row = std::vector<std::string>;

/** \brief The first word of a command. */
std::string
programIn (const std::string& command)
{
  return command.substr (0, command.find (' '));
}

/** \brief Content of the file that a failure has to leave alone. */
constexpr const char* precious = "precious";
constexpr int exit_code_of_killed = 128 + SIGKILL;

/** \brief A folder in which a command is run and made to fail. */
class Failing : public ProgramFolder {
protected:
  explicit Failing (const Row& row = {"", "", "out/a.pcd"})
  : ProgramFolder (PCL_OPS_SEGMENT_PROGRAM)
  , command_ (row.at (1))
  , file_ (row.at (2))
  , kept_ (row.back())
  {
    fs::create_directories (folder_ / "clouds");
    for (const char* file : {"in.pcd", "clouds/scene.pcd"})
      pcl::io::savePCDFileBinary (folder_ / file, floorAndWall());
    folder_.write ("in.las", lasBytes (floorAndWallInLas()));
    folder_.write ("in.xyz", squareText (points_of_side, 100));
    folder_.write ("poses.txt", "0 0 0 0 0 0 0 1\n");
    protect();
  }

  /** \brief Makes the folder of outputs anew, with the file that a failure has to leave
   * alone. */
  void
  protect () const
  {
    fs::remove_all (folder_ / "out");
    fs::create_directories (folder_ / "out");
    folder_.write (kept_, precious);
  }

  /** \brief Runs the command with a trouble. The outcome has no lines of progress.
   * \param[in] trouble variable of failing_calls.cpp, as "NAME=number"; empty: none
   * \param[in] before commands of the shell that are run before the command
   * \param[in] file output to put in place of OUT; not given: file_ */
  Outcome
  failing (const std::string& trouble,
           const std::string& before = "",
           const std::optional<std::string>& file = {}) const
  {
    std::string command = command_;
    command.replace (command.find ("OUT"), 3, "'" + file.value_or (file_) + "'");
    const std::string preload =
        trouble.empty() ? "" : "env LD_PRELOAD='" PCL_OPS_FAILING_CALLS "' " + trouble;
    const std::string script =
        streams_.write ("run.sh", before + "\n" + preload + " " + command);
    Outcome done = shell ("sh '" + script + "'");
    done.err = ownLines (done.err);
    return done;
  }

  bool
  isAsBefore () const
  {
    return contentOf (folder_ / kept_) == precious;
  }

  /** \brief Fails unless a run kept what every program promises about a failed output:
   * its exit code, one line of error that names the culprit and a fix, the old file as
   * it was, and no temporary file (a name with a dot in front) left behind. */
  void
  expectPromise (const Outcome& done,
                 const std::string& culprit,
                 int exit_code = 1) const
  {
    EXPECT_EQ (done.exit_code, exit_code) << done.err;
    EXPECT_EQ (done.err.rfind (programIn (command_) + ": ", 0), 0u) << done.err;
    EXPECT_EQ (lines (done.err), 1u) << done.err;
    EXPECT_TRUE (contains (done.err, culprit));
    EXPECT_TRUE (contains (done.err, ";")) << "no fix";
    EXPECT_FALSE (contains (done.err, ".pcl_ops")) << "a temporary name";
    EXPECT_TRUE (isAsBefore()) << kept_;
    for (const auto& entry : fs::recursive_directory_iterator (folder_.path()))
      EXPECT_NE (entry.path().filename().string().front(), '.') << entry.path();
  }

  /** \brief Raises the memory limit of a program until a run succeeds. Each run before
   * must report that memory is missing. */
  void
  expectMemoryIsMissed () const
  {
    constexpr int step = 4'000, max_limit = 1'000'000; // [kB]
    int limit = step;
    const auto runWithLimit = [&] {
      return failing ("", "ulimit -v " + std::to_string (limit));
    };
    // With too little memory the loader cannot start the program: exit code 127.
    constexpr int not_loaded = 127;
    while (runWithLimit().exit_code == not_loaded && limit < max_limit)
      limit += step;
    // The run before may have succeeded, and a run of many files would skip its
    // outputs: protect() removes them.
    for (protect(); limit < max_limit; limit += step) {
      SCOPED_TRACE (std::to_string (limit) + " kB");
      const Outcome done = runWithLimit();
      if (done.exit_code == 0)
        break;
      expectPromise (done, "memory");
      if (HasFailure())
        return;
    }
    EXPECT_LT (limit, max_limit);
  }

  std::string command_, file_, kept_;

private:
  /** \brief The text without the progress lines of a run of many clouds. */
  static std::string
  ownLines (const std::string& text)
  {
    std::istringstream stream (text);
    std::string own;
    for (std::string line; std::getline (stream, line);)
      if (!contains (line, " clouds, "))
        own += line + "\n";
    return own;
  }
};

/** \brief The rows of outputs.tsv whose programs and formats are in this build. */
std::vector<Row>
allOutputs ()
{
  std::vector<Row> outputs;
  for (const Row& row : tableIn (PCL_OPS_OUTPUTS))
    if (fs::exists (PCL_OPS_PROGRAMS "/" + programIn (row.at (1))) &&
        (row[0] != "Laz" || pcl_ops::apps::hasLaszip()))
      outputs.push_back (row);
  return outputs;
}

constexpr int max_writes = 100;

/** \brief Failures at the output of one row. */
class Failures : public Failing, public testing::WithParamInterface<Row> {
protected:
  Failures() : Failing (GetParam()) {}

  /** \brief Runs the command with a trouble at the first write, then at the second and
   * so on, until a run succeeds. Calls expect (outcome) for each run that fails.
   * \param[in] trouble variable without its number, as "NAME=" */
  void
  expectAtEveryWrite (const std::string& trouble,
                      const std::function<void (const Outcome&)>& expect) const
  {
    int write = 1;
    for (; write < max_writes; ++write) {
      SCOPED_TRACE (trouble + std::to_string (write));
      const Outcome ending = failing (trouble + std::to_string (write));
      if (ending.exit_code == 0)
        break;
      expect (ending);
      if (HasFailure())
        return;
    }
    EXPECT_GT (write, 1) << "nothing was written";
    EXPECT_LT (write, max_writes);
  }

  /** \brief Name for an output: its last part has this many characters, among them the
   * extension of the usual output. An output without an extension is a folder. */
  std::string
  nameOfLength (std::size_t length) const
  {
    const std::string extension = fs::path (file_).extension().string();
    return (extension.empty() ? "" : "out/") +
           std::string (length - extension.size(), 'n') + extension;
  }
};

INSTANTIATE_TEST_SUITE_P (All,
                          Failures,
                          testing::ValuesIn (allOutputs()),
                          [] (const auto& info) { return info.param.at (0); });

} // namespace

TEST_P (Failures, ADiskThatIsFullAtAnyWriteIsReportedAndHarmsNothing)
{
  expectAtEveryWrite ("FULL_AT_WRITE=", [this] (const Outcome& ending) {
    expectPromise (ending, file_);
    protect(); // else the next run of many files would resume this one
  });
}

TEST_P (Failures, ARunKilledAtAnyWriteLeavesTheOldFileAndIsRunAgain)
{
  expectAtEveryWrite ("KILLED_AT_WRITE=", [this] (const Outcome& ending) {
    EXPECT_EQ (ending.exit_code, exit_code_of_killed) << ending.err;
    EXPECT_TRUE (isAsBefore());
  });
  EXPECT_FALSE (isAsBefore()) << "the last run was not hindered";
}

TEST_P (Failures, AFolderThatCannotBeWrittenToIsNamed)
{
  expectPromise (failing ("READ_ONLY=1"), file_);
}

TEST_P (Failures, ANameThatIsTooLongIsReportedAndTheLongestPossibleOneIsTaken)
{
  constexpr std::size_t longest = 255;
  const std::string name = nameOfLength (longest + 1);
  const Outcome ending = failing ("", "", name);
  expectPromise (ending, name);
  EXPECT_TRUE (contains (ending.err, "too long"));
  EXPECT_EQ (failing ("", "", nameOfLength (longest)).exit_code, 0);
}

TEST_P (Failures, AnEmptyNameIsWrongUsage)
{
  constexpr int wrong_usage = 2;
  expectPromise (failing ("", "", ""), "", wrong_usage);
}

TEST_P (Failures, TooLittleMemoryIsReportedAndHarmsNothing) { expectMemoryIsMissed(); }

TEST_P (Failures, AProgramThatCanStartNoThreadSucceeds)
{
  const Outcome ending = failing ("THREADS_TO_START=0");
  EXPECT_EQ (ending.exit_code, 0) << ending.err;
  EXPECT_FALSE (isAsBefore());
}

TEST_F (Failing, TooLittleMemoryIsNotTakenForADamagedCloud)
{
  command_ = "pcl_ops_segment in.pcd OUT --quiet";
  pcl::io::savePCDFileBinary (folder_ / "in.pcd", floorAndWall (250));
  expectMemoryIsMissed();
}

TEST_F (Failing, ALimitOfTheSizeOfFilesIsReported)
{
  command_ = "pcl_ops_segment in.pcd OUT";
  expectPromise (failing ("", "ulimit -f 1"), "a.pcd");
}

TEST_F (Failing, APipeWithoutRoomForItsTemporaryFileIsNamed)
{
  command_ = "pcl_ops_segment - OUT <in.pcd";
  expectPromise (failing ("FULL_AT_WRITE=1", "export TMPDIR=."), "standard input");
}
