// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "thickness.h"

#include <pcl/common/point_tests.h>

#include <Eigen/Geometry>

#include <numbers/statistics.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl_ops::apps {

namespace {

using Eigen::Vector3f;

/** \brief Exact nearest neighbor search by bounding boxes of blocks of 64 points. The
 * boxes take hardly longer to compute than the points take to read. */
class BlockSearch {
public:
  /** \param[in] sorts whether to sort the points first, as a k-d tree divides them, so
   * that the boxes are small: pays for many queries */
  BlockSearch (const XyzCloud& cloud, bool sorts)
  {
    points_.reserve (cloud.size());
    for (const pcl::PointXYZ& point : cloud)
      if (pcl::isXYZFinite (point))
        points_.emplace_back (point.getVector3fMap());
    if (sorts)
      sort (0, points_.size());
    for (std::size_t first = 0; first < points_.size(); first += block) {
      Box box;
      for (std::size_t i = first; i < std::min (points_.size(), first + block); ++i)
        box.extend (points_[i]);
      boxes_.push_back (box);
    }
    for (const Vector3f& point : points_) {
      x_.push_back (point.x());
      y_.push_back (point.y());
      z_.push_back (point.z());
    }
  }

  /** \return the \p count nearest points, or all if there are fewer, in any order */
  std::vector<Vector3f>
  nearest (const Vector3f& query, std::size_t count) const
  {
    std::vector<float> distances; // squared, from the query to each box
    for (const Box& box : boxes_)
      distances.push_back (box.squaredExteriorDistance (query));
    const auto nearest_box = std::size_t (
        std::min_element (distances.begin(), distances.end()) - distances.begin());
    std::vector<Candidate> best;
    if (!boxes_.empty())
      visit (nearest_box, query, count, best);
    for (std::size_t i = 0; i < boxes_.size(); ++i)
      if (i != nearest_box &&
          (best.size() < count || distances[i] < best.front().first))
        visit (i, query, count, best);
    std::vector<Vector3f> neighbors;
    for (const Candidate& candidate : best)
      neighbors.push_back (points_[candidate.second]);
    return neighbors;
  }

private:
  using Box = Eigen::AlignedBox3f;
  /** \brief The squared distance and the index of a point. */
  using Candidate = std::pair<float, std::size_t>;
  static constexpr std::size_t block = 64;

  void
  sort (std::size_t first, std::size_t last)
  {
    if (last - first <= block)
      return;
    Box box;
    for (std::size_t i = first; i < last; ++i)
      box.extend (points_[i]);
    int axis = 0;
    box.sizes().maxCoeff (&axis);
    // The first half has a whole number of blocks.
    const std::size_t half = (last - first + block) / (2 * block) * block;
    const std::size_t middle = first + std::max (half, block);
    const auto begin = points_.begin();
    std::nth_element (
        begin + std::ptrdiff_t (first),
        begin + std::ptrdiff_t (middle),
        begin + std::ptrdiff_t (last),
        [axis] (const Vector3f& a, const Vector3f& b) { return a[axis] < b[axis]; });
    sort (first, middle);
    sort (middle, last);
  }

  /** \brief Adds the points of a block to the best candidates.
   * \param[in,out] best a heap of up to count candidates, the farthest at the front */
  void
  visit (std::size_t which,
         const Vector3f& query,
         std::size_t count,
         std::vector<Candidate>& best) const
  {
    const std::size_t first = which * block;
    const std::size_t size = std::min (block, points_.size() - first);
    std::array<float, block> squared{};
    for (std::size_t i = 0; i < size; ++i) {
      const float x = x_[first + i] - query.x();
      const float y = y_[first + i] - query.y();
      const float z = z_[first + i] - query.z();
      squared[i] = x * x + y * y + z * z;
    }
    if (best.size() == count &&
        *std::min_element (squared.begin(), squared.begin() + size) >=
            best.front().first)
      return;
    for (std::size_t i = 0; i < size; ++i) {
      if (best.size() == count && squared[i] >= best.front().first)
        continue;
      if (best.size() == count) {
        std::pop_heap (best.begin(), best.end());
        best.pop_back();
      }
      best.emplace_back (squared[i], first + i);
      std::push_heap (best.begin(), best.end());
    }
  }

  std::vector<Vector3f> points_;
  std::vector<float> x_, y_, z_;
  std::vector<Box> boxes_;
};

struct Surroundings {
  double scatter, spacing; // [m]
};

/** \brief Noise and spacing of the neighborhood of a point; nothing if even the largest
 * neighborhood is nearly a line. */
std::optional<Surroundings>
surroundingsOf (const Vector3f& point, std::size_t fewest, const BlockSearch& search)
{
  // The rings of a lidar are up to some twenty times as far apart as their points.
  const std::size_t most = 16 * fewest;
  constexpr double min_width = 1.0 / 3.0; // as a share of the length
  constexpr double floor_by_spacing = 0.1;
  constexpr double pi = 3.14159265358979323846;
  for (std::size_t count = fewest; count <= most; count *= 2) {
    Moments moments;
    moments.origin = point.cast<double>();
    for (const Vector3f& neighbor : search.nearest (point, count)) {
      const Eigen::Vector3d local = neighbor.cast<double>() - moments.origin;
      moments.add (local.x(), local.y(), local.z());
    }
    const std::optional<PlaneFit> fit = fitPlane (moments);
    if (!fit || moments.count <= 3.0)
      continue;
    const Eigen::Vector3d& variances = fit->variances;
    if (variances[1] < min_width * min_width * variances[2])
      continue;
    // Points spread evenly over an ellipse: its area is 4 pi sqrt (v1 v2).
    const double area = 4.0 * pi * std::sqrt (variances[1] * variances[2]);
    const double spacing = std::sqrt (area / moments.count);
    const double scatter = std::sqrt (std::max (0.0, variances[0]) * moments.count /
                                      (moments.count - 3.0));
    return Surroundings{std::max (scatter, floor_by_spacing * spacing), spacing};
  }
  return std::nullopt;
}

std::uint64_t
hashOf (const pcl::PointXYZ& point)
{
  std::uint64_t hash = 0;
  for (const float coordinate : {point.x, point.y, point.z}) {
    std::uint32_t bits = 0;
    std::memcpy (&bits, &coordinate, sizeof bits);
    hash = (hash ^ bits) * 0x9e3779b97f4a7c15U;
    hash ^= hash >> 29U;
  }
  return hash;
}

/** \brief Chooses up to \p count inliers by a hash of their coordinates, so that the
 * choice does not depend on their order. */
pcl::Indices
someOf (const pcl::Indices& inliers, const XyzCloud& cloud, std::size_t count)
{
  std::vector<std::pair<std::uint64_t, pcl::index_t>> least; // a max-heap
  for (const pcl::index_t i : inliers) {
    least.emplace_back (hashOf (cloud[std::size_t (i)]), i);
    if (least.size() > count && least.back() >= least.front()) {
      least.pop_back();
      continue;
    }
    std::push_heap (least.begin(), least.end());
    if (least.size() > count) {
      std::pop_heap (least.begin(), least.end());
      least.pop_back();
    }
  }
  std::sort (least.begin(), least.end());
  pcl::Indices chosen;
  for (const auto& hashed : least)
    chosen.push_back (hashed.second);
  return chosen;
}

} // namespace

std::vector<Thickness>
thicknessOf (const XyzCloud& cloud,
             const std::vector<PlaneSegment>& planes,
             std::size_t probes)
{
  // A quarter of a small plane: points around it must not outweigh its own.
  constexpr std::size_t min_neighbors = 20;
  constexpr std::size_t max_neighbors = 80;
  constexpr std::size_t share = 4;
  constexpr std::size_t few_queries = 50;
  const BlockSearch search (cloud, planes.size() * probes > few_queries);
  std::vector<Thickness> all;
  for (const PlaneSegment& plane : planes) {
    Thickness thickness;
    if (const std::optional<PlaneFit> fit = fitPlane (plane.moments))
      thickness.rms = std::sqrt (std::max (0.0, fit->variances[0]));
    const std::size_t neighbors =
        std::clamp (plane.inliers.size() / share, min_neighbors, max_neighbors);
    std::vector<double> scatters;
    std::vector<double> spacings;
    for (const pcl::index_t i : someOf (plane.inliers, cloud, probes))
      if (const auto around = surroundingsOf (
              cloud[std::size_t (i)].getVector3fMap(), neighbors, search)) {
        scatters.push_back (around->scatter);
        spacings.push_back (around->spacing);
      }
    thickness.noise = quantile (scatters, 0.5);
    thickness.spacing = quantile (spacings, 0.5);
    all.push_back (thickness);
  }
  return all;
}

} // namespace pcl_ops::apps
