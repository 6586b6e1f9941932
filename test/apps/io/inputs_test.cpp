// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <io/inputs.h>
#include <support/temporary_folder.h>

#include <filesystem>
#include <string>
#include <vector>

using namespace pcl_ops::apps;

namespace {

using Names = std::vector<std::string>;

class Inputs : public testing::Test {
protected:
  TemporaryFolder folder_;
};

} // namespace

TEST_F (Inputs, HaveALinkToNowhereThatIsNamedLikeAPattern)
{
  const std::string link = folder_ / "scan*.pcd";
  std::filesystem::create_symlink ("gone", link);
  const InputFiles found = findInputs ({folder_ / "*.pcd"});
  EXPECT_EQ (found.files, Names{link});
  EXPECT_EQ (found.problems, Names{});
}

TEST_F (Inputs, HaveTheCloudsOfAFolderThatIsNamedLikeAPattern)
{
  std::filesystem::create_directory (folder_ / "scans[1]");
  const std::string cloud = folder_.write ("scans[1]/a.pcd", "");
  EXPECT_EQ (findInputs ({folder_ / "scans*"}).files, Names{cloud});
}

TEST_F (Inputs, DoNotHaveAFolderThatDoesNotExist)
{
  const std::string mistyped = folder_ / "nodir";
  const InputFiles found = findInputs ({mistyped});
  EXPECT_EQ (found.files, Names{});
  EXPECT_EQ (found.problems, Names{mistyped + ": does not exist; check the name"});
}

TEST_F (Inputs, LeaveACloudThatDoesNotExistToItsReader)
{
  for (const std::string& name :
       {folder_ / "gone.pcd", folder_ / "gone.txt", folder_ / "gone.laz"}) {
    const InputFiles found = findInputs ({name});
    EXPECT_EQ (found.files, Names{name});
    EXPECT_EQ (found.problems, Names{});
  }
}
