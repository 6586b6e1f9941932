// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/point_tests.h>

#include <pcl_ops/parallel.h>
#include <pcl_ops/points.h>

#include <algorithm>
#include <array>
#include <atomic>

namespace pcl_ops {

/** \brief Where coordinates are written to. */
struct PositionsOut {
  float* x;
  float* y;
  float* z;
};

/** \brief Whether indices follow each other without a gap. */
bool
areConsecutive (const pcl::index_t* indices, std::size_t number);

bool
areAscending (const pcl::index_t* indices, std::size_t number);

/** \brief Whether all positions of a range have finite coordinates. */
bool
areFinite (const Coordinates& positions, std::size_t begin, std::size_t end);

/** \brief Drops the points with a NaN or infinite coordinate.
 * \param[in,out] points with their index */
void
keepFinite (Points& points);

/** \brief The median of some of the points: near most of them, wherever a few stray to.
 * \return zero for no points */
template <typename PointT>
Eigen::Vector3d
medianPosition (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices)
{
  constexpr std::size_t looked_at = 100;
  const std::size_t stride = indices.size() / looked_at + 1;
  std::array<std::vector<float>, 3> values;
  for (std::size_t begin = 0; begin < indices.size(); begin += stride) {
    const std::size_t end = std::min (begin + stride, indices.size());
    std::size_t i = begin;
    while (i < end && !pcl::isFinite (cloud[indices[i]]))
      ++i;
    if (i == end)
      continue;
    values[0].push_back (cloud[indices[i]].x);
    values[1].push_back (cloud[indices[i]].y);
    values[2].push_back (cloud[indices[i]].z);
  }
  return {medianOf (values[0]), medianOf (values[1]), medianOf (values[2])};
}

/** \brief Copies points that follow each other in the cloud: a loop without gathers,
 * which the compiler vectorizes. */
template <typename PointT>
void
copyConsecutive (const PointT* points,
                 std::size_t number,
                 const Eigen::Vector3f& origin,
                 const PositionsOut& to)
{
  const float ox = origin.x(), oy = origin.y(), oz = origin.z();
  for (std::size_t i = 0; i < number; ++i) {
    to.x[i] = points[i].x - ox;
    to.y[i] = points[i].y - oy;
    to.z[i] = points[i].z - oz;
  }
}

/** \brief Copies points in the order of the indices, in the frame of their origin.
 * \return whether all are finite */
template <typename PointT>
bool
copyPositions (const pcl::PointCloud<PointT>& cloud,
               const pcl::Indices& indices,
               unsigned threads,
               Points& points)
{
  constexpr std::size_t points_per_piece = 8192;
  points.resize (indices.size());
  const Eigen::Vector3f origin = points.origin.cast<float>();
  std::atomic<bool> all_finite (true);
  parallelFor (
      threads,
      indices.size(),
      points_per_piece,
      [&] (std::size_t begin, std::size_t end) {
        const pcl::index_t* const index = indices.data();
        const PositionsOut to{points.x.data(), points.y.data(), points.z.data()};
        if (areConsecutive (index + begin, end - begin))
          copyConsecutive (&cloud[index[begin]],
                           end - begin,
                           origin,
                           {to.x + begin, to.y + begin, to.z + begin});
        else
          for (std::size_t i = begin; i < end; ++i)
            copyConsecutive (
                &cloud[index[i]], 1, origin, {to.x + i, to.y + i, to.z + i});
        if (!areFinite (points, begin, end))
          all_finite = false;
      });
  return all_finite;
}

template <typename PointT>
Points
finitePoints (const pcl::PointCloud<PointT>& cloud,
              const pcl::Indices& indices,
              unsigned threads)
{
  const bool are_consecutive = areConsecutive (indices.data(), indices.size());
  if (!are_consecutive && !areAscending (indices.data(), indices.size())) {
    pcl::Indices sorted = indices;
    sortOnce (sorted);
    return finitePoints (cloud, sorted, threads);
  }
  Points points;
  points.origin = medianPosition (cloud, indices);
  const bool are_finite = copyPositions (cloud, indices, threads, points);
  const bool are_all = are_consecutive && indices.size() == cloud.size();
  if (!(are_finite && are_all))
    points.index = indices;
  if (!are_finite)
    keepFinite (points);
  return points;
}

} // namespace pcl_ops
