// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "town_files.h"

#include <cli/interruption.h>
#include <cli/memory.h>
#include <io/las_writer.h>
#include <io/output_file.h>

#include <cmath>
#include <cstdio>
#include <filesystem>

namespace pcl_ops::simulation {

namespace {

constexpr double millimetre = 0.001;

std::vector<apps::LasPoint>
toLas (const std::vector<TownPoint>& points, const Eigen::Vector3d& offset)
{
  std::vector<apps::LasPoint> records;
  records.reserve (points.size());
  for (const TownPoint& point : points) {
    const Eigen::Vector3d local = (point.position - offset) / millimetre;
    apps::LasPoint record{{}, point.label};
    for (std::size_t axis = 0; axis < 3; ++axis)
      record.raw[axis] =
          std::int32_t (std::lround (local[static_cast<Eigen::Index> (axis)]));
    records.push_back (record);
  }
  return records;
}

std::string
nameOf (std::uint32_t column, std::uint32_t row)
{
  std::array<char, 32> name{};
  std::snprintf (name.data(), name.size(), "town_%03u_%03u.las", column, row);
  return name.data();
}

} // namespace

std::uint32_t
tilesAlongASide (double tiles)
{
  return std::uint32_t (std::ceil (std::sqrt (tiles)));
}

TownFiles
saveTown (const std::string& folder,
          const Town& town,
          double noise_scale,
          apps::Progress& progress)
{
  apps::makeFolder (folder);
  TownFiles written;
  for (std::uint32_t row = 0; row < town.tiles; ++row)
    for (std::uint32_t column = 0; column < town.tiles; ++column) {
      apps::stopIfInterrupted();
      const std::string file =
          (std::filesystem::path (folder) / nameOf (column, row)).string();
      apps::inMemory (file, "give more --tiles", [&] {
        const auto points =
            toLas (surveyTile (town, column, row, noise_scale), town.corner);
        if (points.empty())
          return;
        apps::saveLas (file, points, millimetre, town.corner);
        ++written.files;
        written.points += points.size();
      });
      progress.step();
    }
  return written;
}

} // namespace pcl_ops::simulation
