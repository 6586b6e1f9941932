// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/data/data_sets.h>
#include <support/temporary_folder.h>
#include <support/text.h>
#include <unistd.h>

#include <filesystem>

namespace {

using namespace pcl_ops::evaluation;
using Eigen::Vector3f;
namespace fs = std::filesystem;

/** Returns the bytes of a PNG file of the test inputs. */
std::string
png (const std::string& name)
{
  return contentOf (PCL_OPS_INPUTS "/" + name + ".png");
}

constexpr bool raw = true, refined = false;

/** One row of two pixels with depths of 2 mm and 3 mm. As SUN RGB-D rotates the bits to
 * the left by 3, they are stored as 0x0010 and 0x0018. */
const std::string two_pixels = png ("frames/kv2/room/frame/depth/0001");

/** A data set of one frame: focal length 1 pixel, center (0, 0), camera level. */
class SunRgbdTest : public testing::Test {
protected:
  TemporaryFolder folder;
  std::string frame = "kv2/room/frame/";

  SunRgbdTest()
  {
    fs::copy (PCL_OPS_INPUTS "/frames", folder.path(), fs::copy_options::recursive);
  }

  EvaluationCloud
  read () const
  {
    return sunRgbdDataSet (folder.path(), raw).at (0).load();
  }
};

TEST_F (SunRgbdTest, ALevelCameraLooksAlongYWithZUp)
{
  const EvaluationCloud cloud = read();
  ASSERT_EQ (cloud.cloud->size(), 2u);
  EXPECT_TRUE ((*cloud.cloud)[0].getVector3fMap().isApprox (Vector3f (0, 0.002f, 0)));
  EXPECT_TRUE (
      (*cloud.cloud)[1].getVector3fMap().isApprox (Vector3f (0.003f, 0.003f, 0)));
}

TEST_F (SunRgbdTest, ATiltedCameraIsTurnedUprightByTheLatestExtrinsics)
{
  // Looking straight down: the camera's forward axis is along gravity.
  folder.write (frame + "extrinsics/2.txt", "1 0 0 0\n0 0 1 0\n0 -1 0 0\n");
  const pcl::PointXYZ point = (*read().cloud)[0];
  EXPECT_TRUE (point.getVector3fMap().isApprox (Vector3f (0, 0, -0.002f)));
}

TEST_F (SunRgbdTest, PixelsWithoutReadingGiveNoPointAndFarOnesAreClipped)
{
  folder.write (frame + "depth/0001.png", png ("none_65m"));
  const EvaluationCloud cloud = read();
  ASSERT_EQ (cloud.cloud->size(), 1u);
  EXPECT_FLOAT_EQ ((*cloud.cloud)[0].y, 8.0f);
}

TEST_F (SunRgbdTest, EveryTruncationAndDamagedByteOfAnImageIsAnError)
{
  const auto expectError = [&] (const std::string& bytes) {
    folder.write (frame + "depth/0001.png", bytes);
    EXPECT_TRUE (contains (complaintOf ([this] { read(); }), "0001.png: "));
  };
  for (std::size_t i = 0; i < two_pixels.size(); ++i) {
    SCOPED_TRACE (i);
    expectError (two_pixels.substr (0, i));
    std::string damaged = two_pixels;
    damaged[i] ^= 0x20;
    expectError (damaged);
  }
}

TEST_F (SunRgbdTest, AnImageThatSaysItsGammaIsRefused)
{
  constexpr std::size_t end_of_header = 8 + 25; // of the signature and the chunk IHDR
  // Each chunk: length, type, content and checksum.
  const std::string gamma ("\0\0\0\x04gAMA\0\0\xb1\x8f\x0b\xfc\x61\x05", 16);
  const std::string srgb ("\0\0\0\x01sRGB\0\xae\xce\x1c\xe9", 13);
  for (const std::string& chunk : {gamma, srgb}) {
    std::string image = two_pixels;
    image.insert (end_of_header, chunk);
    folder.write (frame + "depth/0001.png", image);
    EXPECT_TRUE (contains (complaintOf ([this] { read(); }), "without a gamma"));
  }
}

TEST_F (SunRgbdTest, AFolderThatIsAFrameGivesTheCloudItsName)
{
  for (const char* end : {"", "/"})
    EXPECT_EQ (sunRgbdDataSet (folder / "kv2/room/frame" + end, raw).at (0).name,
               "frame")
        << end;
}

TEST_F (SunRgbdTest, AFolderThatCannotBeReadIsAnErrorNotTheEndOfTheFrames)
{
  if (::geteuid() == 0)
    GTEST_SKIP() << "root may read everything";
  fs::create_directory (folder / "closed");
  fs::permissions (folder / "closed", fs::perms::none);
  const std::string complaint =
      complaintOf ([this] { sunRgbdDataSet (folder.path(), raw); });
  fs::permissions (folder / "closed", fs::perms::owner_all); // for its removal
  EXPECT_TRUE (contains (complaint, "has a folder that cannot be read")) << complaint;
}

TEST (SunRgbd, ARealFrameStandsUpright)
{
  const fs::path folder = fs::path (PCL_OPS_DATA_DIR) / "SUNRGBD";
  if (!fs::exists (folder))
    GTEST_SKIP() << "no SUN RGB-D frames in " << folder;
  const DataSet set = sunRgbdDataSet (folder.string(), refined);
  ASSERT_EQ (set.size(), 16u);
  const EvaluationCloud cloud = set[1].load();
  ASSERT_FALSE (cloud.cloud->empty());
  for (const pcl::PointXYZ& point : *cloud.cloud) {
    ASSERT_GT (point.y, 0.0f);            // in front of the camera
    ASSERT_LT (std::abs (point.z), 4.0f); // no floor or ceiling is farther
  }
}

} // namespace
