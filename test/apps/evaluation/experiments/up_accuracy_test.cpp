// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/experiments/up_accuracy.h>

using namespace pcl_ops::evaluation;

namespace {

using Row = std::vector<std::string>;

/** \brief Two good guesses, a bad one, one nobody believes, and a cloud without any. */
UpGuesses
someGuesses ()
{
  return {"shed", 5, {{0.95, 1.0}, {0.9, 2.0}, {0.75, 90.0}, {0.4, 180.0}}};
}

/** \brief A floor, two walls and a table top, seen by a sensor that looks ahead. */
EvaluationCloud
furnishedRoom ()
{
  EvaluationCloud room;
  room.cloud.reset (new XyzCloud);
  const Eigen::Vector3f eye (0.5f, 2.0f, 1.4f);
  constexpr float table_height = 0.75f;
  const auto is_above_table = [] (float x, float y) {
    return x > 3.0f && x < 4.5f && y > 1.0f && y < 2.0f;
  };
  const auto add = [&] (float x, float y, float z) {
    const Eigen::Vector3f ray = Eigen::Vector3f (x, y, z) - eye;
    const Eigen::Vector3f above = eye + (table_height - eye.z()) / ray.z() * ray;
    const bool is_below_table =
        z < table_height && is_above_table (above.x(), above.y());
    if (!is_below_table)
      room.cloud->push_back ({x, y, z});
  };
  constexpr float step = 0.05f;
  for (float s = step; s < 6.0f; s += step)
    for (float t = step; t < 4.0f; t += step) {
      add (s, t, 0);
      if (t < 2.4f)
        add (s, 0, t);
      if (s < 2.4f)
        add (6, t, s);
      if (is_above_table (s, t))
        add (s, t, table_height);
    }
  room.cloud->sensor_origin_.head<3>() = eye;
  return room;
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
  pcl_ops::apps::Random random (3);
  for (int i = 0; i < 5; ++i) {
    const auto guess = guessUp (furnishedRoom(), random);
    ASSERT_TRUE (guess.has_value());
    EXPECT_LE (guess->error, 1.0);
  }
}

TEST (UpAccuracy, NothingIsGuessedFromAPlaceThatIsNotTheSensors)
{
  EvaluationCloud room = furnishedRoom();
  room.cloud->sensor_origin_.head<3>() = Eigen::Vector3f (3, 2, -2);
  pcl_ops::apps::Random random (3);
  EXPECT_FALSE (guessUp (room, random).has_value());
}

TEST (UpAccuracy, TheErrorIsMeasuredWithItsSign)
{
  EvaluationCloud upside_down = furnishedRoom();
  upside_down.up *= -1.0;
  pcl_ops::apps::Random random (3);
  const auto guess = guessUp (upside_down, random);
  ASSERT_TRUE (guess.has_value());
  EXPECT_GE (guess->error, 179.0);
}
