// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"
#include <io/cloud_file.h>
#include <io/laz_file.h>
#include <io/shifted_cloud.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

using pcl_ops::apps::FileCloud;
using pcl_ops::apps::loadCloud;

namespace {

class SegmentLas : public Segment {
protected:
  LasRecipe recipe_ = floorAndWallInLas();
  std::string input_ = folder_.write ("in.las", lasBytes (recipe_));
};

TEST_F (SegmentLas, LabelsLasAndLazWhereverTheyAreFrom)
{
  std::vector<std::pair<std::string, std::string>> rows = {
      {"in.las out.las", "out.las"},
      {"- piped.las <in.las", "piped.las"},
      {"in.las --output-dir out", "out/in.las"}};
  if (pcl_ops::apps::hasLaszip()) {
    std::ofstream stream (folder_ / "in.laz", std::ios::binary);
    pcl_ops::apps::compressLas (input_, stream);
    rows.insert (rows.end(),
                 {{"in.laz packed.laz", "packed.laz"},
                  {"- piped.laz <in.laz", "piped.laz"},
                  {"in.laz --output-dir out", "out/in.laz"}});
  }
  else
    EXPECT_EQ (run ("in.las out.laz").exit_code, 2) << "no such format";
  for (const auto& [arguments, output] : rows) {
    SCOPED_TRACE (arguments);
    expectDone (arguments);
    const FileCloud cloud = loadCloud (folder_ / output);
    ASSERT_NE (cloud.las, nullptr);
    const auto labels = valuesOf<std::uint32_t> (cloud, "label");
    ASSERT_EQ (labels.size(), recipe_.points.size());
    EXPECT_EQ (distinct (labels, 0, points_of_plane).size(), 1u);
    EXPECT_EQ (distinct (labels, points_of_plane, 2 * points_of_plane).size(), 1u);
    EXPECT_EQ (labels.front() + labels.back(), 3u) << "1 and 2, either way";
  }
}

TEST_F (SegmentLas, HasUtmCoordinatesInEveryOutput)
{
  const auto planes = jsonOf ("in.las out.pcd --rest rest.pcd --only horizontal "
                              "--up 0,0,1 --planes-dir planes")["planes"];
  EXPECT_NEAR (planes.at (0).at ("centroid").at (0), 500000.98, 1e-6);
  EXPECT_NEAR (planes.at (0).at ("centroid").at (1), 5400000.98, 1e-6);
  for (const auto& [file, first] : {std::pair ("out.pcd", 0),
                                    std::pair ("planes/plane_001_horizontal.pcd", 0),
                                    std::pair ("rest.pcd", points_of_plane)}) {
    SCOPED_TRACE (file);
    const FileCloud cloud = loadCloud (folder_ / file);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto places = valuesOf<double> (cloud, std::string (1, "xyz"[axis]));
      for (std::size_t i = 0; i < points_of_plane; ++i)
        ASSERT_EQ (places[i],
                   recipe_.points[std::size_t (first) + i].at (axis) * recipe_.scale +
                       recipe_.offset.at (axis));
    }
  }
}

using SegmentPly = Segment;

TEST_F (SegmentPly, HasEveryFieldOfTheInputToTheBit)
{
  for (const char* output : {"in.pcd out.pcd", "in.pcd out.ply"})
    expectDone (output);
  const FileCloud pcd = loadCloud (folder_ / "out.pcd");
  const FileCloud ply = loadCloud (folder_ / "out.ply");
  ASSERT_EQ (ply.points.width, pcd.points.width);
  for (const char* name : {"x", "y", "z", "intensity", "label"}) {
    EXPECT_EQ (fieldOf (ply, name).datatype, fieldOf (pcd, name).datatype) << name;
    EXPECT_EQ (valuesOf<std::uint32_t> (ply, name), valuesOf<std::uint32_t> (pcd, name))
        << name;
  }
  const auto read = valuesOf<std::uint32_t> (ply, "rgb");
  const auto written = valuesOf<std::uint32_t> (pcd, "rgb");
  for (std::size_t i = 0; i < written.size(); ++i)
    ASSERT_EQ (read[i] & 0xffffff, written[i] & 0xffffff)
        << "the fourth byte is none's";
}

TEST_F (SegmentPly, KeepsFieldsWithTheNamesOfItsOwn)
{
  std::ostringstream text;
  text << "x,y,z,red,nx,normal_x,rgb\n";
  for (int i = 0; i < 2000; ++i)
    text << 0.05 * (i % 50) << "," << 0.05 * (i / 50) << ",0," << i << ",2,3,4\n";
  folder_.write ("in.csv", text.str());
  expectDone ("in.csv out.ply");
  EXPECT_TRUE (contains (contentOf (folder_ / "out.ply"), "property uchar red\n"));
  const FileCloud in = loadCloud (folder_ / "in.csv");
  const FileCloud ply = loadCloud (folder_ / "out.ply");
  EXPECT_EQ (valuesOf<double> (ply, "red_"), valuesOf<double> (in, "red"));
  EXPECT_EQ (valuesOf<double> (ply, "nx_"), valuesOf<double> (in, "normal_x"));
  expectDone ("in.csv out.ply --keep-color");
  EXPECT_TRUE (contains (contentOf (folder_ / "out.ply"), "\nproperty double rgb\n"))
      << "it is a number, not PCL's packed color";
}

TEST_F (SegmentPly, HasTheFieldsOtherProgramsLookFor)
{
  std::string points;
  for (int i = 0; i < 4; ++i)
    points += std::to_string (i) + " 0 1.5 0 0 1 7 8 4294967297 9\n";
  folder_.write ("odd.pcd",
                 "FIELDS x y z normal_x normal_y normal_z shape stamp red\n"
                 "SIZE 4 8 4 4 4 4 2 8 4\nTYPE F F F F F F I I F\n"
                 "COUNT 1 1 1 1 1 1 2 1 1\nWIDTH 2\nHEIGHT 2\nPOINTS 4\nDATA ascii\n" +
                     points);
  expectDone ("odd.pcd out.ply");
  const std::string ply = contentOf (folder_ / "out.ply");
  EXPECT_EQ (ply.substr (0, ply.find ("end_header")),
             "ply\nformat binary_little_endian 1.0\nobj_info num_cols 2\n"
             "obj_info num_rows 2\nelement vertex 4\nproperty float x\n"
             "property double y\nproperty float z\nproperty float nx\n"
             "property float ny\nproperty float nz\nproperty short shape_0\n"
             "property short shape_1\nproperty double stamp\nproperty float red_\n"
             "property uint label\nproperty uchar red\nproperty uchar green\nproperty "
             "uchar blue\n");
  const FileCloud read = loadCloud (folder_ / "out.ply");
  EXPECT_EQ (read.points.width, 2u);
  EXPECT_EQ (valuesOf<double> (read, "stamp")[0], 4294967297.0);
}

TEST_F (Segment, LabelsATextAndKeepsItsMillimetersAndColumns)
{
  folder_.write ("in.csv", "x,y,z,number\n" + squareText (50, 120.789, ","));
  for (const char* output : {"out.pcd", "out.ply"}) {
    SCOPED_TRACE (output);
    expectDone (std::string ("in.csv ") + output);
    const FileCloud cloud = loadCloud (folder_ / output);
    const pcl_ops::apps::CoordinateReader place (cloud);
    EXPECT_EQ (place (51), Eigen::Vector3d (500000.04, 5400000.04, 120.789));
    EXPECT_EQ (valuesOf<double> (cloud, "number"),
               valuesOf<double> (loadCloud (folder_ / "in.csv"), "number"));
    EXPECT_EQ (valuesOf<std::uint32_t> (cloud, "label"),
               std::vector<std::uint32_t> (2500, 1u));
  }
}

TEST_F (Segment, TakesTextsByNameByPatternAndFromAPipe)
{
  std::filesystem::create_directory (folder_ / "scans");
  for (const char* file : {"scans/a.txt", "scans/b.xyz", "scans/notes.csv"})
    folder_.write (file, "\xef\xbb\xbf" + squareText (50, 120)); // the mark of UTF-8
  expectDone ("'scans/*.txt' --output-dir by_pattern");
  EXPECT_EQ (namesIn ("by_pattern"), (std::set<std::string>{"a.json", "a.pcd"}));
  expectDone ("scans --output-dir by_folder");
  EXPECT_EQ (namesIn ("by_folder"), (std::set<std::string>{"b.json", "b.pcd"}));
  EXPECT_EQ (jsonOf ("- <scans/a.txt")["planes"].size(), 1u);
}

class SegmentDistances : public Segment {
protected:
  /** \brief The field of a cloud that was written; of a LAS the last four of the extra
   * bytes, by the header alone. */
  std::vector<float>
  distancesIn (const std::string& file) const
  {
    if (file.find (".las") == std::string::npos)
      return valuesOf<float> (loadCloud (folder_ / file), "distance");
    const std::string las = contentOf (folder_ / file);
    const auto length = lasNumber<std::uint16_t> (las, las_at::record_length);
    std::size_t end = lasNumber<std::uint32_t> (las, las_at::points_offset);
    std::vector<float> distances;
    while ((end += length) <= las.size())
      distances.push_back (lasNumber<float> (las, end - sizeof (float)));
    return distances;
  }

  /** \brief in.las: a wall alone, at an x that single precision has no millimeters of,
   * with every second point 4 mm farther. */
  void
  writeLas () const
  {
    LasRecipe recipe;
    recipe.points.clear();
    for (int i = 0; i < points_of_plane; ++i)
      recipe.points.push_back (
          {i % 2 == 0 ? 4 : 0, 40 * (i / points_of_side), 40 * (i % points_of_side)});
    folder_.write ("in.las", lasBytes (recipe));
  }

  /** \brief Whether points are 2 mm before and behind the plane between them, turn by
   * turn. */
  static void
  expectTurns (const std::vector<float>& distances, float first)
  {
    for (std::size_t i = 0; i < points_of_plane; ++i)
      ASSERT_NEAR (distances.at (i), i % 2 == 0 ? first : -first, 2e-4f) << i;
  }
};

TEST_F (SegmentDistances, AreSignedAndNoneOnNoPlane)
{
  InputCloud cloud = floorAndWall();
  for (int i = 0; i < points_of_plane; ++i)
    cloud[i].z = i % 2 == 0 ? 0.004f : 0.0f;
  save ("rough.pcd", cloud);
  for (const char* output : {"out.pcd", "out.ply"}) {
    expectDone (std::string ("rough.pcd --distances ") + output);
    const std::vector<float> distances = distancesIn (output);
    expectTurns (distances, 0.002f); // the sensor is above the floor
    EXPECT_TRUE (std::isnan (distances[missing_reading]));
    EXPECT_NEAR (distances.back(), 0.0f, 1e-4f);
  }
  expectDone ("rough.pcd out.pcd --distances --only vertical");
  EXPECT_TRUE (std::isnan (distancesIn ("out.pcd").front())) << "of a plane left out";
}

TEST_F (SegmentDistances, AreThoseOfUtmCoordinatesInEveryFormatAndInABatch)
{
  writeLas();
  for (const auto& [arguments, output] :
       {std::pair ("out.pcd", "out.pcd"),
        std::pair ("out.ply", "out.ply"),
        std::pair ("out.las", "out.las"),
        std::pair ("--output-dir out", "out/in.las"),
        std::pair ("--output-dir out --format ply", "out/in.ply")}) {
    expectDone (std::string ("in.las --distances ") + arguments);
    const std::vector<float> distances = distancesIn (output);
    expectTurns (distances, std::copysign (0.002f, distances.at (0)));
  }
}

TEST_F (SegmentDistances, AreDescribedBesideTheLabelInALas)
{
  writeLas();
  expectDone ("in.las out.las --distances");
  // LAS 1.4 R15, table 24: type 5 is an unsigned long, 9 a float, at 2; the name at 4.
  const std::string las = contentOf (folder_ / "out.las");
  constexpr std::size_t vlr_header = 54, description = 192;
  const std::size_t label = lasHeaderSize (4) + vlr_header,
                    distance = label + description;
  EXPECT_EQ (las.substr (label + 2, 1), "\5");
  EXPECT_EQ (las.substr (label + 4, 6), std::string ("label\0", 6));
  EXPECT_EQ (las.substr (distance + 2, 1), "\x9");
  EXPECT_EQ (las.substr (distance + 4, 9), std::string ("distance\0", 9));
  expectDone ("out.las again.las --distances");
  EXPECT_TRUE (contentOf (folder_ / "again.las") == las) << "in their own place";
}

} // namespace
