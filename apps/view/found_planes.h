// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

#include <detection/methods.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief What the keys and clicks of the viewer change, but for the camera. */
struct ViewState {
  std::string method = "ops", preset = "default";
  /** \brief What colors show: "planes" or "orientations". */
  std::string coloring = "planes";
  /** \brief Whether the window lists the keys. */
  bool help = true;
  /** \brief The plane that was clicked, counted from 1; 0 for none. */
  std::uint32_t selected = 0;
};

/** \brief The keys of the viewer, one a line, for the window and --help. */
std::string
keysText ();

/** \brief Changes a state as a key asks for. Other planes are shown without a selected
 * one. \return false if the key changes no state */
bool
pressKey (char key, ViewState& state);

struct FoundPlanes {
  XyzCloud::ConstPtr cloud;
  Detected detected;
  /** \brief Per point: 0 for no plane, else its position in the planes plus 1. */
  std::vector<std::uint32_t> labels;
};

/** \throws UsageError or WorkError as the detector does */
FoundPlanes
findPlanes (const ViewState& state,
            DetectorOptions options,
            const XyzCloud::ConstPtr& cloud);

/** \brief The color of a point; where another plane is selected, light gray. */
pcl::RGB
colorOfPoint (const FoundPlanes& found, const ViewState& state, std::size_t point);

/** \brief Number, orientation, size, area and equation of the selected plane.
 * \param[in] shift zero of the frame of the planes in the frame of the file */
std::string
planeText (const FoundPlanes& found,
           const ViewState& state,
           const Eigen::Vector3d& shift);

/** \brief What the window says: the keys, the planes, which parameter to change where
 * none was found, and the selected plane. */
std::string
statusText (const FoundPlanes& found,
            const ViewState& state,
            const Eigen::Vector3d& shift);

} // namespace pcl_ops::apps
