// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

#include <support/temporary_folder.h>
#include <support/text.h>
#include <tiles/phases.h>
#include <tiles/run_files.h>

#include <chrono>
#include <filesystem>

namespace fs = std::filesystem;
using namespace pcl_ops::apps;

namespace {

TEST (Phases, RefuseAnInputThatHasChanged)
{
  const TemporaryFolder folder;
  const RunFolder run{folder / "out"};
  std::string floor;
  for (int i = 0; i < 40; ++i)
    for (int k = 0; k < 40; ++k)
      floor += std::to_string (0.1 * i) + " " + std::to_string (0.1 * k) + " 0\n";
  const std::string input = folder.write ("floor.xyz", floor);
  const Plan plan = makePlan ({input}, {0.5, 10.0});
  run.make();
  partitionInput (plan, run, 0);
  const SortedPoints points (plan, run);
  for (const TileKey& tile : points.tiles)
    detectTile (plan, run, points, tile);
  joinTiles (plan, run, points);

  fs::remove (run.cells (0));
  fs::last_write_time (input, fs::last_write_time (input) + std::chrono::seconds (1));
  const std::string complaint = input + ": has changed since the run began; remove " +
                                (folder / "out/work") + " and run it again";
  EXPECT_EQ (complaintOf ([&] { partitionInput (plan, run, 0); }), complaint);
  EXPECT_EQ (complaintOf ([&] { labelInput (plan, run, 0); }), complaint);
  for (const std::string& file : {run.cells (0), outputOf (plan, run, 0), run.mark (0)})
    EXPECT_FALSE (isThere (file)) << file;
}

const BlockKey keys[] = {{0, 0, 0}, {0, 0, 1}, {-3, 7, 0}};

TEST (CellFile, HasThePointsOfEachKeyInTheirOrder)
{
  constexpr int turns = 1'000'000; // more than a block has
  const TemporaryFolder folder;
  {
    std::ofstream stream (folder / "0.cells", std::ios::binary);
    CellFileWriter writer (stream);
    for (int i = 0; i < turns; ++i)
      for (const BlockKey& key : keys)
        writer.add (key, Eigen::Vector3i (i, key[1], key[2]).cast<float>());
    writer.finish();
  }
  const CellFile cells (folder / "0.cells");
  for (const BlockKey& key : keys) {
    EXPECT_GT (cells.blocks.at (key).size(), 1u);
    EXPECT_EQ (cells.count (key), std::uint64_t (turns));
    std::vector<Eigen::Vector3f> points;
    cells.read (key, points);
    ASSERT_EQ (points.size(), std::size_t (turns));
    for (int i = 0; i < turns; ++i)
      ASSERT_EQ (points[i], Eigen::Vector3i (i, key[1], key[2]).cast<float>());
  }
  std::vector<Eigen::Vector3f> none;
  cells.read ({-3, 7, 1}, none);
  EXPECT_TRUE (none.empty());
  EXPECT_EQ (cells.count ({1, 0, 0}), 0u);
}

} // namespace
