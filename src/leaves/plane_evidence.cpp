// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaves/plane_evidence.h"

#include "leaves/leaf_bending.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::internal {

namespace {

// Between which angles another plane is the same surface, which goes on.
class FaceTurn {
public:
  explicit FaceTurn (const LeafBending& bending)
  {
    // Turned by less it is the same plane, by more than so many times the slope of the
    // plane's own bend it is another face.
    constexpr double min_turn = 4.0 * M_PI / 180.0;
    constexpr double max_turn_in_slopes = 5.9;
    constexpr double right_turn = 1.5;
    const double uncertain_bend =
        2.0 * bending.left /
        std::sqrt (static_cast<double> (std::max<std::size_t> (1, bending.leaves)));
    const double slope = (bending.amplitude + uncertain_bend) / bending.half_extent;
    least_cosine_ = std::cos (std::min (right_turn, max_turn_in_slopes * slope));
    most_cosine_ = std::cos (min_turn);
  }

  bool
  goesOn (const Plane& own, const Plane& beyond) const
  {
    const double cosine = cosineBetween (own, beyond);
    return cosine > least_cosine_ && cosine < most_cosine_;
  }

private:
  double least_cosine_ = 0.0;
  double most_cosine_ = 0.0;
};

// The plane that a leaf is on, or its own; none where it has none.
const Plane*
planeAt (std::uint32_t leaf,
         const LeafPlanes& planes,
         const std::vector<LeafSurfel>& surfels)
{
  const std::int32_t plane = planes.plane_of_leaf[leaf];
  if (plane != no_plane)
    return &planes.planes[plane];
  return surfels[leaf].exists() ? &surfels[leaf].plane : nullptr;
}

// Whether a leaf lies beside another along a plane, not above it: clutter above a wall
// is no continuation of it.
bool
isBeside (const Moments& own, const Moments& other, const Plane& plane)
{
  constexpr double max_rise = 0.35; // over the distance along the plane
  const Eigen::Vector3d step = other.centroid() - own.centroid();
  const double height = plane.normal.dot (step);
  const double along = step.squaredNorm() - height * height;
  return height * height <= max_rise * max_rise * along;
}

PlaneBorder
borderOf (const LeafCloud& cloud,
          const LeafPlanes& planes,
          const std::vector<LeafSurfel>& surfels,
          const PlaneParts& own,
          const FaceTurn& turn)
{
  // What is farther away than this ends a plane.
  constexpr double max_noises = 7.0;
  const double far =
      max_noises * max_noises * meanSquaredDistance (own.moments, own.plane); // [m^2]
  // So many leaves tell the shares of a long border, too.
  constexpr std::size_t enough = 500;
  const std::size_t step = own.border_leaves.size() / enough + 1;
  PlaneBorder border;
  border.inner_leaves =
      static_cast<double> (own.leaves.size() - own.border_leaves.size());
  for (std::size_t i = 0; i < own.border_leaves.size(); i += step) {
    const std::uint32_t leaf = own.border_leaves[i];
    bool is_inner = true;
    for (const std::uint32_t k : cloud.neighbors[leaf]) {
      if (own.has (planes.plane_of_leaf[k]))
        continue;
      is_inner = false;
      border.links += 1.0;
      const Plane* const beyond = planeAt (k, planes, surfels);
      if (beyond == nullptr)
        border.shapeless += 1.0;
      if (meanSquaredDistance (cloud.moments[k], own.plane) >= far)
        border.ends += 1.0;
      else if (beyond != nullptr && turn.goesOn (own.plane, *beyond) &&
               isBeside (cloud.moments[leaf], cloud.moments[k], own.plane))
        border.goes_on += 1.0;
    }
    if (is_inner)
      border.inner_leaves += static_cast<double> (step);
  }
  return border;
}

// A linear rule: tests one after the other lose planes (src/doc/decisions.md).
double
balance (const LeafBending& bending,
         const PlaneBorder& border,
         double leaves,
         std::size_t points_of_cloud)
{
  constexpr double max_bend = 5.0;
  constexpr double of_going_on = 6.5;
  constexpr double of_shapeless = 7.0;
  constexpr double of_size = 2.8; // for each decade of leaves above the next
  // What planes of noise have by chance: more where there are more leaves.
  constexpr double usual_leaves = 100.0; // in a cloud of so many points
  constexpr double usual_points = 300'000.0;
  constexpr double growth = 0.15;
  constexpr double of_ending = 4.6;
  constexpr double of_inner = 6.8;
  constexpr double rounding = 1e-5; // of half the extent
  const double leaves_by_chance =
      usual_leaves *
      std::pow (static_cast<double> (points_of_cloud) / usual_points, growth);
  const double links = std::max (1.0, border.links);
  const double bend =
      bending.amplitude / (bending.left + rounding * bending.half_extent);
  const double against = std::min (max_bend, bend) +
                         of_going_on * border.goes_on / links +
                         of_shapeless * border.shapeless / links;
  const double in_favor = of_size * std::log10 (leaves / leaves_by_chance) +
                          of_ending * border.ends / links +
                          of_inner * border.inner_leaves / leaves;
  return in_favor - against;
}

} // namespace

std::vector<PlaneParts>
partsOfPlanes (const LeafCloud& cloud, const LeafPlanes& planes)
{
  std::vector<PlaneParts> parts;
  const std::vector<Moments> moments = momentsOfPlanes (cloud, planes);
  for (std::size_t p = 0; p < planes.planes.size(); ++p)
    parts.push_back ({static_cast<std::int32_t> (p), planes.planes[p], moments[p]});
  for (std::uint32_t i = 0; i < cloud.size(); ++i) {
    const std::int32_t plane = planes.plane_of_leaf[i];
    if (plane == no_plane)
      continue;
    parts[plane].leaves.push_back (i);
    const IndexRange around = cloud.neighbors[i];
    if (std::any_of (around.begin(), around.end(), [&] (std::uint32_t k) {
          return planes.plane_of_leaf[k] != plane;
        }))
      parts[plane].border_leaves.push_back (i);
  }
  return parts;
}

double
evidenceOf (const LeafCloud& cloud,
            const LeafPlanes& planes,
            const std::vector<LeafSurfel>& surfels,
            const PlaneParts& own)
{
  const LeafBending bending = bendingOfLeaves (cloud, own.leaves, own.plane);
  const FaceTurn turn (bending);
  return balance (bending,
                  borderOf (cloud, planes, surfels, own, turn),
                  static_cast<double> (own.leaves.size()),
                  cloud.points->size());
}

std::vector<char>
keptPlanes (const LeafCloud& cloud,
            const LeafPlanes& planes,
            const std::vector<LeafSurfel>& surfels,
            const std::vector<std::size_t>& points)
{
  std::vector<char> is_kept (planes.planes.size(), 0);
  for (const PlaneParts& own : partsOfPlanes (cloud, planes))
    is_kept[own.number] = points[own.number] >= min_points_of_plane &&
                          !own.leaves.empty() &&
                          evidenceOf (cloud, planes, surfels, own) > 0.0;
  return is_kept;
}

} // namespace pcl_ops::internal
