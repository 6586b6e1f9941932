// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/types.h>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>

namespace pcl_ops {

/** \brief View of the positions of a cloud of any point type: x, y and z are adjacent
 * floats. The library reads clouds only through it and so needs no templates.
 *
 * It does not own the points. It becomes invalid if the cloud is resized or deleted. */
struct CloudView {
  CloudView() = default;

  /** \tparam PointT a type with adjacent x, y, z, as PCL_ADD_POINT4D declares them */
  template <typename PointT>
  CloudView (const pcl::PointCloud<PointT>& cloud)
  : first (cloud.empty() ? nullptr : &cloud[0].x)
  , stride (sizeof (PointT) / sizeof (float))
  , size (cloud.size())
  {
    static_assert (sizeof (PointT) % sizeof (float) == 0,
                   "a cloud's positions are a whole number of floats apart");
  }

  /** \brief Views positions in a buffer of any layout with adjacent floats x, y and z,
   * for example of a PointCloud2 message.
   * \param[in] data the first point, aligned as floats are
   * \param[in] x_offset bytes from the beginning of a point to its x, a multiple of 4
   * \param[in] point_step bytes from each point to the next, a multiple of 4
   * \param[in] points number of points
   * \throw std::invalid_argument if the floats are not aligned or not within their
   * point, if the buffer is null but has points, or if there are more points than
   * pcl::index_t can count */
  CloudView (const void* data,
             std::size_t x_offset,
             std::size_t point_step,
             std::size_t points)
  : first (data ? reinterpret_cast<const float*> (static_cast<const char*> (data) +
                                                  x_offset)
                : nullptr)
  , stride (point_step / sizeof (float))
  , size (points)
  {
    const auto address = reinterpret_cast<std::uintptr_t> (first);
    if (address % alignof (float) != 0 || point_step % sizeof (float) != 0)
      throw std::invalid_argument (
          "the positions in the buffer must be aligned floats");
    constexpr std::size_t size_of_position = 3 * sizeof (float);
    if (points > 0 && x_offset + size_of_position > point_step)
      throw std::invalid_argument ("a point in the buffer must hold x, y and z");
    if (!data && points > 0)
      throw std::invalid_argument ("the buffer of the positions is null");
    if (points > static_cast<std::size_t> (std::numeric_limits<pcl::index_t>::max()))
      throw std::invalid_argument (
          "a cloud must have fewer than 2^31 points; divide it");
  }

  /** \brief x, y and z of point \p i. */
  const float*
  operator[] (std::size_t i) const
  {
    return first + i * stride;
  }

  /** \brief x of the first point. */
  const float* first = nullptr;
  /** \brief Floats from each point to the next. */
  std::size_t stride = 0;
  /** \brief Number of points, finite or not. */
  std::size_t size = 0;
};

} // namespace pcl_ops
