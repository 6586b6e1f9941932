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

constexpr std::size_t at_once = 1024;
using Hashes = std::array<std::uint32_t, at_once>;

bool
isFinite (float value)
{
  return std::abs (value) <= std::numeric_limits<float>::max();
}

// Mixes in one coordinate after the other, so that integers and other coordinates with
// zero low bits spread over all hashes, too. Zero and minus zero are equal.
PCL_OPS_VECTORIZED void
hashPlaces (const float* x,
            const float* y,
            const float* z,
            std::size_t number,
            std::uint32_t* hashes)
{
  const auto mix = [] (std::uint32_t hash, float value) {
    const float same = value + 0.0f;
    std::uint32_t bits;
    std::memcpy (&bits, &same, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b1u;
    hash = (hash ^ hash >> 15) * 0x85ebca6bu;
    return hash ^ hash >> 13;
  };
  for (std::size_t i = 0; i < number; ++i)
    hashes[i] = mix (mix (mix (0x7feb352du, x[i]), y[i]), z[i]);
}

// Calls visit (i, hash) for all finite points.
template <typename Visit>
void
forHashes (const Coordinates& points, Visit&& visit)
{
  Hashes hashes;
  for (std::size_t begin = 0; begin < points.size(); begin += at_once) {
    const std::size_t number = std::min (at_once, points.size() - begin);
    const float* x = &points.x[begin];
    const float* y = &points.y[begin];
    const float* z = &points.z[begin];
    hashPlaces (x, y, z, number, hashes.data());
    for (std::size_t i = 0; i < number; ++i)
      if (isFinite (x[i]) && isFinite (y[i]) && isFinite (z[i]))
        visit (begin + i, hashes[i]);
  }
}

// Estimates the mean over all points of the number of points at their place: 1 if all
// are distinct, 1 + q if a share q is in pairs. Counts points with equal hash bits. The
// standard deviation is sqrt (2 / buckets) = 0.022.
double
estimatedPointsOfAPlace (const Coordinates& points)
{
  constexpr std::size_t buckets = 4096;
  std::array<std::uint32_t, buckets> counts{};
  forHashes (points,
             [&] (std::size_t, std::uint32_t hash) { ++counts[hash % buckets]; });
  double all = 0.0;
  double squares = 0.0;
  for (const double count : counts) {
    all += count;
    squares += count * count;
  }
  return all > 0.0 ? squares / all - (all - 1.0) / buckets : 0.0;
}

/** \brief Finite points sorted so that equal points follow each other. */
struct SortedByPlace {
  const Coordinates& points;
  /** \brief The hash of each point in the upper half, its index in the lower half. */
  std::vector<std::uint64_t> keys;

  SortedByPlace (const Coordinates& of, unsigned threads) : points (of)
  {
    keys.reserve (points.size());
    forHashes (points, [&] (std::size_t i, std::uint32_t hash) {
      keys.push_back (static_cast<std::uint64_t> (hash) << 32 | i);
    });
    std::vector<std::uint64_t> spare (keys.size());
    const auto hashOf = [] (std::uint64_t key) { return key >> 32; };
    const std::uint64_t* const sorted =
        radixSort (threads, keys.data(), keys.size(), spare.data(), hashOf);
    if (sorted == spare.data())
      keys.swap (spare);
    sortWithinHashes();
  }

  std::uint32_t
  number (std::size_t i) const
  {
    return static_cast<std::uint32_t> (keys[i]);
  }

  std::tuple<float, float, float>
  place (std::uint64_t key) const
  {
    const auto i = static_cast<std::uint32_t> (key);
    return {points.x[i], points.y[i], points.z[i]};
  }

  std::size_t
  endOfPlace (std::size_t begin) const
  {
    std::size_t end = begin + 1;
    while (end < keys.size() && place (keys[end]) == place (keys[begin]))
      ++end;
    return end;
  }

  // Separates the points of different places that have the same hash.
  void
  sortWithinHashes ()
  {
    for (std::size_t begin = 0, end = 0; begin < keys.size(); begin = end) {
      const std::uint64_t hash = keys[begin] >> 32;
      bool is_one_place = true;
      for (end = begin; end < keys.size() && keys[end] >> 32 == hash; ++end)
        is_one_place = is_one_place && place (keys[end]) == place (keys[begin]);
      if (!is_one_place)
        std::sort (keys.begin() + begin, keys.begin() + end, [&] (auto a, auto b) {
          return std::tuple (place (a), a) < std::tuple (place (b), b);
        });
    }
  }
};

/** \brief The first point at each place, and sums over the points that are readings. */
struct ReadingStatistics {
  FirstAtPlace first;
  double readings = 0.0;
  /** \brief Sum over places of the squared number of readings there. */
  double squares = 0.0;
};

ReadingStatistics
equalityOf (const SortedByPlace& sorted)
{
  // A place has no readings if it has more than max_times the average points of a place
  // and if their number squared exceeds max_squares times all points.
  constexpr double max_times = 16.0;
  constexpr double max_squares = 0.25;
  const std::size_t size = sorted.keys.size();
  double places = 0.0;
  for (std::size_t begin = 0; begin < size; begin = sorted.endOfPlace (begin))
    ++places;
  const auto all = static_cast<double> (size);
  ReadingStatistics equality{FirstAtPlace (sorted.points.size(), no_reading)};
  for (std::size_t begin = 0, end = 0; begin < size; begin = end) {
    end = sorted.endOfPlace (begin);
    const auto count = static_cast<double> (end - begin);
    if (count > max_times * all / places && count * count > max_squares * all)
      continue;
    equality.readings += count;
    equality.squares += count * count;
    for (std::size_t i = begin; i < end; ++i)
      equality.first[sorted.number (i)] = sorted.number (begin);
  }
  return equality;
}

} // namespace

FirstAtPlace
firstAtPlace (const Coordinates& points, unsigned threads)
{
  // 0.1 above the value for distinct points: more than 4 deviations of the estimate.
  constexpr double may_be_equal = 1.1;
  constexpr double are_equal = 1.2;
  if (estimatedPointsOfAPlace (points) < may_be_equal)
    return {};
  const SortedByPlace sorted (points, threads);
  ReadingStatistics equality = equalityOf (sorted);
  if (equality.squares >= are_equal * equality.readings)
    return equality.first;
  if (equality.readings == static_cast<double> (sorted.keys.size()))
    return {};
  // Too few readings are equal: each one stays as a point of its own.
  for (std::size_t i = 0; i < points.size(); ++i)
    if (equality.first[i] != no_reading)
      equality.first[i] = static_cast<std::uint32_t> (i);
  return equality.first;
}

} // namespace pcl_ops::internal
