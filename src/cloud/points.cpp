// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud/points.h"

#include "base/parallel.h"
#include "base/vectorized.h"
#include "cloud/equal_points.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl_ops::internal {
namespace {

/** \brief The points of a cloud at the indices, or all points if indices is null. */
struct Chosen {
  const CloudView& cloud;
  const pcl::Indices* indices;

  std::size_t
  size () const
  {
    return indices ? indices->size() : cloud.size;
  }

  const float*
  operator[] (std::size_t i) const
  {
    return cloud[indices ? static_cast<std::size_t> ((*indices)[i]) : i];
  }
};

bool
areAscending (const pcl::Indices& indices)
{
  return std::adjacent_find (indices.begin(), indices.end(), std::greater_equal<>()) ==
         indices.end();
}

pcl::Indices
allOf (const CloudView& cloud)
{
  pcl::Indices all (cloud.size);
  std::iota (all.begin(), all.end(), 0);
  return all;
}

bool
isFinite (float x, float y, float z)
{
  constexpr float largest = std::numeric_limits<float>::max();
  // Integers combined by & make no branch, so that the loops below vectorize.
  const int x_is_finite = std::abs (x) <= largest;
  const int y_is_finite = std::abs (y) <= largest;
  const int z_is_finite = std::abs (z) <= largest;
  return (x_is_finite & y_is_finite & z_is_finite) != 0;
}

bool
areFinite (const Coordinates& points, std::size_t begin, std::size_t end)
{
  int all = 1;
  for (std::size_t i = begin; i < end; ++i)
    all &= isFinite (points.x[i], points.y[i], points.z[i]) ? 1 : 0;
  return all != 0;
}

// Bits of a coordinate to hash: all, or its sign and the upper 12 bits of its mantissa,
// 1 mm at 4 m. The latter omit the exponent, so units that differ by a power of two
// give the same hash, and the last digits, so rounding seldom matters.
constexpr std::uint32_t all_bits = 0xffffffff;
constexpr std::uint32_t leading_bits = 0x807ff800;

// Pseudorandom numbers that depend on the coordinates of a point, not on its index.
PCL_OPS_VECTORIZED void
hashAll (const float* x,
         const float* y,
         const float* z,
         std::size_t number,
         std::uint32_t used_bits,
         std::uint32_t* hashes)
{
  const auto bits = [used_bits] (float value) {
    std::uint32_t same;
    std::memcpy (&same, &value, sizeof same);
    return same & used_bits;
  };
  for (std::size_t i = 0; i < number; ++i) {
    std::uint32_t hash = bits (x[i]) * 0x9e3779b1u ^ bits (y[i]) * 0x85ebca6bu ^
                         bits (z[i]) * 0xc2b2ae35u;
    hash = (hash ^ hash >> 16) * 0x7feb352du;
    hashes[i] = hash ^ hash >> 15;
  }
}

// Indices of at most about as many of the finite points as wanted.
Indices
numbersByHash (const Coordinates& positions,
               std::size_t wanted,
               std::uint32_t used_bits)
{
  constexpr std::size_t at_once = 1024;
  const auto share = static_cast<std::uint32_t> (positions.size() / wanted + 1);
  const std::uint32_t last_taken = std::numeric_limits<std::uint32_t>::max() / share;
  std::array<std::uint32_t, at_once> hashes;
  Indices some;
  for (std::size_t begin = 0; begin < positions.size(); begin += at_once) {
    const std::size_t number = std::min (at_once, positions.size() - begin);
    const float* x = &positions.x[begin];
    const float* y = &positions.y[begin];
    const float* z = &positions.z[begin];
    hashAll (x, y, z, number, used_bits, hashes.data());
    for (std::size_t i = 0; i < number; ++i)
      if (hashes[i] <= last_taken && isFinite (x[i], y[i], z[i]))
        some.push_back (static_cast<std::uint32_t> (begin + i));
  }
  return some;
}

Coordinates
sampleByHash (const Coordinates& positions, std::size_t wanted, std::uint32_t used_bits)
{
  return selected (positions, numbersByHash (positions, wanted, used_bits));
}

// Rounds the median to a multiple of many times the median absolute deviation. So other
// points of the same surroundings nearly always give the same result.
Eigen::Vector3d
roundedMedian (Coordinates points)
{
  constexpr double deviations = 16.0;
  Eigen::Vector3d median;
  double deviation = 0.0;
  Eigen::Index axis = 0;
  for (std::vector<float>* along : {&points.x, &points.y, &points.z}) {
    const double middle = medianOf (*along);
    median[axis] = middle;
    ++axis;
    for (float& value : *along)
      value = std::abs (value - static_cast<float> (middle));
    deviation = std::max (deviation, medianOf (*along));
  }
  if (!(deviation > 0.0 && std::isfinite (deviation)))
    return median;
  const double step = std::exp2 (std::ceil (std::log2 (deviations * deviation)));
  return (median / step).array().round() * step;
}

Coordinates
withoutCopies (const Coordinates& points)
{
  std::vector<std::array<float, 3>> places (points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    places[i] = {points.x[i], points.y[i], points.z[i]};
  std::sort (places.begin(), places.end());
  places.erase (std::unique (places.begin(), places.end()), places.end());
  Coordinates distinct;
  for (const auto& [x, y, z] : places)
    distinct.add (x, y, z);
  return distinct;
}

// Position near the median of a sample: near most points in spite of outliers, in any
// order of the points; zero without finite points.
Eigen::Vector3d
localOrigin (const Coordinates& points)
{
  constexpr std::size_t looked_at = 100;
  Coordinates some = sampleByHash (points, looked_at, all_bits);
  // The sample may be empty: of equal points the hash takes none or all.
  if (some.size() == 0)
    some = sampleByHash (points, points.size() + 1, all_bits);
  return roundedMedian (withoutCopies (some));
}

void
copyPoints (const Chosen& chosen, unsigned threads, Points& points)
{
  points.resize (chosen.size());
  forEach (threads, chosen.size(), [&] (std::size_t i) {
    const float* const position = chosen[i];
    points.x[i] = position[0];
    points.y[i] = position[1];
    points.z[i] = position[2];
  });
}

// Moves points into the frame of their origin; returns whether all are finite.
bool
moveToOrigin (unsigned threads, Points& points)
{
  constexpr std::size_t points_per_piece = 8192;
  const Eigen::Vector3f origin = points.origin.cast<float>();
  std::atomic<bool> all_finite (true);
  const auto move = [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      points.x[i] -= origin.x();
      points.y[i] -= origin.y();
      points.z[i] -= origin.z();
    }
    if (!areFinite (points, begin, end))
      all_finite = false;
  };
  parallelFor (threads, points.size(), points_per_piece, move);
  return all_finite;
}

void
keepFinite (Points& points)
{
  std::size_t left = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = points.x[i];
    const float y = points.y[i];
    const float z = points.z[i];
    // Always written, but counted only if finite: no branch to mispredict.
    points.x[left] = x;
    points.y[left] = y;
    points.z[left] = z;
    points.index[left] = points.index[i];
    left += isFinite (x, y, z);
  }
  points.resize (left);
  points.index.resize (left);
}

/** \brief Indices in the cloud: of the first point at a place, and of a duplicate. */
using IndexPair = std::pair<pcl::index_t, pcl::index_t>;

// Keeps the first point at each place and returns the others. Sets points that are no
// readings to NaN.
std::vector<IndexPair>
takeCopies (Points& points, const FirstAtPlace& first)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<IndexPair> copies;
  const pcl::Indices index = points.index;
  std::size_t left = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool is_reading = first[i] != no_reading;
    if (is_reading && first[i] != i) {
      copies.emplace_back (index[first[i]], index[i]);
      continue;
    }
    points.x[left] = is_reading ? points.x[i] : nan;
    points.y[left] = is_reading ? points.y[i] : nan;
    points.z[left] = is_reading ? points.z[i] : nan;
    points.index[left] = index[i];
    ++left;
  }
  points.resize (left);
  points.index.resize (left);
  return copies;
}

// Looks up the position of each first point in index, which is ascending.
std::vector<Copy>
copiesOf (const pcl::Indices& index, std::vector<IndexPair> pairs)
{
  std::sort (pairs.begin(), pairs.end());
  std::vector<Copy> copies;
  copies.reserve (pairs.size());
  auto place = index.begin();
  for (const auto& [first, copy] : pairs) {
    place = std::lower_bound (place, index.end(), first);
    // A first point is missing if its local coordinates overflowed to infinity.
    if (place != index.end() && *place == first)
      copies.push_back ({copy, static_cast<std::uint32_t> (place - index.begin())});
  }
  std::sort (copies.begin(), copies.end(), [] (const Copy& one, const Copy& other) {
    return one.index < other.index;
  });
  return copies;
}

// Origin near most points, exact in single precision, in which points are moved.
Eigen::Vector3d
originOf (const Coordinates& points, double step)
{
  const Eigen::Vector3d origin = localOrigin (points);
  if (!(step > 0.0))
    return origin;
  return ((origin / step).array().round() * step).matrix().cast<float>().cast<double>();
}

// Implements finitePoints and, with takes_copies, distinctPoints.
Points
readPoints (const CloudView& cloud,
            unsigned threads,
            const pcl::Indices* indices,
            double step,
            bool takes_copies)
{
  if (indices && !areAscending (*indices)) {
    pcl::Indices sorted = *indices;
    std::sort (sorted.begin(), sorted.end());
    sorted.erase (std::unique (sorted.begin(), sorted.end()), sorted.end());
    return readPoints (cloud, threads, &sorted, step, takes_copies);
  }
  const auto chosenIndices = [&] { return indices ? *indices : allOf (cloud); };
  Points points;
  copyPoints ({cloud, indices}, threads, points);
  std::vector<IndexPair> copies;
  const FirstAtPlace first =
      takes_copies ? firstAtPlace (points, threads) : FirstAtPlace();
  if (!first.empty()) {
    points.index = chosenIndices();
    copies = takeCopies (points, first);
  }
  points.origin = originOf (points, step);
  const bool are_finite = moveToOrigin (threads, points);
  if (are_finite && points.size() == cloud.size)
    return points;
  if (points.index.empty())
    points.index = chosenIndices();
  if (!are_finite)
    keepFinite (points);
  points.copies = copiesOf (points.index, std::move (copies));
  return points;
}

} // namespace

Coordinates
selected (const Coordinates& points, const Indices& numbers)
{
  Coordinates some;
  some.resize (numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    some.x[i] = points.x[numbers[i]];
    some.y[i] = points.y[numbers[i]];
    some.z[i] = points.z[numbers[i]];
  }
  return some;
}

Coordinates
samplePoints (const Coordinates& positions, std::size_t wanted)
{
  return sampleByHash (positions, wanted, leading_bits);
}

Indices
sampleNumbers (const Coordinates& positions, std::size_t wanted)
{
  return numbersByHash (positions, wanted, all_bits);
}

double
medianOf (std::vector<float>& values)
{
  if (values.empty())
    return 0.0;
  const auto middle = values.begin() + values.size() / 2;
  std::nth_element (values.begin(), middle, values.end());
  return *middle;
}

Points
finitePoints (const CloudView& cloud,
              unsigned threads,
              const pcl::Indices* indices,
              double step)
{
  return readPoints (cloud, threads, indices, step, false);
}

Points
distinctPoints (const CloudView& cloud,
                unsigned threads,
                const pcl::Indices* indices,
                double step)
{
  return readPoints (cloud, threads, indices, step, true);
}

} // namespace pcl_ops::internal
