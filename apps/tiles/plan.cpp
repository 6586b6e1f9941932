// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plan.h"

#include <boost/format.hpp>

#include "point_file.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <detection/plane_list.h>
#include <io/las_crs.h>
#include <io/las_file.h>
#include <io/output_file.h>
#include <nlohmann/json.hpp>
#include <pcl_ops/voxel_size.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Version of the files that phases leave for each other: one more with each
 * change. */
constexpr int format_of_files = 6;

PlannedInput
stateOf (const std::string& file)
{
  PlannedInput input;
  std::error_code error;
  input.file = fs::absolute (file).lexically_normal().string();
  input.bytes = fs::file_size (file, error);
  if (!error)
    input.written = fs::last_write_time (file, error).time_since_epoch().count();
  return input;
}

bool
isEmptyLas (const std::string& file)
{
  std::error_code error;
  if (!isLasName (file) || !fs::is_regular_file (file, error))
    return false;
  HeaderReader reader (file, "LAS");
  return readLasHeader (reader).pointCount() == 0;
}

/** \brief Sorts paths by file name, then by the whole path. */
std::vector<std::string>
sorted (std::vector<std::string> files)
{
  std::sort (files.begin(), files.end(), [] (const auto& a, const auto& b) {
    return std::pair (fs::path (a).filename().string(), a) <
           std::pair (fs::path (b).filename().string(), b);
  });
  return files;
}

std::int64_t
cellsOfTile (const PlanOptions& options, double cell)
{
  // A tile has half a million points at the usual density, and needs some 500 MB; on
  // voxels it has 2 million, and needs some 300 MB.
  constexpr std::int64_t usual = 128;
  constexpr std::int64_t usual_on_voxels = 256;
  if (!options.tile)
    return options.voxel_size ? usual_on_voxels : usual;
  constexpr auto step = TileGrid::cells_of_coarsest;
  const double cells = step * std::round (*options.tile / (step * cell));
  if (cells < double (TileGrid::halo))
    throw UsageError ("--tile",
                      "is less than " + std::to_string (TileGrid::halo) +
                          " voxels wide; give a larger one or a smaller --voxel-size");
  if (cells > double (TileGrid::max_cells))
    throw UsageError ("--tile",
                      "is more than " + std::to_string (TileGrid::max_cells) +
                          " voxels wide; give a smaller one or a larger --voxel-size");
  return static_cast<std::int64_t> (cells);
}

/** \brief Refuses cells so small that \ref TileGrid::reach leaves out more than a tenth
 * of an input's places. \throws UsageError */
void
checkReach (const TileGrid& grid,
            const std::string& file,
            const std::vector<Eigen::Vector3d>& places)
{
  constexpr double min_reached = 0.9;
  const auto reached =
      std::count_if (places.begin(), places.end(), [&grid] (const auto& place) {
        return grid.reaches (place);
      });
  if (double (reached) >= min_reached * double (places.size()))
    return;
  throw UsageError ("--voxel-size",
                    str (boost::format ("voxels of %g reach %g from zero, and %s has "
                                        "points farther away; give a larger one") %
                         grid.edge % grid.reach() % file));
}

/** \return edge of a cell by \ref voxelSizeFor [m]; 0 if most places coincide */
double
unroundedEdgeFor (const std::vector<Eigen::Vector3d>& places,
                  const Eigen::Vector3d& zero,
                  std::uint64_t points)
{
  constexpr double points_of_cell = 20.0;
  pcl::PointCloud<pcl::PointXYZ> near_zero;
  near_zero.resize (places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    near_zero[i].getVector3fMap() = (places[i] - zero).cast<float>();
  return voxelSizeFor (CloudView (near_zero), std::max (1.0, points / points_of_cell));
}

/** \brief Edge of a cell with about 20 points where it crosses a surface [m], rounded
 * to two digits. It follows from the density of the points, not from their number.
 * Measured on simulated surveys: larger cells miss planes, smaller ones cost more.
 * \param[in] places an even sample of the points; most of them may coincide
 * \param[in] zero a place near most of them */
double
cellEdgeFor (std::vector<Eigen::Vector3d> places,
             const Eigen::Vector3d& zero,
             std::uint64_t points)
{
  double edge = unroundedEdgeFor (places, zero, points);
  if (!(edge > 0.0)) {
    // Most places coincide: each counts once instead.
    std::sort (places.begin(), places.end(), [] (const auto& a, const auto& b) {
      return std::lexicographical_compare (
          a.data(), a.data() + 3, b.data(), b.data() + 3);
    });
    places.erase (std::unique (places.begin(), places.end()), places.end());
    edge = unroundedEdgeFor (places, zero, points);
  }
  if (!(edge > 0.0))
    throw WorkError ("INPUT", "has its points at one place; give --voxel-size");
  const double digit = std::pow (10.0, std::floor (std::log10 (edge)) - 1.0);
  return std::round (edge / digit) * digit;
}

struct Sample {
  PlannedInput input;
  std::vector<Eigen::Vector3d> some_places;
  /** \brief A place near most points; set for the first input only. */
  Eigen::Vector3d usual = Eigen::Vector3d::Zero();
};

std::vector<Sample>
lookAt (const std::vector<std::string>& files)
{
  constexpr std::size_t most = 16384;
  constexpr std::size_t fewest = 64;
  const std::size_t wanted =
      std::max (fewest, most / std::max<std::size_t> (1, files.size()));
  std::vector<Sample> samples;
  for (const std::string& file : files) {
    if (isEmptyLas (file)) {
      warn (file + ": has no points; it is left out");
      continue;
    }
    PointFile points (file);
    const std::string problem = points.las ? points.las->validate ({label_field}) : "";
    if (!problem.empty())
      throw WorkError (file, problem);
    const auto place = [&points] (std::uint64_t i) { return points.place (i); };
    Sample sample{stateOf (file), somePlaces (points.size(), place, wanted)};
    sample.input.points = points.size();
    if (samples.empty())
      sample.usual = localOrigin (points.size(), place);
    samples.push_back (std::move (sample));
  }
  return samples;
}

/** \brief Joins the samples of all inputs, thinned to the same share of the points. */
std::vector<Eigen::Vector3d>
evenSample (const std::vector<Sample>& samples)
{
  // The input with the smallest share of its points in its sample limits all.
  double per_point = 1.0;
  for (const auto& [input, places, usual] : samples)
    per_point = std::min (per_point, places.size() / double (input.points));
  std::vector<Eigen::Vector3d> even;
  for (const auto& [input, places, usual] : samples) {
    const double wanted = std::ceil (per_point * double (input.points));
    const std::size_t count = std::min (std::size_t (wanted), places.size());
    for (std::size_t k = 0; k < count; ++k)
      even.push_back (places[k * places.size() / count]);
  }
  return even;
}

/** \brief What \p say reads from the reference system of every input; nothing if the
 * results differ, or an input is missing or no .las. */
template <typename Said>
std::optional<Said>
commonToLas (const std::vector<PlannedInput>& inputs, Said (*say) (LasFile&))
{
  std::optional<Said> common;
  for (const PlannedInput& input : inputs) {
    // Inputs of a run that is done may be gone.
    if (!isLasName (input.file) || !fs::exists (input.file))
      return std::nullopt;
    LasFile las (input.file);
    const Said said = say (las);
    if (common && *common != said)
      return std::nullopt;
    common = said;
  }
  return common;
}

} // namespace

bool
hasChanged (const PlannedInput& input)
{
  const PlannedInput now = stateOf (input.file);
  return input.bytes != now.bytes || input.written != now.written;
}

Plan
makePlan (std::vector<std::string> files, const PlanOptions& options)
{
  const std::vector<Sample> samples = lookAt (sorted (std::move (files)));
  if (samples.empty())
    throw WorkError ("INPUT", "has no points in any file; give clouds that have");
  const std::vector<Eigen::Vector3d> some = evenSample (samples);
  const Eigen::Vector3d usual = samples.front().usual;
  Plan plan;
  for (const Sample& sample : samples)
    plan.inputs.push_back (sample.input);
  TileGrid& grid = plan.grid;
  grid.edge = options.voxel_size ? *options.voxel_size
                                 : cellEdgeFor (some, usual, plan.points());
  plan.is_on_voxels = options.voxel_size.has_value();
  grid.cells_of_tile = cellsOfTile (options, grid.edge);
  for (const Sample& sample : samples)
    checkReach (grid, sample.input.file, sample.some_places);
  checkReach (grid, plan.inputs.front().file, {usual});
  constexpr auto step = TileGrid::cells_of_coarsest;
  for (int axis = 0; axis < 3; ++axis)
    grid.place[axis] = step * std::llround (usual[axis] / (step * grid.edge));
  std::set<TileKey> tiles;
  for (const Eigen::Vector3d& place : some)
    if (grid.reaches (place))
      tiles.insert (grid.tileOf (grid.cellOf (place)));
  plan.likely_tiles = tiles.size();
  plan.meter = options.meter ? *options.meter
                             : commonToLas (plan.inputs, unitsInMeter).value_or (1.0);
  return plan;
}

std::string
commonCrs (const Plan& plan)
{
  return commonToLas (plan.inputs, crsOf).value_or ("");
}

std::string
toText (const Plan& plan)
{
  nlohmann::ordered_json json = {{"format", format_of_files},
                                 {"cell", plan.grid.edge},
                                 {"cells_of_tile", plan.grid.cells_of_tile},
                                 {"place", plan.grid.place},
                                 {"likely_tiles", plan.likely_tiles},
                                 {"is_on_voxels", plan.is_on_voxels},
                                 {"meter", plan.meter}};
  for (const PlannedInput& input : plan.inputs)
    json["inputs"].push_back ({{"file", input.file},
                               {"bytes", input.bytes},
                               {"written", input.written},
                               {"points", input.points}});
  return jsonText (json);
}

Plan
loadPlan (const PlanFile& file)
{
  try {
    // A folder is no plan either; reading one would throw another exception.
    std::ifstream stream (fs::is_directory (file.name) ? "" : file.name);
    const auto json = nlohmann::json::parse (stream);
    Plan plan;
    if (json.value ("format", 1) != format_of_files)
      throw WorkError (file.name,
                       "is the plan of another version of this program; " + file.fix);
    TileGrid& grid = plan.grid;
    json.at ("cell").get_to (grid.edge);
    json.at ("cells_of_tile").get_to (grid.cells_of_tile);
    json.at ("place").get_to (grid.place);
    json.at ("likely_tiles").get_to (plan.likely_tiles);
    json.at ("is_on_voxels").get_to (plan.is_on_voxels);
    json.at ("meter").get_to (plan.meter);
    for (const auto& input : json.at ("inputs"))
      plan.inputs.push_back ({input.at ("file"),
                              input.at ("bytes"),
                              input.at ("written"),
                              input.at ("points")});
    if (grid.edge > 0.0 && std::isfinite (grid.edge) && plan.meter > 0.0 &&
        grid.cells_of_tile % TileGrid::cells_of_coarsest == 0 &&
        grid.cells_of_tile >= TileGrid::halo &&
        grid.cells_of_tile <= TileGrid::max_cells)
      return plan;
  }
  catch (const nlohmann::json::exception&) {
    // the error is thrown below
  }
  throw WorkError (file.name, "is no plan; " + file.fix);
}

void
checkIsFor (const Plan& plan,
            const PlanFile& file,
            std::vector<std::string> inputs,
            const PlanOptions& options)
{
  const auto refuse = [&] (const std::string& reason) {
    throw WorkError (file.name,
                     "is the plan of another run (" + reason + "); " + file.fix);
  };
  std::size_t known = 0;
  for (const std::string& input : sorted (std::move (inputs))) {
    const std::string name = stateOf (input).file;
    const auto planned =
        std::find_if (plan.inputs.begin(), plan.inputs.end(), [&] (const auto& other) {
          return other.file == name;
        });
    if (planned == plan.inputs.end() && isEmptyLas (input))
      continue;
    if (planned == plan.inputs.end())
      refuse (input + " is not in it");
    if (hasChanged (*planned))
      refuse (input + " has changed");
    ++known;
  }
  if (known < plan.inputs.size())
    refuse ("it has " + std::to_string (plan.inputs.size()) + " inputs, not " +
            std::to_string (known));
  if (options.voxel_size && *options.voxel_size != plan.grid.edge)
    refuse ("--voxel-size was another one");
  if (options.tile && cellsOfTile (options, plan.grid.edge) != plan.grid.cells_of_tile)
    refuse ("--tile was another one");
  if (options.meter && *options.meter != plan.meter)
    refuse ("--meter was another one");
}

} // namespace pcl_ops::apps
