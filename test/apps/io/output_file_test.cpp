// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <io/inputs.h>
#include <io/output_file.h>
#include <support/temporary_folder.h>
#include <support/text.h>

using namespace pcl_ops::apps;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

class InFolder : public testing::Test {
protected:
  TemporaryFolder folder_;
};
using Inputs = InFolder;
using OutputFile = InFolder;

TEST_F (Inputs, AreWhatNamesAndPatternsStandFor)
{
  fs::create_symlink ("gone", folder_ / "scan*.pcd");
  fs::create_directory (folder_ / "scans[1]");
  folder_.write ("scans[1]/a.pcd", "");
  const std::pair<const char*, const char*> rows[] = {
      // What is named like a pattern: a link to nowhere, a folder.
      {"*.pcd", "scan*.pcd"},
      {"scans*", "scans[1]/a.pcd"},
      // A cloud that does not exist is left to its reader.
      {"gone.pcd", "gone.pcd"},
      {"gone.txt", "gone.txt"},
      {"gone.laz", "gone.laz"}};
  for (const auto& [name, file] : rows) {
    const InputFiles found = findInputs ({folder_ / name});
    EXPECT_EQ (found.files, Names{folder_ / file});
    EXPECT_EQ (found.problems, Names{});
  }
  const std::string mistyped = folder_ / "nodir";
  const InputFiles none = findInputs ({mistyped});
  EXPECT_EQ (none.files, Names{});
  EXPECT_EQ (none.problems, Names{mistyped + ": does not exist; check the name"});
}

TEST_F (OutputFile, WritesManyFilesOfAFolderAtOnceEachInOneStep)
{
  writeFile (folder_ / "a.json", [&] (std::ostream& outer) {
    writeFile (folder_ / "a.json", [] (std::ostream& inner) { inner << "inner"; });
    outer << "outer" << std::flush;
    EXPECT_EQ (contentOf (folder_ / "a.json"), "inner");
  });
  EXPECT_EQ (contentOf (folder_ / "a.json"), "outer");
  EXPECT_EQ (folder_.fileCount(), 1u);
}

TEST_F (OutputFile, LeavesTemporaryFilesOfOthersAlone)
{
  // Of a program of the same number, as in another container.
  constexpr int many = 500;
  const std::string start = ".pcl_ops." + std::to_string (::getpid()) + ".";
  for (int i = 0; i < many; ++i)
    folder_.write (start + std::to_string (i), "precious");
  writeTextFile (folder_ / "a.json", "new");
  for (int i = 0; i < many; ++i)
    EXPECT_EQ (contentOf (folder_ / (start + std::to_string (i))), "precious");
}

TEST_F (OutputFile, IsWrittenThroughLinksBeforeItExistsAndAfterAndKeepsPermissions)
{
  fs::create_symlink ("second.csv", folder_ / "first.csv");
  fs::create_symlink (folder_ / "real.csv", folder_ / "second.csv");
  for (const char* text : {"old", "new"}) {
    writeTextFile (folder_ / "first.csv", text);
    EXPECT_TRUE (fs::is_symlink (folder_ / "first.csv"));
    EXPECT_EQ (contentOf (folder_ / "real.csv"), text);
    if (text == std::string ("old"))
      fs::permissions (folder_ / "real.csv", fs::perms (0600));
  }
  EXPECT_EQ (fs::status (folder_ / "real.csv").permissions(), fs::perms (0600));
}

TEST_F (OutputFile, NamesWhatIsInTheWay)
{
  fs::create_symlink ("itself.csv", folder_ / "itself.csv");
  const std::pair<std::string, std::string> rows[] = {
      {folder_ / "fine.pcd", ""},
      {folder_.path(), "is a folder; give the name of a file in it"},
      {folder_ / "no/a.pcd",
       "its folder does not exist; create it or give another name"},
      {"/dev/null", "is no regular file; give another name"},
      {folder_ / "itself.csv", "is a link that leads nowhere; give another name"}};
  for (const auto& [name, complaint] : rows)
    EXPECT_EQ (complaintOf ([&, file = name] { checkWritable (file); }),
               complaint.empty() ? "" : name + ": " + complaint);
  EXPECT_EQ (complaintOf ([] { checkWritable (""); }),
             "'': is no file name; give one to write to");
}

TEST_F (OutputFile, KnowsAFileByAnyName)
{
  writeTextFile (folder_ / "a.pcd", "");
  fs::create_hard_link (folder_ / "a.pcd", folder_ / "b.pcd");
  EXPECT_TRUE (isSameFile (folder_ / "a.pcd", folder_ / "./a.pcd"));
  EXPECT_TRUE (isSameFile (folder_ / "a.pcd", folder_ / "b.pcd"));
  EXPECT_TRUE (isSameFile (folder_ / "new.pcd", folder_ / "./new.pcd"));
  EXPECT_FALSE (isSameFile (folder_ / "a.pcd", folder_ / "c.pcd"));
}

} // namespace
