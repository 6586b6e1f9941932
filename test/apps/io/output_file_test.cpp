// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/output_file.h>
#include <support/temporary_folder.h>

using namespace pcl_ops::apps;
namespace fs = std::filesystem;

namespace {

class OutputFile : public testing::Test {
protected:
  TemporaryFolder folder_;
};

TEST_F (OutputFile, IsWrittenInOneStepByEachOfTwoThatWriteAtOnce)
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
  // These files have the names that temporary files of this process could have: another
  // container may run a program with the same process id.
  constexpr int files = 500; // so many that they have the next number of this process
  const std::string start = ".pcl_ops." + std::to_string (::getpid()) + ".";
  for (int i = 0; i < files; ++i)
    folder_.write (start + std::to_string (i), "precious");
  writeTextFile (folder_ / "a.json", "new");
  for (int i = 0; i < files; ++i)
    EXPECT_EQ (contentOf (folder_ / (start + std::to_string (i))), "precious");
}

TEST_F (OutputFile, IsWrittenThroughLinksWhetherItExistsOrNotAndKeepsPermissions)
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

} // namespace
