// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/experiments/edge_accuracy.h>

using namespace pcl_ops::evaluation;
using pcl_ops::PlaneEdge;

namespace {

PlaneEdge
edgeFrom (const Eigen::Vector3d& from, const Eigen::Vector3d& to)
{
  PlaneEdge edge;
  edge.from = from;
  edge.to = to;
  return edge;
}

/** \brief Two edges and their corner, of which one is found 2 cm beside and half as
 * long, and the corner 3 cm off. */
EdgePair
somePair ()
{
  EdgePair edges;
  edges.truth.edges = {edgeFrom ({0, 0, 0}, {2, 0, 0}),
                       edgeFrom ({0, 0, 0}, {0, 1, 0})};
  edges.truth.corners = {{{0, 1, 2}, {0, 0, 0}}};
  edges.is_of_wall = {true, false};
  edges.found.edges = {edgeFrom ({1, 0, 0.02}, {0, 0, 0.02})};
  edges.found.corners = {{{0, 1, 2}, {0, 0, 0.03}}, {{0, 1, 3}, {9, 9, 9}}};
  return edges;
}

/** \brief A floor and two walls that meet at zero, in steps of 2 cm, with their truth.
 */
EvaluationCloud
corner ()
{
  EvaluationCloud cloud;
  cloud.cloud.reset (new XyzCloud);
  cloud.truth.emplace();
  cloud.cloud->sensor_origin_.head<3>() = Eigen::Vector3f (1, 1, 1);
  for (float s = 0.01f; s < 2.0f; s += 0.02f)
    for (float t = 0.01f; t < 2.0f; t += 0.02f) {
      cloud.cloud->push_back ({s, t, 0});
      cloud.cloud->push_back ({0, s, t});
      cloud.cloud->push_back ({t, 0, s});
      for (const std::uint32_t label : {1, 2, 3})
        cloud.truth->push_back (label);
    }
  return cloud;
}

EdgeScore
scoreOf (const EdgePair& edges)
{
  EdgeScore score;
  addScore (edges, score);
  return score;
}

} // namespace

TEST (EdgeAccuracy, CountsLengthsThatAreFoundAndTrue)
{
  const EdgeScore score = scoreOf (somePair());
  EXPECT_NEAR (score.true_length, 3.0, 1e-9);
  EXPECT_NEAR (score.true_length_found, 1.0, 0.06) << "its end is as near as its side";
  EXPECT_NEAR (score.wall_length, 2.0, 1e-9);
  EXPECT_NEAR (score.wall_length_found, 1.0, 0.06);
  EXPECT_NEAR (score.found_length, 1.0, 1e-9);
  EXPECT_NEAR (score.found_length_true, 1.0, 1e-9);
  EXPECT_NEAR (score.edge_errors.front(), 0.02, 1e-9);
  EXPECT_EQ (score.corners_matched, 1u);
  EXPECT_EQ (score.found_corners, 2u);
  EXPECT_NEAR (score.corner_errors.front(), 0.03, 1e-9);
}

TEST (EdgeAccuracy, AddsUpOverClouds)
{
  EdgeScore sum = scoreOf (somePair());
  addScore (somePair(), sum);
  const TextTable once = edgeTable ({{"set", scoreOf (somePair())}});
  EXPECT_EQ (edgeTable ({{"set", sum}}).rows, once.rows) << "shares stay";
  EXPECT_NEAR (sum.true_length, 6.0, 1e-9);
}

TEST (EdgeAccuracy, IsPerfectOnACornerOfExactPoints)
{
  const EdgeScore score = scoreOf (findBothEdges (corner()));
  EXPECT_NEAR (score.true_length, 6.0, 0.2);
  EXPECT_NEAR (score.wall_length, 4.0, 0.2) << "both on the floor";
  EXPECT_NEAR (score.true_length_found / score.true_length, 1.0, 1e-9);
  EXPECT_NEAR (score.found_length_true / score.found_length, 1.0, 1e-9);
  EXPECT_EQ (score.corners_matched, 1u);
}
