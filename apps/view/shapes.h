// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/visualization/pcl_visualizer.h>

#include "found_planes.h"

namespace pcl_ops::apps {

/** \brief Draws the outlines, normals, edges and corners that a state asks for, in
 * place of those drawn before.
 * \param[in] arrow length of a normal, in the unit of the cloud */
void
drawShapes (pcl::visualization::PCLVisualizer& viewer,
            const FoundPlanes& found,
            const ViewState& state,
            double arrow);

} // namespace pcl_ops::apps
