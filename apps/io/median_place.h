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

/** \brief A place near most points of a cloud: one outlier must not leave the others
 * without digits. Zero where no point is finite.
 * \param[in] size of the cloud
 * \param[in] place of a point; some thousand are looked at, or as many as it takes to
 * find a finite one */
Eigen::Vector3d
usualPlace (std::size_t size,
            const std::function<Eigen::Vector3d (std::size_t)>& place);

} // namespace pcl_ops::apps
