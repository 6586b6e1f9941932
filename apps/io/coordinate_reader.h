// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "cloud_file.h"
#include "median_place.h"
#include "typed_number.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace pcl_ops::apps {

/** \brief The three coordinates of each point, whatever their type. */
class CoordinateReader {
public:
  /** \param[in] cloud has x, y and z, and is used as long as this is */
  explicit CoordinateReader (const FileCloud& cloud);

  bool
  isSinglePrecision () const
  {
    return is_single_;
  }

  Eigen::Vector3d
  operator() (std::size_t i) const
  {
    const std::uint8_t* const point = cloud_.data.data() + i * cloud_.point_step;
    return Eigen::Vector3d (readers_[0](point + offsets_[0]),
                            readers_[1](point + offsets_[1]),
                            readers_[2](point + offsets_[2]));
  }

private:
  const pcl::PCLPointCloud2& cloud_;
  std::array<pcl::uindex_t, 3> offsets_{};
  std::array<NumberReader, 3> readers_{};
  bool is_single_ = true;
};

/** \brief Places of some of the points, evenly spread over their order, without those
 * that are not finite.
 * \param[in] place of a point, by its index */
template <typename Place>
std::vector<Eigen::Vector3d>
somePlaces (Place&& place, std::size_t size, std::size_t looked_at)
{
  const std::size_t stride = size / looked_at + 1;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t begin = 0; begin < size; begin += stride)
    for (std::size_t i = begin; i < std::min (size, begin + stride); ++i)
      if (const Eigen::Vector3d found = place (i); found.allFinite()) {
        places.push_back (found);
        break;
      }
  return places;
}

/** \brief Near most points: one outlier must not leave the others without digits. */
template <typename Place>
Eigen::Vector3d
usualPlace (Place&& place, std::size_t size)
{
  constexpr std::size_t looked_at = 1000;
  const std::vector<Eigen::Vector3d> places = somePlaces (place, size, looked_at);
  return places.empty() ? Eigen::Vector3d (Eigen::Vector3d::Zero())
                        : medianPlace (places);
}

/** \brief Of the whole multiples of a step along each axis the nearest to a place. */
inline Eigen::Vector3d
nearestMultiple (const Eigen::Vector3d& place, double step)
{
  return (place / step).array().round() * step;
}

} // namespace pcl_ops::apps
