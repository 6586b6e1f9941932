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

// Points are compared with planes in blocks. A plane too far from the bounding box of a
// block is skipped. Blocks are small enough for compact boxes, if successive points are
// neighbors in space, and large enough that the boxes cost little.
constexpr std::size_t block_size = 256;
constexpr std::size_t points_of_a_task = 64 * block_size;
// Number of planes compared with a block between checks whether all points are done.
constexpr std::size_t planes_between_looks = 32;

struct Box {
  Eigen::Vector3d center, half_size;
};

Box
boxOf (const Coordinates& points, std::size_t begin, std::size_t end)
{
  const auto size = static_cast<Eigen::Index> (end - begin);
  Eigen::Vector3f low;
  Eigen::Vector3f high;
  for (const auto& [axis, values] :
       {std::pair (0, &points.x), {1, &points.y}, {2, &points.z}}) {
    const Eigen::Map<const Eigen::ArrayXf> coordinates (values->data() + begin, size);
    low[axis] = coordinates.minCoeff();
    high[axis] = coordinates.maxCoeff();
  }
  return {0.5 * (low + high).cast<double>(), 0.5 * (high - low).cast<double>()};
}

// Whether a point of the box may be within the threshold of a plane, with tolerance for
// rounding of distances.
bool
reaches (const Plane& plane, const Box& box, double threshold)
{
  constexpr double single_precision = 1e-5;
  const double reach = plane.normal.cwiseAbs().dot (box.half_size);
  const double rounding =
      single_precision * (std::abs (plane.offset) + box.center.norm() + reach);
  return std::abs (plane.distance (box.center)) <= threshold + reach + rounding;
}

// Assigns points begin .. end - 1, at most block_size. A point goes to a plane nearer
// than its best distance: at first the threshold, then the distance to its plane, or 0
// by rule First.
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
  std::array<float, block_size> best;
  best.fill (threshold);
  std::size_t compared = 0;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!reaches (planes[p], box, threshold))
      continue;
    // By rule First the block is done once all points have a plane, so best 0. With
    // thousands of planes, the first few hundred often take all points.
    const float* const last = best.data() + (end - begin);
    if (rule == AssignmentRule::First && ++compared % planes_between_looks == 0 &&
        std::count (std::as_const (best).data(), last, 0.0f) == last - best.data())
      return;
    const auto label = static_cast<std::int32_t> (p);
    std::int32_t* const label_of = labels.data();
    // By rule First best becomes 0: no distance is below it, so the plane stays. A
    // factor instead of a branch lets the loop be vectorized.
    const float factor = rule == AssignmentRule::First ? 0.0f : 1.0f;
    const auto assign = [=, &best] (std::size_t i, float distance) {
      float& nearest = best[i - begin];
      const bool closer = distance < nearest;
      label_of[i] = closer ? label : label_of[i];
      nearest = closer ? factor * distance : nearest;
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
  const auto assign = [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; i += block_size) {
      const std::size_t last = std::min (i + block_size, end);
      assignBlock (points, i, last, planes, threshold, rule, labels);
    }
  };
  parallelFor (threads, points.size(), points_of_a_task, assign);
  return labels;
}

std::vector<Moments>
momentsOfLabels (const Coordinates& points,
                 const Labels& labels,
                 std::size_t number,
                 unsigned threads)
{
  // A piece has at least this many points per plane. Otherwise, with thousands of
  // planes, its sums would take more memory than its points.
  constexpr std::size_t points_per_plane = 8;
  // Sums per piece are added in order: the same digits for any number of threads.
  const auto sum = [&] (std::size_t begin, std::size_t end) {
    std::vector<Moments> moments (number);
    for (std::size_t i = begin; i < end; ++i)
      // no_plane is negative, so the cast makes it larger than any label
      if (const auto label = static_cast<std::size_t> (labels[i]); label < number)
        moments[label].add (points.x[i], points.y[i], points.z[i]);
    return moments;
  };
  const std::size_t grain = std::max (points_of_a_task, points_per_plane * number);
  const auto partial = parallelChunks (threads, points.size(), grain, sum);
  std::vector<Moments> moments (number);
  for (const std::vector<Moments>& piece : partial)
    for (std::size_t p = 0; p < number; ++p)
      moments[p] += piece[p];
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
  constexpr std::size_t labels_per_piece = 65536;
  const auto replace = [&] (std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (labels[i] != no_plane)
        labels[i] = merged_into[labels[i]];
  };
  parallelFor (threads, labels.size(), labels_per_piece, replace);
}

} // namespace pcl_ops::internal
