// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scene_files.h"

#include <cli/errors.h>
#include <cli/interruption.h>
#include <io/labeled_pcd.h>
#include <io/las_file.h>
#include <io/output_file.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

namespace pcl_ops::simulation {

namespace {

namespace fs = std::filesystem;

constexpr double millimeter = 0.001;

/** \brief A name of printf's pattern in a folder. */
template <typename... Numbers>
std::string
nameIn (const std::string& folder, const char* pattern, Numbers... numbers)
{
  std::array<char, 32> name{};
  std::snprintf (name.data(), name.size(), pattern, numbers...);
  return (fs::path (folder) / name.data()).string();
}

std::vector<apps::LasPoint>
toLas (const std::vector<TownPoint>& points, const Eigen::Vector3d& offset)
{
  std::vector<apps::LasPoint> records;
  records.reserve (points.size());
  for (const TownPoint& point : points) {
    const Eigen::Vector3d local = (point.position - offset) / millimeter;
    apps::LasPoint record{{}, point.label};
    for (std::size_t axis = 0; axis < 3; ++axis)
      record.raw[axis] =
          std::int32_t (std::lround (local[static_cast<Eigen::Index> (axis)]));
    records.push_back (record);
  }
  return records;
}

} // namespace

WrittenFiles
saveTown (const std::string& folder,
          const Town& town,
          double noise_scale,
          apps::Progress& progress)
{
  apps::makeFolder (folder);
  WrittenFiles written;
  for (std::uint32_t row = 0; row < town.tiles; ++row)
    for (std::uint32_t column = 0; column < town.tiles; ++column) {
      apps::stopIfInterrupted();
      const std::string file = nameIn (folder, "town_%03u_%03u.las", column, row);
      apps::inMemory (file, "give more --tiles", [&] {
        const auto points =
            toLas (surveyTile (town, column, row, noise_scale), town.corner);
        if (points.empty())
          return;
        apps::saveLas (file, points, millimeter, town.corner);
        ++written.files;
        written.points += points.size();
      });
      progress.step();
    }
  return written;
}

WrittenFiles
saveFrames (const std::string& folder,
            std::size_t frames,
            const std::function<LabeledCloud (std::size_t)>& look,
            apps::Progress& progress)
{
  constexpr const char* pattern = "frame_%03zu.pcd";
  apps::makeFolder (folder);
  WrittenFiles written{frames, 0};
  for (std::size_t i = 0; i < frames; ++i) {
    apps::stopIfInterrupted();
    const std::string file = nameIn (folder, pattern, i);
    apps::inMemory (file, "give a smaller image or another --sensor", [&] {
      const auto cloud = look (i);
      apps::saveLabeledPcd (file, cloud);
      written.points += cloud.size();
    });
    progress.step();
  }
  // Those of a longer walk before it would be taken for frames of this one.
  for (std::size_t i = frames; fs::remove (nameIn (folder, pattern, i));)
    ++i;
  return written;
}

} // namespace pcl_ops::simulation
