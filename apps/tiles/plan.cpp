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
#include <io/las_unit.h>
#include <io/output_file.h>
#include <nlohmann/json.hpp>
#include <pcl_ops/voxel_size.h>

#include <filesystem>
#include <fstream>
#include <set>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Version of the format of the plan and of all files that phases write for
 * later ones: one more with each change. */
constexpr int format_version = 6;

/** \brief Returns path, size and time of a file as they are now, but no number of
 * points. */
PlannedInput
currentState (const std::string& file)
{
  PlannedInput input;
  std::error_code error;
  input.file = fs::absolute (file).lexically_normal().string();
  input.bytes = fs::file_size (file, error);
  if (!error)
    input.changed_at = fs::last_write_time (file, error).time_since_epoch().count();
  return input;
}

/** \brief Whether the header of a .las or .laz says that it has no points. */
bool
isEmptyLas (const std::string& file)
{
  std::error_code error;
  if (!isLasName (file) || !fs::is_regular_file (file, error))
    return false;
  FileReader reader (file, "LAS");
  return readLasHeader (reader).pointCount() == 0;
}

/** \brief Sorts paths by file name, then by the whole path. */
std::vector<std::string>
sorted (std::vector<std::string> files)
{
  const auto name_and_path = [] (const std::string& file) {
    return std::pair (fs::path (file).filename().string(), file);
  };
  std::sort (files.begin(),
             files.end(),
             [&] (const std::string& one, const std::string& other) {
               return name_and_path (one) < name_and_path (other);
             });
  return files;
}

/** \brief Returns the number of cells along an edge of a tile.
 * \throws UsageError if the given tile is too small or too large */
std::int64_t
cellsOfTile (const PlanOptions& options, double cell_edge)
{
  // A tile has half a million points at the usual density, and needs some 500 MB; on
  // voxels it has 2 million, and needs some 300 MB.
  constexpr std::int64_t default_cells = 128;
  constexpr std::int64_t default_cells_on_voxels = 256;
  if (!options.tile)
    return options.voxel_size ? default_cells_on_voxels : default_cells;
  constexpr std::int64_t multiple_of = TileGrid::cells_of_coarsest;
  const double cells =
      multiple_of * std::round (*options.tile / (multiple_of * cell_edge));
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
 * of the sampled points of an input. \throws UsageError */
void
checkReach (const TileGrid& grid,
            const std::string& file,
            const std::vector<Eigen::Vector3d>& points)
{
  constexpr double min_reached_share = 0.9;
  const auto reached = std::count_if (
      points.begin(), points.end(), [&grid] (const Eigen::Vector3d& point) {
        return grid.reaches (point);
      });
  if (double (reached) >= min_reached_share * double (points.size()))
    return;
  throw UsageError ("--voxel-size",
                    str (boost::format ("voxels of %g reach %g from zero, and %s has "
                                        "points farther away; give a larger one") %
                         grid.edge % grid.reach() % file));
}

/** \brief Returns \ref cellEdgeFor before it is rounded [m]; 0 if most points of the
 * sample coincide. */
double
unroundedCellEdgeFor (const std::vector<Eigen::Vector3d>& sample,
                      const Eigen::Vector3d& local_origin,
                      std::uint64_t points)
{
  constexpr double points_of_cell = 20.0; // on average
  pcl::PointCloud<pcl::PointXYZ> local_sample;
  local_sample.resize (sample.size());
  for (std::size_t i = 0; i < sample.size(); ++i)
    local_sample[i].getVector3fMap() = (sample[i] - local_origin).cast<float>();
  const double wanted_cells = std::max (1.0, points / points_of_cell);
  return voxelSizeFor (CloudView (local_sample), wanted_cells);
}

/** \brief Returns the edge of cells that have about 20 points if a surface crosses them
 * [m], rounded to two digits. It follows from the density of the points: twice the area
 * with twice the points gives the same edge. As measured on simulated surveys, with
 * larger cells planes are missed, and smaller ones take more time.
 * \param[in] file an input, for messages
 * \param[in] sample an even sample of the finite points; most of them may coincide
 * \param[in] local_origin a position near most points of the sample
 * \param[in] points number of all points of the survey
 * \throws WorkError if no point is finite, or all points of the sample coincide */
double
cellEdgeFor (const std::string& file,
             std::vector<Eigen::Vector3d> sample,
             const Eigen::Vector3d& local_origin,
             std::uint64_t points)
{
  if (sample.empty())
    throw WorkError (file, "has no point with finite coordinates; leave it out");
  double edge = unroundedCellEdgeFor (sample, local_origin, points);
  if (!(edge > 0.0)) {
    // Most points coincide. The sample gets each position once; the number of points,
    // and so that of the cells, stays as it is.
    using Position = Eigen::Vector3d;
    const auto is_before = [] (const Position& one, const Position& other) {
      return std::lexicographical_compare (
          one.data(), one.data() + 3, other.data(), other.data() + 3);
    };
    std::sort (sample.begin(), sample.end(), is_before);
    sample.erase (std::unique (sample.begin(), sample.end()), sample.end());
    edge = unroundedCellEdgeFor (sample, local_origin, points);
  }
  if (!(edge > 0.0))
    throw WorkError (file, "has its points at one place; give --voxel-size");
  const double unit_of_second_digit =
      std::pow (10.0, std::floor (std::log10 (edge)) - 1.0);
  return std::round (edge / unit_of_second_digit) * unit_of_second_digit;
}

/** \brief An input with some of its points. */
struct InputSample {
  PlannedInput input;
  /** \brief Sampled finite points; empty if the input has no finite points. */
  std::vector<Eigen::Vector3d> points;
  /** \brief A position near most points; zero for inputs after \ref firstWithPoints. */
  Eigen::Vector3d local_origin = Eigen::Vector3d::Zero();
};

/** \brief Returns the first sample that has points, or else the first one.
 * \param[in] samples one or more */
const InputSample&
firstWithPoints (const std::vector<InputSample>& samples)
{
  for (const InputSample& sample : samples)
    if (!sample.points.empty())
      return sample;
  return samples.front();
}

/** \brief Samples the points of all files that have points.
 * \throws WorkError if a file cannot be read or labels cannot be added to it */
std::vector<InputSample>
sampleInputs (const std::vector<std::string>& files)
{
  // Both are chosen by hand.
  constexpr std::size_t usual_sample_size = 16384; // of all files together
  constexpr std::size_t min_per_file = 64;         // if there are many files
  const std::size_t max_per_file = std::max (
      min_per_file, usual_sample_size / std::max<std::size_t> (1, files.size()));
  std::vector<InputSample> samples;
  for (const std::string& file : files) {
    if (isEmptyLas (file)) {
      warn (file + ": has no points; it is left out");
      continue;
    }
    PointFile points (file);
    const std::string problem = points.las ? points.las->validate ({label_field}) : "";
    if (!problem.empty())
      throw WorkError (file, problem);
    const auto position = [&points] (std::uint64_t i) { return points.position (i); };
    InputSample sample{currentState (file),
                       somePositions (points.size(), position, max_per_file)};
    sample.input.points = points.size();
    if (samples.empty() || firstWithPoints (samples).points.empty())
      sample.local_origin = localOrigin (points.size(), position);
    samples.push_back (std::move (sample));
  }
  return samples;
}

/** \brief Joins the samples of all inputs. They are thinned, so that the same share of
 * the points of each input is in the sample. */
std::vector<Eigen::Vector3d>
evenSample (const std::vector<InputSample>& samples)
{
  // Share of the points of each input: that of the input with the smallest one.
  double share = 1.0;
  for (const InputSample& sample : samples)
    if (!sample.points.empty())
      share = std::min (share, sample.points.size() / double (sample.input.points));
  std::vector<Eigen::Vector3d> even;
  for (const InputSample& sample : samples) {
    const std::size_t size = sample.points.size();
    const double wanted = std::ceil (share * double (sample.input.points));
    const std::size_t kept = std::min (std::size_t (wanted), size);
    for (std::size_t i = 0; i < kept; ++i)
      even.push_back (sample.points[i * size / kept]);
  }
  return even;
}

/** \brief Returns the value that \p read gives for every input. Returns nothing if the
 * values differ, or if an input is missing or is no .las or .laz. */
template <typename Value>
std::optional<Value>
commonToLas (const std::vector<PlannedInput>& inputs, Value (*read) (LasFile&))
{
  std::optional<Value> common;
  for (const PlannedInput& input : inputs) {
    // The inputs of a finished run may have been removed.
    if (!isLasName (input.file) || !fs::exists (input.file))
      return std::nullopt;
    LasFile las (input.file);
    const Value value = read (las);
    if (common && *common != value)
      return std::nullopt;
    common = value;
  }
  return common;
}

/** \brief Refuses inputs of which some are in meters and some in feet by their
 * reference systems: their places would not fit. */
void
refuseMixedUnits (const std::vector<PlannedInput>& inputs)
{
  std::string in_meters;
  std::string in_feet;
  for (const PlannedInput& input : inputs)
    if (isLasName (input.file)) {
      LasFile las (input.file);
      const LasUnit unit = unitOf (las);
      if (unit == LasUnit::Meter && in_meters.empty())
        in_meters = input.file;
      if (unit == LasUnit::Foot && in_feet.empty())
        in_feet = input.file;
    }
  if (!in_meters.empty() && !in_feet.empty())
    throw WorkError (in_feet,
                     "is in feet by its reference system and " + in_meters +
                         " in meters; convert one of them or give --meter");
}

/** \brief Whether the lengths and cells of a plan file are valid. */
bool
hasValidLengths (const Plan& plan)
{
  const TileGrid& grid = plan.grid;
  const bool is_edge_valid = grid.edge > 0.0 && std::isfinite (grid.edge);
  const bool is_tile_valid = grid.cells_of_tile % TileGrid::cells_of_coarsest == 0 &&
                             grid.cells_of_tile >= TileGrid::halo &&
                             grid.cells_of_tile <= TileGrid::max_cells;
  const bool is_cell_valid = std::all_of (
      grid.cell_near_points.begin(), grid.cell_near_points.end(), [] (auto number) {
        return number % TileGrid::cells_of_coarsest == 0 &&
               number >= -TileGrid::max_cells && number <= TileGrid::max_cells;
      });
  return is_edge_valid && is_tile_valid && is_cell_valid && plan.meter > 0.0;
}

} // namespace

bool
hasChanged (const PlannedInput& input)
{
  const PlannedInput now = currentState (input.file);
  return input.bytes != now.bytes || input.changed_at != now.changed_at;
}

Plan
makePlan (std::vector<std::string> files, const PlanOptions& options)
{
  const std::vector<InputSample> samples = sampleInputs (sorted (std::move (files)));
  if (samples.empty())
    throw WorkError ("INPUT", "has no points in any file; give clouds that have");
  const std::vector<Eigen::Vector3d> even_sample = evenSample (samples);
  const InputSample& first = firstWithPoints (samples);
  const Eigen::Vector3d& local_origin = first.local_origin;
  Plan plan;
  for (const InputSample& sample : samples)
    plan.inputs.push_back (sample.input);
  TileGrid& grid = plan.grid;
  grid.edge =
      options.voxel_size
          ? *options.voxel_size
          : cellEdgeFor (first.input.file, even_sample, local_origin, plan.points());
  plan.is_on_voxels = options.voxel_size.has_value();
  grid.cells_of_tile = cellsOfTile (options, grid.edge);
  for (const InputSample& sample : samples)
    checkReach (grid, sample.input.file, sample.points);
  // The cell near local_origin, set below, must be in reach, too.
  checkReach (grid, first.input.file, {local_origin});
  constexpr std::int64_t multiple_of = TileGrid::cells_of_coarsest;
  for (int axis = 0; axis < 3; ++axis)
    grid.cell_near_points[axis] =
        multiple_of * std::llround (local_origin[axis] / (multiple_of * grid.edge));
  std::set<TileKey> tiles;
  for (const Eigen::Vector3d& point : even_sample)
    if (grid.reaches (point))
      tiles.insert (grid.tileOf (grid.cellOf (point)));
  plan.likely_tiles = tiles.size();
  if (!options.meter)
    refuseMixedUnits (plan.inputs);
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
  // The keys are part of the format.
  nlohmann::ordered_json json = {{"format", format_version},
                                 {"cell", plan.grid.edge},
                                 {"cells_of_tile", plan.grid.cells_of_tile},
                                 {"place", plan.grid.cell_near_points},
                                 {"likely_tiles", plan.likely_tiles},
                                 {"is_on_voxels", plan.is_on_voxels},
                                 {"meter", plan.meter}};
  for (const PlannedInput& input : plan.inputs)
    json["inputs"].push_back ({{"file", input.file},
                               {"bytes", input.bytes},
                               {"written", input.changed_at},
                               {"points", input.points}});
  return jsonText (json);
}

Plan
loadPlan (const PlanFile& file)
{
  try {
    // A folder is no plan. Reading one would throw another exception, so none is
    // opened.
    std::error_code error;
    std::ifstream stream (fs::is_directory (file.name, error) ? "" : file.name);
    const auto json = nlohmann::json::parse (stream);
    Plan plan;
    if (json.at ("format") != format_version)
      throw WorkError (file.name,
                       "is the plan of another version of this program; " + file.fix);
    TileGrid& grid = plan.grid;
    json.at ("cell").get_to (grid.edge);
    json.at ("cells_of_tile").get_to (grid.cells_of_tile);
    json.at ("place").get_to (grid.cell_near_points);
    json.at ("likely_tiles").get_to (plan.likely_tiles);
    json.at ("is_on_voxels").get_to (plan.is_on_voxels);
    json.at ("meter").get_to (plan.meter);
    for (const auto& input : json.at ("inputs"))
      plan.inputs.push_back ({input.at ("file"),
                              input.at ("bytes"),
                              input.at ("written"),
                              input.at ("points")});
    if (hasValidLengths (plan))
      return plan;
  }
  catch (const nlohmann::json::exception&) {
    // The error is thrown below.
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
  std::size_t inputs_in_plan = 0;
  for (const std::string& input : sorted (std::move (inputs))) {
    const std::string path = currentState (input).file;
    const auto planned =
        std::find_if (plan.inputs.begin(),
                      plan.inputs.end(),
                      [&] (const PlannedInput& other) { return other.file == path; });
    if (planned == plan.inputs.end() && isEmptyLas (input))
      continue;
    if (planned == plan.inputs.end())
      refuse (input + " is not in it");
    if (hasChanged (*planned))
      refuse (input + " has changed");
    ++inputs_in_plan;
  }
  if (inputs_in_plan < plan.inputs.size())
    refuse ("it has " + std::to_string (plan.inputs.size()) + " inputs, not " +
            std::to_string (inputs_in_plan));
  const bool is_on_these_voxels =
      plan.is_on_voxels && options.voxel_size == plan.grid.edge;
  if (options.voxel_size && !is_on_these_voxels)
    refuse (plan.is_on_voxels ? "--voxel-size was another one"
                              : "it was made without --voxel-size");
  if (options.tile && cellsOfTile (options, plan.grid.edge) != plan.grid.cells_of_tile)
    refuse ("--tile was another one");
  if (options.meter && *options.meter != plan.meter)
    refuse ("--meter was another one");
}

} // namespace pcl_ops::apps
