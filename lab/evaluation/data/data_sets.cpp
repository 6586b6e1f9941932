// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "data_sets.h"

#include <pcl/common/common.h>
#include <pcl/common/io.h>
#include <pcl/common/point_tests.h>

#include <boost/format.hpp>

#include <cli/errors.h>
#include <cli/parse_number.h>
#include <cli/program.h>
#include <io/cloud_file.h>
#include <simulation/airborne.h>
#include <simulation/scenes.h>

#include <filesystem>
#include <set>
#include <sstream>

namespace pcl_ops::evaluation {

using namespace apps;

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
    "airborne:FIRST-LAST (hills, woods and roofs from above, by seed), "
    "streets-hills:FIRST-LAST (a street on hills with bushes, by seed), "
    "tables:FIRST-LAST (a flat table whose depth is bent, by seed), "
    "plaster:FIRST-LAST (a room of wavy walls, by seed), "
    "slabs:FIRST-LAST (a thin wall and a board seen from both sides, by seed), "
    "missing:FIRST-LAST (rooms with readings at zero, by seed), "
    "rooms-kinect:FIRST-LAST (rooms with depth in steps, by seed), "
    "clouds:PATH (.pcd, .ply, .las and text, field label as truth; a folder is a data "
    "set of its name), "
    "real:PATH or real-instances:PATH (field label or instance as truth, which field "
    "ignore says is unknown where it is 1), wild:PATH (no truth: how thick planes "
    "are); "
    "these take FOLDER/BEGINNING*, too, and make a data set of files of the same first "
    "two words, as in room_office_3.pcd; @M behind a PATH: planes with a larger rms "
    "are "
    "thick (0.03)";

namespace {

namespace fs = std::filesystem;

/** Simulates a cloud and returns its finite points with their truth. */
EvaluationCloud
simulated (const simulation::Simulation& simulation)
{
  const simulation::SimulatedCloud labeled = simulation::simulate (simulation);
  const XyzCloud::Ptr cloud (new XyzCloud);
  pcl::copyPointCloud (labeled.cloud, *cloud);
  PlaneLabels labels;
  for (const auto& point : labeled.cloud)
    labels.push_back (point.label);
  EvaluationCloud finite = finiteOf (cloud, labels);
  finite.up = labeled.up;
  if (!labeled.is_ignored.empty())
    for (const pcl::index_t i : finitePointsOf (*cloud))
      finite.is_ignored.push_back (labeled.is_ignored[std::size_t (i)]);
  if (simulation.scene == "airborne")
    finite.min_plane_points = simulation::min_points_of_roof;
  return finite;
}

/** Data sets whose clouds are the same kind of scene, one for each seed. */
const struct SceneDataSet {
  const char* name;           // before the colon of a text for dataSetOf
  const char* scene;          // Simulation::scene
  const char* sensor = "";    // Simulation::sensor; empty: none
  bool has_raw_depth = false; // Simulation::has_raw_depth
} scene_data_sets[] = {{"rooms", "room"},
                       {"rooms-raw", "room", "", true},
                       {"rooms-kinect", "room-kinect"},
                       {"missing", "missing"},
                       {"tables", "table"},
                       {"plaster", "plaster"},
                       {"slabs", "slabs"},
                       {"airborne", "airborne"},
                       {"furniture", "furniture"},
                       {"survey", "survey"},
                       {"shapes", "shapes"},
                       {"streets", "street", "lidar-64"},
                       {"streets-32", "street", "lidar-32"},
                       {"streets-16", "street", "lidar-16"},
                       {"streets-hills", "street-hills", "lidar-64-level"},
                       {"streets-livox", "street", "livox"}};

/** Returns \ref EvaluationCloud::thick_length of a scene [m], chosen by hand. It grows
 * with the range of the sensor, as noise and the unevenness of the ground do. */
double
thickLengthOf (const SceneDataSet& scenes)
{
  constexpr double in_airborne_surveys = 0.5;
  constexpr double in_lidar_scans = 0.1;
  if (std::string (scenes.scene) == "airborne")
    return in_airborne_surveys;
  const bool has_lidar = !std::string (scenes.sensor).empty();
  return has_lidar ? in_lidar_scans : usual_thick_length;
}

/** Returns a cloud for each seed.
 * \param[in] seeds "3-20", or "7" for one scene */
DataSet
scenesDataSet (const SceneDataSet& scenes, const std::string& seeds)
{
  // More than anyone waits for; with it a typing error cannot fill the memory.
  constexpr std::uint32_t max_scenes = 100'000;
  const auto parseSeed = [&scenes] (const std::string& text) {
    return parseNumber<std::uint32_t> (scenes.name, text, from (0));
  };
  const std::size_t dash = seeds.find ('-'); // npos + 1 is 0: the whole text again
  const std::uint32_t first = parseSeed (seeds.substr (0, dash));
  const std::uint32_t last = parseSeed (seeds.substr (dash + 1));
  if (last < first || last - first >= max_scenes)
    throw UsageError (scenes.name + (':' + seeds), "is no range of seeds such as 1-20");
  DataSet clouds;
  simulation::Simulation simulation;
  simulation.scene = scenes.scene;
  simulation.has_raw_depth = scenes.has_raw_depth;
  simulation.sensor = scenes.sensor;
  const double thick_length = thickLengthOf (scenes);
  const std::set<std::string> scenes_of_images = {
      "room", "room-kinect", "furniture", "table", "missing"};
  simulation.organized = scenes_of_images.count (simulation.scene) > 0;
  for (std::uint32_t i = 0; i <= last - first; ++i) {
    simulation.seed = first + i;
    clouds.push_back ({scenes.name,
                       str (boost::format ("%s-%04u") % scenes.scene % (first + i)),
                       [simulation, thick_length] {
                         EvaluationCloud cloud = simulated (simulation);
                         cloud.thick_length = thick_length;
                         return cloud;
                       }});
  }
  return clouds;
}

/** Returns a scan of a whole room for each number of points.
 * \param[in] name of the data set
 * \param[in] sizes numbers of points, separated by commas */
DataSet
scansDataSet (const std::string& name, const std::string& sizes)
{
  // The limit holds memory below 8 GB: a point takes 16 bytes, and 56 more while it is
  // simulated.
  const Range of_points = from (1).upTo (1e8);
  DataSet clouds;
  std::istringstream list (sizes);
  for (std::string size; std::getline (list, size, ',');) {
    simulation::Simulation scan;
    scan.points = parseNumber<std::uint32_t> (name, size, of_points);
    clouds.push_back ({name, "scan-" + size, [scan] { return simulated (scan); }});
  }
  if (clouds.empty())
    throw UsageError (name, "has no size; give numbers of points, 300000,3000000");
  return clouds;
}

/** Returns the cloud files in a folder and its subfolders, or the given file. */
std::set<fs::path>
cloudFilesAt (const std::string& path)
{
  std::error_code error;
  if (!fs::exists (path, error))
    throw WorkError (path, "does not exist; give a cloud or a folder of clouds");
  if (!fs::is_directory (path, error))
    return {path};
  std::set<fs::path> files;
  // A folder that cannot be read ends the loop and leaves its error.
  for (fs::recursive_directory_iterator entry (path, error), end; entry != end;
       entry.increment (error))
    if (isCloudFile (entry->path().string()))
      files.insert (entry->path());
  if (error)
    throw WorkError (path,
                     "has a folder that cannot be read (" + error.message() +
                         "); change its permissions");
  if (files.empty())
    throw WorkError (
        path, "has no " + folderExtensions() + " file; give a folder with clouds");
  return files;
}

void
requirePoints (const EvaluationCloud& cloud, const std::string& file)
{
  if (cloud.cloud->empty())
    throw WorkError (file, "has no finite point; leave it out");
}

/** Removes the last @ and the length behind it from a text and returns that length [m].
 * Returns \ref usual_thick_length if there is no @, or if the whole text is the name of
 * a file. */
double
takeThickLength (std::string& text)
{
  const std::size_t at = text.rfind ('@');
  std::error_code error;
  if (at == std::string::npos || fs::exists (text, error))
    return usual_thick_length;
  const std::string length = text.substr (at + 1);
  text.resize (at);
  return parseNumber<double> ("length behind @", length, above (0));
}

/** Returns the clouds of a file or a folder, with the field label, if there is one, as
 * exact truth.
 * \param[in] path may end with @ and a thick length */
DataSet
cloudsDataSet (std::string path, const Vector3d& up)
{
  const double thick_length = takeThickLength (path);
  const std::set<fs::path> files = cloudFilesAt (path);
  const bool is_folder = fs::is_directory (path);
  const fs::path folder = is_folder ? fs::path (path) : fs::path (path).parent_path();
  const std::string name = is_folder ? folder.filename().string() : "";
  DataSet clouds;
  for (const fs::path& file : files)
    clouds.push_back ({name.empty() ? "clouds" : name,
                       file.lexically_relative (folder).generic_string(),
                       [input = file.string(), up, thick_length] {
                         const LabeledCloud all =
                             loadLabeledCloud (input, WithoutLabels::LeaveEmpty);
                         EvaluationCloud finite = finiteOf (all.cloud, all.labels);
                         finite.up = up;
                         finite.thick_length = thick_length;
                         requirePoints (finite, input);
                         return finite;
                       }});
  return clouds;
}

/** Loads a real cloud with the truth of its file, or without truth.
 * \param[in] truth_field empty: there is no truth */
EvaluationCloud
loadRealCloud (const std::string& file, const std::string& truth_field)
{
  return inMemory (file, "give a smaller cloud", [&] {
    const FileCloud cloud = loadCloud (file);
    const XyzCloud::ConstPtr points = shiftedCloudOf (cloud).cloud;
    const bool has_truth = !truth_field.empty();
    EvaluationCloud finite = finiteOf (
        points, has_truth ? labelsIn (cloud.points, file, truth_field) : PlaneLabels());
    finite.grows_truth = has_truth;
    if (has_truth && hasField (cloud, "ignore"))
      for (const std::uint32_t mark : selectLabels (
               labelsIn (cloud.points, file, "ignore"), finitePointsOf (*points)))
        finite.is_ignored.push_back (mark != 0);
    requirePoints (finite, file);
    return finite;
  });
}

/** Returns the first two words of a file name: "room_office" for room_office_3.pcd. */
std::string
firstWordsOf (const fs::path& file)
{
  const std::string stem = file.stem().string();
  const std::size_t first_gap = stem.find ('_');
  return first_gap == std::string::npos
             ? stem
             : stem.substr (0, stem.find ('_', first_gap + 1));
}

/** Returns real clouds. Their data sets are named by the kind and \ref firstWordsOf the
 * file.
 * \param[in] kind "real", "real-instances" or "wild"
 * \param[in] path a file, a folder, or FOLDER/BEGINNING* for files with this beginning;
 * it may end with @ and a thick length
 * \param[in] truth_field empty: there is no truth */
DataSet
realDataSet (const std::string& kind,
             std::string path,
             const std::string& truth_field,
             const Vector3d& up)
{
  const double thick_length = takeThickLength (path);
  const bool is_pattern = !path.empty() && path.back() == '*';
  const fs::path pattern (path.substr (0, path.size() - (is_pattern ? 1 : 0)));
  const std::string beginning = is_pattern ? pattern.filename().string() : "";
  const fs::path parent = pattern.parent_path();
  const std::string parent_or_here = parent.empty() ? "." : parent.string();
  const std::string searched = is_pattern ? parent_or_here : path;
  const fs::path folder = fs::is_directory (searched) ? fs::path (searched) : parent;
  DataSet clouds;
  for (const fs::path& file : cloudFilesAt (searched))
    if (file.filename().string().rfind (beginning, 0) == 0)
      clouds.push_back ({kind + '-' + firstWordsOf (file),
                         file.lexically_relative (folder).generic_string(),
                         [input = file.string(), truth_field, up, thick_length] {
                           EvaluationCloud cloud = loadRealCloud (input, truth_field);
                           cloud.up = up;
                           cloud.thick_length = thick_length;
                           return cloud;
                         }});
  if (clouds.empty())
    throw WorkError (path, "is the beginning of no cloud's name; give another");
  return clouds;
}

} // namespace

EvaluationCloud
finiteOf (const XyzCloud::ConstPtr& cloud, const PlaneLabels& labels)
{
  const pcl::Indices finite = finitePointsOf (*cloud);
  EvaluationCloud result;
  result.cloud.reset (new XyzCloud (*cloud, finite));
  result.cloud->is_dense = true;
  if (!labels.empty())
    result.truth = selectLabels (labels, finite);
  if (cloud->isOrganized())
    result.image = cloud;
  return result;
}

namespace {

/** Returns the data set of a kind.
 * \param[in] kind text before the colon
 * \param[in] source text behind the colon: a path, seeds or numbers of points
 * \return nullopt if the kind is unknown */
std::optional<DataSet>
findDataSet (const std::string& kind, const std::string& source, const Vector3d& up)
{
  if (kind == "sunrgbd" || kind == "sunrgbd-raw")
    return sunRgbdDataSet (source, kind == "sunrgbd-raw");
  if (kind == "simulated")
    return scansDataSet (kind, source);
  if (kind == "clouds")
    return cloudsDataSet (source, up);
  if (kind == "real")
    return realDataSet (kind, source, "label", up);
  if (kind == "real-instances")
    return realDataSet (kind, source, "instance", up);
  if (kind == "wild")
    return realDataSet (kind, source, "", up);
  for (const SceneDataSet& scenes : scene_data_sets)
    if (kind == scenes.name)
      return scenesDataSet (scenes, source);
  return std::nullopt;
}

} // namespace

DataSet
dataSetOf (const std::string& text, const Eigen::Vector3f& up)
{
  const std::size_t colon = text.find (':');
  const std::string kind = text.substr (0, colon);
  const std::string source = colon == std::string::npos ? "" : text.substr (colon + 1);
  std::optional<DataSet> found;
  if (!source.empty())
    found = findDataSet (kind, source, up.cast<double>().normalized());
  if (!found)
    throw UsageError (text, std::string ("is no data set; give ") + data_set_help);
  return *std::move (found);
}

} // namespace pcl_ops::evaluation
