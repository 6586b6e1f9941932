// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <io/output_file.h>
#include <support/temporary_folder.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace fs = std::filesystem;
using namespace pcl_ops::apps;

namespace {

class OutputFile : public testing::Test {
protected:
  TemporaryFolder folder_;
};

} // namespace

TEST_F (OutputFile, ReplacesTheTargetInOneStep)
{
  writeTextFile (folder_ / "a.json", "old");
  writeFile (folder_ / "a.json", [&] (const std::string& temporary) {
    EXPECT_EQ (fs::path (temporary).parent_path(), folder_.path());
    EXPECT_EQ (fs::path (temporary).extension(), ".json");
    std::ofstream (temporary) << "new";
    EXPECT_EQ (contentOf (folder_ / "a.json"), "old");
  });
  EXPECT_EQ (contentOf (folder_ / "a.json"), "new");
  EXPECT_EQ (folder_.fileCount(), 1u);
}

TEST_F (OutputFile, KeepsTheTargetWhenWritingFails)
{
  writeTextFile (folder_ / "a.json", "old");
  const auto fail_half_way = [] (const std::string& temporary) {
    std::ofstream (temporary) << "ne";
    throw WorkError ("a.json", "broke");
  };
  EXPECT_THROW (writeFile (folder_ / "a.json", fail_half_way), WorkError);
  EXPECT_EQ (contentOf (folder_ / "a.json"), "old");
  EXPECT_EQ (folder_.fileCount(), 1u);
}

TEST_F (OutputFile, WritesThroughALinkAndKeepsPermissions)
{
  writeTextFile (folder_ / "real.csv", "old");
  fs::permissions (folder_ / "real.csv", fs::perms (0600));
  fs::create_symlink (folder_ / "real.csv", folder_ / "link.csv");
  writeTextFile (folder_ / "link.csv", "new");
  EXPECT_TRUE (fs::is_symlink (folder_ / "link.csv"));
  EXPECT_EQ (contentOf (folder_ / "real.csv"), "new");
  EXPECT_EQ (fs::status (folder_ / "real.csv").permissions(), fs::perms (0600));
}

TEST_F (OutputFile, NamesWhatIsInTheWay)
{
  const auto complaint = [] (const std::string& name) -> std::string {
    try {
      checkWritable (name);
    }
    catch (const WorkError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ (complaint (folder_ / "fine.pcd"), "");
  EXPECT_EQ (complaint (folder_.path()),
             folder_.path() + ": is a folder; give the name of a file in it");
  EXPECT_EQ (complaint (folder_ / "no/a.pcd"),
             folder_ / "no/a.pcd" +
                 ": its folder does not exist; create it or give another name");
  EXPECT_EQ (complaint ("/dev/null"),
             "/dev/null: is no regular file; give another name");
  EXPECT_EQ (complaint (""), "'': is no file name; give one to write to");
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
