// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/common/io.h>

#include <Eigen/Core>

#include "cloud_file.h"
#include "number_types.h"

#include <array>
#include <cstddef>
#include <string>

namespace pcl_ops::apps {

/** \brief The three coordinates of each point, whatever their type. */
class CoordinateReader {
public:
  /** \param[in] cloud has x, y and z, and is used as long as this is */
  explicit CoordinateReader (const FileCloud& cloud) : cloud_ (cloud.points)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      const int index = pcl::getFieldIndex (cloud_, std::string (1, "xyz"[i]));
      const pcl::PCLPointField& field = cloud_.fields.at (std::size_t (index));
      offsets_[i] = field.offset;
      readers_[i] = numberType (field.datatype).read;
      is_single_ = is_single_ && field.datatype == pcl::PCLPointField::FLOAT32;
    }
  }

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

} // namespace pcl_ops::apps
