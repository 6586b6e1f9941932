// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <support/temporary_folder.h>
#include <support/text.h>
#include <tiles/survey_noise.h>

#include <fstream>

using namespace pcl_ops::apps;

TEST (TilesToMeasure, AreAllOfASmallSurveyAndEvenlySpreadInALargeOne)
{
  // Of more than 400,000 points, as many tiles are measured as have about that many.
  EXPECT_EQ (tilesToMeasure ({1000, 5, 300}), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ (tilesToMeasure (std::vector<std::uint64_t> (8, 200'000)),
             (std::vector<std::size_t>{2, 6}));
  EXPECT_EQ (tilesToMeasure ({5'000'000, 5'000'000}).size(), 1u);
}

TEST (SurveyNoise, ComesBackFromItsFile)
{
  const TemporaryFolder folder;
  // Any numbers, in the order of the members that are compared below.
  const pcl_ops::CloudNoise noise{1e7, {1.7, 1.0}, 2.5, 0.013, {{-3, 0.02}, {7, 0.01}}};
  saveNoise (folder / "noise", noise);
  const pcl_ops::CloudNoise again = loadNoise (folder / "noise");
  EXPECT_EQ (again.points, noise.points);
  EXPECT_EQ (again.growth, noise.growth);
  EXPECT_EQ (again.common_errors, noise.common_errors);
  EXPECT_EQ (again.usual, noise.usual);
  EXPECT_EQ (again.usual_of_octave, noise.usual_of_octave);
}

TEST (SurveyNoise, IsRefusedWhereABitOfItsFileChanged)
{
  const TemporaryFolder folder;
  saveNoise (folder / "noise", {1e7, {1.7, 1.0}, 2.5, 0.013, {{-3, 0.02}}});
  const std::string right = contentOf (folder / "noise");
  for (const std::size_t offset :
       {std::size_t (0), right.size() / 2, right.size() - 1}) {
    std::string damaged = right;
    damaged[offset] ^= 1;
    std::ofstream (folder / "noise", std::ios::binary) << damaged;
    EXPECT_EQ (complaintOf ([&] { loadNoise (folder / "noise"); }),
               (folder / "noise") + ": is damaged; remove its folder and run it again")
        << offset;
  }
}
