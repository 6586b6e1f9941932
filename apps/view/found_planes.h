// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "view_state.h"
#include <detection/methods.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_extent.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief The planes of a cloud with what is needed to show them. */
struct FoundPlanes {
  /** \brief Direction against gravity, as given or found. */
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  std::vector<PlaneSegment> planes;
  std::vector<PlaneExtent> extents;
  PlaneEdges edges;
  /** \brief The label each plane has the color of (\ref colorOfLabel). */
  std::vector<std::uint32_t> colors;
  /** \brief Per point: 0 for no plane, else its position in \ref planes plus 1. */
  std::vector<std::uint32_t> labels;
  /** \brief Which parameter to change where no plane was found, and what was found of
   * the up axis; empty where there is nothing to say. */
  std::string notes;
};

/** \brief Finds the planes a state asks for.
 * \throws UsageError or WorkError as the detector does */
FoundPlanes
findPlanes (const ViewState& state,
            DetectorOptions options,
            const XyzCloud::ConstPtr& cloud);

/** \brief The label each plane before merging has the color of: the largest part of
 * every merged plane that of the plane, the others labels of their own.
 * \param[in] before, after of one cloud */
std::vector<std::uint32_t>
colorsBeforeMerging (const FoundPlanes& before, const FoundPlanes& after);

/** \brief The color of each plane as a state asks for it. Orientations are shaded by
 * the direction of the plane, which tells neighbors of one class apart. */
std::vector<pcl::RGB>
planeColors (const FoundPlanes& found, const ViewState& state);

/** \brief The color of each point as a state asks for it; where a plane is selected,
 * all others fade.
 * \param[in] input the colors of the file, one per point */
std::vector<pcl::RGB>
pointColors (const FoundPlanes& found,
             const ViewState& state,
             const std::vector<pcl::RGB>& input);

/** \brief Number, orientation, size, area and equation of a plane.
 * \param[in] id its position plus 1
 * \param[in] shift zero of the frame of the planes in the frame of the file */
std::string
planeText (const FoundPlanes& found, std::uint32_t id, const Eigen::Vector3d& shift);

/** \brief What the window says: the keys, the cloud, the planes and the selected one.
 * \param[in] file the cloud's name */
std::string
statusText (const std::string& file,
            const FoundPlanes& found,
            const ViewState& state,
            const Eigen::Vector3d& shift);

} // namespace pcl_ops::apps
