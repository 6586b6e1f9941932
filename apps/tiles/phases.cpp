// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "phases.h"

#include "planes_json.h"
#include "point_file.h"
#include "survey_noise.h"
#include <cli/program.h>
#include <io/inputs.h>
#include <io/las_file.h>
#include <io/output_file.h>

namespace fs = std::filesystem;

namespace pcl_ops::apps {

namespace {

/** \brief Folders of the files that phases leave, in the order of the phases. */
constexpr const char* folders[] = {"cells", "planes", "labelled"};

TilePoints
pointsOf (const SortedPoints& points, const TileKey& tile)
{
  const BlockKey own{tile[0], tile[1], 0};
  const BlockKey halo{tile[0], tile[1], 1};
  TilePoints all{tile, {}, {}};
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < points.files.size(); ++i) {
    const CellFile& file = points.files[i];
    count += file.count (own) + file.count (halo);
    if (file.count (own) > 0)
      all.own_of_input.emplace_back (i, file.count (own));
  }
  all.points.reserve (count);
  for (const BlockKey& key : {own, halo})
    for (const CellFile& file : points.files)
      file.read (key, all.points);
  return all;
}

/** \brief A line with the checksum of a text, padded by spaces to whole words. */
std::string
sumOf (const std::string& file, std::string text)
{
  text.resize ((text.size() / sizeof (std::uint32_t) + 1) * sizeof (std::uint32_t),
               ' ');
  Checksum sum (file);
  sum.add (text.data(), text.size());
  return std::to_string (sum.value()) + "\n";
}

void
saveNumbers (const std::string& file, const std::vector<std::uint32_t>& numbers)
{
  writeFile (file, [&] (std::ostream& stream) {
    BinaryWriter write (stream, file);
    write (numbers);
    write.finish();
  });
}

/** \brief Refuses an input that has changed since the plan was made, as all phases must
 * see the same points. \throws WorkError */
void
checkIsAsPlanned (const PlannedInput& input, const RunFolder& folder)
{
  if (hasChanged (input))
    throw WorkError (input.file,
                     "has changed since the run began; remove " +
                         folder.output ("work") + " and run it again");
}

/** \brief Reads the labels of an input's points in one tile, in the order of the
 * points, with few of them in memory. */
class TileLabels {
public:
  TileLabels (const RunFolder& folder, const TileKey& tile, std::size_t input)
  : file_ (folder.labels (tile, input)), sum_ (file_)
  {
    BinaryReader read (folder.ofTile (tile, ".numbers"));
    read (numbers_);
    read.finish();
  }

  std::uint32_t
  next ()
  {
    constexpr std::uint64_t most = 4096;
    if (used_ % most == 0)
      readPieces (most);
    if (used_ % most == pieces_.size())
      throw WorkError (file_, "has too few labels; remove its folder and run it again");
    const std::uint32_t piece = pieces_[used_++ % most];
    if (piece > numbers_.size())
      BinaryReader (file_).fail();
    return piece == 0 ? 0 : numbers_[piece - 1];
  }

private:
  /** \brief Reads at most \p most further piece numbers. After the last ones it checks
   * the checksum of the file. */
  void
  readPieces (std::uint64_t most)
  {
    BinaryReader read (file_);
    if (read.size < (used_ + 2) * sizeof (std::uint32_t))
      read.fail();
    const std::uint64_t left = read.size / sizeof (std::uint32_t) - 2 - used_;
    pieces_.resize (std::min (most, left));
    read.stream.seekg (used_ * sizeof (std::uint32_t));
    read.sum = sum_;
    read (pieces_.data(), pieces_.size());
    sum_ = read.sum;
    if (pieces_.size() == left)
      read.finish();
  }

  std::string file_;
  /** \brief Checksum of the piece numbers read so far. */
  Checksum sum_;
  /** \brief The plane of each piece of the tile. */
  std::vector<std::uint32_t> numbers_;
  std::vector<std::uint32_t> pieces_;
  std::uint64_t used_ = 0;
};

} // namespace

void
RunFolder::make() const
{
  makeFolder (outputs);
  for (const char* folder : folders)
    makeFolder (work (folder));
}

void
RunFolder::empty() const
{
  std::error_code error;
  fs::remove (work (run_file::end), error);
  if (!error)
    error = clean();
  if (error)
    throw WorkError (output ("work"),
                     "cannot be emptied (" + error.message() +
                         "); remove it or give another --output-dir");
}

std::error_code
RunFolder::clean() const
{
  std::error_code error;
  for (const char* folder : folders)
    if (!error)
      fs::remove_all (work (folder), error);
  return error;
}

void
RunFolder::finish (const std::function<std::string (const std::string&)>& amended) const
{
  const std::string file = work (run_file::list);
  std::string list = readTextFile (file, "planes.json");
  const std::size_t end = list.rfind ('\n', list.size() - 2) + 1; // begin of its sum
  if (list.size() < 2 || list.substr (end) != sumOf (file, list.substr (0, end)))
    BinaryReader (file).fail();
  list.resize (end);
  // Writes a string: a stream copied into a stream does not report a full disk.
  writeTextFile (output (planes_file), amended (list));
  writeTextFile (work (run_file::end), "");
}

void
partitionInput (const Plan& plan, const RunFolder& folder, std::size_t input)
{
  const TileGrid& grid = plan.grid;
  PointFile points (plan.inputs[input].file);
  writeFile (folder.cells (input), [&] (std::ostream& stream) {
    CellFileWriter writer (stream, folder.cells (input));
    points.forPlaces ([&] (const Eigen::Vector3d& place) {
      if (!grid.reaches (place))
        return;
      const auto add = [&] (const TileKey& tile, bool is_halo) {
        const Eigen::Vector3d corner = grid.cornerOf (grid.frameOf (tile));
        writer.add ({tile[0], tile[1], is_halo}, (place - corner).cast<float>());
      };
      const CellKey cell = grid.cellOf (place);
      add (grid.tileOf (cell), false);
      grid.forTilesAround (cell, [&] (const TileKey& tile) { add (tile, true); });
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
    for (const auto& [key, blocks] : files.back().blocks)
      if (key[2] == 0)
        points[{key[0], key[1]}] += files.back().count (key);
  }
  for (const auto& [tile, count] : points) {
    tiles.push_back (tile);
    points_of_tile.push_back (count);
  }
}

void
measureSurvey (const Plan& plan, const RunFolder& folder, const SortedPoints& points)
{
  if (points.tiles.size() < 2 || plan.is_on_voxels)
    return;
  std::vector<TileKey> telling;
  for (const std::size_t tile : tilesThatTell (points.points_of_tile))
    telling.push_back (points.tiles[tile]);
  const auto points_of = [&] (const TileKey& tile) {
    std::vector<Eigen::Vector3f> own;
    for (const CellFile& file : points.files)
      file.read ({tile[0], tile[1], 0}, own);
    return own;
  };
  saveNoise (folder.work (run_file::noise), noiseOfSurvey (plan, telling, points_of));
}

void
detectTile (const Plan& plan,
            const RunFolder& folder,
            const SortedPoints& points,
            const TileKey& tile)
{
  const TilePoints seen = pointsOf (points, tile);
  std::optional<CloudNoise> noise;
  if (const std::string file = folder.work (run_file::noise); isThere (file))
    noise = loadNoise (file);
  const TileDetection found = detectInTile (plan, noise, seen);
  const std::uint32_t* labels = found.labels.data();
  for (const auto& [input, count] : seen.own_of_input) {
    const std::string file = folder.labels (tile, input);
    writeFile (file, [&, count = count] (std::ostream& stream) {
      BinaryWriter write (stream, file);
      write (labels, count);
      write.finish();
    });
    labels += count;
  }
  saveTilePlanes (folder.ofTile (tile, ".planes"), found.planes);
}

void
joinTiles (const Plan& plan, const RunFolder& folder, const SortedPoints& points)
{
  const std::vector<TileKey>& tiles = points.tiles;
  const JoinedPlanes joined = joinPlanes (tiles, [&folder] (const TileKey& tile) {
    return loadTilePlanes (folder.ofTile (tile, ".planes"));
  });
  for (std::size_t i = 0; i < tiles.size(); ++i)
    saveNumbers (folder.ofTile (tiles[i], ".numbers"), joined.numbers[i]);
  const std::string list = toJson (plan, tiles.size(), joined.planes);
  writeTextFile (folder.work (run_file::list),
                 list + sumOf (folder.work (run_file::list), list));
}

void
labelInput (const Plan& plan, const RunFolder& folder, std::size_t input)
{
  const TileGrid& grid = plan.grid;
  std::map<TileKey, TileLabels> tiles;
  auto last = tiles.end();
  checkIsAsPlanned (plan.inputs[input], folder);
  PointFile points (plan.inputs[input].file);
  const std::string output = outputOf (plan, folder, input);
  points.saveLabelled (output, [&] (const Eigen::Vector3d& place) -> std::uint32_t {
    if (!grid.reaches (place))
      return 0;
    const TileKey tile = grid.tileOf (grid.cellOf (place));
    if (last == tiles.end() || last->first != tile)
      last = tiles.try_emplace (tile, folder, tile, input).first;
    return last->second.next();
  });
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

void
forLabelledPoints (const Plan& plan,
                   const RunFolder& folder,
                   const VisitLabelled& visit)
{
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    stopIfInterrupted();
    const std::string file = outputOf (plan, folder, i);
    inMemory (file, "give smaller inputs", [&] { PointFile (file).forLabels (visit); });
  }
}

} // namespace pcl_ops::apps
