// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/plane_assignment.h"

#include "base/parallel.h"
#include "geometry/float_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl_ops::internal {
namespace {

// Points are compared with planes in blocks of successive points. A plane too far from
// the bounding box of a block is skipped. If successive points are neighbors in space,
// blocks are small enough for compact boxes. They are large enough that boxes cost
// little. The size was chosen by hand, and changes no label.
constexpr std::size_t block_size = 256;
// Points of a piece of a parallel loop. Another number changes the rounding of sums in
// momentsOfLabels.
constexpr std::size_t points_per_piece = 64 * block_size;
// After so many planes a block checks again whether all its points have a plane. The
// number changes no label.
constexpr std::size_t planes_between_checks = 32;

/** \brief A bounding box along the axes [m]. */
struct Box {
  Eigen::Vector3d center, half_size;
};

// Returns the bounding box of points begin .. end - 1.
Box
boxOf (const Coordinates& points, std::size_t begin, std::size_t end)
{
  const auto size = static_cast<Eigen::Index> (end - begin);
  Eigen::Vector3f low;
  Eigen::Vector3f high;
  const std::array<const float*, 3> values{
      points.x.data(), points.y.data(), points.z.data()};
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Map<const Eigen::ArrayXf> coordinates (values[axis] + begin, size);
    low[axis] = coordinates.minCoeff();
    high[axis] = coordinates.maxCoeff();
  }
  // In double precision: sums of coordinates near the largest float would be infinite.
  const Eigen::Vector3d lowest = low.cast<double>();
  const Eigen::Vector3d highest = high.cast<double>();
  return {0.5 * (lowest + highest), 0.5 * (highest - lowest)};
}

// Whether a point of the box may be within the threshold of a plane [m], with tolerance
// for rounding of distances to single precision.
bool
mayBeNear (const Plane& plane, const Box& box, double threshold)
{
  constexpr double relative_rounding = 1e-5; // some 100 times that of a float
  const double half_depth = plane.normal.cwiseAbs().dot (box.half_size);
  const double rounding =
      relative_rounding * (std::abs (plane.offset) + box.center.norm() + half_depth);
  return std::abs (plane.distance (box.center)) <= threshold + half_depth + rounding;
}

// Assigns points begin .. end - 1, at most block_size of them. A point goes to a plane
// if it is nearer to the plane than its limit: at first the threshold [m]; once it has
// a plane, its distance to that plane, or 0 by rule First.
void
assignBlock (const Coordinates& points,
             std::size_t begin,
             std::size_t end,
             const std::vector<Plane>& planes,
             float threshold,
             AssignmentRule rule,
             Labels& labels)
{
  const Box box = boxOf (points, begin, end);
  std::array<float, block_size> limits;
  limits.fill (threshold);
  std::size_t compared_planes = 0;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!mayBeNear (planes[p], box, threshold))
      continue;
    // By rule First the block is done once all points have a plane, and with it a limit
    // of 0. With thousands of planes, the first few hundred often take all points.
    const float* const limits_end = limits.data() + (end - begin);
    if (rule == AssignmentRule::First &&
        ++compared_planes % planes_between_checks == 0 &&
        std::count (std::as_const (limits).data(), limits_end, 0.0f) ==
            limits_end - limits.data())
      return;
    const auto label = static_cast<std::int32_t> (p);
    std::int32_t* const label_of = labels.data();
    // By rule First the limit becomes 0: no distance is below it, so the point keeps
    // its plane. A factor instead of a branch lets the loop be vectorized.
    const float limit_factor = rule == AssignmentRule::First ? 0.0f : 1.0f;
    const auto assign = [=, &limits] (std::size_t i, float distance) {
      float& limit = limits[i - begin];
      const bool is_nearer = distance < limit;
      label_of[i] = is_nearer ? label : label_of[i];
      limit = is_nearer ? limit_factor * distance : limit;
    };
    forDistances (FloatPlane (planes[p]), points, begin, end, assign);
  }
}

} // namespace

Labels
assignPoints (const Coordinates& points,
              const std::vector<Plane>& planes,
              double distance_threshold,
              AssignmentRule rule,
              unsigned threads)
{
  const auto threshold = static_cast<float> (distance_threshold);
  Labels labels (points.size(), no_plane);
  const auto assignPiece = [&] (std::size_t begin, std::size_t end) {
    for (std::size_t block = begin; block < end; block += block_size) {
      const std::size_t block_end = std::min (block + block_size, end);
      assignBlock (points, block, block_end, planes, threshold, rule, labels);
    }
  };
  parallelFor (threads, points.size(), points_per_piece, assignPiece);
  return labels;
}

std::vector<Moments>
momentsOfLabels (const Coordinates& points,
                 const Labels& labels,
                 std::size_t planes,
                 unsigned threads)
{
  // A piece has at least this many points per plane. Otherwise, with thousands of
  // planes, its sums, 104 bytes per plane, would take far more memory than its points,
  // 12 bytes each.
  constexpr std::size_t min_points_per_plane = 8;
  const auto momentsOfPiece = [&] (std::size_t begin, std::size_t end) {
    std::vector<Moments> moments (planes);
    for (std::size_t i = begin; i < end; ++i)
      // no_plane is negative, so that the cast makes it larger than any label.
      if (const auto label = static_cast<std::size_t> (labels[i]); label < planes)
        moments[label].add (points.x[i], points.y[i], points.z[i]);
    return moments;
  };
  const std::size_t piece_size =
      std::max (points_per_piece, min_points_per_plane * planes);
  const std::vector<std::vector<Moments>> moments_of_pieces =
      parallelPieces (threads, points.size(), piece_size, momentsOfPiece);
  // The pieces are added in order: the sums are the same for any number of threads.
  std::vector<Moments> moments (planes);
  for (const std::vector<Moments>& of_piece : moments_of_pieces)
    for (std::size_t p = 0; p < planes; ++p)
      moments[p] += of_piece[p];
  return moments;
}

AssignedPoints
assignToUnboundedPlanes (const Coordinates& points,
                         const std::vector<Plane>& planes,
                         double distance_threshold,
                         AssignmentRule rule,
                         unsigned threads)
{
  AssignedPoints assigned;
  assigned.labels = assignPoints (points, planes, distance_threshold, rule, threads);
  assigned.moments = momentsOfLabels (points, assigned.labels, planes.size(), threads);
  return assigned;
}

void
relabel (Labels& labels, const Labels& merged_into, unsigned threads)
{
  constexpr std::size_t labels_per_piece = 65536; // of the parallel loop
  const auto replace = [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (labels[i] != no_plane)
        labels[i] = merged_into[labels[i]];
  };
  parallelFor (threads, labels.size(), labels_per_piece, replace);
}

} // namespace pcl_ops::internal
