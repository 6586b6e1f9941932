// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "survey_noise.h"

#include "run_files.h"
#include <io/output_file.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>
#include <numeric>

namespace pcl_ops::apps {

namespace {

/** \brief An entry of CloudNoise::usual_of_octave, as stored in a file. */
struct OctaveNoise {
  /** \brief log2 of the density of points [1/m^2], rounded down. */
  std::int64_t octave = 0;
  /** \brief Median noise of points at this density [m]. */
  double usual = 0.0;
};

} // namespace

std::vector<std::size_t>
tilesToMeasure (const std::vector<std::uint64_t>& points_of_tile)
{
  // So few that the noise is measured in less time than the planes of a large tile are
  // found; so many that densities of a few per cent of the points are among them.
  constexpr std::uint64_t points_to_measure = 400'000; // of the chosen tiles together
  const std::size_t tiles = points_of_tile.size();
  const std::uint64_t points =
      std::accumulate (points_of_tile.begin(), points_of_tile.end(), std::uint64_t (0));
  const std::uint64_t step = std::max<std::uint64_t> (1, points / points_to_measure);
  // The first chosen tile is the middle one of the first `step` tiles. If the list ends
  // before it, the remainder chooses a tile.
  const std::size_t first = step / 2 % std::max<std::size_t> (1, tiles);
  std::vector<std::size_t> chosen;
  for (std::size_t tile = first; tile < tiles; tile += step)
    chosen.push_back (tile);
  return chosen;
}

CloudNoise
noiseOfSurvey (const Plan& plan,
               const std::vector<TileKey>& tiles,
               const PointsOfTile& points_of)
{
  const auto origin_of = [&] (const TileKey& tile) {
    // Zero of the frame of a tile is a corner of a cell.
    return plan.grid.cornerOf (plan.grid.frameOf (tile));
  };
  std::vector<Eigen::Vector3f> points; // in the frame of the first tile
  for (const TileKey& tile : tiles) {
    const Eigen::Vector3d shift = origin_of (tile) - origin_of (tiles.front());
    for (const Eigen::Vector3f& point : points_of (tile))
      points.emplace_back ((shift + point.cast<double>()).cast<float>());
  }
  constexpr std::size_t x_offset = 0; // [bytes]
  const CloudView view (points.data(), x_offset, sizeof (points[0]), points.size());
  const OrientedPointSamplingParameters defaults; // those of the search in each tile
  return measureNoise (view, defaults, plan.points());
}

void
saveNoise (const std::string& file, const CloudNoise& noise)
{
  std::vector<OctaveNoise> octaves;
  for (const auto& [octave, usual] : noise.usual_of_octave)
    octaves.push_back ({octave, usual});
  writeFile (file, [&] (std::ostream& stream) {
    BinaryWriter write (stream, file);
    for (const double value : {noise.points, noise.common_errors, noise.usual})
      write (&value, 1);
    write (noise.growth);
    write (octaves);
    write.finish();
  });
}

CloudNoise
loadNoise (const std::string& file)
{
  BinaryReader read (file);
  CloudNoise noise;
  for (double* const value : {&noise.points, &noise.common_errors, &noise.usual})
    read (value, 1);
  read (noise.growth);
  std::vector<OctaveNoise> octaves;
  read (octaves);
  read.finish();
  for (const auto& [octave, usual] : octaves)
    noise.usual_of_octave[static_cast<int> (octave)] = usual;
  return noise;
}

} // namespace pcl_ops::apps
