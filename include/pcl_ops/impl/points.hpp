// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/point_tests.h>

#include <pcl_ops/points.h>

#include <algorithm>
#include <array>

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

/** \brief Closes the gaps that positions with a NaN or infinite coordinate leave.
 * \param[in] index of each position
 * \param[in,out] positions what is left comes first
 * \param[out] kept the index of each of them
 * \return their number */
std::size_t
keepFinite (const pcl::index_t* index,
            std::size_t number,
            const PositionsOut& positions,
            pcl::index_t* kept);

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

/** \brief Copies the finite points in the order of the indices.
 * \return whether the indices ascend */
template <typename PointT>
bool
copyFinite (const pcl::PointCloud<PointT>& cloud,
            const pcl::Indices& indices,
            Points& points)
{
  constexpr std::size_t block = 1024;
  points.resize (indices.size());
  points.index.resize (indices.size());
  const Eigen::Vector3f origin = points.origin.cast<float>();
  std::size_t number = 0;
  bool ascends = true;
  for (std::size_t begin = 0; begin < indices.size(); begin += block) {
    const std::size_t size = std::min (block, indices.size() - begin);
    const pcl::index_t* const index = indices.data() + begin;
    const PositionsOut to{&points.x[number], &points.y[number], &points.z[number]};
    const bool is_run = areConsecutive (index, size);
    if (is_run)
      copyConsecutive (&cloud[index[0]], size, origin, to);
    else
      for (std::size_t i = 0; i < size; ++i)
        copyConsecutive (&cloud[index[i]], 1, origin, {to.x + i, to.y + i, to.z + i});
    ascends = ascends && (begin == 0 || index[-1] < index[0]) &&
              (is_run || areAscending (index, size));
    number += keepFinite (index, size, to, &points.index[number]);
  }
  points.resize (number);
  points.index.resize (number);
  return ascends;
}

template <typename PointT>
Points
finitePoints (const pcl::PointCloud<PointT>& cloud, const pcl::Indices& indices)
{
  Points points;
  points.origin = medianPosition (cloud, indices);
  if (copyFinite (cloud, indices, points))
    return points;
  pcl::Indices sorted = indices;
  sortOnce (sorted);
  points.origin = medianPosition (cloud, sorted);
  copyFinite (cloud, sorted, points);
  return points;
}

} // namespace pcl_ops
