// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segment_program.h"
#include <support/cloud_values.h>

#include <cmath>

using pcl_ops::apps::loadCloud;

namespace {

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

} // namespace
