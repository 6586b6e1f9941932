// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Dense>

#include "arguments.h"
#include "constants.h"
#include <pcl_ops/buildings/plane_regularization.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace pcl_ops {
namespace {

using namespace internal::buildings;
using Eigen::Vector3d;

/** \brief Nearly parallel planes and the direction of their normals. */
struct DirectionGroup {
  Vector3d direction;  // unit vector
  double points = 0.0; // number of points of all planes
  /** \brief Indices of the planes in the list of planes, by falling number of points;
   * those of a group that was joined follow behind. */
  std::vector<std::size_t> members = {};
};

/** \brief Returns \p direction, negated if it points away from \p side. */
Vector3d
towards (const Vector3d& direction, const Vector3d& side)
{
  return direction.dot (side) < 0.0 ? Vector3d (-direction) : direction;
}

/** \brief Returns whether a plane has more points than another one. Of planes with
 * equally many, all that a move depends on decides, so that their order in the list
 * changes nothing. */
bool
comesBefore (const PlaneSegment& a, const PlaneSegment& b)
{
  if (a.moments.count != b.moments.count)
    return a.moments.count > b.moments.count;
  const auto numbersOf = [] (const PlaneSegment& plane) {
    Eigen::Matrix<double, 3, 6> numbers;
    numbers << plane.centroid, plane.normal, plane.moments.centroid(),
        plane.moments.covariance();
    return numbers;
  };
  const auto of_a = numbersOf (a);
  const auto of_b = numbersOf (b);
  return std::lexicographical_compare (
      of_a.data(), of_a.data() + of_a.size(), of_b.data(), of_b.data() + of_b.size());
}

/** \brief Returns the indices of the planes that have points, by \ref comesBefore. The
 * moments of a plane without points say neither its mean nor its rms, so that it stays.
 */
std::vector<std::size_t>
largestFirst (const std::vector<PlaneSegment>& planes)
{
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (planes[i].moments.count > 0.0)
      order.push_back (i);
  std::stable_sort (order.begin(), order.end(), [&] (std::size_t a, std::size_t b) {
    return comesBefore (planes[a], planes[b]);
  });
  return order;
}

/** \brief Returns the mean direction of the normals of planes, whatever their signs:
 * the unit vector with the largest sum of squared cosines to them, weighted by points.
 * It points to the side of the normal of the first member. */
Vector3d
meanDirection (const std::vector<PlaneSegment>& planes,
               const std::vector<std::size_t>& members)
{
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const std::size_t i : members)
    sum += planes[i].moments.count * planes[i].normal * planes[i].normal.transpose();
  // The last eigenvector is that of the largest eigenvalue.
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
    const auto found =
        std::find_if (groups.begin(), groups.end(), [&] (const DirectionGroup& known) {
          return angleBetween (planes[i], planes[known.members.front()]) <= max_angle;
        });
    DirectionGroup& group = found == groups.end()
                                ? groups.emplace_back (DirectionGroup{planes[i].normal})
                                : *found;
    group.members.push_back (i);
    group.points += planes[i].moments.count;
  }
  for (DirectionGroup& group : groups)
    group.direction = meanDirection (planes, group.members);
  std::stable_sort (groups.begin(), groups.end(), [] (const auto& a, const auto& b) {
    return a.points > b.points;
  });
  return groups;
}

/** \brief Largest cosine of directions that are orthogonal, and largest sine of
 * directions that are parallel, but for rounding. Chosen by hand: rounding makes some
 * 1e-16 of it, max_angle is far larger. */
constexpr double rounding = 1e-9;

/** \brief Makes the direction of each group orthogonal to that of a larger group: of
 * the largest one to which it is orthogonal within \p max_angle [rad]. If a second such
 * group is orthogonal to the first one, the direction becomes the cross product of both
 * directions.
 * \param[in,out] groups the group with most points first */
void
makeOrthogonal (std::vector<DirectionGroup>& groups, double max_angle)
{
  for (std::size_t i = 1; i < groups.size(); ++i) {
    // Directions of larger groups to which this one becomes orthogonal, at most two.
    std::vector<Vector3d> across;
    for (std::size_t j = 0; j < i && across.size() < 2; ++j) {
      const Vector3d& larger = groups[j].direction;
      const double cosine = std::abs (groups[i].direction.dot (larger));
      const bool is_nearly_across = std::asin (std::min (1.0, cosine)) <= max_angle;
      const bool agrees_with_first =
          across.empty() || std::abs (across[0].dot (larger)) <= rounding;
      if (is_nearly_across && agrees_with_first)
        across.push_back (larger);
    }
    Vector3d& direction = groups[i].direction;
    if (across.size() == 2)
      direction = towards (across[0].cross (across[1]).normalized(), direction);
    else if (across.size() == 1)
      direction = (direction - direction.dot (across[0]) * across[0]).normalized();
  }
}

/** \brief Joins groups whose directions became equal in \ref makeOrthogonal.
 * DirectionGroup::points stays that of the first group; it is not used any more. */
void
joinEqualDirections (std::vector<DirectionGroup>& groups)
{
  std::vector<DirectionGroup> joined;
  for (const DirectionGroup& group : groups) {
    const auto equal =
        std::find_if (joined.begin(), joined.end(), [&] (const DirectionGroup& known) {
          return known.direction.cross (group.direction).norm() <= rounding;
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
 * and then shifted along \p normal by \p offset [unit of the planes]. */
PlaneMove
moveTo (const PlaneSegment& plane, const Vector3d& normal, double offset)
{
  PlaneMove move;
  move.angle = slopeOf (plane.normal, normal);
  move.offset = offset;
  // The distance of a point p to the plane changes by turn . (p - centroid) - offset,
  // which is linear in p: its mean is that at the mean of the points, and its variance
  // is turn^T covariance turn.
  const Vector3d turn = normal - plane.normal;
  const Vector3d mean = plane.moments.centroid() - plane.centroid;
  const double mean_change = turn.dot (mean) - offset;
  const double variance_of_change = turn.dot (plane.moments.covariance() * turn);
  const double mean_squared_change =
      mean_change * mean_change + std::max (0.0, variance_of_change);
  if (mean_squared_change > 0.0)
    move.displacement =
        std::sqrt (mean_squared_change) / plane.rms(); // infinite for rms 0
  return move;
}

/** \brief Returns whether a move is larger than rounding errors. Its limits are chosen
 * by hand. */
bool
isMove (const PlaneMove& move, const PlaneSegment& plane)
{
  constexpr double max_angle_of_rounding = 1e-9;  // [rad]
  constexpr double max_offset_of_rounding = 1e-9; // in units of the size of the plane
  const double size = std::sqrt (plane.moments.covariance().trace());
  return move.angle > max_angle_of_rounding ||
         std::abs (move.offset) > max_offset_of_rounding * size;
}

/** \brief Groups planes by direction and moves them. PlaneMove::direction and
 * PlaneMove::level of all planes are numbers of one sequence. A level is a set of
 * planes of one group that become coplanar. */
class Regularization {
public:
  Regularization (const std::vector<PlaneSegment>& planes,
                  const PlaneRegularizationParameters& parameters)
  : planes_ (planes)
  , parameters_ (parameters)
  , result_{planes, std::vector<PlaneMove> (planes.size())}
  {}

  RegularizedPlanes
  run ()
  {
    // Planes that would move too far do not count for the directions of others: the
    // groups are made again until no plane is left out.
    std::vector<std::size_t> kept = largestFirst (planes_); // indices of planes
    std::vector<DirectionGroup> groups;
    std::size_t previously_kept = kept.size() + 1;
    while (kept.size() < previously_kept) {
      previously_kept = kept.size();
      groups = parallelGroups (planes_, kept, parameters_.max_angle);
      makeOrthogonal (groups, parameters_.max_angle);
      joinEqualDirections (groups);
      kept = withoutFarthest (groups, kept);
    }
    for (const DirectionGroup& group : groups)
      alignGroup (group);
    for (std::size_t i = 0; i < planes_.size(); ++i)
      if (!is_aligned_[i]) { // it stays; displacement tells how far it would have moved
        result_.moves[i].angle = 0.0;
        result_.moves[i].offset = 0.0;
        result_.moves[i].direction = next_number_;
        result_.moves[i].level = next_number_;
        ++next_number_;
      }
    return std::move (result_);
  }

private:
  /** \brief Returns whether a move is not too far. */
  bool
  isAllowed (const PlaneMove& move) const
  {
    return move.displacement <= parameters_.max_displacement;
  }

  /** \brief Returns the planes without, for each group, the plane that would move
   * farthest if that is too far: without this plane the others may move less. Sets
   * result_.moves to the rotations alone, without offsets.
   * \param[in] grouped indices of the planes of all groups */
  std::vector<std::size_t>
  withoutFarthest (const std::vector<DirectionGroup>& groups,
                   const std::vector<std::size_t>& grouped)
  {
    std::vector<char> is_left_out (planes_.size(), 0);
    for (const DirectionGroup& group : groups) {
      for (const std::size_t i : group.members)
        result_.moves[i] =
            moveTo (planes_[i], towards (group.direction, planes_[i].normal), 0.0);
      const std::size_t farthest = *std::max_element (
          group.members.begin(),
          group.members.end(),
          [&] (std::size_t a, std::size_t b) {
            return result_.moves[a].displacement < result_.moves[b].displacement;
          });
      is_left_out[farthest] = isAllowed (result_.moves[farthest]) ? 0 : 1;
    }
    std::vector<std::size_t> kept;
    for (const std::size_t i : grouped)
      if (!is_left_out[i])
        kept.push_back (i);
    return kept;
  }

  /** \brief Returns the position of plane \p i along the direction of its group, from
   * the centroid of the first plane of the group [unit of the planes]: positions from
   * zero would lose digits in map coordinates. */
  double
  positionOf (std::size_t i, const DirectionGroup& group) const
  {
    const Vector3d& origin = planes_[group.members.front()].centroid;
    return group.direction.dot (planes_[i].centroid - origin);
  }

  /** \brief Returns the largest distance of two parallel planes that become coplanar
   * [unit of the planes]. */
  double
  maxOffset (std::size_t first, std::size_t second) const
  {
    return parameters_.max_offset.value_or (
        constants.rms_of_offset *
        std::hypot (planes_[first].rms(), planes_[second].rms()));
  }

  /** \brief Gives the planes of a group its direction as normal, and the planes of each
   * level a common position along it. Planes at one position stay in the order of the
   * group: which of them comes first may decide which level it is on. */
  void
  alignGroup (const DirectionGroup& group)
  {
    std::vector<std::size_t> members = group.members;
    std::stable_sort (
        members.begin(), members.end(), [&] (std::size_t a, std::size_t b) {
          return positionOf (a, group) < positionOf (b, group);
        });
    const std::size_t direction_number = next_number_++;
    for (std::size_t first = 0, next = 0; first < members.size(); first = next) {
      std::vector<std::size_t> level;
      while (next < members.size() &&
             (level.empty() || isOnLevel (members[next], level, group)))
        level.push_back (members[next++]);
      moveLevel (level, group, direction_number);
    }
  }

  /** \brief Returns whether a plane is within maxOffset of all planes of a level. The
   * nearest one does not suffice: levels would grow from plane to plane. */
  bool
  isOnLevel (std::size_t plane,
             const std::vector<std::size_t>& level,
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
      result_.planes[i].normal = normal;
      result_.planes[i].centroid += move.offset * normal;
      result_.moves[i] = move;
      is_aligned_[i] = 1;
    }
  }

  const std::vector<PlaneSegment>& planes_;
  const PlaneRegularizationParameters& parameters_;
  RegularizedPlanes result_;
  std::vector<char> is_aligned_ = std::vector<char> (planes_.size(), 0);
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
