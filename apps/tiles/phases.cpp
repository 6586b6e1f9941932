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

/** \brief Names of the folders in \ref RunFolder::work with the files of phases, in the
 * order of the phases. */
constexpr const char* folders[] = {"cells", "planes", "labelled"};

/** \brief Size of a word of \ref Checksum [bytes]. */
constexpr std::size_t word_size = sizeof (std::uint32_t);

/** \brief Reads all points that a tile sees. */
TilePoints
pointsSeenBy (const TileKey& tile, const SortedPoints& points)
{
  const BlockKey own{tile, TilePart::Own};
  const BlockKey halo{tile, TilePart::Halo};
  TilePoints seen{tile, {}, {}};
  std::uint64_t seen_count = 0;
  for (std::size_t input = 0; input < points.files.size(); ++input) {
    const BlockFile& file = points.files[input];
    seen_count += file.count (own) + file.count (halo);
    if (file.count (own) > 0)
      seen.own_of_inputs.push_back (
          {static_cast<std::uint32_t> (input), file.count (own)});
  }
  seen.points.reserve (seen_count);
  for (const BlockKey& key : {own, halo})
    for (const BlockFile& file : points.files)
      file.read (key, seen.points);
  return seen;
}

/** \brief Returns a line with the checksum of a text.
 * \param[in] file that will have the text: its name is part of the checksum */
std::string
checksumLine (const std::string& file, std::string text)
{
  // A checksum is over whole words: one to four spaces fill the last one.
  text.resize ((text.size() / word_size + 1) * word_size, ' ');
  Checksum sum (file);
  sum.add (text.data(), text.size());
  return std::to_string (sum.value()) + "\n";
}

/** \brief Writes, for each piece of a tile, the number of its plane in planes.json. */
void
savePlaneNumbers (const std::string& file, const std::vector<std::uint32_t>& numbers)
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
  : file_ (folder.pieceNumbers (tile, input)), sum_ (file_)
  {
    BinaryReader read (folder.ofTile (tile, ".numbers"));
    read (plane_of_piece_);
    read.finish();
  }

  /** \brief Returns the label of the next point: the number of its plane, 0 for none.
   */
  std::uint32_t
  next ()
  {
    const std::uint64_t position = points_done_ % max_buffer; // in the buffer
    if (position == 0)
      fillBuffer();
    if (position == buffer_.size())
      throw WorkError (file_, "has too few labels; remove its folder and run it again");
    ++points_done_;
    const std::uint32_t piece = buffer_[position];
    if (piece > plane_of_piece_.size())
      BinaryReader (file_).fail();
    return piece == 0 ? 0 : plane_of_piece_[piece - 1];
  }

private:
  static constexpr std::uint64_t max_buffer = 4096; // [piece numbers]

  /** \brief Reads the next max_buffer piece numbers, or as many as there are. When the
   * last one of the file is read, checks the checksum of the file. */
  void
  fillBuffer ()
  {
    constexpr std::uint64_t words_of_checksum = sizeof (std::uint64_t) / word_size;
    BinaryReader read (file_);
    if (read.size < (points_done_ + words_of_checksum) * word_size)
      read.fail();
    const std::uint64_t unread =
        read.size / word_size - words_of_checksum - points_done_;
    buffer_.resize (std::min (max_buffer, unread));
    read.stream.seekg (points_done_ * word_size);
    read.sum = sum_; // continues the checksum of the numbers before
    read (buffer_.data(), buffer_.size());
    sum_ = read.sum;
    if (buffer_.size() == unread)
      read.finish();
  }

  std::string file_;
  /** \brief Checksum of the piece numbers read so far. */
  Checksum sum_;
  /** \brief Number of the plane of each piece of the tile. */
  std::vector<std::uint32_t> plane_of_piece_;
  /** \brief Piece numbers of some successive points: from 1 on, 0 for no piece. */
  std::vector<std::uint32_t> buffer_;
  /** \brief Number of points whose labels were returned. */
  std::uint64_t points_done_ = 0;
};

} // namespace

void
RunFolder::makeFolders() const
{
  makeFolder (outputs);
  for (const char* folder : folders)
    makeFolder (work (folder));
}

void
RunFolder::removeEarlierRun() const
{
  std::error_code error;
  fs::remove (work (run_file::end_mark), error);
  if (!error)
    error = removePhaseFiles();
  if (error)
    throw WorkError (output ("work"),
                     "cannot be emptied (" + error.message() +
                         "); remove it or give another --output-dir");
}

std::error_code
RunFolder::removePhaseFiles() const
{
  std::error_code error;
  for (const char* folder : folders)
    if (!error)
      fs::remove_all (work (folder), error);
  return error;
}

void
RunFolder::finish (
    const std::function<std::string (const std::string&)>& with_warnings) const
{
  const std::string file = work (run_file::list);
  std::string list = readTextFile (file, "planes.json");
  // The last line is the checksum of the lines before it.
  const std::size_t begin_of_checksum = list.rfind ('\n', list.size() - 2) + 1;
  const bool is_damaged =
      list.size() < 2 || list.substr (begin_of_checksum) !=
                             checksumLine (file, list.substr (0, begin_of_checksum));
  if (is_damaged)
    BinaryReader (file).fail();
  list.resize (begin_of_checksum);
  // Writes a string: a stream copied into a stream does not report a full disk.
  writeTextFile (output (planes_file), with_warnings (list));
  writeTextFile (work (run_file::end_mark), "");
}

void
partitionInput (const Plan& plan, const RunFolder& folder, std::size_t input)
{
  const TileGrid& grid = plan.grid;
  PointFile points (plan.inputs[input].file);
  writeFile (folder.blocks (input), [&] (std::ostream& stream) {
    BlockFileWriter writer (stream, folder.blocks (input));
    points.forPositions ([&] (const Eigen::Vector3d& point) {
      if (!grid.reaches (point))
        return;
      const auto add_to = [&] (const TileKey& tile, TilePart part) {
        const Eigen::Vector3d origin = grid.cornerOf (grid.frameOf (tile));
        writer.add ({tile, part}, (point - origin).cast<float>());
      };
      const CellKey cell = grid.cellOf (point);
      add_to (grid.tileOf (cell), TilePart::Own);
      grid.forTilesAround (
          cell, [&] (const TileKey& tile) { add_to (tile, TilePart::Halo); });
    });
    writer.finish();
    // Inside writeFile: if this throws, there is no file, and the phase is not done.
    checkIsAsPlanned (plan.inputs[input], folder);
  });
}

SortedPoints::SortedPoints (const Plan& plan, const RunFolder& folder)
{
  std::map<TileKey, std::uint64_t> own_points;
  for (std::size_t input = 0; input < plan.inputs.size(); ++input) {
    const BlockFile& file = files.emplace_back (folder.blocks (input));
    for (const auto& [key, blocks] : file.blocks)
      if (key.part == TilePart::Own)
        own_points[key.tile] += file.count (key);
  }
  for (const auto& [tile, count] : own_points) {
    tiles.push_back (tile);
    points_of_tile.push_back (count);
  }
}

void
measureSurvey (const Plan& plan, const RunFolder& folder, const SortedPoints& points)
{
  if (points.tiles.size() < 2 || plan.is_on_voxels)
    return;
  std::vector<TileKey> measured_tiles;
  for (const std::size_t tile : tilesToMeasure (points.points_of_tile))
    measured_tiles.push_back (points.tiles[tile]);
  const auto points_of = [&] (const TileKey& tile) {
    std::vector<Eigen::Vector3f> own;
    for (const BlockFile& file : points.files)
      file.read ({tile, TilePart::Own}, own);
    return own;
  };
  saveNoise (folder.work (run_file::noise),
             noiseOfSurvey (plan, measured_tiles, points_of));
}

void
detectTile (const Plan& plan,
            const RunFolder& folder,
            const SortedPoints& points,
            const TileKey& tile)
{
  const TilePoints seen = pointsSeenBy (tile, points);
  std::optional<CloudNoise> noise;
  if (const std::string file = folder.work (run_file::noise); isThere (file))
    noise = loadNoise (file);
  const TileDetection found = detectInTile (plan, noise, seen);
  const std::uint32_t* numbers_of_input = found.piece_numbers.data();
  for (const OwnPoints& own : seen.own_of_inputs) {
    const std::string file = folder.pieceNumbers (tile, own.input);
    writeFile (file, [&] (std::ostream& stream) {
      BinaryWriter write (stream, file);
      write (numbers_of_input, own.count);
      write.finish();
    });
    numbers_of_input += own.count;
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
    savePlaneNumbers (folder.ofTile (tiles[i], ".numbers"), joined.numbers[i]);
  const std::string list = toJson (plan, tiles.size(), joined.planes);
  const std::string file = folder.work (run_file::list);
  writeTextFile (file, list + checksumLine (file, list));
}

void
labelInput (const Plan& plan, const RunFolder& folder, std::size_t input)
{
  const TileGrid& grid = plan.grid;
  std::map<TileKey, TileLabels> labels_of_tiles;
  // Those of the tile of the last point: the next point is mostly in the same tile.
  auto last_labels = labels_of_tiles.end();
  checkIsAsPlanned (plan.inputs[input], folder);
  PointFile points (plan.inputs[input].file);
  const std::string output = outputOf (plan, folder, input);
  points.saveLabeled (output, [&] (const Eigen::Vector3d& point) -> std::uint32_t {
    if (!grid.reaches (point))
      return 0;
    const TileKey tile = grid.tileOf (grid.cellOf (point));
    if (last_labels == labels_of_tiles.end() || last_labels->first != tile)
      last_labels = labels_of_tiles.try_emplace (tile, folder, tile, input).first;
    return last_labels->second.next();
  });
  if (hasChanged (plan.inputs[input]))
    fs::remove (output);
  checkIsAsPlanned (plan.inputs[input], folder);
  writeTextFile (folder.labeledMark (input), "");
}

std::string
outputOf (const Plan& plan, const RunFolder& folder, std::size_t input)
{
  const std::string& file = plan.inputs[input].file;
  const std::string extension = isLasName (file) ? extensionOf (file) : ".pcd";
  return folder.output (fs::path (file).stem().string() + extension);
}

void
forEachLabeledPoint (const Plan& plan,
                     const RunFolder& folder,
                     const VisitLabeledPosition& visit)
{
  for (std::size_t i = 0; i < plan.inputs.size(); ++i) {
    stopIfInterrupted();
    const std::string file = outputOf (plan, folder, i);
    inMemory (file, "give smaller inputs", [&] { PointFile (file).forLabels (visit); });
  }
}

} // namespace pcl_ops::apps
