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
  /** \brief Number of points in the cloud; \ref places has all or some of them. */
  std::size_t all = 0;
  /** \brief In pseudo-random order: the first ones are an even sample. */
  std::vector<Eigen::Vector3d> places;
};

/** \brief Samples any number of points without storing them all. If there are more than
 * the maximum, each group keeps a number of points in proportion to its size, but at
 * least 100, or an equal part of half of the maximum if that is less. The sample does
 * not depend on the order of the points. Non-finite points are left out. */
class PointSample {
public:
  /** \param[in] sizes of the groups
   * \param[in] max_points of all groups together */
  PointSample (const std::vector<std::size_t>& sizes, std::size_t max_points);

  void
  add (std::size_t group, const Eigen::Vector3d& place);

  /** \brief Returns the groups and leaves this sample empty. */
  std::vector<SampledPoints>
  take ();

private:
  /** \brief A point and its hash, which decides on its turn in the order. */
  struct Turn {
    std::uint32_t hash;
    Eigen::Vector3d place;
  };

  struct Group {
    std::size_t quota = 0;
    std::size_t all = 0;
    std::vector<Turn> turns;
  };

  static bool
  isBefore (const Turn& a, const Turn& b);

  /** \brief Keeps the points whose turn comes first, up to the quota, unsorted. */
  static void
  keepFirst (Group& group);

  std::vector<Group> groups_;
};

} // namespace pcl_ops::apps
