// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "shifted_cloud.h"

#include <pcl/common/point_tests.h>

#include <boost/format.hpp>

#include <Eigen/Geometry>

#include <numbers/statistics.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <utility>

namespace pcl_ops::apps {

namespace {

using boost::format;
using Positions = std::vector<Eigen::Vector3d>;

/** \brief Returns a sample of the finite points, evenly spread over the indices: a
 * share of the sample is about that of the cloud. */
Positions
sampleOf (const XyzCloud& cloud)
{
  constexpr std::size_t wanted = 4096; // the sample has less than twice as many
  const std::size_t step = std::max<std::size_t> (1, cloud.size() / wanted);
  Positions sample;
  for (std::size_t i = 0; i < cloud.size(); i += step)
    if (pcl::isXYZFinite (cloud[i]))
      sample.push_back (cloud[i].getVector3fMap().cast<double>());
  return sample;
}

/** \brief The place at which the most points are. */
struct SharedPlace {
  Eigen::Vector3d position;
  /** \brief Number of points at this place. */
  std::size_t points;
  /** \brief Number of distinct places. */
  std::size_t all_places;
};

SharedPlace
mostSharedPlace (const Positions& positions)
{
  std::map<std::array<double, 3>, std::size_t> points_at;
  for (const Eigen::Vector3d& position : positions)
    ++points_at[{position.x(), position.y(), position.z()}];
  const auto most_shared = std::max_element (
      points_at.begin(), points_at.end(), [] (const auto& a, const auto& b) {
        return a.second < b.second;
      });
  const auto& [place, points] = *most_shared;
  return {Eigen::Vector3d (place.data()), points, points_at.size()};
}

/** \brief Returns the number of outliers. The points are sorted by their distance from
 * the median. In the farther half, a point is an outlier if it is farther from the
 * median than a thousand diagonals of the bounding box of all nearer points; so are all
 * points behind the first outlier. */
std::size_t
countFar (Positions positions)
{
  constexpr double max_diagonals = 1000.0;
  const Eigen::Vector3d median = quantileOfEach (positions, 0.5);
  const auto is_nearer = [&] (const auto& first, const auto& second) {
    return (first - median).squaredNorm() < (second - median).squaredNorm();
  };
  std::sort (positions.begin(), positions.end(), is_nearer);
  Eigen::AlignedBox3d nearer;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double diagonal = nearer.diagonal().norm();
    const bool is_outlier = 2 * i > positions.size() && diagonal > 0.0 &&
                            (positions[i] - median).norm() > max_diagonals * diagonal;
    if (is_outlier)
      return positions.size() - i;
    nearer.extend (positions[i]);
  }
  return 0;
}

/** \brief Returns the share as text, "12 %". */
std::string
percentText (std::size_t count, std::size_t all)
{
  constexpr double nearly_all = 99.5; // [%], which two digits would show as 1e+02
  const double percent =
      100.0 * static_cast<double> (count) / static_cast<double> (all);
  return str (format (percent < nearly_all ? "%.2g %%" : "%.3g %%") % percent);
}

/** \brief Whether all coordinates are exact in single precision. */
bool
isExactInSingle (const CoordinateReader& reader, std::size_t size)
{
  const auto is_exact = [] (double value) {
    return std::isnan (value) ||
           static_cast<double> (static_cast<float> (value)) == value;
  };
  for (std::size_t i = 0; i < size && !reader.is_single; ++i) {
    const Eigen::Vector3d position = reader (i);
    if (!std::all_of (position.begin(), position.end(), is_exact))
      return false;
  }
  return true;
}

bool
isBefore (const Eigen::Vector3d& first, const Eigen::Vector3d& second)
{
  return std::lexicographical_compare (
      first.begin(), first.end(), second.begin(), second.end());
}

/** \brief Returns at most about \p wanted finite places, sorted. Which ones does not
 * depend on the order of the points. */
Positions
sampleByHash (std::size_t size, const PositionOf& position_of, std::size_t wanted)
{
  const auto points_for_one = static_cast<std::uint32_t> (size / wanted + 1);
  const std::uint32_t max_hash =
      std::numeric_limits<std::uint32_t>::max() / points_for_one;
  Positions places;
  for (std::size_t i = 0; i < size; ++i)
    if (const Eigen::Vector3d position = position_of (i);
        hashOf (position) <= max_hash && position.allFinite())
      places.push_back (position);
  std::sort (places.begin(), places.end(), isBefore);
  places.erase (std::unique (places.begin(), places.end()), places.end());
  return places;
}

/** \brief Returns the median, rounded to a multiple of a power of two that is at least
 * 16 times the median absolute deviation; the library rounds the origin of its frame in
 * the same way. So it is nearly always the same for other points of the same
 * surroundings, and zero for those around zero. It is zero for no points, and not
 * rounded if the deviation is 0. */
Eigen::Vector3d
roundedMedian (const Positions& places)
{
  constexpr double min_deviations = 16.0;
  if (places.empty())
    return Eigen::Vector3d::Zero();
  const Eigen::Vector3d median = quantileOfEach (places, 0.5);
  Positions deviations;
  deviations.reserve (places.size());
  for (const Eigen::Vector3d& place : places)
    deviations.emplace_back ((place - median).cwiseAbs());
  const double deviation = quantileOfEach (deviations, 0.5).maxCoeff();
  if (!(deviation > 0.0 && std::isfinite (deviation)))
    return median;
  const double step = std::exp2 (std::ceil (std::log2 (min_deviations * deviation)));
  return (median / step + Eigen::Vector3d::Constant (0.5)).array().floor() * step;
}

} // namespace

std::uint32_t
hashOf (const Eigen::Vector3d& position)
{
  constexpr std::uint64_t multiplier = 0x9e3779b97f4a7c15u; // 2^64 / golden ratio, odd
  std::uint64_t hash = 0;
  for (const double coordinate : position) {
    const double without_minus_zero = coordinate + 0.0;
    std::uint64_t bits;
    std::memcpy (&bits, &without_minus_zero, sizeof bits);
    hash = (hash ^ bits) * multiplier;
    hash ^= hash >> 32; // high bits change the low ones, which are returned
  }
  return static_cast<std::uint32_t> (hash);
}

ShiftedCloud
shiftedCloudOf (const FileCloud& cloud, double step)
{
  const CoordinateReader reader (cloud);
  ShiftedCloud shifted;
  const std::size_t size = cloud.size();
  if (step > 0.0)
    shifted.shift = (localOrigin (size, reader) / step).array().round() * step;
  else if (!isExactInSingle (reader, size))
    shifted.shift = localOrigin (size, reader);
  shifted.cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  shifted.cloud->points.reserve (size);
  for (std::size_t i = 0; i < size; ++i) {
    const Eigen::Vector3f point = (reader (i) - shifted.shift).cast<float>();
    shifted.cloud->points.emplace_back (point.x(), point.y(), point.z());
  }
  shifted.cloud->width = cloud.points.width;
  shifted.cloud->height = cloud.points.height;
  shifted.cloud->is_dense = false;
  shifted.cloud->sensor_orientation_ = cloud.orientation.cast<float>();
  shifted.cloud->sensor_origin_.head<3>() =
      (cloud.origin - shifted.shift).cast<float>();
  return shifted;
}

std::string
damageOf (const ShiftedCloud& shifted)
{
  // A share of fewer points says nothing.
  constexpr std::size_t min_points = 10;
  // On a coarse grid points coincide, too, but about as many at every place.
  constexpr std::size_t min_times_mean = 16;
  // Half a percent, as a sample may have fewer of the far points.
  constexpr double max_far_share = 0.005;
  const Positions sample = sampleOf (*shifted.cloud);
  const std::size_t size = sample.size();
  if (size < min_points)
    return "";
  const SharedPlace shared = mostSharedPlace (sample);
  const Eigen::Vector3d position = shared.position + shifted.shift;
  // 10 digits: UTM coordinates to the millimeter.
  const std::string shared_text = str (
      format ("%s of its points are at (%.10g, %.10g, %.10g)") %
      percentText (shared.points, size) % position.x() % position.y() % position.z());
  if (2 * shared.points > size)
    return "looks damaged: " + shared_text +
           "; leave missing readings out or write them as NaN";
  const std::size_t far = countFar (sample);
  if (static_cast<double> (far) > max_far_share * static_cast<double> (size))
    return "looks damaged: " + percentText (far, size) +
           " of its points are more than 1000 times as far away as the rest is wide; "
           "leave them out";
  const bool is_one_percent = 100 * shared.points >= size;
  const bool is_far_above_mean =
      shared.points * shared.all_places > min_times_mean * size;
  if (is_one_percent && is_far_above_mean && shared.points >= min_points)
    return "is missing readings: " + shared_text +
           " and count as such; leave them out or write them as NaN";
  return "";
}

Positions
somePositions (std::size_t size, const PositionOf& position_of, std::size_t max_sample)
{
  const std::size_t stride = size / max_sample + 1;
  Positions sample;
  for (std::size_t begin = 0; begin < size; begin += stride)
    for (std::size_t i = begin; i < std::min (size, begin + stride); ++i)
      if (const Eigen::Vector3d position = position_of (i); position.allFinite()) {
        sample.push_back (position);
        break;
      }
  return sample;
}

Eigen::Vector3d
localOrigin (std::size_t size, const PositionOf& position_of)
{
  constexpr std::size_t wanted = 8192;
  Positions places = sampleByHash (size, position_of, wanted);
  // If all points are at few places, the hash may take none of them.
  if (places.empty())
    places = sampleByHash (size, position_of, size + 1);
  return roundedMedian (places);
}

} // namespace pcl_ops::apps
