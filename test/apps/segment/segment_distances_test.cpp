// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"
#include <io/cloud_file.h>
#include <support/cloud_values.h>
#include <support/las_bytes.h>

#include <cmath>
#include <cstring>

namespace {

constexpr int millimetres_off = 4;

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

  /** \brief in.las: a wall alone, at an x that single precision has no millimetres of,
   * with every second point 4 mm farther. */
  void
  writeLas () const
  {
    LasRecipe recipe;
    recipe.points.clear();
    for (int i = 0; i < points_of_plane; ++i)
      recipe.points.push_back ({i % 2 == 0 ? millimetres_off : 0,
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

} // namespace

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
