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
#include <vector>

namespace pcl_ops::apps {

using XyzCloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief What planes are looked for in: coordinates alone, in single precision. */
struct ShiftedCloud {
  /** \brief Every point, NaN too, and the sensor's pose relative to \ref shift. */
  XyzCloud::Ptr cloud;
  /** \brief In the file's frame: near most points, whatever their order, where the file
   * has digits that single precision would lose; else zero. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
};

/** \param[in] step the shift is near most points, at a whole multiple of it along each
 * axis, whatever the precision; 0: not asked for */
ShiftedCloud
shiftedCloudOf (const FileCloud& cloud, double step = 0.0);

/** \brief What makes a cloud look damaged though it can be read, with the fix: most of
 * some thousand points are at one place, or some are a thousand times as far away as
 * the rest is wide; or that one per cent or more are at one place, as missing readings
 * are. Empty where nothing does. */
std::string
damageOf (const ShiftedCloud& shifted);

/** \brief The three coordinates of each point of a cloud, whatever their type. */
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

  /** \brief Whether all are in single precision. */
  bool is_single = true;

private:
  const pcl::PCLPointCloud2& cloud_;
  std::array<pcl::uindex_t, 3> offsets_{};
  std::array<NumberReader, 3> readers_{};
};

using PlaceOf = std::function<Eigen::Vector3d (std::size_t)>;

/** \brief A number as good as drawn, but the same for a place wherever it stands. */
std::uint32_t
hashOf (const Eigen::Vector3d& place);

/** \brief Finite ones of some points, evenly spread over their order. */
std::vector<Eigen::Vector3d>
somePlaces (std::size_t size, const PlaceOf& place, std::size_t looked_at);

/** \brief A place near most points, whatever their order; wherever few stray to, and
 * however many are at one place: one outlier must not leave the others without digits.
 * Zero where no point is finite. All are read, some thousand looked at. */
Eigen::Vector3d
localOrigin (std::size_t size, const PlaceOf& place);

} // namespace pcl_ops::apps
