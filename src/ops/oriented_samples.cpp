// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "principal_axes.h"
#include <pcl_ops/oriented_samples.h>
#include <pcl_ops/random.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops {

void
OrientedSamples::add (const Eigen::Vector3d& position, const Eigen::Vector3d& normal)
{
  const Eigen::Vector3f p = position.cast<float>();
  const Eigen::Vector3f n = normal.cast<float>();
  Coordinates::add (p.x(), p.y(), p.z());
  normals.add (n.x(), n.y(), n.z());
}

Positions
drawSample (std::size_t size, double rate, std::uint32_t seed)
{
  const double drawn_share = std::min (1.0, std::max (0.0, rate));
  auto wanted = static_cast<std::size_t> (
      std::llround (drawn_share * static_cast<double> (size)));
  RandomGenerator generator (seed);
  Positions sample;
  sample.reserve (wanted);
  for (std::size_t i = 0; wanted > 0; ++i)
    if (drawBelow (generator, static_cast<std::uint32_t> (size - i)) < wanted) {
      sample.push_back (static_cast<std::uint32_t> (i));
      --wanted;
    }
  return sample;
}

Eigen::Vector3d
normalOfScatter (const Eigen::Matrix3d& scatter)
{
  const PrincipalAxes axes = principalAxes (scatter);
  // Narrower than a thousandth of its length it is a line: rounding decides the rest.
  constexpr double smallest_relative_variance = 1e-6;
  if (!(axes.values[1] > smallest_relative_variance * axes.values[2]))
    return Eigen::Vector3d::Zero();
  return axes.normal;
}

std::array<Positions, 3>
groupByOrientation (const OrientedSamples& samples,
                    const Eigen::Vector3d& up,
                    double tolerance)
{
  std::array<Positions, 3> groups;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Orientation group = orientationOf (samples.normals[i], up, tolerance);
    groups[static_cast<std::size_t> (group)].push_back (static_cast<std::uint32_t> (i));
  }
  return groups;
}

} // namespace pcl_ops
