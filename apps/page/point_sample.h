// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

/** \brief All points of a plane, or of no plane, or a sample of them. */
struct SampledPoints {
  /** \brief Number of finite points of the group; \ref positions has all or some. */
  std::size_t all_points = 0;
  /** \brief In pseudo-random order: the first ones are an even sample. */
  std::vector<Eigen::Vector3d> positions;
};

/** \brief Samples any number of points without storing them all. If there are more than
 * the maximum, each group keeps a number of points in proportion to its size. The least
 * number that it keeps of a larger group is 100, or, with many groups, an equal part of
 * half of the maximum. The sample does not depend on the order of the points.
 * Non-finite points are left out. */
class PointSample {
public:
  /** \param[in] sizes number of finite points of each group; at least one group
   * \param[in] max_points of all groups together */
  PointSample (const std::vector<std::size_t>& sizes, std::size_t max_points);

  /** \param[in] group its index in the sizes */
  void
  add (std::size_t group, const Eigen::Vector3d& position);

  /** \brief Returns the points of each group and leaves this sample empty. */
  std::vector<SampledPoints>
  take ();

private:
  /** \brief A point and its hash, by which points are put in order. */
  struct HashedPoint {
    std::uint32_t hash;
    Eigen::Vector3d position;
  };

  struct Group {
    /** \brief Number of points to keep in the end. */
    std::size_t quota = 0;
    /** \brief Number of points that were added. */
    std::size_t all_points = 0;
    /** \brief Those that may be kept, unsorted: the first ones in the order of \ref
     * isBefore, and some more. */
    std::vector<HashedPoint> points;
  };

  /** \brief The order: by hash, then by coordinates. */
  static bool
  isBefore (const HashedPoint& a, const HashedPoint& b);

  /** \brief Keeps as many points as the quota, the first ones in the order, unsorted.
   * The group must have as many. */
  static void
  keepFirst (Group& group);

  std::vector<Group> groups_;
};

} // namespace pcl_ops::apps
