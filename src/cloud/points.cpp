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
#include <tuple>
#include <utility>

namespace pcl_ops::internal {
namespace {

/** \brief The points of a cloud with the given indices; all points if indices is null.
 */
struct ChosenPoints {
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

// Returns whether a point is finite.
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

// Returns whether the points begin .. end - 1 are finite.
bool
areFinite (const Coordinates& points, std::size_t begin, std::size_t end)
{
  int all = 1;
  for (std::size_t i = begin; i < end; ++i)
    all &= isFinite (points.x[i], points.y[i], points.z[i]) ? 1 : 0;
  return all != 0;
}

// Bits of a coordinate to hash: all of them, or the leading bits: its sign and the
// upper 12 bits of its mantissa, which at 4 m are steps of 1 mm. The leading bits leave
// out the exponent, so that units that differ by a power of two give the same hash, and
// the last digits, so that rounding seldom changes the hash.
constexpr std::uint32_t all_bits = 0xffffffff;
constexpr std::uint32_t leading_bits = 0x807ff800;

// Hashes points: pseudorandom numbers that depend on the coordinates of a point, not on
// its index.
// \param[in] used_bits of each coordinate: all_bits or leading_bits
PCL_OPS_VECTORIZED void
computeHashes (const float* x,
               const float* y,
               const float* z,
               std::size_t count,
               std::uint32_t used_bits,
               std::uint32_t* hashes)
{
  const auto bitsOf = [used_bits] (float value) {
    std::uint32_t bits;
    std::memcpy (&bits, &value, sizeof bits);
    return bits & used_bits;
  };
  // Odd factors and shifts that mix all bits of the coordinates into those of the hash.
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t hash = bitsOf (x[i]) * 0x9e3779b1u ^ bitsOf (y[i]) * 0x85ebca6bu ^
                         bitsOf (z[i]) * 0xc2b2ae35u;
    hash = (hash ^ hash >> 16) * 0x7feb352du;
    hashes[i] = hash ^ hash >> 15;
  }
}

// Returns the indices of at most about as many of the finite points as wanted: those
// with the smallest hashes.
// \param[in] used_bits as of computeHashes
Indices
indicesByHash (const Coordinates& points, std::size_t wanted, std::uint32_t used_bits)
{
  constexpr std::size_t points_at_once = 1024; // chosen by hand, changes only the time
  // About one of so many points is taken.
  const auto points_per_taken = static_cast<std::uint32_t> (points.size() / wanted + 1);
  const std::uint32_t max_taken_hash =
      std::numeric_limits<std::uint32_t>::max() / points_per_taken;
  std::array<std::uint32_t, points_at_once> hashes;
  Indices taken;
  for (std::size_t begin = 0; begin < points.size(); begin += points_at_once) {
    const std::size_t count = std::min (points_at_once, points.size() - begin);
    const float* x = &points.x[begin];
    const float* y = &points.y[begin];
    const float* z = &points.z[begin];
    computeHashes (x, y, z, count, used_bits, hashes.data());
    for (std::size_t i = 0; i < count; ++i)
      if (hashes[i] <= max_taken_hash && isFinite (x[i], y[i], z[i]))
        taken.push_back (static_cast<std::uint32_t> (begin + i));
  }
  return taken;
}

Coordinates
sampleByHash (const Coordinates& points, std::size_t wanted, std::uint32_t used_bits)
{
  return selected (points, indicesByHash (points, wanted, used_bits));
}

// Returns the median along each axis, rounded to a multiple of a step. The step is a
// power of two, 16 to 32 times the largest median absolute deviation of the three axes:
// other samples of the same cloud nearly always give the same result. A larger step
// would move the origin farther away from the points.
Eigen::Vector3d
roundedMedian (Coordinates points)
{
  constexpr double deviations_of_step = 16.0;
  Eigen::Vector3d median;
  double largest_deviation = 0.0;
  Eigen::Index axis = 0;
  for (std::vector<float>* values : {&points.x, &points.y, &points.z}) {
    const double median_of_axis = medianOf (*values);
    median[axis] = median_of_axis;
    ++axis;
    std::vector<float>& deviations = *values; // overwrites the values
    for (float& value : deviations)
      value = std::abs (value - static_cast<float> (median_of_axis));
    largest_deviation = std::max (largest_deviation, medianOf (deviations));
  }
  if (!(largest_deviation > 0.0 && std::isfinite (largest_deviation)))
    return median;
  const double step =
      std::exp2 (std::ceil (std::log2 (deviations_of_step * largest_deviation)));
  return (median / step).array().round() * step;
}

Coordinates
withoutDuplicates (const Coordinates& points)
{
  std::vector<std::array<float, 3>> positions (points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    positions[i] = {points.x[i], points.y[i], points.z[i]};
  std::sort (positions.begin(), positions.end());
  positions.erase (std::unique (positions.begin(), positions.end()), positions.end());
  Coordinates distinct;
  for (const auto& [x, y, z] : positions)
    distinct.add (x, y, z);
  return distinct;
}

// Returns a position near the median of a sample: near most points in spite of
// outliers, and the same for any order of the points; zero without finite points.
Eigen::Vector3d
medianOfSample (const Coordinates& points)
{
  constexpr std::size_t wanted = 100; // chosen by hand: roundedMedian needs no more
  Coordinates sample = sampleByHash (points, wanted, all_bits);
  // The sample may be empty: of equal points the hash takes none or all. Then take all.
  if (sample.size() == 0)
    sample = sampleByHash (points, points.size() + 1, all_bits);
  return roundedMedian (withoutDuplicates (sample));
}

void
copyPoints (const ChosenPoints& chosen, unsigned threads, Points& points)
{
  points.resize (chosen.size());
  forEach (threads, chosen.size(), [&] (std::size_t i) {
    const float* const position = chosen[i];
    points.x[i] = position[0];
    points.y[i] = position[1];
    points.z[i] = position[2];
  });
}

// Moves points to the local frame, by points.origin. Returns whether all are finite
// there.
bool
moveToOrigin (unsigned threads, Points& points)
{
  constexpr std::size_t points_per_piece = 8192; // chosen by hand, for the time
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

// Removes the points that are not finite. points.index must be filled in.
void
keepFinite (Points& points)
{
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float x = points.x[i];
    const float y = points.y[i];
    const float z = points.z[i];
    // Always written, but counted only if finite: no branch to mispredict.
    points.x[kept] = x;
    points.y[kept] = y;
    points.z[kept] = z;
    points.index[kept] = points.index[i];
    kept += isFinite (x, y, z);
  }
  points.resize (kept);
  points.index.resize (kept);
}

/** \brief Two equal points, by their indices in the input cloud. */
struct EqualPoints {
  pcl::index_t first; // of all points at their place
  pcl::index_t duplicate;

  bool
  operator<(const EqualPoints& other) const
  {
    return std::tie (first, duplicate) < std::tie (other.first, other.duplicate);
  }
};

// Keeps the first point at each place, and removes and returns the others. Sets points
// that are no readings to NaN. points.index must be filled in.
// \param[in] first_at_place for each point the index of the first one
std::vector<EqualPoints>
removeDuplicates (const FirstAtPlace& first_at_place, Points& points)
{
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  std::vector<EqualPoints> removed;
  const pcl::Indices index = points.index;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::uint32_t first = first_at_place[i];
    const bool is_reading = first != no_reading;
    if (is_reading && first != i) {
      removed.push_back ({index[first], index[i]});
      continue;
    }
    points.x[kept] = is_reading ? points.x[i] : nan;
    points.y[kept] = is_reading ? points.y[i] : nan;
    points.z[kept] = is_reading ? points.z[i] : nan;
    points.index[kept] = index[i];
    ++kept;
  }
  points.resize (kept);
  points.index.resize (kept);
  return removed;
}

// Makes Points::copies: looks up each first point in Points::index.
// \param[in] index ascending, with all first points
std::vector<Copy>
copiesOf (const pcl::Indices& index, std::vector<EqualPoints> pairs)
{
  std::sort (pairs.begin(), pairs.end());
  std::vector<Copy> copies;
  copies.reserve (pairs.size());
  auto found = index.begin();
  for (const EqualPoints& pair : pairs) {
    found = std::lower_bound (found, index.end(), pair.first);
    copies.push_back (
        {pair.duplicate, static_cast<std::uint32_t> (found - index.begin())});
  }
  std::sort (copies.begin(), copies.end(), [] (const Copy& one, const Copy& other) {
    return one.index < other.index;
  });
  return copies;
}

// Returns the origin of the local frame, near most points. Its coordinates are numbers
// of single precision, in which points are moved to that frame.
// \param[in] step as of finitePoints
Eigen::Vector3d
originOf (const Coordinates& points, double step)
{
  // The distance of two numbers may be too large for single precision. That from a
  // number up to this one is not: it is below half the step at the largest number.
  constexpr double largest_coordinate = 0x1p102;
  Eigen::Array3d origin = medianOfSample (points).array();
  if (step > 0.0)
    origin = (origin / step).round() * step;
  const Eigen::Array3d near_zero =
      (origin.abs() <= largest_coordinate).select (origin, 0.0);
  return near_zero.cast<float>().cast<double>().matrix();
}

enum class EqualPointsAre { Kept, RemovedIfMany };

// Implements finitePoints and distinctPoints.
Points
readPoints (const CloudView& cloud,
            unsigned threads,
            const pcl::Indices* indices,
            double step,
            EqualPointsAre equal_points_are)
{
  if (indices && !areAscending (*indices)) {
    pcl::Indices sorted = *indices;
    std::sort (sorted.begin(), sorted.end());
    sorted.erase (std::unique (sorted.begin(), sorted.end()), sorted.end());
    return readPoints (cloud, threads, &sorted, step, equal_points_are);
  }
  const auto chosenIndices = [&] { return indices ? *indices : allOf (cloud); };
  Points points;
  copyPoints ({cloud, indices}, threads, points);
  std::vector<EqualPoints> duplicates;
  const FirstAtPlace first_at_place = equal_points_are == EqualPointsAre::RemovedIfMany
                                          ? firstAtPlace (points, threads)
                                          : FirstAtPlace();
  if (!first_at_place.empty()) {
    points.index = chosenIndices();
    duplicates = removeDuplicates (first_at_place, points);
  }
  points.origin = originOf (points, step);
  const bool are_finite = moveToOrigin (threads, points);
  const bool are_whole_cloud = are_finite && points.size() == cloud.size;
  if (are_whole_cloud)
    return points;
  if (points.index.empty())
    points.index = chosenIndices();
  if (!are_finite)
    keepFinite (points);
  points.copies = copiesOf (points.index, std::move (duplicates));
  return points;
}

} // namespace

Coordinates
selected (const Coordinates& points, const Indices& indices)
{
  Coordinates chosen;
  chosen.resize (indices.size());
  for (std::size_t i = 0; i < indices.size(); ++i) {
    chosen.x[i] = points.x[indices[i]];
    chosen.y[i] = points.y[indices[i]];
    chosen.z[i] = points.z[indices[i]];
  }
  return chosen;
}

Coordinates
samplePoints (const Coordinates& points, std::size_t wanted)
{
  return sampleByHash (points, wanted, leading_bits);
}

Indices
sampleIndices (const Coordinates& points, std::size_t wanted)
{
  return indicesByHash (points, wanted, all_bits);
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
  return readPoints (cloud, threads, indices, step, EqualPointsAre::Kept);
}

Points
distinctPoints (const CloudView& cloud,
                unsigned threads,
                const pcl::Indices* indices,
                double step)
{
  return readPoints (cloud, threads, indices, step, EqualPointsAre::RemovedIfMany);
}

} // namespace pcl_ops::internal
