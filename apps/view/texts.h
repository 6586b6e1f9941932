// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "found_planes.h"
#include "view_state.h"

#include <string>

namespace pcl_ops::apps {

/** \brief What the window says about a cloud and the run that is shown, some lines.
 * \param[in] file the cloud's name */
std::string
statusText (const std::string& file, const FoundPlanes& found, const ViewState& state);

/** \brief The same text with lines no longer than a window is wide. */
std::string
wrapped (const std::string& text);

/** \brief The keys, one in a line. */
std::string
keysText ();

/** \brief Number, orientation, size, area and equation of a plane.
 * \param[in] id its position plus 1
 * \param[in] shift zero of the frame of the planes in the frame of the file */
std::string
planeText (const FoundPlanes& found, std::uint32_t id, const Eigen::Vector3d& shift);

} // namespace pcl_ops::apps
