// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"
#include <poll.h>
#include <sys/inotify.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <filesystem>
#include <set>

namespace {

namespace fs = std::filesystem;

/** \brief Waits for files that appear in a folder. */
class FolderWatch {
public:
  explicit FolderWatch (const std::string& folder) : queue_ (::inotify_init())
  {
    ::inotify_add_watch (queue_, folder.c_str(), IN_CREATE | IN_MOVED_TO);
  }
  FolderWatch (const FolderWatch&) = delete;
  FolderWatch&
  operator= (const FolderWatch&) = delete;
  ~FolderWatch() { ::close (queue_); }

  /** \brief Waits until a file of this name appears, or any file for an empty name.
   * \return false if no file appears in time */
  bool
  waitFor (const std::string& name) const
  {
    constexpr int milliseconds = 60'000; // a program writes its first file much sooner
    pollfd events{queue_, POLLIN, 0};
    while (::poll (&events, 1, milliseconds) > 0)
      for (const std::string& appeared : takeNames())
        if (name.empty() || appeared == name)
          return true;
    return false;
  }

private:
  std::set<std::string>
  takeNames () const
  {
    alignas (inotify_event) std::array<char, 4096> bytes{};
    const ssize_t size = ::read (queue_, bytes.data(), bytes.size());
    std::set<std::string> names;
    for (ssize_t begin = 0; begin < size;) {
      const auto* const event =
          reinterpret_cast<const inotify_event*> (bytes.data() + begin);
      if (event->len > 0)
        names.insert (event->name);
      begin += static_cast<ssize_t> (sizeof (inotify_event) + event->len);
    }
    return names;
  }

  int queue_;
};

/** \brief A run of pcl_ops_segment that SIGTERM ends while it works. */
class Interruption : public Segment {
protected:
  /** \brief Starts a command in the folder. It replaces the shell (exec), so that
   * signals reach it. Standard output goes to the file "printed", standard error to
   * "said".
   * \param[in] input file descriptor of its standard input
   * \return the process id of the command */
  pid_t
  start (const std::string& command, int input = STDIN_FILENO) const
  {
    const std::string line =
        "cd '" + folder_.path() + "' && exec " + command + " >printed 2>said";
    const pid_t child = ::fork();
    if (child == 0) {
      ::dup2 (input, STDIN_FILENO);
      ::execl ("/bin/sh", "sh", "-c", line.c_str(), nullptr);
      constexpr int no_shell = 127;
      ::_exit (no_shell);
    }
    return child;
  }

  /** \brief Sends SIGTERM to a program and waits for its end.
   * \return its exit code, or 128 plus the number of the signal that ended it */
  static int
  interrupt (pid_t program)
  {
    ::kill (program, SIGTERM);
    int status = 0;
    ::waitpid (program, &status, 0);
    return WIFSIGNALED (status) ? 128 + WTERMSIG (status) : WEXITSTATUS (status);
  }

  std::set<std::string>
  namesIn (const std::string& folder) const
  {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator (folder_ / folder))
      names.insert (entry.path().filename().string());
    return names;
  }

  static constexpr int ended_by_sigterm = 128 + SIGTERM;
};

/** \brief A run that is interrupted in the midst of 40 clouds. */
class InterruptedBatch : public Interruption {
protected:
  InterruptedBatch()
  {
    save ("dense.pcd", floorAndWall (300));
    fs::create_directory (folder_ / "scans");
    fs::create_directory (folder_ / "out");
    for (int i = 1; i <= 40; ++i)
      fs::create_hard_link (folder_ / "dense.pcd",
                            folder_ / ("scans/s" + std::to_string (i) + ".pcd"));
    const FolderWatch outputs (folder_ / "out");
    const pid_t program =
        start ("'" PCL_OPS_SEGMENT_PROGRAM "' scans --output-dir out --jobs 2");
    EXPECT_TRUE (outputs.waitFor ("s1.json"));
    exit_code_ = interrupt (program);
  }

  std::set<std::string>
  finishedLists () const
  {
    std::set<std::string> lists;
    for (const std::string& name : namesIn ("out"))
      if (fs::path (name).extension() == ".json")
        lists.insert (name);
    return lists;
  }

  int exit_code_ = 0;
};

} // namespace

TEST_F (InterruptedBatch, SaysInOneLineHowManyInputsAreDone)
{
  EXPECT_EQ (exit_code_, ended_by_sigterm);
  const std::string said = contentOf (folder_ / "said");
  EXPECT_EQ (said.find ("pcl_ops_segment: interrupted: "), 0u) << said;
  EXPECT_EQ (lines (said), 1u) << said;
  const std::size_t done = finishedLists().size();
  EXPECT_LT (done, 40u);
  EXPECT_TRUE (contains (said, " " + std::to_string (done) + " of 40 inputs")) << said;
}

TEST_F (InterruptedBatch, LeavesNothingTemporaryAndOnlyWholeClouds)
{
  std::set<std::string> expected;
  for (const std::string& list : finishedLists()) {
    expected.insert (list);
    expected.insert (fs::path (list).stem().string() + ".pcd");
  }
  std::set<std::string> names = namesIn ("out");
  // The labels of a cloud (.pcd) are written before its planes (.json), so that one may
  // have labels alone.
  for (auto name = names.begin(); name != names.end();) {
    const bool is_labels_alone =
        fs::path (*name).extension() == ".pcd" && expected.count (*name) == 0;
    name = is_labels_alone ? names.erase (name) : std::next (name);
  }
  EXPECT_EQ (names, expected);
  expectDone ("out --output-dir again");
}

TEST_F (Interruption, OfAPipeLeavesNoTemporaryFile)
{
  // More than a pipe holds: when all is written the program has read some of it, and it
  // waits for the end of the pipe.
  std::string bytes;
  while (bytes.size() < 3'000'000)
    bytes += "1 2 3\n";
  int pipe[2];
  ASSERT_EQ (::pipe (pipe), 0);
  std::signal (SIGPIPE, SIG_IGN); // if the program ends too soon, write fails instead
  fs::create_directory (folder_ / "tmp");
  const FolderWatch temporary_files (folder_ / "tmp");
  const pid_t program =
      start ("env TMPDIR=tmp '" PCL_OPS_SEGMENT_PROGRAM "' -", pipe[0]);
  ::close (pipe[0]);
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t part = ::write (pipe[1], &bytes[written], bytes.size() - written);
    ASSERT_GT (part, 0);
    written += static_cast<std::size_t> (part);
  }
  EXPECT_TRUE (temporary_files.waitFor (""));
  EXPECT_EQ (interrupt (program), ended_by_sigterm);
  ::close (pipe[1]);
  EXPECT_EQ (namesIn ("tmp"), std::set<std::string>());
}

TEST_F (Interruption, BehindTheFirstOutputDoesNotSayThatNothingIsWritten)
{
  save ("dense.pcd", floorAndWall (300));
  const FolderWatch outputs (folder_.path());
  const pid_t program =
      start ("'" PCL_OPS_SEGMENT_PROGRAM "' dense.pcd out.pcd --trace stages --quiet");
  EXPECT_TRUE (outputs.waitFor ("out.pcd")); // all stages follow it
  EXPECT_EQ (interrupt (program), ended_by_sigterm);
  EXPECT_EQ (contentOf (folder_ / "said"),
             "pcl_ops_segment: interrupted: no file is half-written; run it again\n");
}
