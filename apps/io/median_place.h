// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <vector>

namespace pcl_ops::apps {

/** \brief The median of each coordinate: near most of the places, wherever a few stray
 * to; NaN for none. */
Eigen::Vector3d
medianPlace (const std::vector<Eigen::Vector3d>& places);

/** \brief Of a point, by its index. */
using PlaceOf = std::function<Eigen::Vector3d (std::size_t)>;

/** \brief Places of some of the points, evenly spread over their order, without those
 * that are not finite. */
std::vector<Eigen::Vector3d>
somePlaces (std::size_t size, const PlaceOf& place, std::size_t looked_at);

/** \brief A place near most points of a cloud: one outlier must not leave the others
 * without digits. Zero where no point is finite.
 * \param[in] size of the cloud
 * \param[in] place of a point; some thousand are looked at, or as many as it takes to
 * find a finite one */
Eigen::Vector3d
usualPlace (std::size_t size, const PlaceOf& place);

/** \brief Of the whole multiples of a step along each axis the nearest to a place. */
Eigen::Vector3d
nearestMultiple (const Eigen::Vector3d& place, double step);

} // namespace pcl_ops::apps
