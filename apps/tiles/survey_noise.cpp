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
  std::int64_t octave = 0;
  double usual = 0.0;
};

} // namespace

std::vector<std::size_t>
tilesThatTell (const std::vector<std::uint64_t>& points)
{
  // Measuring these points takes less time than finding the planes of one large tile.
  // They show densities that only a few per cent of all points have.
  constexpr std::uint64_t enough = 400'000;
  const std::uint64_t all =
      std::accumulate (points.begin(), points.end(), std::uint64_t (0));
  const std::uint64_t step = std::max<std::uint64_t> (1, all / enough);
  std::vector<std::size_t> tiles;
  for (std::size_t tile = step / 2 % std::max<std::size_t> (1, points.size());
       tile < points.size();
       tile += step)
    tiles.push_back (tile);
  return tiles;
}

CloudNoise
noiseOfSurvey (const Plan& plan,
               const std::vector<TileKey>& tiles,
               const PointsOfTile& points_of)
{
  const auto corner_of = [&] (const TileKey& tile) {
    return plan.grid.cornerOf (plan.grid.frameOf (tile));
  };
  std::vector<Eigen::Vector3f> all;
  for (const TileKey& tile : tiles) {
    const Eigen::Vector3d offset = corner_of (tile) - corner_of (tiles.front());
    for (const Eigen::Vector3f& point : points_of (tile))
      all.emplace_back ((offset + point.cast<double>()).cast<float>());
  }
  return measureNoise ({all.data(), 0, sizeof (all[0]), all.size()}, {}, plan.points());
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
