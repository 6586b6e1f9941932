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

/** \brief The coordinates of a cloud in single precision, relative to a point near it:
 * the cloud that planes are looked for in. */
struct ShiftedCloud {
  /** \brief All points of the file, those with NaN, too, and the pose of the sensor,
   * all relative to \ref shift. */
  XyzCloud::Ptr cloud;
  /** \brief Zero of the cloud in the frame of the file. It is not zero only where
   * single precision would lose digits of the file, or a step is asked for. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
};

/** \brief Shifts a cloud by \ref localOrigin, if single precision does not hold all its
 * coordinates.
 * \param[in] step above 0: shifts it in any case, by a multiple of this along each axis */
ShiftedCloud
shiftedCloudOf (const FileCloud& cloud, double step = 0.0);

/** \brief What makes a cloud that can be read look damaged, and what to do about it;
 * empty if nothing does. By a sample of its points, one of these:
 * - most are at one place;
 * - some are more than a thousand times as far away as the rest is wide;
 * - one per cent or more are at one place, as missing readings are. */
std::string
damageOf (const ShiftedCloud& shifted);

/** \brief Reads the three coordinates of points of a cloud, whatever their type. Keeps
 * a reference to the cloud. */
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

  Eigen::Vector3d
  operator() (std::size_t i) const
  {
    const std::uint8_t* const point = cloud_.data.data() + i * cloud_.point_step;
    return Eigen::Vector3d (readers_[0](point + offsets_[0]),
                            readers_[1](point + offsets_[1]),
                            readers_[2](point + offsets_[2]));
  }

  /** \brief Whether the fields of all three coordinates are in single precision. */
  bool is_single = true;

private:
  const pcl::PCLPointCloud2& cloud_;
  std::array<pcl::uindex_t, 3> offsets_{};
  std::array<NumberReader, 3> readers_{};
};

/** \brief Returns where a point is, by its number. */
using PlaceOf = std::function<Eigen::Vector3d (std::size_t)>;

/** \brief A hash of the coordinates of a place: to choose points by it is as good as to
 * draw them, but does not depend on their order. */
std::uint32_t
hashOf (const Eigen::Vector3d& place);

/** \brief A sample of the finite points, evenly spread over their order.
 * \param[in] size how many points there are
 * \param[in] looked_at largest size of the sample */
std::vector<Eigen::Vector3d>
somePlaces (std::size_t size, const PlaceOf& place, std::size_t looked_at);

/** \brief A place near most points: the median of a sample of different points,
 * rounded. It does not depend on the order of the points, and neither outliers nor many
 * points at one place draw it away: the others would lose digits. Zero if no point is
 * finite.
 * \param[in] size how many points there are; all are read */
Eigen::Vector3d
localOrigin (std::size_t size, const PlaceOf& place);

} // namespace pcl_ops::apps
