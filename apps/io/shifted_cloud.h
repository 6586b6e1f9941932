// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/io.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include "cloud_file.h"
#include "number_types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

using XyzCloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief The coordinates of a cloud in single precision, relative to a point near the
 * cloud. Planes are searched in this cloud. */
struct ShiftedCloud {
  /** \brief All points of the file, also those with NaN, and the pose of the sensor;
   * both are relative to \ref shift. */
  XyzCloud::Ptr cloud;
  /** \brief What has to be added to the coordinates of \ref cloud to get those of the
   * file. Zero unless single precision would lose digits of the file, or \ref
   * shiftedCloudOf gets a step. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
};

/** \brief Shifts a cloud by \ref localOrigin if single precision does not hold all its
 * coordinates exactly.
 * \param[in] step if above 0, the cloud is shifted in any case, and the shift along
 * each axis is rounded to a multiple of \p step [unit of the cloud] */
ShiftedCloud
shiftedCloudOf (const FileCloud& cloud, double step = 0.0);

/** \brief Returns why a cloud that can be read looks damaged, and the fix; empty if the
 * cloud does not look so, or has less than ten finite points. It looks damaged if in a
 * sample of its finite points
 * - more than half of the points are at one place; or
 * - more than 0.5 % of the points are outliers, more than a thousand times as far away
 *   from the median as the other points are apart; or
 * - 1 % or more of the points, and ten or more, are at one place, as missing readings
 *   are, and these are more than 16 times as many as the mean of all places. */
std::string
damageOf (const ShiftedCloud& shifted);

/** \brief Reads x, y and z of points of a cloud, which must have these fields, of any
 * number type. Keeps a reference to the cloud. */
class CoordinateReader {
public:
  explicit CoordinateReader (const FileCloud& cloud) : cloud_ (cloud.points)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      const int index = pcl::getFieldIndex (cloud_, std::string (1, "xyz"[i]));
      const pcl::PCLPointField& field = cloud_.fields.at (std::size_t (index));
      offsets_[i] = field.offset;
      readers_[i] = numberType (field.datatype).read;
      is_single = is_single && field.datatype == pcl::PCLPointField::FLOAT32;
    }
  }

  /** \brief Returns the coordinates of the point with index \p i. */
  Eigen::Vector3d
  operator() (std::size_t i) const
  {
    const std::uint8_t* const point = cloud_.data.data() + i * cloud_.point_step;
    return Eigen::Vector3d (readers_[0](point + offsets_[0]),
                            readers_[1](point + offsets_[1]),
                            readers_[2](point + offsets_[2]));
  }

  /** \brief Whether x, y and z are all fields in single precision. */
  bool is_single = true;

private:
  const pcl::PCLPointCloud2& cloud_;
  /** \brief Offsets of x, y and z in a point [bytes]. */
  std::array<pcl::uindex_t, 3> offsets_{};
  std::array<NumberReader, 3> readers_{};
};

/** \brief Returns the coordinates of a point, by its index. */
using PositionOf = std::function<Eigen::Vector3d (std::size_t point)>;

/** \brief Returns a hash of coordinates. A sample chosen by it is as good as a random
 * one, but does not depend on the order of the points. */
std::uint32_t
hashOf (const Eigen::Vector3d& position);

/** \brief Returns a sample of the finite points, evenly spread over the indices of all
 * points.
 * \param[in] size number of all points, also of those that are not finite
 * \param[in] max_sample largest number of points in the sample */
std::vector<Eigen::Vector3d>
somePositions (std::size_t size, const PositionOf& position_of, std::size_t max_sample);

/** \brief Returns a rounded position near most points: the median of a sample of
 * places. Outliers, or many points at one place, hardly change it, so the other points
 * lose no digits relative to it. The position does not depend on the order of the
 * points. Zero if no point is finite.
 * \param[in] size number of all points; all of them are read */
Eigen::Vector3d
localOrigin (std::size_t size, const PositionOf& position_of);

} // namespace pcl_ops::apps
