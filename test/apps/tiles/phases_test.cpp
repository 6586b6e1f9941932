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
    for (const TileSize& size : points.tiles)
      detectTile (plan_, run_, points, size.tile);
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

constexpr int points_of_key = 40'000; // more than a block has
const BlockKey first{{0, 0}, false}, halo_of_first{{0, 0}, true},
    second{{-3, 7}, false};

/** \brief A file with points of three keys by turns; x is the number of the turn. */
std::string
savedCells (const TemporaryFolder& folder)
{
  std::ofstream stream (folder / "0.cells", std::ios::binary);
  CellFileWriter writer (stream);
  for (int i = 0; i < points_of_key; ++i)
    for (const BlockKey& key : {first, halo_of_first, second})
      writer.add (key,
                  {static_cast<float> (i),
                   static_cast<float> (key.tile[1]),
                   key.is_halo ? 1.0f : 0.0f});
  writer.finish();
  return folder / "0.cells";
}

TEST (CellFile, HasThePointsOfEachKeyInTheirOrder)
{
  const TemporaryFolder folder;
  const CellFile cells (savedCells (folder));
  for (const BlockKey& key : {first, halo_of_first, second}) {
    EXPECT_EQ (cells.count (key), std::uint64_t (points_of_key));
    std::vector<float> coordinates;
    cells.read (key, coordinates);
    ASSERT_EQ (coordinates.size(), std::size_t (3 * points_of_key));
    for (int i = 0; i < points_of_key; ++i) {
      const float* const point = coordinates.data() + 3 * i;
      ASSERT_EQ (point[0], static_cast<float> (i));
      ASSERT_EQ (point[1], static_cast<float> (key.tile[1]));
      ASSERT_EQ (point[2], key.is_halo ? 1.0f : 0.0f);
    }
  }
}

TEST (CellFile, HasNothingOfOtherKeys)
{
  const TemporaryFolder folder;
  const CellFile cells (savedCells (folder));
  std::vector<float> coordinates;
  cells.read ({{-3, 7}, true}, coordinates);
  EXPECT_TRUE (coordinates.empty());
  EXPECT_EQ (cells.count ({{1, 0}, false}), 0u);
}

TEST (CellFile, SaysThatItIsDamaged)
{
  const TemporaryFolder folder;
  const std::string file = folder.write ("0.cells", "1234");
  EXPECT_THROW (CellFile{file}, std::runtime_error);
}

} // namespace
