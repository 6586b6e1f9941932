// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/parallel.h>
#include <pcl_ops/plane_assignment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace pcl_ops {

namespace {

// So few that they lie close together where neighbours in the list are neighbours in
// space, and most planes can be left out; so many that leaving out costs little.
constexpr std::size_t block_size = 256;
constexpr std::size_t points_per_piece = 64 * block_size;

struct Block {
  const float* x;
  const float* y;
  const float* z;
  std::size_t size;
  std::int32_t* labels;
};

struct Box {
  Eigen::Vector3d centre, half_size;
};

Box
boxOf (const Block& block)
{
  const auto size = static_cast<Eigen::Index> (block.size);
  Eigen::Vector3f low, high;
  for (const auto& [axis, values] :
       {std::make_pair (0, block.x), {1, block.y}, {2, block.z}}) {
    const Eigen::Map<const Eigen::ArrayXf> coordinates (values, size);
    low[axis] = coordinates.minCoeff();
    high[axis] = coordinates.maxCoeff();
  }
  return {0.5 * (low + high).cast<double>(), 0.5 * (high - low).cast<double>()};
}

// False if no point of the box can be within the threshold, rounding included.
bool
reaches (const Plane& plane, const Box& box, double threshold)
{
  constexpr double single_precision = 1e-5;
  const double reach = plane.normal.cwiseAbs().dot (box.half_size);
  const double rounding =
      single_precision * (std::abs (plane.offset) + box.centre.norm() + reach);
  return std::abs (plane.distance (box.centre)) <= threshold + reach + rounding;
}

void
assignBlock (const Block& block,
             const std::vector<Plane>& planes,
             float threshold,
             AssignmentRule rule)
{
  const Box box = boxOf (block);
  std::array<float, block_size> best;
  best.fill (threshold);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    if (!reaches (planes[p], box, threshold))
      continue;
    const Eigen::Vector3f n = planes[p].normal.cast<float>();
    const auto offset = static_cast<float> (planes[p].offset);
    const auto label = static_cast<std::int32_t> (p);
    // A distance no later plane can beat makes the first plane final.
    const float won = rule == AssignmentRule::First ? 0.0f : 1.0f;
    for (std::size_t i = 0; i < block.size; ++i) {
      const float distance = std::abs (n.x() * block.x[i] + n.y() * block.y[i] +
                                       n.z() * block.z[i] + offset);
      const bool closer = distance < best[i];
      block.labels[i] = closer ? label : block.labels[i];
      best[i] = closer ? won * distance : best[i];
    }
  }
}

} // namespace

Labels
assignPoints (const Coordinates& positions,
              const std::vector<Plane>& planes,
              double distance_threshold,
              AssignmentRule rule,
              unsigned threads)
{
  Labels labels (positions.size(), no_plane);
  parallelFor (threads,
               positions.size(),
               points_per_piece,
               [&] (std::size_t begin, std::size_t end) {
                 for (std::size_t i = begin; i < end; i += block_size)
                   assignBlock ({positions.x.data() + i,
                                 positions.y.data() + i,
                                 positions.z.data() + i,
                                 std::min (block_size, end - i),
                                 labels.data() + i},
                                planes,
                                static_cast<float> (distance_threshold),
                                rule);
               });
  return labels;
}

std::vector<Moments>
momentsOfLabels (const Coordinates& positions,
                 const Labels& labels,
                 std::size_t number,
                 unsigned threads)
{
  // Sums per piece, added up in order: the same digits for any number of threads.
  const auto partial = parallelPieces (
      threads,
      positions.size(),
      points_per_piece,
      [&] (std::size_t begin, std::size_t end) {
        std::vector<Moments> moments (number);
        for (std::size_t i = begin; i < end; ++i)
          if (const auto label = static_cast<std::size_t> (labels[i]); label < number)
            moments[label].add (positions.x[i], positions.y[i], positions.z[i]);
        return moments;
      });
  std::vector<Moments> moments (number);
  for (const std::vector<Moments>& piece : partial)
    for (std::size_t p = 0; p < number; ++p)
      moments[p] += piece[p];
  return moments;
}

} // namespace pcl_ops
