// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

/** \brief The points of a group of \ref PointSample, or a sample of them. */
struct SampledPoints {
  /** \brief Number of finite points of the group; \ref positions has all or some of
   * them.
   */
  std::size_t all_points = 0;
  /** \brief In pseudo-random order, so that the first ones are an even sample. */
  std::vector<Eigen::Vector3d> positions;
};

/** \brief Samples any number of points, in groups such as planes, without storing them
 * all. If all groups together have no more finite points than the maximum, they keep
 * them all. Else each group keeps a number in proportion to its size, but not fewer
 * than 100 points, or than max_points / (2 * number of groups) if this is less; a group
 * that has fewer keeps them all. The sample does not depend on the order of the points.
 * Points that are not finite are left out. */
class PointSample {
public:
  /** \param[in] sizes number of finite points of each group; at least one group
   * \param[in] max_points of all groups together */
  PointSample (const std::vector<std::size_t>& sizes, std::size_t max_points);

  /** \brief Adds a point to a group.
   * \param[in] group index of the group in the sizes */
  void
  add (std::size_t group, const Eigen::Vector3d& position);

  /** \brief Returns the points of each group and leaves this sample empty. */
  std::vector<SampledPoints>
  take ();

private:
  /** \brief A point and its hash (\ref hashOf), which decides on the order of points.
   */
  struct HashedPoint {
    std::uint32_t hash;
    Eigen::Vector3d position;
  };

  struct Group {
    /** \brief Number of points to keep in the end. */
    std::size_t quota = 0;
    /** \brief Number of points that were added. */
    std::size_t all_points = 0;
    /** \brief The points that may be kept, unsorted: the first ones in the order of
     * \ref isBefore, as many as the quota, and some more. */
    std::vector<HashedPoint> points;
  };

  /** \brief The order of points: by hash, points of equal hash by coordinates. */
  static bool
  isBefore (const HashedPoint& a, const HashedPoint& b);

  /** \brief Drops all points of a group but the first ones in the order of \ref
   * isBefore, as many as the quota. The group must have as many. */
  static void
  keepFirst (Group& group);

  std::vector<Group> groups_;
};

} // namespace pcl_ops::apps
