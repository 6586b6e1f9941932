// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/temporary_folder.h>
#include <support/text.h>
#include <tiles/phases.h>
#include <tiles/run_files.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>

namespace fs = std::filesystem;
using namespace pcl_ops::apps;

namespace {

/** \brief A run on a floor of 8 m x 8 m after all its phases but the last, which labels
 * points.
 * \param[in] edge_of_tile [m] */
struct FloorRun {
  explicit FloorRun (double edge_of_tile)
  : run{folder / "out"}
  , input (folder.write ("floor.xyz", floor()))
  , plan (makePlan ({input}, {voxel_size, edge_of_tile}))
  {
    run.makeFolders();
    partitionInput (plan, run, 0); // there is one input, 0
    measureSurvey (plan, run, SortedPoints (plan, run));
    detect();
    join();
  }

  /** \brief Text of 40 x 40 points, 20 cm apart. */
  static std::string
  floor ()
  {
    std::string points;
    for (int i = 0; i < 40; ++i)
      for (int k = 0; k < 40; ++k)
        points += std::to_string (0.2 * i) + " " + std::to_string (0.2 * k) + " 0\n";
    return points;
  }

  void
  detect () const
  {
    const SortedPoints points (plan, run);
    for (const TileKey& tile : points.tiles)
      detectTile (plan, run, points, tile);
  }

  void
  join () const
  {
    joinTiles (plan, run, SortedPoints (plan, run));
  }

  /** \brief Offsets at which a changed bit has to be noticed [byte]: at both ends of a
   * file and some between. In a file of points (.cells): two within the own points of a
   * tile, and the last one. */
  static std::vector<std::size_t>
  offsetsIn (const std::string& file)
  {
    const std::size_t size = fs::file_size (file);
    if (fs::path (file).extension() != ".cells")
      return {0, size / 3, size / 2, size - 1};
    for (const auto& [key, blocks] : BlockFile (file).blocks)
      if (key.part == TilePart::Own)
        return {blocks.front().offset, blocks.front().offset + 100, size - 1};
    return {};
  }

  std::vector<std::string>
  filesWith (const std::string& extension) const
  {
    std::vector<std::string> files;
    for (const fs::directory_entry& entry :
         fs::recursive_directory_iterator (run.work ("")))
      if (entry.path().extension() == extension)
        files.push_back (entry.path().string());
    return files;
  }

  static constexpr double voxel_size = 0.5; // [m]
  TemporaryFolder folder;
  RunFolder run;
  std::string input;
  Plan plan;
};

TEST (Phases, RefuseAnInputThatHasChanged)
{
  const FloorRun floor (10.0);
  const TemporaryFolder& folder = floor.folder;
  const RunFolder& run = floor.run;
  const std::string& input = floor.input;
  fs::remove (run.blocks (0));
  fs::last_write_time (input, fs::last_write_time (input) + std::chrono::seconds (1));
  const std::string complaint = input + ": has changed since the run began; remove " +
                                (folder / "out/work") + " and run it again";
  EXPECT_EQ (complaintOf ([&] { partitionInput (floor.plan, run, 0); }), complaint);
  EXPECT_EQ (complaintOf ([&] { labelInput (floor.plan, run, 0); }), complaint);
  for (const std::string& file :
       {run.blocks (0), outputOf (floor.plan, run, 0), run.labeledMark (0)})
    EXPECT_FALSE (isThere (file)) << file;
}

TEST (Phases, RefuseAFileOfTheirsInWhichABitChanged)
{
  const FloorRun floor (10.0);
  const std::pair<std::string, std::function<void()>> readers[] = {
      {".cells", [&] { floor.detect(); }},
      {".planes", [&] { floor.join(); }},
      {".numbers", [&] { labelInput (floor.plan, floor.run, 0); }},
      {".labels", [&] { labelInput (floor.plan, floor.run, 0); }},
      {".json",
       [&] { floor.run.finish ([] (const std::string& list) { return list; }); }}};
  for (const auto& [extension, read] : readers) {
    const std::string file = extension == ".json" ? floor.run.work (run_file::list)
                                                  : floor.filesWith (extension).at (0);
    const std::string right = contentOf (file);
    const std::vector<std::size_t> offsets = FloorRun::offsetsIn (file);
    ASSERT_FALSE (offsets.empty()) << file;
    for (const std::size_t offset : offsets) {
      std::string damaged = right;
      damaged.at (offset) ^= 1;
      std::ofstream (file, std::ios::binary) << damaged;
      EXPECT_EQ (complaintOf (read),
                 file + ": is damaged; remove its folder and run it again")
          << offset;
    }
    std::ofstream (file, std::ios::binary) << right;
    read();
  }
}

TEST (Phases, RefuseTheFileOfAnotherTile)
{
  const FloorRun floor (6.0);
  const std::vector<std::string> files = floor.filesWith (".planes");
  ASSERT_GT (files.size(), 1u);
  fs::copy_file (files[0], files[1], fs::copy_options::overwrite_existing);
  EXPECT_EQ (complaintOf ([&] { floor.join(); }),
             files[1] + ": is damaged; remove its folder and run it again");
}

const BlockKey keys[] = {
    {{0, 0}, TilePart::Own}, {{0, 0}, TilePart::Halo}, {{-3, 7}, TilePart::Own}};

/** \brief A point that differs from all points with another number or key. */
Eigen::Vector3f
pointOf (int number, const BlockKey& key)
{
  return Eigen::Vector3i (number, key.tile[1], static_cast<int> (key.part))
      .cast<float>();
}

TEST (Phases, SayThatARunGoesOnAfterAnInterruption)
{
  EXPECT_EQ (asResumable ([] { return 7; }), 7);
  std::string complaint;
  try {
    asResumable ([] () -> int { throw Interrupted(); });
  }
  catch (const WorkError& error) {
    complaint = error.what();
  }
  EXPECT_EQ (complaint,
             "interrupted: no output is half-written; run it again to go on");
}

TEST (BlockFile, HasThePointsOfEachKeyInTheirOrder)
{
  constexpr int turns = 1'000'000; // more than a block has
  const TemporaryFolder folder;
  {
    std::ofstream stream (folder / "0.cells", std::ios::binary);
    BlockFileWriter writer (stream, "0.cells");
    for (int i = 0; i < turns; ++i)
      for (const BlockKey& key : keys)
        writer.add (key, pointOf (i, key));
    writer.finish();
  }
  const BlockFile cells (folder / "0.cells");
  for (const BlockKey& key : keys) {
    EXPECT_GT (cells.blocks.at (key).size(), 1u);
    EXPECT_EQ (cells.count (key), std::uint64_t (turns));
    std::vector<Eigen::Vector3f> points;
    cells.read (key, points);
    ASSERT_EQ (points.size(), std::size_t (turns));
    for (int i = 0; i < turns; ++i)
      ASSERT_EQ (points[i], pointOf (i, key));
  }
  std::vector<Eigen::Vector3f> none;
  cells.read ({{-3, 7}, TilePart::Halo}, none);
  EXPECT_TRUE (none.empty());
  EXPECT_EQ (cells.count ({{1, 0}, TilePart::Own}), 0u);
}

} // namespace
