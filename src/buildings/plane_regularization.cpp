// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Dense>

#include "arguments.h"
#include "constants.h"
#include <pcl_ops/buildings/plane_regularization.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace pcl_ops {
namespace {

using namespace internal::buildings;
using Eigen::Vector3d;

/** \brief Nearly parallel planes with their common direction and number of points. */
struct DirectionGroup {
  Vector3d direction;
  double points = 0.0;
  /** \brief Indices of the planes in the list of planes. */
  std::vector<std::size_t> members = {};
};

/** \brief Returns \p direction, negated if it points away from \p side. */
Vector3d
towards (const Vector3d& direction, const Vector3d& side)
{
  return direction.dot (side) < 0.0 ? Vector3d (-direction) : direction;
}

/** \brief Returns the indices of all planes by falling number of points. */
std::vector<std::size_t>
largestFirst (const std::vector<PlaneSegment>& planes)
{
  std::vector<std::size_t> order (planes.size());
  std::iota (order.begin(), order.end(), std::size_t (0));
  std::stable_sort (order.begin(), order.end(), [&] (std::size_t a, std::size_t b) {
    return planes[a].moments.count > planes[b].moments.count;
  });
  return order;
}

/** \brief Returns the mean direction of normals of any sign: the eigenvector with the
 * largest sum of squared cosines to them, weighted by points. */
Vector3d
meanDirection (const std::vector<PlaneSegment>& planes,
               const std::vector<std::size_t>& members)
{
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const std::size_t i : members)
    sum += planes[i].moments.count * planes[i].normal * planes[i].normal.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes (sum);
  return towards (axes.eigenvectors().col (2), planes[members.front()].normal);
}

/** \brief Returns groups of nearly parallel planes, the group with most points first.
 * All planes of a group are within \p max_angle [rad] of its largest plane.
 * \param[in] order indices of planes, the largest plane first */
std::vector<DirectionGroup>
parallelGroups (const std::vector<PlaneSegment>& planes,
                const std::vector<std::size_t>& order,
                double max_angle)
{
  std::vector<DirectionGroup> groups;
  for (const std::size_t i : order) {
    const auto group =
        std::find_if (groups.begin(), groups.end(), [&] (const DirectionGroup& known) {
          return angleBetween (planes[i], planes[known.members.front()]) <= max_angle;
        });
    DirectionGroup& group_of_plane =
        group == groups.end() ? groups.emplace_back (DirectionGroup{planes[i].normal})
                              : *group;
    group_of_plane.members.push_back (i);
    group_of_plane.points += planes[i].moments.count;
  }
  for (DirectionGroup& group : groups)
    group.direction = meanDirection (planes, group.members);
  std::stable_sort (groups.begin(), groups.end(), [] (const auto& a, const auto& b) {
    return a.points > b.points;
  });
  return groups;
}

/** \brief Cosines and sines of angles that count as exactly 90 or 0 degrees. */
constexpr double exact = 1e-9;

/** \brief Makes each direction orthogonal to that of a larger group: of the largest one
 * to which it is orthogonal within \p max_angle. If a second such group is orthogonal
 * to the first one, the direction becomes the cross product of both directions. */
void
makeOrthogonal (std::vector<DirectionGroup>& groups, double max_angle)
{
  for (std::size_t i = 1; i < groups.size(); ++i) {
    std::vector<Vector3d> across; // directions of larger groups, at most two
    for (std::size_t j = 0; j < i && across.size() < 2; ++j) {
      const Vector3d& larger = groups[j].direction;
      const double cosine = std::abs (groups[i].direction.dot (larger));
      const bool is_nearly_across = std::asin (std::min (1.0, cosine)) <= max_angle;
      const bool is_across_first =
          across.empty() || std::abs (across[0].dot (larger)) <= exact;
      if (is_nearly_across && is_across_first)
        across.push_back (larger);
    }
    Vector3d& direction = groups[i].direction;
    if (across.size() == 2)
      direction = towards (across[0].cross (across[1]).normalized(), direction);
    else if (across.size() == 1)
      direction = (direction - direction.dot (across[0]) * across[0]).normalized();
  }
}

/** \brief Joins groups whose directions became equal in makeOrthogonal. Numbers of
 * points are no longer needed, and stay those of the first group. */
void
joinEqualDirections (std::vector<DirectionGroup>& groups)
{
  std::vector<DirectionGroup> joined;
  for (const DirectionGroup& group : groups) {
    const auto equal =
        std::find_if (joined.begin(), joined.end(), [&] (const DirectionGroup& known) {
          return known.direction.cross (group.direction).norm() <= exact;
        });
    if (equal == joined.end()) {
      joined.push_back (group);
      continue;
    }
    equal->members.insert (
        equal->members.end(), group.members.begin(), group.members.end());
  }
  groups = std::move (joined);
}

/** \brief Returns how far a plane moves if it is turned about its centroid to \p normal
 * and then shifted along \p normal by \p offset [m]. */
PlaneMove
moveTo (const PlaneSegment& plane, const Vector3d& normal, double offset)
{
  PlaneMove move;
  move.angle = slopeOf (plane.normal, normal);
  move.offset = offset;
  // The change of a point's distance to the plane is linear in its position.
  const Vector3d turn = normal - plane.normal;
  const Vector3d mean = plane.moments.centroid() - plane.centroid;
  const double displacement_of_mean = turn.dot (mean) - offset;
  const double spread = turn.dot (plane.moments.covariance() * turn);
  const double squared_displacement =
      displacement_of_mean * displacement_of_mean + std::max (0.0, spread);
  if (squared_displacement > 0.0)
    move.displacement =
        std::sqrt (squared_displacement) / plane.rms(); // infinite for rms 0
  return move;
}

/** \brief Returns whether a move is more than rounding of a plane that stays. */
bool
isMove (const PlaneMove& move, const PlaneSegment& plane)
{
  constexpr double rounding = 1e-9; // in radians, and in units of the size
  const double size = std::sqrt (plane.moments.covariance().trace());
  return move.angle > rounding || std::abs (move.offset) > rounding * size;
}

/** \brief Groups planes by direction and moves them. Directions and levels of planes
 * share one sequence of numbers. */
class Regularization {
public:
  Regularization (const std::vector<PlaneSegment>& planes,
                  const PlaneRegularizationParameters& parameters)
  : planes_ (planes)
  , parameters_ (parameters)
  , found_{planes, std::vector<PlaneMove> (planes.size())}
  {}

  RegularizedPlanes
  run ()
  {
    // Planes that would move too far do not count for the directions of others: the
    // groups are made again until no plane is left out.
    std::vector<std::size_t> members = largestFirst (planes_);
    std::vector<DirectionGroup> groups;
    std::size_t previous_members = members.size() + 1;
    while (members.size() < previous_members) {
      previous_members = members.size();
      groups = parallelGroups (planes_, members, parameters_.max_angle);
      makeOrthogonal (groups, parameters_.max_angle);
      joinEqualDirections (groups);
      members = withoutFarthest (groups, members);
    }
    for (const DirectionGroup& group : groups)
      alignGroup (group);
    for (std::size_t i = 0; i < planes_.size(); ++i)
      if (!is_done_[i]) { // it stays; displacement tells how far it would have moved
        found_.moves[i].angle = 0.0;
        found_.moves[i].offset = 0.0;
        found_.moves[i].direction = next_number_;
        found_.moves[i].level = next_number_;
        ++next_number_;
      }
    return std::move (found_);
  }

private:
  bool
  isAllowed (const PlaneMove& move) const
  {
    return move.displacement <= parameters_.max_displacement;
  }

  /** \brief Returns the members without, for each group, the plane that moves farthest
   * if that is too far. Without this plane the others may move less. */
  std::vector<std::size_t>
  withoutFarthest (const std::vector<DirectionGroup>& groups,
                   const std::vector<std::size_t>& members)
  {
    std::vector<char> is_left_out (planes_.size(), 0);
    for (const DirectionGroup& group : groups) {
      for (const std::size_t i : group.members)
        found_.moves[i] =
            moveTo (planes_[i], towards (group.direction, planes_[i].normal), 0.0);
      const std::size_t farthest = *std::max_element (
          group.members.begin(),
          group.members.end(),
          [&] (std::size_t a, std::size_t b) {
            return found_.moves[a].displacement < found_.moves[b].displacement;
          });
      is_left_out[farthest] = isAllowed (found_.moves[farthest]) ? 0 : 1;
    }
    std::vector<std::size_t> kept;
    for (const std::size_t i : members)
      if (!is_left_out[i])
        kept.push_back (i);
    return kept;
  }

  /** \brief Returns the position of a plane along the direction of its group. */
  double
  positionOf (std::size_t i, const DirectionGroup& group) const
  {
    const Vector3d& origin = planes_[group.members.front()].centroid;
    return group.direction.dot (planes_[i].centroid - origin);
  }

  /** \brief Returns the largest distance of two parallel planes that are coplanar. */
  double
  maxOffset (std::size_t first, std::size_t second) const
  {
    return parameters_.max_offset.value_or (
        constants.noises_of_offset *
        std::hypot (planes_[first].rms(), planes_[second].rms()));
  }

  /** \brief Gives the planes of a group its direction as normal, and planes of one
   * level a common offset. */
  void
  alignGroup (const DirectionGroup& group)
  {
    std::vector<std::size_t> members = group.members;
    std::sort (members.begin(), members.end(), [&] (std::size_t a, std::size_t b) {
      return std::pair (positionOf (a, group), a) <
             std::pair (positionOf (b, group), b);
    });
    const std::size_t direction_number = next_number_++;
    for (std::size_t first = 0, next = 0; first < members.size(); first = next) {
      std::vector<std::size_t> level;
      while (next < members.size() &&
             (level.empty() || areLevel (level, members[next], group)))
        level.push_back (members[next++]);
      moveLevel (level, group, direction_number);
    }
  }

  /** \brief Returns whether a plane is within maxOffset of all planes of a level. The
   * nearest one does not suffice: levels would grow from plane to plane. */
  bool
  areLevel (const std::vector<std::size_t>& level,
            std::size_t plane,
            const DirectionGroup& group) const
  {
    return std::all_of (level.begin(), level.end(), [&] (std::size_t other) {
      return std::abs (positionOf (plane, group) - positionOf (other, group)) <=
             maxOffset (plane, other);
    });
  }

  /** \brief Turns the planes of a level and moves them to their mean position. */
  void
  moveLevel (const std::vector<std::size_t>& level,
             const DirectionGroup& group,
             std::size_t direction_number)
  {
    double points = 0.0;
    double mean_position = 0.0;
    for (const std::size_t i : level) {
      points += planes_[i].moments.count;
      mean_position += planes_[i].moments.count * positionOf (i, group);
    }
    mean_position /= points;
    const std::size_t level_number = next_number_++;
    for (const std::size_t i : level) {
      const Vector3d normal = towards (group.direction, planes_[i].normal);
      const double sign = normal.dot (group.direction) < 0.0 ? -1.0 : 1.0;
      const double offset =
          level.size() > 1 ? sign * (mean_position - positionOf (i, group)) : 0.0;
      PlaneMove move = moveTo (planes_[i], normal, offset);
      move.level = level_number;
      if (!isAllowed (move)) { // it is turned, but keeps its own offset
        move = moveTo (planes_[i], normal, 0.0);
        move.level = next_number_++;
      }
      move.direction = direction_number;
      move.is_moved = isMove (move, planes_[i]);
      found_.planes[i].normal = normal;
      found_.planes[i].centroid += move.offset * normal;
      found_.moves[i] = move;
      is_done_[i] = 1;
    }
  }

  const std::vector<PlaneSegment>& planes_;
  const PlaneRegularizationParameters& parameters_;
  RegularizedPlanes found_;
  std::vector<char> is_done_ = std::vector<char> (planes_.size(), 0);
  std::size_t next_number_ = 0;
};

} // namespace

std::string
validate (const PlaneRegularizationParameters& parameters)
{
  constexpr double largest = M_PI / 4.0;
  if (!(parameters.max_angle > 0.0 && parameters.max_angle < largest))
    return "the largest angle must be above 0 and below pi/4 (radians)";
  if (parameters.max_offset &&
      !(*parameters.max_offset >= 0.0 && std::isfinite (*parameters.max_offset)))
    return "the largest offset must be a length from 0, or not be given";
  if (!(parameters.max_displacement > 0.0))
    return "the largest displacement must be above 0";
  return {};
}

RegularizedPlanes
regularizePlanes (const std::vector<PlaneSegment>& planes,
                  const PlaneRegularizationParameters& parameters)
{
  throwIfWrong (validate (parameters));
  for (const PlaneSegment& plane : planes)
    if (!plane.centroid.allFinite() || !std::isfinite (plane.normal.squaredNorm()))
      throw std::invalid_argument ("planes must have finite centroids and normals");
  return Regularization (planes, parameters).run();
}

} // namespace pcl_ops
