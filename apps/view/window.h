// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

#include <Eigen/Core>

#include "view_state.h"
#include <detection/methods.h>
#include <io/shifted_cloud.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief What the command line asks for. */
struct ViewOptions {
  std::string input;
  /** \brief The picture to make instead of opening a window; empty for a window. */
  std::string screenshot;
  DetectorOptions detector;
  ViewState state;
  /** \brief Size of the window [pixel]. */
  int width = 1280;
  int height = 960;
};

/** \brief A cloud as the viewer needs it. */
struct ViewedCloud {
  XyzCloud::ConstPtr coordinates;
  /** \brief Zero of the frame of the coordinates in the frame of the file. */
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  /** \brief One per point. */
  std::vector<pcl::RGB> colors;
};

/** \brief Opens a window until the user closes it, or writes options.screenshot.
 * There must be a display.
 * \param[in] cloud has a finite point
 * \throws WorkError if the picture cannot be written, and whatever the first detection
 * throws */
void
showCloud (const ViewOptions& options, const ViewedCloud& cloud);

} // namespace pcl_ops::apps
