// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/up_accuracy.h>

using namespace pcl_ops::evaluation;

namespace {

using Row = std::vector<std::string>;

/** \brief Two good guesses, a bad one, one nobody believes, and a cloud without any. */
UpGuesses
someGuesses ()
{
  return {"shed", 5, {{0.95, 1.0}, {0.9, 2.0}, {0.75, 90.0}, {0.4, 180.0}}};
}

/** \brief A floor and two walls, seen by a sensor that looks ahead. */
EvaluationCloud
corner ()
{
  EvaluationCloud corner;
  corner.cloud.reset (new Cloud);
  const auto add = [&corner] (float x, float y, float z) {
    corner.cloud->push_back ({x, y, z});
  };
  constexpr float step = 0.05f;
  for (float s = step; s < 4.0f; s += step)
    for (float t = step; t < 2.0f; t += step) {
      add (s, t, 0);
      add (s, 2, t);
      if (s < 2.0f)
        add (4, s, t);
    }
  corner.cloud->sensor_origin_ = Eigen::Vector4f (-1.0f, 0.8f, 1.2f, 0.0f);
  return corner;
}

} // namespace

TEST (UpAccuracy, CountsOnlyAnswersThatAreSureEnough)
{
  const TextTable sure = errorTable ({someGuesses()}, 0.8);
  EXPECT_EQ (sure.rows,
             std::vector<Row> ({{"shed", "5", "40.00", "0.00", "1.00", "2.00"}}));
  const TextTable all = errorTable ({someGuesses()}, 0.0);
  EXPECT_EQ (all.rows,
             std::vector<Row> ({{"shed", "5", "80.00", "40.00", "2.00", "180.00"}}));
  const TextTable none = errorTable ({someGuesses()}, 0.99);
  EXPECT_EQ (none.rows, std::vector<Row> ({{"shed", "5", "0.00", "0.00", "-", "-"}}));
}

TEST (UpAccuracy, TellsHowOftenAConfidenceIsRight)
{
  const TextTable table = reliabilityTable ({someGuesses()});
  ASSERT_EQ (table.rows.size(), 5u);
  EXPECT_EQ (table.rows[0], Row ({"0.0 to 0.5", "1", "40.00", "0.00"}));
  EXPECT_EQ (table.rows[1], Row ({"0.5 to 0.7", "0", "-", "-"}));
  EXPECT_EQ (table.rows[2], Row ({"0.7 to 0.8", "1", "75.00", "0.00"}));
  EXPECT_EQ (table.rows[4], Row ({"0.9 to 1.0", "2", "92.50", "100.00"}));
}

TEST (UpAccuracy, ARightGuessStaysRightHoweverTheCloudIsTurned)
{
  pcl_ops::RandomGenerator generator (3);
  for (int i = 0; i < 5; ++i) {
    const auto guess = guessUp (corner(), generator);
    ASSERT_TRUE (guess.has_value());
    EXPECT_LE (guess->error, 1.0);
  }
}

TEST (UpAccuracy, TheErrorIsMeasuredWithItsSign)
{
  EvaluationCloud upside_down = corner();
  upside_down.up *= -1.0;
  pcl_ops::RandomGenerator generator (3);
  const auto guess = guessUp (upside_down, generator);
  ASSERT_TRUE (guess.has_value());
  EXPECT_GE (guess->error, 179.0);
}
