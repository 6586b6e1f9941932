// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "thickness.h"

#include <pcl/common/point_tests.h>

#include <Eigen/Geometry>

#include <numbers/statistics.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <tuple>
#include <utility>

namespace pcl_ops::apps {

namespace {

using Eigen::Vector3f;

/** \brief Exact nearest neighbor search by bounding boxes of blocks of 64 points. To
 * compute the boxes takes hardly longer than to read the points. */
class BlockSearch {
public:
  /** \brief Order in which points are put into blocks. If they are sorted as the leaves
   * of a k-d tree, blocks have small boxes. For many queries this saves more time than
   * sorting takes. */
  enum class Order { AsInCloud, Sorted };

  BlockSearch (const XyzCloud& cloud, Order order)
  {
    points_.reserve (cloud.size());
    for (const pcl::PointXYZ& point : cloud)
      if (pcl::isXYZFinite (point))
        points_.emplace_back (point.getVector3fMap());
    if (order == Order::Sorted)
      sort (0, points_.size());
    for (std::size_t first = 0; first < points_.size(); first += block_size) {
      Box box;
      const std::size_t end = std::min (points_.size(), first + block_size);
      for (std::size_t i = first; i < end; ++i)
        box.extend (points_[i]);
      boxes_.push_back (box);
    }
    for (const Vector3f& point : points_) {
      x_.push_back (point.x());
      y_.push_back (point.y());
      z_.push_back (point.z());
    }
  }

  /** \brief Returns the \p count points nearest to \p query, or all points if there are
   * fewer, in any order. */
  std::vector<Vector3f>
  nearest (const Vector3f& query, std::size_t count) const
  {
    std::vector<float> squared_distances;
    for (const Box& box : boxes_)
      squared_distances.push_back (box.squaredExteriorDistance (query));
    const auto nearest_box = std::size_t (
        std::min_element (squared_distances.begin(), squared_distances.end()) -
        squared_distances.begin());
    std::vector<Candidate> best;
    if (!boxes_.empty())
      visit (nearest_box, query, count, best);
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const bool may_be_nearer =
          best.size() < count || squared_distances[i] < best.front().squared_distance;
      if (i != nearest_box && may_be_nearer)
        visit (i, query, count, best);
    }
    std::vector<Vector3f> neighbors;
    for (const Candidate& candidate : best)
      neighbors.push_back (points_[candidate.point]);
    return neighbors;
  }

private:
  using Box = Eigen::AlignedBox3f;
  /** \brief A point that may be one of the nearest ones. */
  struct Candidate {
    /** \brief From the query. */
    float squared_distance;
    /** \brief Index of the point in \ref points_. */
    std::size_t point;

    friend bool
    operator<(const Candidate& a, const Candidate& b)
    {
      return std::tie (a.squared_distance, a.point) <
             std::tie (b.squared_distance, b.point);
    }
  };
  static constexpr std::size_t block_size = 64; // chosen by hand

  /** \brief Sorts the points from index first up to end, which is not included: divides
   * them into two halves along the longest axis of their bounding box, and each half in
   * the same way, until there are blocks. */
  void
  sort (std::size_t first, std::size_t end)
  {
    if (end - first <= block_size)
      return;
    Box box;
    for (std::size_t i = first; i < end; ++i)
      box.extend (points_[i]);
    int axis = 0;
    box.sizes().maxCoeff (&axis);
    // The first half has a whole number of blocks.
    const std::size_t half = (end - first + block_size) / (2 * block_size) * block_size;
    const std::size_t middle = first + std::max (half, block_size);
    const auto begin = points_.begin();
    std::nth_element (
        begin + std::ptrdiff_t (first),
        begin + std::ptrdiff_t (middle),
        begin + std::ptrdiff_t (end),
        [axis] (const Vector3f& a, const Vector3f& b) { return a[axis] < b[axis]; });
    sort (first, middle);
    sort (middle, end);
  }

  /** \brief Puts the points of a block among the best candidates, if they are nearer.
   * \param[in] block index of the block
   * \param[in,out] best a heap of up to count candidates, the farthest one at the
   * front */
  void
  visit (std::size_t block,
         const Vector3f& query,
         std::size_t count,
         std::vector<Candidate>& best) const
  {
    const std::size_t first = block * block_size;
    const std::size_t size = std::min (block_size, points_.size() - first);
    std::array<float, block_size> squared_distances{};
    for (std::size_t i = 0; i < size; ++i) {
      const float x = x_[first + i] - query.x();
      const float y = y_[first + i] - query.y();
      const float z = z_[first + i] - query.z();
      squared_distances[i] = x * x + y * y + z * z;
    }
    const auto is_too_far = [&] (float squared_distance) {
      return best.size() == count && squared_distance >= best.front().squared_distance;
    };
    if (is_too_far (*std::min_element (squared_distances.begin(),
                                       squared_distances.begin() + size)))
      return;
    for (std::size_t i = 0; i < size; ++i) {
      if (is_too_far (squared_distances[i]))
        continue;
      if (best.size() == count) {
        std::pop_heap (best.begin(), best.end());
        best.pop_back();
      }
      best.push_back ({squared_distances[i], first + i});
      std::push_heap (best.begin(), best.end());
    }
  }

  /** \brief The finite points of the cloud, block by block. */
  std::vector<Vector3f> points_;
  /** \brief The coordinates of \ref points_, axis by axis: faster to read in \ref
   * visit.
   */
  std::vector<float> x_, y_, z_;
  /** \brief The bounding boxes of the blocks. */
  std::vector<Box> boxes_;
};

/** \brief Noise and spacing of the neighborhood of a point [m]; see \ref Thickness. */
struct Surroundings {
  double noise, spacing;
};

/** \brief Returns the noise and spacing of the neighborhood of a point; nothing if even
 * the largest neighborhood is nearly a line.
 * \param[in] min_neighbors number of points of the smallest neighborhood */
std::optional<Surroundings>
surroundingsOf (const Vector3f& point,
                std::size_t min_neighbors,
                const BlockSearch& search)
{
  // The rings of a lidar are up to some twenty times as far apart as the points of a
  // ring.
  const std::size_t max_neighbors = 16 * min_neighbors;
  constexpr double min_width_by_length = 1.0 / 3.0; // of a neighborhood that is no line
  constexpr double min_noise_by_spacing = 0.1;
  constexpr double parameters_of_plane = 3.0;
  for (std::size_t count = min_neighbors; count <= max_neighbors; count *= 2) {
    Moments moments;
    moments.origin = point.cast<double>();
    for (const Vector3f& neighbor : search.nearest (point, count)) {
      const Eigen::Vector3d local = neighbor.cast<double>() - moments.origin;
      moments.add (local.x(), local.y(), local.z());
    }
    const std::optional<PlaneFit> fit = fitPlane (moments);
    if (!fit || moments.count <= parameters_of_plane)
      continue;
    const Eigen::Vector3d& variances = fit->variances;
    const bool is_nearly_line =
        variances[1] < min_width_by_length * min_width_by_length * variances[2];
    if (is_nearly_line)
      continue;
    // The area of an ellipse in which evenly spread points have these variances.
    const double area = 4.0 * M_PI * std::sqrt (variances[1] * variances[2]);
    const double spacing = std::sqrt (area / moments.count);
    const double noise = std::sqrt (std::max (0.0, variances[0]) * moments.count /
                                    (moments.count - parameters_of_plane));
    return Surroundings{std::max (noise, min_noise_by_spacing * spacing), spacing};
  }
  return std::nullopt;
}

/** \brief Returns a hash of the coordinates. */
std::uint64_t
hashOf (const pcl::PointXYZ& point)
{
  constexpr std::uint64_t multiplier = 0x9e3779b97f4a7c15U; // 2^64 / golden ratio, odd
  std::uint64_t hash = 0;
  for (const float coordinate : {point.x, point.y, point.z}) {
    std::uint32_t bits = 0;
    std::memcpy (&bits, &coordinate, sizeof bits);
    hash = (hash ^ bits) * multiplier;
    hash ^= hash >> 29U; // the upper bits are mixed best
  }
  return hash;
}

/** \brief Returns the \p count inliers with the smallest hashes of their coordinates,
 * or all if there are fewer. The choice does not depend on the order of the inliers. */
pcl::Indices
someOf (const pcl::Indices& inliers, const XyzCloud& cloud, std::size_t count)
{
  using HashAndIndex = std::pair<std::uint64_t, pcl::index_t>;
  std::vector<HashAndIndex>
      smallest; // a heap, the largest of these hashes at the front
  for (const pcl::index_t inlier : inliers) {
    smallest.emplace_back (hashOf (cloud[std::size_t (inlier)]), inlier);
    if (smallest.size() > count && smallest.back() >= smallest.front()) {
      smallest.pop_back();
      continue;
    }
    std::push_heap (smallest.begin(), smallest.end());
    if (smallest.size() > count) {
      std::pop_heap (smallest.begin(), smallest.end());
      smallest.pop_back();
    }
  }
  std::sort (smallest.begin(), smallest.end());
  pcl::Indices chosen;
  for (const auto& [hash, inlier] : smallest)
    chosen.push_back (inlier);
  return chosen;
}

} // namespace

std::vector<Thickness>
thicknessOf (const XyzCloud& cloud,
             const std::vector<PlaneSegment>& planes,
             std::size_t probes)
{
  // In a small plane a neighborhood has a quarter of the number of inliers, so that
  // most of its points are on the plane.
  constexpr std::size_t min_neighbors = 20;
  constexpr std::size_t max_neighbors = 80;
  constexpr std::size_t inliers_per_neighbor = 4;
  constexpr std::size_t max_queries_unsorted = 50; // for fewer, sorting takes longer
  const bool has_many_queries = planes.size() * probes > max_queries_unsorted;
  const BlockSearch search (cloud,
                            has_many_queries ? BlockSearch::Order::Sorted
                                             : BlockSearch::Order::AsInCloud);
  std::vector<Thickness> thicknesses;
  for (const PlaneSegment& plane : planes) {
    Thickness thickness;
    if (const std::optional<PlaneFit> fit = fitPlane (plane.moments))
      thickness.rms = std::sqrt (std::max (0.0, fit->variances[0]));
    const std::size_t neighbors = std::clamp (
        plane.inliers.size() / inliers_per_neighbor, min_neighbors, max_neighbors);
    std::vector<double> noises;
    std::vector<double> spacings;
    for (const pcl::index_t i : someOf (plane.inliers, cloud, probes))
      if (const auto around = surroundingsOf (
              cloud[std::size_t (i)].getVector3fMap(), neighbors, search)) {
        noises.push_back (around->noise);
        spacings.push_back (around->spacing);
      }
    thickness.noise = quantile (noises, 0.5);
    thickness.spacing = quantile (spacings, 0.5);
    thicknesses.push_back (thickness);
  }
  return thicknesses;
}

} // namespace pcl_ops::apps
