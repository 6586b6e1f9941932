// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl_ops::apps {

/** \brief All points of a plane, or those on none, or a sample of them. */
struct SampledPoints {
  /** \brief Of the cloud; \ref places has all of them, or some. */
  std::size_t all = 0;
  /** \brief In an order as good as drawn: the first ones are an even sample. */
  std::vector<Eigen::Vector3d> places;
};

/** \brief Keeps some of the points that pass by, however many these are. Where there
 * are more than asked for, each group keeps a hundred points, or its share of half of
 * them, before the rest is shared out by size. The same for any order of the points;
 * those that are not finite are left out. */
class PointSample {
public:
  /** \param[in] sizes of the groups
   * \param[in] max_points of all groups together */
  PointSample (const std::vector<std::size_t>& sizes, std::size_t max_points);

  void
  add (std::size_t group, const Eigen::Vector3d& place);

  /** \brief The groups; the sample is empty then. */
  std::vector<SampledPoints>
  take ();

private:
  /** \brief A point, and what its turn in the order depends on. */
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

  /** \brief Leaves those whose turn comes first, in any order. */
  static void
  keepFirst (Group& group);

  std::vector<Group> groups_;
};

} // namespace pcl_ops::apps
