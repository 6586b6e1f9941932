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

/** \brief Returns a sample of the finite points, evenly spread over their indices, so
 * that about the same percentage of points is at a place in the sample as in the cloud.
 */
Positions
sampleOf (const XyzCloud& cloud)
{
  // The sample has less than twice as many; 0.5 % of these are 20 points (damageOf).
  constexpr std::size_t min_size = 4096;
  const std::size_t step = std::max<std::size_t> (1, cloud.size() / min_size);
  Positions sample;
  for (std::size_t i = 0; i < cloud.size(); i += step)
    if (pcl::isXYZFinite (cloud[i]))
      sample.push_back (cloud[i].getVector3fMap().cast<double>());
  return sample;
}

/** \brief The place of the most points of a sample. */
struct SharedPlace {
  Eigen::Vector3d position;
  /** \brief Number of points at this place. */
  std::size_t point_count;
  /** \brief Number of all places of the sample. */
  std::size_t place_count;
};

/** \param[in] positions of the points of a sample, at least one */
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
  const auto& [coordinates, point_count] = *most_shared;
  return {Eigen::Vector3d (coordinates.data()), point_count, points_at.size()};
}

/** \brief Returns the number of outliers. The points are sorted by their distance from
 * the median. The first outlier is in the farther half: its distance from the median is
 * more than a thousand times the diagonal of the bounding box of all nearer points. All
 * farther points are outliers, too. */
std::size_t
countOutliers (Positions positions)
{
  constexpr double max_distance_in_diagonals = 1000.0; // as the message says
  const Eigen::Vector3d median = quantileOfEach (positions, 0.5);
  const auto is_nearer = [&] (const auto& first, const auto& second) {
    return (first - median).squaredNorm() < (second - median).squaredNorm();
  };
  std::sort (positions.begin(), positions.end(), is_nearer);
  Eigen::AlignedBox3d nearer;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double diagonal = nearer.diagonal().norm();
    const bool is_outlier =
        2 * i > positions.size() && diagonal > 0.0 &&
        (positions[i] - median).norm() > max_distance_in_diagonals * diagonal;
    if (is_outlier)
      return positions.size() - i;
    nearer.extend (positions[i]);
  }
  return 0;
}

/** \brief Returns which percentage of \p all is \p count, as text: "12 %". */
std::string
percentText (std::size_t count, std::size_t all)
{
  // From here on two digits would show 1e+02.
  constexpr double nearly_all = 99.5; // [%]
  const double percent =
      100.0 * static_cast<double> (count) / static_cast<double> (all);
  return str (format (percent < nearly_all ? "%.2g %%" : "%.3g %%") % percent);
}

/** \brief Whether single precision holds all coordinates exactly.
 * \param[in] size number of points */
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

/** \brief An order of positions: by x, then y, then z. */
bool
isBefore (const Eigen::Vector3d& first, const Eigen::Vector3d& second)
{
  return std::lexicographical_compare (
      first.begin(), first.end(), second.begin(), second.end());
}

/** \brief Returns the finite places with the smallest hashes, sorted by their
 * coordinates: about \p wanted or fewer. The choice does not depend on the order of the
 * points.
 * \param[in] size number of all points */
Positions
placesBySmallestHash (std::size_t size,
                      const PositionOf& position_of,
                      std::size_t wanted)
{
  const auto points_per_chosen_one = static_cast<std::uint32_t> (size / wanted + 1);
  const std::uint32_t max_hash =
      std::numeric_limits<std::uint32_t>::max() / points_per_chosen_one;
  Positions places;
  for (std::size_t i = 0; i < size; ++i)
    if (const Eigen::Vector3d position = position_of (i);
        hashOf (position) <= max_hash && position.allFinite())
      places.push_back (position);
  std::sort (places.begin(), places.end(), isBefore);
  places.erase (std::unique (places.begin(), places.end()), places.end());
  return places;
}

/** \brief Returns the median of places, rounded to a multiple of a step. The step is
 * the least power of two that is 16 times the median absolute deviation or more. So
 * clouds of the same surroundings nearly always have the same rounded median, and
 * clouds around zero have zero. The library rounds the origin of its frame in the same
 * way. Zero if there are no places; not rounded if the deviation is 0. */
Eigen::Vector3d
roundedMedian (const Positions& places)
{
  constexpr double min_step_in_deviations = 16.0;
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
  const double step =
      std::exp2 (std::ceil (std::log2 (min_step_in_deviations * deviation)));
  return (median / step + Eigen::Vector3d::Constant (0.5)).array().floor() * step;
}

} // namespace

std::uint32_t
hashOf (const Eigen::Vector3d& position)
{
  constexpr std::uint64_t multiplier = 0x9e3779b97f4a7c15u; // 2^64 / golden ratio, odd
  std::uint64_t hash = 0;
  for (const double coordinate : position) {
    const double without_minus_zero = coordinate + 0.0; // -0.0 becomes 0.0
    std::uint64_t bits;
    std::memcpy (&bits, &without_minus_zero, sizeof bits);
    hash = (hash ^ bits) * multiplier;
    hash ^= hash >> 32; // mixes the upper bits into the lower ones, which are returned
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
  constexpr std::size_t min_points = 10; // percentages of fewer points tell nothing
  // In units of the mean number of points at a place: on a coarse grid points coincide,
  // too, but at every place about as many. Chosen by hand, as the next number.
  constexpr std::size_t min_points_of_missing_readings = 16;
  constexpr double max_outlier_share = 0.005; // of the sample
  const Positions sample = sampleOf (*shifted.cloud);
  const std::size_t size = sample.size();
  if (size < min_points)
    return "";
  const SharedPlace shared = mostSharedPlace (sample);
  const Eigen::Vector3d position = shared.position + shifted.shift;
  // 10 digits show UTM coordinates to the millimeter.
  const std::string shared_text =
      str (format ("%s of its points are at (%.10g, %.10g, %.10g)") %
           percentText (shared.point_count, size) % position.x() % position.y() %
           position.z());
  if (2 * shared.point_count > size)
    return "looks damaged: " + shared_text +
           "; leave missing readings out or write them as NaN";
  const std::size_t outliers = countOutliers (sample);
  if (static_cast<double> (outliers) > max_outlier_share * static_cast<double> (size))
    return "looks damaged: " + percentText (outliers, size) +
           " of its points are more than 1000 times as far away as the rest is wide; "
           "leave them out";
  const bool is_at_least_one_percent = 100 * shared.point_count >= size;
  const bool is_far_above_mean =
      shared.point_count * shared.place_count > min_points_of_missing_readings * size;
  if (is_at_least_one_percent && is_far_above_mean && shared.point_count >= min_points)
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
  // So many places that their median lies near most points; chosen by hand.
  constexpr std::size_t wanted = 8192;
  Positions places = placesBySmallestHash (size, position_of, wanted);
  // If all points are at few places, all hashes may be too large. Then all places
  // count.
  if (places.empty())
    places = placesBySmallestHash (size, position_of, size + 1);
  return roundedMedian (places);
}

} // namespace pcl_ops::apps
