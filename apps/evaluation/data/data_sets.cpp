// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data_sets.h"

#include <pcl/common/point_tests.h>

#include "labeled_cloud.h"
#include "sun_rgbd.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <io/cloud_file.h>
#include <simulation/simulate.h>

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace pcl_ops::evaluation {

const char* const data_set_help =
    "sunrgbd:FOLDER or sunrgbd-raw:FOLDER (refined or raw depth), "
    "rooms:FIRST-LAST or rooms-raw:FIRST-LAST (simulated, by seed), "
    "simulated:N,N,... (scans of a whole room with N points), "
    "furniture:FIRST-LAST (boards on posts in a corner, by seed), "
    "survey:FIRST-LAST (36 houses on a ground, by seed), "
    "shapes:FIRST-LAST (round shapes beside a ground, by seed), "
    "streets:FIRST-LAST, streets-32:FIRST-LAST, streets-16:FIRST-LAST or "
    "streets-livox:FIRST-LAST (a street around a lidar with 64, 32 or 16 beams or a "
    "rosette, by seed), "
    "clouds:PATH (.pcd, .ply, .las and text, field label as truth; a folder is a data "
    "set of its name)";

namespace {

namespace fs = std::filesystem;

/** More scenes than anybody waits for; keeps a typing error from filling the memory. */
constexpr std::uint32_t max_scenes = 100'000;
/** A point takes 16 bytes, and 36 more while it is simulated. */
constexpr double max_points = 1e8;

/** The finite points, and the pixels they come from if the cloud is an image. */
template <typename PointT, typename Visit>
EvaluationCloud
finiteOf (const pcl::PointCloud<PointT>& cloud, const Visit& visit)
{
  EvaluationCloud result;
  result.cloud.reset (new XyzCloud);
  result.cloud->reserve (cloud.size());
  result.cloud->sensor_origin_ = cloud.sensor_origin_;
  result.cloud->sensor_orientation_ = cloud.sensor_orientation_;
  if (cloud.height > 1)
    result.grid = ImageGrid{cloud.width, cloud.height, {}};
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    if (!pcl::isXYZFinite (cloud[i]))
      continue;
    result.cloud->push_back (pcl::PointXYZ (cloud[i].x, cloud[i].y, cloud[i].z));
    if (result.grid)
      result.grid->pixels.push_back (std::uint32_t (i));
    visit (i);
  }
  return result;
}

EvaluationCloud
simulated (const simulation::Simulation& simulation)
{
  const auto cloud = simulation::simulate (simulation).cloud;
  PlaneLabels truth;
  EvaluationCloud result =
      finiteOf (cloud, [&] (std::size_t i) { truth.push_back (cloud[i].label); });
  result.truth = truth;
  return result;
}

/** Data sets of scenes by seed. */
const struct Scenes {
  const char *name, *scene, *sensor = "";
  bool has_raw_depth = false;
} all_scenes[] = {{"rooms", "room"},
                  {"rooms-raw", "room", "", true},
                  {"furniture", "furniture"},
                  {"survey", "survey"},
                  {"shapes", "shapes"},
                  {"streets", "street", "lidar-64"},
                  {"streets-32", "street", "lidar-32"},
                  {"streets-16", "street", "lidar-16"},
                  {"streets-livox", "street", "livox"}};

/** "3-20", or "7" for one scene. */
std::pair<std::uint32_t, std::uint32_t>
seedRange (const std::string& kind, const std::string& text)
{
  const std::size_t dash = text.find ('-');
  const apps::Range any = apps::Range::from (0);
  const auto first =
      apps::parseNumber<std::uint32_t> (kind, text.substr (0, dash), any);
  const auto last =
      dash == std::string::npos
          ? first
          : apps::parseNumber<std::uint32_t> (kind, text.substr (dash + 1), any);
  if (last < first || last - first >= max_scenes)
    throw apps::UsageError (kind + ':' + text, "is no range of seeds such as 1-20");
  return {first, last};
}

DataSet
scenesDataSet (const Scenes& scenes, const std::string& seeds)
{
  const auto [first, last] = seedRange (scenes.name, seeds);
  DataSet data_set{scenes.name, {}};
  for (std::uint32_t i = 0; i <= last - first; ++i) {
    simulation::Simulation simulation;
    simulation.scene = scenes.scene;
    simulation.seed = first + i;
    simulation.has_raw_depth = scenes.has_raw_depth;
    simulation.sensor = scenes.sensor;
    simulation.organized =
        simulation.scene == "room" || simulation.scene == "furniture";
    std::ostringstream cloud;
    cloud << scenes.scene << '-' << std::setfill ('0') << std::setw (4) << first + i;
    data_set.clouds.push_back (
        {cloud.str(), [simulation] { return simulated (simulation); }});
  }
  return data_set;
}

DataSet
scansDataSet (const std::string& name, const std::string& sizes)
{
  const apps::Range of_points = apps::Range::from (1).upTo (max_points);
  DataSet data_set{name, {}};
  std::istringstream list (sizes);
  for (std::string size; std::getline (list, size, ',');) {
    simulation::Simulation scan;
    scan.points = apps::parseNumber<double> (name, size, of_points);
    data_set.clouds.push_back ({"scan-" + size, [scan] { return simulated (scan); }});
  }
  if (data_set.clouds.empty())
    throw apps::UsageError (name,
                            "has no size; give numbers of points, 300000,3000000");
  return data_set;
}

EvaluationCloud
readCloud (const std::string& file, const Eigen::Vector3d& up)
{
  const LabeledCloud all = loadLabeledCloud (file, LabelField::Optional);
  PlaneLabels truth;
  EvaluationCloud finite = finiteOf (*all.cloud, [&] (std::size_t i) {
    if (!all.labels.empty())
      truth.push_back (all.labels[i]);
  });
  finite.up = up;
  if (!all.labels.empty())
    finite.truth = truth;
  if (finite.cloud->empty())
    throw apps::WorkError (file, "has no finite point; leave it out");
  return finite;
}

std::vector<fs::path>
cloudFilesIn (const std::string& folder)
{
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator entry (folder, error), end; entry != end;
       entry.increment (error)) {
    if (apps::isCloudFile (entry->path().string()))
      files.push_back (entry->path());
  }
  if (files.empty())
    throw apps::WorkError (folder,
                           std::string ("has no ") + apps::folder_extensions +
                               " file; give a folder with clouds");
  std::sort (files.begin(), files.end());
  return files;
}

DataSet
cloudsDataSet (const std::string& path, const Eigen::Vector3d& up)
{
  std::error_code error;
  if (!fs::exists (path, error))
    throw apps::WorkError (path, "does not exist; give a cloud or a folder of clouds");
  const bool is_folder = fs::is_directory (path, error);
  const fs::path folder = is_folder ? fs::path (path) : fs::path (path).parent_path();
  const fs::path name = is_folder ? folder.filename() : fs::path();
  DataSet data_set{name.empty() ? "clouds" : name.string(), {}};
  for (const fs::path& file :
       is_folder ? cloudFilesIn (path) : std::vector<fs::path>{path})
    data_set.clouds.push_back (
        {file.lexically_relative (folder).generic_string(),
         [name = file.string(), up] { return readCloud (name, up); }});
  return data_set;
}

} // namespace

DataSet
dataSetOf (const std::string& text, const Eigen::Vector3d& up)
{
  const std::size_t colon = text.find (':');
  const std::string kind = text.substr (0, colon);
  const std::string rest = colon == std::string::npos ? "" : text.substr (colon + 1);
  if (!rest.empty()) {
    if (kind == "sunrgbd")
      return sunRgbdDataSet (rest, SunRgbdDepth::Refined);
    if (kind == "sunrgbd-raw")
      return sunRgbdDataSet (rest, SunRgbdDepth::Raw);
    if (kind == "simulated")
      return scansDataSet (kind, rest);
    if (kind == "clouds")
      return cloudsDataSet (rest, up);
    for (const Scenes& scenes : all_scenes)
      if (kind == scenes.name)
        return scenesDataSet (scenes, rest);
  }
  throw apps::UsageError (text, std::string ("is no data set; give ") + data_set_help);
}

std::vector<DataSet>
dataSetsOf (const std::vector<std::string>& texts, const Eigen::Vector3f& up)
{
  std::vector<DataSet> data_sets;
  for (const std::string& text : texts)
    data_sets.push_back (dataSetOf (text, up.cast<double>().normalized()));
  return data_sets;
}

} // namespace pcl_ops::evaluation
