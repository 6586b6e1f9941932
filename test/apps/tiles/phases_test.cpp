// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <support/temporary_folder.h>
#include <tiles/cell_file.h>
#include <tiles/phases.h>

#include <chrono>
#include <filesystem>
#include <string>

using namespace pcl_ops::apps;

namespace {

class Phases : public testing::Test {
protected:
  Phases()
  {
    std::string floor;
    for (int i = 0; i < 40; ++i)
      for (int k = 0; k < 40; ++k)
        floor += std::to_string (0.1 * i) + " " + std::to_string (0.1 * k) + " 0\n";
    input_ = folder_.write ("floor.xyz", floor);
    plan_ = makePlan ({input_}, {0.5, 10.0});
    run_.make();
  }

  /** \brief As if another program had written it after the plan was made. */
  void
  touchInput () const
  {
    std::filesystem::last_write_time (
        input_, std::filesystem::last_write_time (input_) + std::chrono::seconds (1));
  }

  /** \brief All phases before the last. */
  void
  findPlanes () const
  {
    partitionInput (plan_, run_, 0);
    const SortedPoints points (plan_, run_);
    for (const TileKey& tile : points.tiles)
      detectTile (plan_, run_, points, tile);
    joinTiles (plan_, run_, points);
  }

  TemporaryFolder folder_;
  RunFolder run_{folder_ / "out"};
  std::string input_;
  Plan plan_;
};

TEST_F (Phases, LabelAnInputThatIsAsPlanned)
{
  findPlanes();
  labelInput (plan_, run_, 0);
  EXPECT_TRUE (isThere (outputOf (plan_, run_, 0)));
  EXPECT_TRUE (isThere (run_.mark (0)));
}

TEST_F (Phases, DoNotSortAnInputThatHasChanged)
{
  touchInput();
  EXPECT_THROW (partitionInput (plan_, run_, 0), WorkError);
  EXPECT_FALSE (isThere (run_.cells (0)));
}

TEST_F (Phases, DoNotLabelAnInputThatHasChanged)
{
  findPlanes();
  touchInput();
  try {
    labelInput (plan_, run_, 0);
    ADD_FAILURE() << "labelled";
  }
  catch (const WorkError& error) {
    EXPECT_EQ (error.what(),
               input_ + ": has changed since the run began; remove " +
                   (folder_ / "out/work") + " and run it again");
  }
  EXPECT_FALSE (isThere (outputOf (plan_, run_, 0)));
  EXPECT_FALSE (isThere (run_.mark (0)));
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
  EXPECT_GT (cells.blocks().size(), std::size (keys));
  for (const BlockKey& key : keys) {
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

TEST (CellFile, SaysThatItIsDamaged)
{
  const TemporaryFolder folder;
  const std::string file = folder.write ("0.cells", "1234");
  EXPECT_THROW (CellFile{file}, WorkError);
}

} // namespace
