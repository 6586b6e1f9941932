// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data_sets.h"

#include <pcl/common/point_tests.h>

#include "labelled_cloud.h"
#include "sun_rgbd.h"
#include <cli/errors.h>
#include <cli/option_value.h>
#include <io/cloud_file.h>
#include <simulation/dense_scan.h>
#include <simulation/poses.h>
#include <simulation/shapes.h>
#include <simulation/street.h>
#include <simulation/survey.h>

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
    "clouds:PATH (.pcd, .ply, .las and text, field label as truth)";

namespace {

namespace fs = std::filesystem;
using simulation::NoiseProfile;

/** More scenes than anybody waits for; keeps a typing error from filling the memory. */
constexpr std::uint32_t most_scenes = 100'000;
/** A point takes 16 bytes, and 36 more while it is simulated. */
constexpr double most_points = 1e8;

EvaluationCloud
withExactTruth (const simulation::SimulatedCloud& simulated)
{
  EvaluationCloud result;
  result.cloud.reset (new XyzCloud);
  result.cloud->reserve (simulated.cloud.size());
  result.cloud->sensor_origin_ = simulated.cloud.sensor_origin_;
  result.cloud->sensor_orientation_ = simulated.cloud.sensor_orientation_;
  result.truth.emplace();
  for (const pcl::PointXYZL& point : simulated.cloud) {
    result.cloud->push_back (pcl::PointXYZ (point.x, point.y, point.z));
    result.truth->push_back (point.label);
  }
  return result;
}

EvaluationCloud
imageOf (const simulation::Room& room, std::uint32_t seed, NoiseProfile profile)
{
  const Eigen::Isometry3d pose = simulation::drawCameraPose (room, seed);
  simulation::NoiseParameters noise;
  noise.profile = profile;
  return withExactTruth (
      simulation::toCloud (simulation::scanByCamera (room.scene, {}, pose, noise, seed),
                           pose,
                           room.scene,
                           simulation::CloudLayout::Readings));
}

EvaluationCloud
simulateFurniture (std::uint32_t seed)
{
  return imageOf (
      simulation::makeFurnishedCorner (seed), seed, NoiseProfile::Correlated);
}

EvaluationCloud
simulateSurvey (std::uint32_t seed)
{
  return withExactTruth (simulation::scanSurvey (
      simulation::makeSurvey (seed), simulation::points_of_survey, 1.0, seed));
}

EvaluationCloud
simulateShapes (std::uint32_t seed)
{
  return withExactTruth (simulation::scanShapes (
      simulation::makeShapes (seed), simulation::points_of_shapes, 1.0, seed));
}

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
  if (last < first || last - first >= most_scenes)
    throw apps::UsageError (kind + ':' + text, "is no range of seeds such as 1-20");
  return {first, last};
}

/** Scenes by seed.
 * \param[in] scene what the name of a cloud begins with
 * \param[in] simulate the cloud of a seed */
DataSet
scenesDataSet (const std::string& name,
               const std::string& scene,
               const std::string& seeds,
               const std::function<EvaluationCloud (std::uint32_t)>& simulate)
{
  const auto [first, last] = seedRange (name, seeds);
  DataSet data_set{name, {}};
  for (std::uint32_t i = 0; i <= last - first; ++i) {
    const std::uint32_t seed = first + i;
    std::ostringstream cloud;
    cloud << scene << '-' << std::setfill ('0') << std::setw (4) << seed;
    data_set.clouds.push_back (
        {cloud.str(), [seed, simulate] { return simulate (seed); }});
  }
  return data_set;
}

DataSet
roomsDataSet (const std::string& name, const std::string& seeds, NoiseProfile profile)
{
  return scenesDataSet (name, "room", seeds, [profile] (std::uint32_t seed) {
    return imageOf (simulation::makeRoom (seed), seed, profile);
  });
}

/** \param[in] sensor one of simulation::lidarNames */
DataSet
streetsDataSet (const std::string& name,
                const std::string& seeds,
                const std::string& sensor)
{
  return scenesDataSet (name, "street", seeds, [sensor] (std::uint32_t seed) {
    const simulation::Street street = simulation::makeStreet (seed);
    const simulation::Lidar lidar = simulation::lidarOf (sensor);
    const Eigen::Isometry3d pose = simulation::drawSensorPose (street, seed);
    return withExactTruth (simulation::toCloud (
        simulation::scanAround (street.scene, lidar, pose, 1.0, seed),
        pose,
        street.scene,
        simulation::CloudLayout::Readings));
  });
}

DataSet
scansDataSet (const std::string& name, const std::string& sizes)
{
  constexpr std::uint32_t seed = 1;
  const apps::Range of_points = apps::Range::from (1).upTo (most_points);
  DataSet data_set{name, {}};
  std::istringstream list (sizes);
  for (std::string size; std::getline (list, size, ',');) {
    const auto points = apps::parseNumber<std::size_t> (name, size, of_points);
    data_set.clouds.push_back ({"scan-" + size, [points] {
                                  const auto room = simulation::makeRoom (seed);
                                  return withExactTruth (simulation::scanDensely (
                                      room.scene, points, 1.0, seed));
                                }});
  }
  if (data_set.clouds.empty())
    throw apps::UsageError (name,
                            "has no size; give numbers of points, 300000,3000000");
  return data_set;
}

EvaluationCloud
readCloud (const std::string& file, const Eigen::Vector3d& up)
{
  const LabelledCloud all = loadLabelledCloud (file, LabelField::Optional);
  EvaluationCloud finite;
  finite.up = up;
  finite.cloud.reset (new XyzCloud);
  finite.cloud->sensor_origin_ = all.cloud->sensor_origin_;
  finite.cloud->sensor_orientation_ = all.cloud->sensor_orientation_;
  if (!all.labels.empty())
    finite.truth.emplace();
  for (std::size_t i = 0; i < all.cloud->size(); ++i) {
    if (!pcl::isXYZFinite ((*all.cloud)[i]))
      continue;
    finite.cloud->push_back ((*all.cloud)[i]);
    if (finite.truth)
      finite.truth->push_back (all.labels[i]);
  }
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
  DataSet data_set{"clouds", {}};
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
    if (kind == "rooms")
      return roomsDataSet (kind, rest, NoiseProfile::Correlated);
    if (kind == "rooms-raw")
      return roomsDataSet (kind, rest, NoiseProfile::Raw);
    if (kind == "simulated")
      return scansDataSet (kind, rest);
    if (kind == "furniture")
      return scenesDataSet (kind, kind, rest, simulateFurniture);
    if (kind == "survey")
      return scenesDataSet (kind, kind, rest, simulateSurvey);
    if (kind == "shapes")
      return scenesDataSet (kind, kind, rest, simulateShapes);
    if (kind == "streets")
      return streetsDataSet (kind, rest, "lidar-64");
    if (kind == "streets-32")
      return streetsDataSet (kind, rest, "lidar-32");
    if (kind == "streets-16")
      return streetsDataSet (kind, rest, "lidar-16");
    if (kind == "streets-livox")
      return streetsDataSet (kind, rest, "livox");
    if (kind == "clouds")
      return cloudsDataSet (rest, up);
  }
  throw apps::UsageError (text, std::string ("is no data set; give ") + data_set_help);
}

} // namespace pcl_ops::evaluation
