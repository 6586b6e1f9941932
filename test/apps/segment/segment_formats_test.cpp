// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/io.h>

#include "segment_program.h"
#include <io/cloud_file.h>
#include <io/laz_file.h>
#include <io/shifted_cloud.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iomanip>
#include <sstream>

using pcl_ops::apps::FileCloud;
using pcl_ops::apps::loadCloud;

namespace {

class SegmentLas : public Segment {
protected:
  /** \brief What each record of a labelled file ends with. */
  std::vector<std::uint32_t>
  labelsIn (const std::string& file) const
  {
    const std::string las = contentOf (folder_ / file);
    const std::size_t points = lasNumber<std::uint32_t> (las, las_at::points_offset);
    const std::size_t length = lasNumber<std::uint16_t> (las, las_at::record_length);
    std::vector<std::uint32_t> labels;
    for (std::size_t i = 0; i < recipe_.points.size(); ++i) {
      const std::size_t record = points + i * length;
      EXPECT_EQ (las.substr (record, length - 4), lasRecord (recipe_, i));
      labels.push_back (lasNumber<std::uint32_t> (las, record + length - 4));
    }
    return labels;
  }

  /** \brief Whether floor and wall are a plane each. */
  static void
  expectFloorAndWall (const std::vector<std::uint32_t>& labels)
  {
    const auto wall = labels.begin() + points_of_plane;
    const std::set<std::uint32_t> on_floor (labels.begin(), wall);
    const std::set<std::uint32_t> on_wall (wall, labels.end());
    EXPECT_EQ (on_floor.size(), 1u);
    EXPECT_EQ (on_wall.size(), 1u);
    EXPECT_EQ (*on_floor.begin() + *on_wall.begin(), 3u) << "1 and 2, either way";
  }

  LasRecipe recipe_ = floorAndWallInLas();
  std::string input_ = folder_.write ("in.las", lasBytes (recipe_));
};

TEST_F (SegmentLas, LabelsEveryRecordAndKeepsItsOtherBytesWhereverItIsFrom)
{
  std::filesystem::create_directory (folder_ / "scans");
  std::filesystem::copy_file (input_, folder_ / "scans/in.las");
  for (const auto& [arguments, output] :
       {std::pair ("in.las out.las", "out.las"),
        std::pair ("- piped.las <in.las", "piped.las"),
        std::pair ("scans --output-dir out", "out/in.las")}) {
    SCOPED_TRACE (arguments);
    expectDone (arguments);
    expectFloorAndWall (labelsIn (output));
  }
}

TEST_F (SegmentLas, LabelsALazInEveryWayALasIsLabelled)
{
  if (!pcl_ops::apps::hasLaszip()) {
    EXPECT_EQ (run ("in.las out.laz").exit_code, 2) << "no such format";
    GTEST_SKIP() << "LASzip is missing";
  }
  expectDone ("in.las out.las");
  {
    std::ofstream stream (folder_ / "in.laz", std::ios::binary);
    pcl_ops::apps::compressLas (input_, stream);
  }
  for (const auto& [arguments, output] :
       {std::pair ("in.laz packed.laz", "packed.laz"),
        std::pair ("- piped.laz < in.laz", "piped.laz"),
        std::pair ("in.laz --output-dir out", "out/in.laz")}) {
    expectDone (arguments);
    std::ofstream stream (folder_ / "unpacked.las", std::ios::binary);
    pcl_ops::apps::decompressLaz (folder_ / output, stream);
    stream.close();
    EXPECT_TRUE (contentOf (folder_ / "unpacked.las") ==
                 contentOf (folder_ / "out.las"));
  }
}

TEST_F (SegmentLas, HasUtmCoordinatesInEveryOutput)
{
  expectDone ("in.las out.pcd --planes p.json --rest rest.pcd --only "
              "horizontal --up 0,0,1 --planes-dir planes");
  const auto json = jsonIn ("p.json");
  EXPECT_NEAR (json.at ("planes").at (0).at ("centroid").at (0), 500000.98, 1e-6);
  EXPECT_NEAR (json.at ("planes").at (0).at ("centroid").at (1), 5400000.98, 1e-6);
  const std::vector<std::pair<std::string, std::size_t>> clouds = {
      {"out.pcd", 0},
      {"planes/plane_001_horizontal.pcd", 0},
      {"rest.pcd", points_of_plane}};
  for (const auto& [file, first] : clouds) {
    SCOPED_TRACE (file);
    const pcl_ops::apps::FileCloud cloud = pcl_ops::apps::loadCloud (folder_ / file);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto places = valuesOf<double> (cloud, std::string (1, "xyz"[axis]));
      for (std::size_t i = 0; i < points_of_plane; ++i)
        ASSERT_EQ (places[i],
                   recipe_.points[first + i].at (axis) * recipe_.scale +
                       recipe_.offset.at (axis));
    }
  }
}

TEST_F (SegmentLas, HasMillimetersInItsMesh)
{
  for (auto& point : recipe_.points)
    point[1] += 1;
  folder_.write ("in.las", lasBytes (recipe_));
  for (const char* mesh : {"m.ply", "m.vtk"}) {
    expectDone (std::string ("in.las --mesh ") + mesh);
    double southmost = std::numeric_limits<double>::infinity();
    std::istringstream words (contentOf (folder_ / mesh));
    for (std::string word; words >> word;)
      if (const double number = std::strtod (word.c_str(), nullptr); number > 5e6)
        southmost = std::min (southmost, number);
    EXPECT_NEAR (southmost, 5400000.001, 1e-4) << mesh;
  }
}

class SegmentPly : public Segment {
protected:
  /** \brief Labels a cloud as .pcd and as .ply. */
  void
  writeBoth (const std::string& input) const
  {
    for (const char* output : {" out.pcd", " out.ply"}) {
      expectDone (input + output);
    }
  }

  /** \brief Whether the .ply is read with these fields of the .pcd, to the bit. */
  void
  expectSameFields (const std::vector<std::string>& names) const
  {
    const FileCloud pcd = loadCloud (folder_ / "out.pcd");
    const FileCloud ply = loadCloud (folder_ / "out.ply");
    ASSERT_EQ (ply.points.width, pcd.points.width);
    ASSERT_EQ (ply.points.height, pcd.points.height);
    for (const std::string& name : names) {
      EXPECT_EQ (fieldOf (ply, name).datatype, fieldOf (pcd, name).datatype) << name;
      EXPECT_TRUE (bytesOf (ply, name) == bytesOf (pcd, name)) << name;
    }
  }

  static std::vector<std::uint8_t>
  bytesOf (const FileCloud& cloud, const std::string& name)
  {
    const pcl::PCLPointField field = fieldOf (cloud, name);
    const int size = pcl::getFieldSize (field.datatype);
    std::vector<std::uint8_t> bytes;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const auto number = cloud.points.data.begin() +
                          std::ptrdiff_t (i * cloud.points.point_step + field.offset);
      bytes.insert (bytes.end(), number, number + size);
    }
    return bytes;
  }
};

TEST_F (SegmentPly, HasEveryFieldOfTheInputToTheBit)
{
  writeBoth ("in.pcd");
  expectSameFields ({"x", "y", "z", "intensity", "label"});
  const FileCloud ply = loadCloud (folder_ / "out.ply");
  EXPECT_TRUE (contains (contentOf (folder_ / "out.ply"),
                         "ply\nformat binary_little_endian 1.0\n"));
  // PCL's reader leaves the fourth byte of a color as it is.
  const FileCloud pcd = loadCloud (folder_ / "out.pcd");
  const auto read = bytesOf (ply, "rgb"), written = bytesOf (pcd, "rgb");
  ASSERT_EQ (read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i)
    if (i % 4 != 3) {
      ASSERT_EQ (read[i], written[i]) << i;
    }
}

TEST_F (SegmentPly, KeepsFieldsWithTheNamesOfItsColors)
{
  std::ostringstream text;
  text << "x,y,z,red,nx,normal_x\n";
  for (int i = 0; i < 2000; ++i)
    text << 0.05 * (i % 50) << "," << 0.05 * (i / 50) << ",0," << i << ",2,3\n";
  folder_.write ("in.csv", text.str());
  expectDone ("in.csv out.ply");
  EXPECT_TRUE (contains (contentOf (folder_ / "out.ply"), "property uchar red\n"));
  const FileCloud in = loadCloud (folder_ / "in.csv");
  const FileCloud ply = loadCloud (folder_ / "out.ply");
  EXPECT_TRUE (bytesOf (ply, "red_") == bytesOf (in, "red"));
  EXPECT_TRUE (bytesOf (ply, "nx_") == bytesOf (in, "normal_x"));
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

/** \brief A floor of 2 m by 2 m at UTM coordinates, in millimeters, with the number of
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

TEST_F (Segment, LabelsATextAndKeepsItsMillimetersAndColumns)
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
  expectDone ("- <marked.txt"); // the mark of UTF-8
}

TEST_F (Segment, KeepsAColumnCalledRgb)
{
  folder_.write ("in.csv", "x,y,z,rgb\n" + floorText (','));
  expectDone ("in.csv out.ply --keep-color");
  EXPECT_TRUE (contains (contentOf (folder_ / "out.ply"), "\nproperty double rgb\n"))
      << "it is a number, not PCL's packed color";
}

TEST_F (Segment, HasNoPlaneInATextOfAFewPoints)
{
  for (const char* text : {"1 2 3\n", "1 2 3\n1 2 4\n", "1 2 3\n1 2 4\n1 3 3\n"}) {
    folder_.write ("few.xyz", text);
    expectDone ("few.xyz out.pcd --planes p.json");
    EXPECT_TRUE (contains (contentOf (folder_ / "p.json"), "\"planes\": []"));
  }
}

constexpr int millimeters_off = 4;

class SegmentDistances : public Segment {
protected:
  /** \brief The field of a cloud that was written. */
  std::vector<float>
  distancesIn (const std::string& file) const
  {
    if (file.find (".las") != std::string::npos)
      return distancesInLas (contentOf (folder_ / file));
    return valuesOf<float> (pcl_ops::apps::loadCloud (folder_ / file), "distance");
  }

  /** \brief The last four of the extra bytes, by the header alone. */
  static std::vector<float>
  distancesInLas (const std::string& las)
  {
    const auto length = lasNumber<std::uint16_t> (las, las_at::record_length);
    std::vector<float> distances;
    for (std::size_t end =
             lasNumber<std::uint32_t> (las, las_at::points_offset) + length;
         end <= las.size();
         end += length) {
      distances.emplace_back();
      std::memcpy (&distances.back(), &las[end - sizeof (float)], sizeof (float));
    }
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
      recipe.points.push_back ({i % 2 == 0 ? millimeters_off : 0,
                                40 * (i / points_of_side),
                                40 * (i % points_of_side)});
    folder_.write ("in.las", lasBytes (recipe));
  }

  /** \brief Whether points are 2 mm before and behind the plane between them, turn by
   * turn. */
  void
  expectTurns (const std::string& file) const
  {
    const std::vector<float> distances = distancesIn (file);
    ASSERT_EQ (distances.size(), std::size_t (points_of_plane));
    const float before = distances[0] > 0.0f ? 0.002f : -0.002f;
    for (std::size_t i = 0; i < distances.size(); ++i)
      ASSERT_NEAR (distances[i], i % 2 == 0 ? before : -before, 2e-4f) << i;
  }
};

TEST_F (SegmentDistances, AreSignedAndNoneOnNoPlane)
{
  InputCloud cloud = floorAndWall();
  for (int i = 0; i < points_of_plane; ++i)
    cloud[i].z = i % 2 == 0 ? 0.004f : 0.0f;
  pcl::io::savePCDFileBinary (folder_ / "rough.pcd", cloud);
  for (const char* output : {"out.pcd", "out.ply"}) {
    expectDone (std::string ("rough.pcd --distances ") + output);
    const std::vector<float> distances = distancesIn (output);
    for (int i = 0; i < points_of_plane; ++i)
      ASSERT_NEAR (distances[i], i % 2 == 0 ? 0.002f : -0.002f, 2e-4f)
          << "the sensor is above the floor";
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
    expectTurns (output);
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
  // Once more, in their own place.
  expectDone ("out.las again.las --distances");
  EXPECT_TRUE (contentOf (folder_ / "again.las") == las);
}

} // namespace
