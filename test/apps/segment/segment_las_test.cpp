// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"
#include <io/cloud_file.h>
#include <io/laz_file.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

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

} // namespace

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

TEST_F (SegmentLas, HasMillimetresInItsMesh)
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
