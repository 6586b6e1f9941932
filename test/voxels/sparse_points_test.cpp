// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "voxels/sparse_points.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief Fewest points in a dense voxel and its neighbors together. */
constexpr double min_points = 30.0;
constexpr int dense_steps = 120;
constexpr std::size_t dense_points = dense_steps * dense_steps;

/** \brief A dense square of \ref dense_points points, and a sparse square somewhere
 * else of sparse_steps x sparse_steps points 1 m apart, in voxels of 10 cm. */
VoxelGrid
denseAndSparse (int sparse_steps)
{
  Coordinates points = gridsOf ({{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}}}, dense_steps);
  const double edge = sparse_steps * 1_m;
  addGrid (points, {{10, 0, 0}, {edge, 0, 0}, {0, edge, 0}}, sparse_steps);
  return connectedGrid (points, 10_cm);
}

/** \brief Indices of the sparse points of a grid whose points all have this label. */
Indices
sparseAmong (const VoxelGrid& grid, std::int32_t label = no_plane)
{
  const pcl_ops::Labels labels (grid.order->size(), label);
  return sparsePoints (openPoints (grid, sparseVoxels (grid, min_points), labels),
                       labels.size());
}

} // namespace

TEST (SparsePoints, AreThosePointsThatHaveFewPointsAround)
{
  constexpr int sparse_steps = 20;
  Indices sparse (sparse_steps * sparse_steps);
  std::iota (sparse.begin(), sparse.end(), static_cast<std::uint32_t> (dense_points));
  EXPECT_EQ (sparseAmong (denseAndSparse (sparse_steps)), sparse);
}

TEST (SparsePoints, AreNoneIfOnAPlaneOrLessThanAHundredthOrMoreThanHalfOfTheCloud)
{
  EXPECT_TRUE (sparseAmong (denseAndSparse (20), 0).empty()) << "on a plane";
  EXPECT_TRUE (sparseAmong (denseAndSparse (12)).empty())
      << "144 points, less than a hundredth";
  EXPECT_TRUE (sparseAmong (denseAndSparse (121)).empty())
      << "more than half: the voxel size suits them already";
}

TEST (SparsePoints, LoseThePlaneThatTheyScatterAboutLikeAMist)
{
  // The points of plane 2 scatter by as much as their spacing, and by 10 times the
  // noise of the dense plane: they are a mist. Those of plane 0 scatter by only a tenth
  // of their spacing; those of plane 1 by 5 times the noise of the dense plane, which
  // is less than other_noise_ratio.
  //
  // 10 x 10 points, by turns above and below a plane by a height [m].
  const auto momentsOfGrid = [] (double spacing, double height) {
    pcl_ops::Moments moments;
    for (int i = 0; i < 100; ++i)
      moments.add (spacing * (i / 10),
                   spacing * (i % 10),
                   i % 2 == i / 10 % 2 ? height : -height);
    return moments;
  };
  AssignedPoints sparse{{0, 1, no_plane, 2, 0},
                        {momentsOfGrid (1_m, 10_cm),
                         momentsOfGrid (10_cm, 5_cm),
                         momentsOfGrid (10_cm, 10_cm)}};
  rejectMist ({momentsOfGrid (1_cm, 1_cm)}, one_thread, sparse);
  EXPECT_EQ (sparse.labels, (pcl_ops::Labels{0, 1, no_plane, no_plane, 0}));
  EXPECT_EQ (sparse.moments[0].count, 100.0);
  EXPECT_EQ (sparse.moments[2].count, 0.0);
}
