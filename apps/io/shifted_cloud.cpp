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
#include <tuple>
#include <utility>

namespace pcl_ops::apps {

namespace {

using boost::format;
using Places = std::vector<Eigen::Vector3d>;

/** \brief Returns a sample of the finite points, evenly spread over the indices: a
 * share of the sample is about that of the cloud. */
Places
someOf (const XyzCloud& cloud)
{
  constexpr std::size_t most = 4096;
  const std::size_t step = std::max<std::size_t> (1, cloud.size() / most);
  Places places;
  for (std::size_t i = 0; i < cloud.size(); i += step)
    if (pcl::isXYZFinite (cloud[i]))
      places.push_back (cloud[i].getVector3fMap().cast<double>());
  return places;
}

/** \brief Returns the place that most points share, the number of these points, and the
 * number of distinct places. */
std::tuple<Eigen::Vector3d, std::size_t, std::size_t>
mostSharedPlace (const Places& places)
{
  std::map<std::array<double, 3>, std::size_t> counts;
  for (const Eigen::Vector3d& place : places)
    ++counts[{place.x(), place.y(), place.z()}];
  const auto most = std::max_element (
      counts.begin(), counts.end(), [] (const auto& a, const auto& b) {
        return a.second < b.second;
      });
  return {Eigen::Vector3d (most->first.data()), most->second, counts.size()};
}

/** \brief Returns the number of outliers: points sorted by distance from the median
 * count from the first one that is farther than a thousand diagonals of the bounding
 * box of all nearer ones, at least half of the points. */
std::size_t
countFar (Places places)
{
  constexpr double max_diagonals = 1000.0;
  const Eigen::Vector3d middle = quantileOfEach (places, 0.5);
  std::sort (places.begin(), places.end(), [&] (const auto& first, const auto& second) {
    return (first - middle).squaredNorm() < (second - middle).squaredNorm();
  });
  Eigen::AlignedBox3d rest;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_beyond =
        2 * i > places.size() && rest.diagonal().norm() > 0.0 &&
        (places[i] - middle).norm() > max_diagonals * rest.diagonal().norm();
    if (is_beyond)
      return places.size() - i;
    rest.extend (places[i]);
  }
  return 0;
}

std::string
perCent (std::size_t count, std::size_t all)
{
  constexpr double nearly_all = 99.5;
  const double share = 100.0 * static_cast<double> (count) / static_cast<double> (all);
  return str (format (share < nearly_all ? "%.2g %%" : "%.3g %%") % share);
}

/** \brief Whether all coordinates are exact in single precision. */
bool
isExactInSingle (const CoordinateReader& reader, std::size_t size)
{
  const auto isExact = [] (double value) {
    return std::isnan (value) ||
           static_cast<double> (static_cast<float> (value)) == value;
  };
  for (std::size_t i = 0; i < size && !reader.is_single; ++i) {
    const Eigen::Vector3d place = reader (i);
    if (!std::all_of (place.begin(), place.end(), isExact))
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

/** \brief Returns at most about \p wanted distinct finite places, sorted. Which ones
 * does not depend on the order of the points. */
Places
sampleByHash (std::size_t size, const PlaceOf& placeOf, std::size_t wanted)
{
  const auto share = static_cast<std::uint32_t> (size / wanted + 1);
  const std::uint32_t last_taken = std::numeric_limits<std::uint32_t>::max() / share;
  Places places;
  for (std::size_t i = 0; i < size; ++i)
    if (const Eigen::Vector3d place = placeOf (i);
        hashOf (place) <= last_taken && place.allFinite())
      places.push_back (place);
  std::sort (places.begin(), places.end(), isBefore);
  places.erase (std::unique (places.begin(), places.end()), places.end());
  return places;
}

/** \brief Returns the median, rounded to a multiple of a power of two that is at least
 * 16 times the median absolute deviation, as the library takes its frame. So it is
 * nearly always the same for other points of the same surroundings, and zero for those
 * around zero. Zero for no points; not rounded for deviation 0. */
Eigen::Vector3d
roundedMedian (Places places)
{
  constexpr double deviations = 16.0;
  if (places.empty())
    return Eigen::Vector3d::Zero();
  const Eigen::Vector3d median = quantileOfEach (places, 0.5);
  for (Eigen::Vector3d& place : places)
    place = (place - median).cwiseAbs();
  const double deviation = quantileOfEach (places, 0.5).maxCoeff();
  if (!(deviation > 0.0 && std::isfinite (deviation)))
    return median;
  const double step = std::exp2 (std::ceil (std::log2 (deviations * deviation)));
  return (median / step + Eigen::Vector3d::Constant (0.5)).array().floor() * step;
}

} // namespace

std::uint32_t
hashOf (const Eigen::Vector3d& place)
{
  std::uint64_t hash = 0;
  for (const double coordinate : place) {
    const double same = coordinate + 0.0; // minus zero becomes zero
    std::uint64_t bits;
    std::memcpy (&bits, &same, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15u;
    hash ^= hash >> 32;
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
  constexpr std::size_t min_places = 10;
  // On a coarse grid points coincide, too, but about as many at every place.
  constexpr std::size_t times_of_a_place = 16;
  // Half of one per cent, as a sample may have fewer of the far points.
  constexpr double far_share = 0.005;
  const Places places = someOf (*shifted.cloud);
  if (places.size() < min_places)
    return "";
  const auto [shared_place, shared, different] = mostSharedPlace (places);
  const Eigen::Vector3d place = shared_place + shifted.shift;
  // 10 digits: UTM coordinates to the millimeter.
  const std::string shared_share =
      str (format ("%s of its points are at (%.10g, %.10g, %.10g)") %
           perCent (shared, places.size()) % place.x() % place.y() % place.z());
  const std::size_t far = countFar (places);
  if (2 * shared > places.size())
    return "looks damaged: " + shared_share +
           "; leave missing readings out or write them as NaN";
  if (static_cast<double> (far) > far_share * static_cast<double> (places.size()))
    return "looks damaged: " + perCent (far, places.size()) +
           " of its points are more than 1000 times as far away as the rest is wide; "
           "leave them out";
  if (100 * shared >= places.size() && shared >= min_places &&
      shared * different > times_of_a_place * places.size())
    return "is missing readings: " + shared_share +
           " and count as such; leave them out or write them as NaN";
  return "";
}

Places
somePlaces (std::size_t size, const PlaceOf& place, std::size_t looked_at)
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

Eigen::Vector3d
localOrigin (std::size_t size, const PlaceOf& place)
{
  constexpr std::size_t looked_at = 8192;
  Places places = sampleByHash (size, place, looked_at);
  // If all points are at few places, the hash may take none of them.
  if (places.empty())
    places = sampleByHash (size, place, size + 1);
  return roundedMedian (std::move (places));
}

} // namespace pcl_ops::apps
