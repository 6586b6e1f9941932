// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "phases.h"

#include "planes_json.h"
#include "point_file.h"
#include "tile_planes.h"
#include <cli/errors.h>
#include <io/inputs.h>
#include <io/laz_file.h>
#include <io/output_file.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <system_error>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Of what phases leave, in the order of the phases. */
constexpr const char* folders[] = {"cells", "planes", "labelled"};

TilePoints
pointsOf (const SortedPoints& points, const TileKey& tile)
{
  TilePoints all{tile, {}, {}};
  std::uint64_t count = 0;
  const std::vector<CellFile>& files = points.files;
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::uint64_t own = files[i].count ({tile, false});
    count += own + files[i].count ({tile, true});
    if (own > 0)
      all.own_of_input.emplace_back (static_cast<std::uint32_t> (i), own);
  }
  all.coordinates.reserve (3 * count);
  for (const bool is_halo : {false, true})
    for (const CellFile& file : files)
      file.read ({tile, is_halo}, all.coordinates);
  return all;
}

/** \brief Refuses points that are not those that the other phases saw, or will see. */
void
checkIsAsPlanned (const PlannedInput& input, const RunFolder& folder)
{
  if (hasChanged (input))
    throw WorkError (input.file,
                     "has changed since the run began; remove " +
                         folder.output ("work") + " and run it again");
}

class LabelsInOrder {
public:
  LabelsInOrder (const Plan& plan, const RunFolder& folder, std::size_t input)
  : grid_ (plan.grid())
  , folder_ (folder)
  , input_ (static_cast<std::uint32_t> (input))
  , numbers_ (loadPlaneNumbers (folder.work (run_file::numbers)))
  {}

  std::uint32_t
  next (const Eigen::Vector3d& place)
  {
    if (!grid_.reaches (place))
      return 0;
    const TileKey tile = grid_.tileOf (grid_.cellOf (place));
    if (last_ == nullptr || last_->tile != tile)
      last_ = &readerOf (tile);
    const std::uint32_t piece = last_->labels.next();
    if (piece > last_->numbers->size())
      failDamaged (folder_.ofTile (tile, ".labels"));
    return piece == 0 ? 0 : (*last_->numbers)[piece - 1];
  }

private:
  struct Tile {
    TileKey tile;
    LabelReader labels;
    const std::vector<std::uint32_t>* numbers;
  };

  Tile&
  readerOf (const TileKey& tile)
  {
    const auto numbers = numbers_.find (tile);
    if (numbers == numbers_.end())
      failDamaged (folder_.work (run_file::numbers));
    std::unique_ptr<Tile>& known = tiles_[tile];
    if (!known)
      known.reset (new Tile{tile,
                            LabelReader (folder_.ofTile (tile, ".labels"), input_),
                            &numbers->second});
    return *known;
  }

  TileGrid grid_;
  const RunFolder& folder_;
  std::uint32_t input_;
  PlaneNumbers numbers_;
  std::map<TileKey, std::unique_ptr<Tile>> tiles_;
  Tile* last_ = nullptr;
};

} // namespace

std::string
RunFolder::output (const std::string& name) const
{
  return (fs::path (outputs) / name).string();
}

void
RunFolder::make() const
{
  makeFolder (outputs);
  for (const char* folder : folders)
    makeFolder (work (folder));
}

void
RunFolder::startAnew() const
{
  std::error_code error;
  fs::remove (work (run_file::end), error);
  for (const char* folder : folders)
    if (!error)
      fs::remove_all (work (folder), error);
  if (error)
    throw WorkError (output ("work"),
                     "cannot be emptied (" + error.message() +
                         "); remove it or give another --output-dir");
  make();
}

void
RunFolder::finish() const
{
  // As a text: a stream that takes another one does not tell that the disk became full.
  writeTextFile (output (planes_file),
                 readTextFile (work (run_file::list), "planes.json"));
  writeTextFile (work (run_file::end), "");
}

void
RunFolder::clean() const
{
  std::error_code ignored;
  for (const char* folder : folders)
    fs::remove_all (work (folder), ignored);
}

bool
isThere (const std::string& file)
{
  std::error_code error;
  return fs::exists (file, error);
}

void
partitionInput (const Plan& plan, const RunFolder& folder, std::size_t input)
{
  const TileGrid grid = plan.grid();
  PointFile points (plan.inputs[input].file);
  writeFile (folder.cells (input), [&] (std::ostream& stream) {
    CellFileWriter writer (stream);
    TileKey last{};
    Eigen::Vector3d corner = grid.cornerOf (grid.frameOf (last));
    points.forPlaces ([&] (const Eigen::Vector3d& place) {
      if (!grid.reaches (place))
        return;
      const CellKey cell = grid.cellOf (place);
      const TileKey tile = grid.tileOf (cell);
      if (tile != last)
        corner = grid.cornerOf (grid.frameOf (tile));
      last = tile;
      writer.add ({tile, false}, (place - corner).cast<float>());
      grid.forTilesAround (cell, [&] (const TileKey& other) {
        const Eigen::Vector3d of_other = grid.cornerOf (grid.frameOf (other));
        writer.add ({other, true}, (place - of_other).cast<float>());
      });
    });
    writer.finish();
    checkIsAsPlanned (plan.inputs[input], folder);
  });
}

SortedPoints::SortedPoints (const Plan& plan, const RunFolder& folder)
{
  std::map<TileKey, std::uint64_t> points;
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    files.emplace_back (folder.cells (i));
    for (const Block& block : files.back().blocks())
      if (!block.key.is_halo)
        points[block.key.tile] += block.points;
  }
  for (const auto& [tile, count] : points)
    tiles.push_back ({tile, count});
  std::stable_sort (tiles.begin(), tiles.end(), [] (const auto& a, const auto& b) {
    return a.points > b.points;
  });
}

void
detectTile (const Plan& plan,
            const RunFolder& folder,
            const SortedPoints& points,
            const TileKey& tile)
{
  const TileDetection found = detectInTile (plan.grid(), pointsOf (points, tile));
  saveTileLabels (folder.ofTile (tile, ".labels"), found.labels);
  saveTilePlanes (folder.ofTile (tile, ".planes"), found.planes);
}

void
joinTiles (const Plan& plan, const RunFolder& folder, const SortedPoints& points)
{
  std::vector<TileKey> tiles;
  for (const TileSize& size : points.tiles)
    tiles.push_back (size.tile);
  std::sort (tiles.begin(), tiles.end());
  const JoinedPlanes joined = joinPlanes (tiles, [&folder] (const TileKey& tile) {
    return loadTilePlanes (folder.ofTile (tile, ".planes"));
  });
  writeTextFile (folder.work (run_file::list),
                 toJson (plan, tiles.size(), joined.planes));
  savePlaneNumbers (folder.work (run_file::numbers), joined.numbers);
}

void
labelInput (const Plan& plan, const RunFolder& folder, std::size_t input)
{
  LabelsInOrder labels (plan, folder, input);
  checkIsAsPlanned (plan.inputs[input], folder);
  PointFile points (plan.inputs[input].file);
  const std::string output = outputOf (plan, folder, input);
  points.saveLabelled (
      output, [&labels] (const Eigen::Vector3d& place) { return labels.next (place); });
  if (hasChanged (plan.inputs[input]))
    fs::remove (output);
  checkIsAsPlanned (plan.inputs[input], folder);
  writeTextFile (folder.mark (input), "");
}

std::string
outputOf (const Plan& plan, const RunFolder& folder, std::size_t input)
{
  const std::string& file = plan.inputs[input].file;
  const std::string extension = isLasName (file) ? extensionOf (file) : ".pcd";
  return folder.output (fs::path (file).stem().string() + extension);
}

} // namespace pcl_ops::apps
