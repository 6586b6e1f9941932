// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <boost/crc.hpp>
#include <boost/iostreams/device/back_inserter.hpp>
#include <boost/iostreams/filter/zlib.hpp>
#include <boost/iostreams/filtering_stream.hpp>

#include <cli/errors.h>
#include <evaluation/data/sun_rgbd.h>
#include <support/temporary_folder.h>

#include <filesystem>
#include <fstream>

namespace {

using namespace pcl_ops::evaluation;
namespace fs = std::filesystem;

std::string
bigEndian (std::uint32_t value)
{
  return {char (value >> 24), char (value >> 16), char (value >> 8), char (value)};
}

std::string
chunk (const std::string& type, const std::string& data)
{
  boost::crc_32_type checksum;
  checksum.process_bytes ((type + data).data(), type.size() + data.size());
  return bigEndian (data.size()) + type + data + bigEndian (checksum.checksum());
}

std::string
deflated (const std::string& text)
{
  namespace io = boost::iostreams;
  std::string compressed;
  io::filtering_ostream stream;
  stream.push (io::zlib_compressor());
  stream.push (io::back_inserter (compressed));
  stream << text;
  stream.reset();
  return compressed;
}

/** A PNG of the given rows, each a filter number and then its bytes. */
std::string
png (std::uint32_t width, std::uint32_t height, char bits, const std::string& rows)
{
  const std::string header =
      bigEndian (width) + bigEndian (height) + bits + std::string (4, '\0');
  return "\x89PNG\r\n\x1a\n" + chunk ("IHDR", header) +
         chunk ("IDAT", deflated (rows)) + chunk ("IEND", "");
}

void
write (const fs::path& file, const std::string& text)
{
  fs::create_directories (file.parent_path());
  std::ofstream (file, std::ios::binary) << text;
}

/** Two pixels, 0x0010 and 0x0018: 2 mm and 3 mm as SUN RGB-D stores them. */
const std::string two_pixels = png (2, 1, 16, std::string ("\0\0\x10\0\x18", 5));

/** A data set of one frame: focal length 1 pixel, center (0, 0), camera level. */
class SunRgbdTest : public testing::Test {
protected:
  TemporaryFolder folder;
  fs::path root = folder.path();
  fs::path frame = root / "kv2" / "room" / "frame";

  SunRgbdTest()
  {
    write (frame / "depth" / "0001.png", two_pixels);
    write (frame / "intrinsics.txt", "1 0 0\n0 1 0\n0 0 1\n");
    write (frame / "extrinsics" / "1.txt", "1 0 0 0\n0 1 0 0\n0 0 1 0\n");
  }

  std::string
  errorOfReading () const
  {
    try {
      readSunRgbdFrame (frame.string(), SunRgbdDepth::Raw);
    }
    catch (const pcl_ops::apps::WorkError& error) {
      return error.what();
    }
    return "";
  }
};

void
expectPoint (const pcl::PointXYZ& point, const Eigen::Vector3f& expected)
{
  EXPECT_LT ((point.getVector3fMap() - expected).norm(), 1e-6f) << point;
}

TEST_F (SunRgbdTest, ALevelCameraLooksAlongYWithZUp)
{
  const EvaluationCloud cloud = readSunRgbdFrame (frame.string(), SunRgbdDepth::Raw);
  ASSERT_EQ (cloud.cloud->size(), 2u);
  expectPoint ((*cloud.cloud)[0], {0.0f, 0.002f, 0.0f});
  expectPoint ((*cloud.cloud)[1], {0.003f, 0.003f, 0.0f});
}

TEST_F (SunRgbdTest, ATiltedCameraIsTurnedUprightByTheLatestExtrinsics)
{
  // Looking straight down: the camera's forward axis is along gravity.
  write (frame / "extrinsics" / "2.txt", "1 0 0 0\n0 0 1 0\n0 -1 0 0\n");
  const EvaluationCloud cloud = readSunRgbdFrame (frame.string(), SunRgbdDepth::Raw);
  expectPoint ((*cloud.cloud)[0], {0.0f, 0.0f, -0.002f});
}

TEST_F (SunRgbdTest, PixelsWithoutReadingGiveNoPointAndFarOnesAreClipped)
{
  // 0, and 0xFFFF = 65.535 m
  write (frame / "depth" / "0001.png",
         png (2, 1, 16, std::string ("\0\0\0\xff\xff", 5)));
  const EvaluationCloud cloud = readSunRgbdFrame (frame.string(), SunRgbdDepth::Raw);
  ASSERT_EQ (cloud.cloud->size(), 1u);
  EXPECT_FLOAT_EQ ((*cloud.cloud)[0].y, 8.0f);
  EXPECT_EQ (cloud.grid->pixels, std::vector<std::uint32_t>{1});
}

TEST_F (SunRgbdTest, FramesAreFoundAtAnyDepthAndReadLate)
{
  write (root / "kv1" / "a" / "b" / "c" / "depth_bfx" / "1.png", two_pixels);
  const DataSet set = sunRgbdDataSet (root.string(), SunRgbdDepth::Raw);
  ASSERT_EQ (set.clouds.size(), 2u);
  EXPECT_EQ (set.clouds[0].name, "kv1/a/b/c");
  EXPECT_THROW (set.clouds[0].load(), pcl_ops::apps::WorkError);
  EXPECT_EQ (set.clouds[1].load().cloud->size(), 2u);
}

TEST_F (SunRgbdTest, FilesThatAreMissingAreNamed)
{
  fs::remove (frame / "depth" / "0001.png");
  EXPECT_NE (errorOfReading().find ("has no .png file"), std::string::npos);
  fs::remove (frame / "intrinsics.txt");
  EXPECT_NE (errorOfReading().find ("intrinsics.txt: cannot be read"),
             std::string::npos);
}

TEST_F (SunRgbdTest, MalformedMatricesAreNamed)
{
  write (frame / "extrinsics" / "1.txt", "2 0 0 0\n0 1 0 0\n0 0 1 0\n");
  EXPECT_NE (errorOfReading().find ("no rotation"), std::string::npos);
  for (const char* text : {"1 0 0\n0 1",
                           "1 0 0 a 1 0 0 0 1",
                           "1 0 0 0 1 0 0 0 1 7",
                           "0 0 0 0 0 0 0 0 1",
                           "nan 0 0 0 1 0 0 0 1",
                           ""}) {
    write (frame / "intrinsics.txt", text);
    EXPECT_NE (errorOfReading().find ("intrinsics.txt"), std::string::npos) << text;
  }
}

TEST_F (SunRgbdTest, EveryTruncationAndDamagedByteOfAnImageIsAnError)
{
  // But for the checksum of its end, which some versions of libpng pass over.
  constexpr std::size_t checksum = 4;
  for (std::size_t i = 0; i < two_pixels.size(); ++i) {
    write (frame / "depth" / "0001.png", two_pixels.substr (0, i));
    EXPECT_NE (errorOfReading().find ("0001.png: "), std::string::npos) << i;
    std::string damaged = two_pixels;
    damaged[i] ^= 0x20;
    write (frame / "depth" / "0001.png", damaged);
    if (i < two_pixels.size() - checksum) {
      EXPECT_NE (errorOfReading().find ("0001.png: "), std::string::npos) << i;
    }
  }
}

TEST_F (SunRgbdTest, ImagesOfOtherPixelsAreErrors)
{
  write (frame / "depth" / "0001.png", png (2, 1, 8, std::string (3, '\0')));
  EXPECT_NE (errorOfReading().find ("16-bit gray"), std::string::npos);
  write (frame / "depth" / "0001.png", png (2, 1, 16, std::string (4, '\0')));
  EXPECT_NE (errorOfReading().find ("damaged"), std::string::npos);
  write (frame / "depth" / "0001.png",
         png (2'000'000'000, 2'000'000'000, 16, std::string (4, '\0')));
  EXPECT_NE (errorOfReading().find ("no whole PNG"), std::string::npos);
}

TEST (SunRgbd, RealFramesStandUpright)
{
  const fs::path folder = fs::path (PCL_OPS_DATA_DIR) / "SUNRGBD";
  if (!fs::exists (folder))
    GTEST_SKIP() << "no SUN RGB-D frames in " << folder;
  const DataSet set = sunRgbdDataSet (folder.string(), SunRgbdDepth::Refined);
  EXPECT_EQ (set.clouds.size(), 16u);
  const EvaluationCloud cloud = set.clouds[1].load();
  for (const pcl::PointXYZ& point : *cloud.cloud) {
    ASSERT_GT (point.y, 0.0f); // in front of the camera
    ASSERT_LT (std::abs (point.z), 4.0f);
  }
}

} // namespace
