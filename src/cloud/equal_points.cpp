// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/equal_points.h"

#include "base/radix_sort.h"
#include "base/vectorized.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <tuple>

namespace pcl_ops::internal {
namespace {

bool
isFinite (float value)
{
  return std::abs (value) <= std::numeric_limits<float>::max();
}

// Hashes points: equal points, also those with zero and minus zero, have equal hashes.
// Mixes in one coordinate after the other, so that integers and other coordinates whose
// low bits are zero give all hashes about equally often, too. The factors are odd
// constants of well-known hashes.
PCL_OPS_VECTORIZED void
computeHashes (const float* x,
               const float* y,
               const float* z,
               std::size_t count,
               std::uint32_t* hashes)
{
  const auto mix = [] (std::uint32_t hash, float value) {
    const float with_one_zero = value + 0.0f; // turns minus zero into zero
    std::uint32_t bits;
    std::memcpy (&bits, &with_one_zero, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b1u;
    hash = (hash ^ hash >> 15) * 0x85ebca6bu;
    return hash ^ hash >> 13;
  };
  for (std::size_t i = 0; i < count; ++i)
    hashes[i] = mix (mix (mix (0x7feb352du, x[i]), y[i]), z[i]);
}

// Calls visit (i, hash) with the index and the hash of each finite point.
template <typename Visit>
void
forFinitePoints (const Coordinates& points, Visit&& visit)
{
  constexpr std::size_t points_at_once = 1024; // chosen by hand, changes only the time
  std::array<std::uint32_t, points_at_once> hashes;
  for (std::size_t begin = 0; begin < points.size(); begin += points_at_once) {
    const std::size_t count = std::min (points_at_once, points.size() - begin);
    const float* x = &points.x[begin];
    const float* y = &points.y[begin];
    const float* z = &points.z[begin];
    computeHashes (x, y, z, count, hashes.data());
    for (std::size_t i = 0; i < count; ++i)
      if (isFinite (x[i]) && isFinite (y[i]) && isFinite (z[i]))
        visit (begin + i, hashes[i]);
  }
}

// Estimates the mean, over all finite points, of the number of points at their place: 1
// if all are distinct, 1 + q if the share q of all points is in pairs; 0 without finite
// points. It counts the points in buckets by the lowest bits of their hashes, and
// subtracts what distinct points give on average. The standard deviation of the
// estimate is sqrt (2 / buckets) = 0.022.
double
estimatedPointsPerPlace (const Coordinates& points)
{
  constexpr std::size_t buckets = 4096;
  std::array<std::uint32_t, buckets> counts{};
  forFinitePoints (points,
                   [&] (std::size_t, std::uint32_t hash) { ++counts[hash % buckets]; });
  double all_points = 0.0;
  double sum_of_squared_counts = 0.0;
  for (const double count : counts) {
    all_points += count;
    sum_of_squared_counts += count * count;
  }
  return all_points > 0.0
             ? sum_of_squared_counts / all_points - (all_points - 1.0) / buckets
             : 0.0;
}

/** \brief Finite points sorted so that equal points follow each other, by ascending
 * index. */
struct SortedByPlace {
  /** \brief The hash of a point in the upper 32 bits, its index in the lower ones. */
  using Key = std::uint64_t;
  static constexpr int bits_of_index = 32;

  const Coordinates& points;
  std::vector<Key> keys;

  SortedByPlace (const Coordinates& all_points, unsigned threads) : points (all_points)
  {
    keys.reserve (points.size());
    forFinitePoints (points, [&] (std::size_t i, std::uint32_t hash) {
      keys.push_back (static_cast<Key> (hash) << bits_of_index | i);
    });
    std::vector<Key> spare (keys.size());
    const auto hashOfKey = [] (Key key) { return hashOf (key); };
    const Key* const sorted =
        radixSort (threads, keys.data(), keys.size(), spare.data(), hashOfKey);
    if (sorted == spare.data())
      keys.swap (spare);
    sortWithinHashes();
  }

  static std::uint64_t
  hashOf (Key key)
  {
    return key >> bits_of_index;
  }

  static std::uint32_t
  indexOf (Key key)
  {
    return static_cast<std::uint32_t> (key);
  }

  std::tuple<float, float, float>
  placeOf (Key key) const
  {
    const std::uint32_t i = indexOf (key);
    return {points.x[i], points.y[i], points.z[i]};
  }

  // Returns the index in keys behind the last point at the place of keys[begin].
  std::size_t
  endOfPlace (std::size_t begin) const
  {
    std::size_t end = begin + 1;
    while (end < keys.size() && placeOf (keys[end]) == placeOf (keys[begin]))
      ++end;
    return end;
  }

  // Separates the points of different places that have the same hash.
  void
  sortWithinHashes ()
  {
    for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
      const std::uint64_t hash = hashOf (keys[begin]);
      bool is_one_place = true;
      for (end = begin; end < keys.size() && hashOf (keys[end]) == hash; ++end)
        is_one_place = is_one_place && placeOf (keys[end]) == placeOf (keys[begin]);
      if (!is_one_place)
        std::sort (keys.begin() + begin, keys.begin() + end, [&] (Key a, Key b) {
          return std::tuple (placeOf (a), a) < std::tuple (placeOf (b), b);
        });
    }
  }
};

/** \brief The first point at each place, and sums over the points that are readings. */
struct ReadingStatistics {
  FirstAtPlace first_at_place;
  double readings = 0.0; // number of readings
  /** \brief Sum over places of the squared number of readings there. */
  double sum_of_squared_counts = 0.0;
};

ReadingStatistics
statisticsOf (const SortedByPlace& sorted)
{
  // The points of a place are missing readings if two conditions hold. They are more
  // than max_mean_counts times the mean number of points per place: no place of a cloud
  // that repeats all its points equally often has so many. And they alone add more than
  // max_added_to_mean to the mean, over all points, of the number of points at their
  // place. Both limits were chosen by hand.
  constexpr double max_mean_counts = 16.0;
  constexpr double max_added_to_mean = 0.25;
  const std::size_t size = sorted.keys.size();
  double places = 0.0;
  for (std::size_t begin = 0; begin < size; begin = sorted.endOfPlace (begin))
    ++places;
  const auto all_points = static_cast<double> (size);
  ReadingStatistics statistics{FirstAtPlace (sorted.points.size(), no_reading)};
  for (std::size_t begin = 0, end = 0; begin < size; begin = end) {
    end = sorted.endOfPlace (begin);
    const auto count = static_cast<double> (end - begin);
    const bool are_missing_readings = count > max_mean_counts * all_points / places &&
                                      count * count > max_added_to_mean * all_points;
    if (are_missing_readings)
      continue;
    statistics.readings += count;
    statistics.sum_of_squared_counts += count * count;
    const std::uint32_t first = SortedByPlace::indexOf (sorted.keys[begin]);
    for (std::size_t i = begin; i < end; ++i)
      statistics.first_at_place[SortedByPlace::indexOf (sorted.keys[i])] = first;
  }
  return statistics;
}

} // namespace

FirstAtPlace
firstAtPlace (const Coordinates& points, unsigned threads)
{
  // Smallest means, over points, of the number of points at their place, at which equal
  // points matter. The mean is 1 if all points are distinct; min_estimate is more than
  // 4 standard deviations of the estimate above that. A fifth of the readings in pairs
  // gives min_mean_of_readings, chosen by hand.
  constexpr double min_estimate = 1.1;
  constexpr double min_mean_of_readings = 1.2;
  if (estimatedPointsPerPlace (points) < min_estimate)
    return {};
  const SortedByPlace sorted (points, threads);
  ReadingStatistics statistics = statisticsOf (sorted);
  if (statistics.sum_of_squared_counts >= min_mean_of_readings * statistics.readings)
    return statistics.first_at_place;
  const bool are_all_readings =
      statistics.readings == static_cast<double> (sorted.keys.size());
  if (are_all_readings)
    return {};
  // Too few readings are equal: each one stays as a point of its own.
  for (std::size_t i = 0; i < points.size(); ++i)
    if (statistics.first_at_place[i] != no_reading)
      statistics.first_at_place[i] = static_cast<std::uint32_t> (i);
  return statistics.first_at_place;
}

} // namespace pcl_ops::internal
