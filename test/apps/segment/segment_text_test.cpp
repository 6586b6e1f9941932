// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"
#include <io/cloud_file.h>
#include <io/shifted_cloud.h>
#include <support/cloud_values.h>

#include <iomanip>
#include <sstream>

namespace {

/** \brief A floor of 2 m by 2 m at UTM coordinates, in millimetres, with the number of
 * each point.
 * \param[in] separator between the numbers */
std::string
floorText (char separator = ' ')
{
  std::ostringstream text;
  text << std::fixed << std::setprecision (3);
  for (int i = 0; i < points_of_plane; ++i)
    text << 500000.123 + 0.04 * (i / points_of_side) << separator
         << 5400000.456 + 0.04 * (i % points_of_side) << separator << 120.789
         << separator << i << "\n";
  return text.str();
}

} // namespace

TEST_F (Segment, LabelsATextAndKeepsItsMillimetresAndColumns)
{
  folder_.write ("in.csv", "x,y,z,number\n" + floorText (','));
  for (const char* output : {"out.pcd", "out.ply"}) {
    SCOPED_TRACE (output);
    expectDone (std::string ("in.csv ") + output);
    const pcl_ops::apps::FileCloud cloud = pcl_ops::apps::loadCloud (folder_ / output);
    const pcl_ops::apps::CoordinateReader place (cloud);
    ASSERT_EQ (cloud.size(), std::size_t (points_of_plane));
    EXPECT_EQ (place (0), Eigen::Vector3d (500000.123, 5400000.456, 120.789));
    const std::vector<double> numbers = valuesOf<double> (cloud, "number");
    for (std::size_t i = 0; i < cloud.size(); ++i)
      ASSERT_EQ (numbers[i], double (i));
    EXPECT_EQ (valuesOf<std::uint32_t> (cloud, "label"),
               std::vector<std::uint32_t> (cloud.size(), 1u));
  }
}

TEST_F (Segment, TakesTextsByNameByPatternAndFromAPipe)
{
  std::filesystem::create_directory (folder_ / "scans");
  folder_.write ("scans/a.txt", floorText());
  folder_.write ("scans/b.xyz", floorText());
  folder_.write ("scans/notes.csv", "no cloud");
  expectDone ("'scans/*.txt' --output-dir by_pattern");
  EXPECT_TRUE (std::filesystem::exists (folder_ / "by_pattern/a.pcd"));
  expectDone ("scans --output-dir by_folder");
  EXPECT_TRUE (std::filesystem::exists (folder_ / "by_folder/b.pcd"));
  EXPECT_FALSE (std::filesystem::exists (folder_ / "by_folder/a.pcd"));
  const Outcome piped = expectDone ("- <scans/a.txt");
  EXPECT_TRUE (contains (piped.out, "\"horizontal\""));
  folder_.write ("marked.txt", "\xef\xbb\xbf" + contentOf (folder_ / "scans/a.txt"));
  const Outcome marked = run ("- <marked.txt");
  EXPECT_EQ (marked.exit_code, 0) << "the mark of UTF-8: " << marked.err;
}

TEST_F (Segment, KeepsAColumnCalledRgb)
{
  folder_.write ("in.csv", "x,y,z,rgb\n" + floorText (','));
  expectDone ("in.csv out.ply --keep-color");
  EXPECT_TRUE (contains (contentOf (folder_ / "out.ply"), "\nproperty double rgb\n"))
      << "it is a number, not PCL's packed colour";
}

TEST_F (Segment, HasNoPlaneInATextOfAFewPoints)
{
  for (const char* text : {"1 2 3\n", "1 2 3\n1 2 4\n", "1 2 3\n1 2 4\n1 3 3\n"}) {
    folder_.write ("few.xyz", text);
    expectDone ("few.xyz out.pcd --planes p.json");
    EXPECT_TRUE (contains (contentOf (folder_ / "p.json"), "\"planes\": []"));
  }
}
