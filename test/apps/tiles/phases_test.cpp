// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cli/errors.h>
#include <support/temporary_folder.h>
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

} // namespace

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
