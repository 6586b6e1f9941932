// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The types of PCL that programs and the Python module use, for builds without PCL.
// There each of PCL's headers includes only this one (CMakeLists.txt beside it).

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace pcl {

using index_t = std::int32_t;
using uindex_t = std::uint32_t;
using Indices = std::vector<index_t>;

struct PCLHeader {};

struct PCLPointField {
  // clang-format off
  enum PointFieldTypes { INT8 = 1, UINT8, INT16, UINT16, INT32, UINT32, FLOAT32,
                         FLOAT64, INT64, UINT64, BOOL }; // PCL's numbers
  // clang-format on
  std::string name;
  uindex_t offset = 0;
  std::uint8_t datatype = 0;
  uindex_t count = 0;
};

struct PCLPointCloud2 {
  PCLHeader header;
  uindex_t height = 0;
  uindex_t width = 0;
  std::vector<PCLPointField> fields;
  std::uint8_t is_bigendian = 0;
  uindex_t point_step = 0;
  uindex_t row_step = 0;
  std::vector<std::uint8_t> data;
  std::uint8_t is_dense = 0;
};

inline int
getFieldIndex (const PCLPointCloud2& cloud, const std::string& name)
{
  for (std::size_t i = 0; i < cloud.fields.size(); ++i)
    if (cloud.fields[i].name == name)
      return static_cast<int> (i);
  return -1;
}

struct PointXYZ {
  PointXYZ (float x_ = 0.0F, float y_ = 0.0F, float z_ = 0.0F) : data{x_, y_, z_, 1.0F}
  {}

  Eigen::Map<Eigen::Vector3f>
  getVector3fMap ()
  {
    return Eigen::Map<Eigen::Vector3f> (data);
  }
  Eigen::Map<const Eigen::Vector3f>
  getVector3fMap () const
  {
    return Eigen::Map<const Eigen::Vector3f> (data);
  }

  union {
    float data[4];
    struct {
      float x, y, z;
    };
  };
};

struct PointXYZL : PointXYZ {
  std::uint32_t label = 0;
};

struct RGB {
  RGB() : RGB (0, 0, 0) {}
  RGB (std::uint8_t red, std::uint8_t green, std::uint8_t blue)
  : b (blue), g (green), r (red)
  {}

  Eigen::Vector3i
  getRGBVector3i () const
  {
    return {r, g, b};
  }

  std::uint8_t b, g, r;
  std::uint8_t a = 255;
};

/** \brief Colors in place of PCL's table. They are fully saturated, their hues are a
 * golden section of the color circle apart, and every other color is darker. */
struct GlasbeyLUT {
  static constexpr std::size_t
  size ()
  {
    return 256;
  }

  static RGB
  at (std::size_t i)
  {
    constexpr double golden_section = 0.6180339887498949;
    constexpr double darker = 0.65; // chosen by eye
    constexpr double full = 255.0;
    const double brightness = i % 2 == 0 ? full : darker * full;
    // A channel is full within a sixth of a turn of its own hue and 0 from a third on.
    const auto channel = [&] (double hue_of_channel) {
      const double turns = golden_section * static_cast<double> (i) + hue_of_channel;
      const double from_half_turn = std::abs (turns - std::floor (turns) - 0.5);
      const double share = std::min (1.0, std::max (0.0, 6.0 * from_half_turn - 1.0));
      return static_cast<std::uint8_t> (std::lround (brightness * share));
    };
    return {channel (0.0), channel (2.0 / 3.0), channel (1.0 / 3.0)};
  }
};

/** \brief A scale of 256 colors in place of PCL's, index 0 to 255: from dark violet
 * over green to yellow, each lighter than the one before. The colors are chosen by eye.
 */
struct ViridisLUT {
  static RGB
  at (std::size_t i)
  {
    constexpr double first[] = {70, 0, 85}, middle[] = {32, 145, 140},
                     last[] = {253, 231, 37};
    constexpr double index_of_middle = 127.5;
    const double halves = double (i) / index_of_middle; // 0 to 2
    const bool is_in_first_half = halves < 1.0;
    const double* const from = is_in_first_half ? first : middle;
    const double* const to = is_in_first_half ? middle : last;
    const auto mixed = [&] (std::size_t channel) {
      const double part = is_in_first_half ? halves : halves - 1.0;
      return std::uint8_t (from[channel] + part * (to[channel] - from[channel]));
    };
    return {mixed (0), mixed (1), mixed (2)};
  }
};

inline bool
isXYZFinite (const PointXYZ& point)
{
  return point.getVector3fMap().allFinite();
}

inline bool
isFinite (const PointXYZ& point)
{
  return isXYZFinite (point);
}

template <typename Number>
Number
deg2rad (Number degrees)
{
  return degrees * static_cast<Number> (0.017453292519943295); // pi / 180
}

using std::make_shared;
using std::shared_ptr;

template <typename PointT>
struct PointCloud {
  using Ptr = std::shared_ptr<PointCloud>;
  using ConstPtr = std::shared_ptr<const PointCloud>;

  PointCloud() = default;
  /** \brief Copies the points with these indices, in their order. */
  PointCloud (const PointCloud& other, const Indices& indices)
  : is_dense (other.is_dense)
  , sensor_origin_ (other.sensor_origin_)
  , sensor_orientation_ (other.sensor_orientation_)
  {
    for (const index_t i : indices)
      push_back (other[static_cast<std::size_t> (i)]);
  }

  // clang-format off
  bool empty () const { return points.empty(); }
  std::size_t size () const { return points.size(); }
  void reserve (std::size_t size) { points.reserve (size); }
  void push_back (const PointT& point) { emplace_back (point); }
  const PointT& operator[] (std::size_t i) const { return points[i]; }
  PointT& operator[] (std::size_t i) { return points[i]; }
  auto begin () { return points.begin(); }
  auto end () { return points.end(); }
  auto begin () const { return points.begin(); }
  auto end () const { return points.end(); }
  // clang-format on

  /** \brief Adds a point. The cloud is then no image: its height is 1. */
  template <typename... Args>
  void
  emplace_back (Args... args)
  {
    points.emplace_back (args...);
    width = static_cast<uindex_t> (points.size());
    height = 1;
  }

  std::vector<PointT> points;
  uindex_t width = 0;
  uindex_t height = 0;
  bool is_dense = true;
  Eigen::Vector4f sensor_origin_ = Eigen::Vector4f::Zero();
  Eigen::Quaternionf sensor_orientation_ = Eigen::Quaternionf::Identity();
};

// Types that the detector classes name. Builds without PCL make no objects of them.
template <typename PointT>
class PCLBase;
template <typename PointT>
class PlanarRegion;
struct ModelCoefficients {
  PCLHeader header;
};
struct PointIndices {
  PCLHeader header;
  Indices indices;
};
namespace search {
template <typename PointT>
class Search;
}

// Does nothing: without PCL there are no messages of PCL to silence.
namespace console {
constexpr int L_ALWAYS = 0;
inline void
setVerbosityLevel (int)
{}
} // namespace console

} // namespace pcl
