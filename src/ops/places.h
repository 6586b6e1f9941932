// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cloud/points.h"

#include <cstddef>
#include <vector>

namespace pcl_ops::internal {

/** \brief The plane fit to the points around a place. */
struct Support {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  /** \brief Rms distance of the points to the plane [m], with the variance of quantized
   * depth, corrected for the three parameters of the fit. */
  float scatter = 0.0F;
  /** \brief Extent of the points in the narrower direction in the plane [m]: the width
   * of a uniform distribution with their variance. */
  float width = 0.0F;
  /** \brief Whether its scatter is small for its width, and it is no line. The limits
   * are PlaceConstants::max_thickness and min_slimness. */
  bool is_flat = false;
};

/** \brief Distinct points, each with its neighborhood. No cells divide space: one more
 * or one less point in the cloud changes a neighborhood by one point only. The borders
 * of cells of a grid or a tree could move, and a cell could then hold entirely
 * different points. */
struct Places {
  /** \brief [m] in the local frame, whose zero is Points::origin. */
  std::vector<Eigen::Vector3d> position;
  /** \brief The nearest places of each place, without itself, nearest first, in clouds
   * with quantized depth by scaled distances (PlaceConstants::depth_scale): \ref
   * neighbors_per_place entries for place 0, then as many for place 1, and so on. */
  Indices nearest;
  std::size_t neighbors_per_place = 0;
  /** \brief For each place the points of its neighborhood over the squared width of
   * its smallest support [1/m^2]. */
  std::vector<float> density;
  /** \brief supports[level][place]; the supports grow with the level. */
  std::vector<std::vector<Support>> supports;
  /** \brief For each level how many independent points a support counts as. */
  std::vector<double> points_of_level;

  std::size_t
  size () const
  {
    return position.size();
  }

  /** \brief Pointer to the \ref neighbors_per_place nearest places of a place. */
  const std::uint32_t*
  nearestOf (std::size_t place) const
  {
    return nearest.data() + place * neighbors_per_place;
  }
};

/** \brief Returns the number of points of a neighborhood, its place included. The
 * number follows from the size of the cloud as PlaceConstants::min_neighborhood
 * describes.
 * \param[in] points number of points of the cloud
 * \param[in] factor multiplies the number before it is rounded
 * \return 6 to NearestPoints::max_size; may exceed \p points */
std::size_t
neighborhoodSize (double points, double factor);

/** \brief Makes each point a place: finds its nearest points, and fits planes to its
 * supports.
 *
 * The smallest support of a place is its neighborhood. The support of the next level
 * adds up the supports of the place and of its arms: eight places around it (fewer in
 * small neighborhoods). On level 1 they are the farthest places of its neighborhood.
 * From level to level they are about twice as far away. So all levels cost the same,
 * however many points their supports have.
 * \param[in] points six (min_places) or more, all different, in an order that depends
 * only on their coordinates: so the result does not depend on the order of the cloud
 * \param[in] neighborhood_size points of a neighborhood, its place included; six or
 * more, at most as many as \p points */
Places
describePlaces (const Coordinates& points,
                std::size_t neighborhood_size,
                unsigned threads);

} // namespace pcl_ops::internal
