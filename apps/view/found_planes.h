// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

#include <detection/methods.h>
#include <pcl_ops/plane_edges.h>
#include <pcl_ops/plane_extent.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief What the keys and clicks of the viewer change, but for the camera. */
struct ViewState {
  std::string method = "ops";
  std::string preset = "default";
  /** \brief Off: the planes before they are merged. */
  bool merging = true;
  /** \brief What colors show: "planes", "orientations" or "input". */
  std::string coloring = "planes";
  bool hulls = false;
  bool edges = false;
  bool normals = false;
  /** \brief Whether the window lists the keys. */
  bool help = true;
  /** \brief The plane that was clicked, counted from 1; 0 for none. */
  std::uint32_t selected = 0;

  bool
  hasSamePlanes (const ViewState& other) const
  {
    return method == other.method && preset == other.preset && merging == other.merging;
  }
};

/** \brief The keys of the viewer, one a line, for the window and --help. */
std::string
keysText ();

/** \brief Changes a state as a key asks for. Other planes are shown without a selected
 * one. \return false if the key changes no state */
bool
pressKey (char key, ViewState& state);

/** \brief The planes of a cloud with what is needed to show them. */
struct FoundPlanes {
  Detected detected;
  std::vector<PlaneExtent> extents;
  PlaneEdges edges;
  /** \brief Per point: 0 for no plane, else its position in the planes plus 1. */
  std::vector<std::uint32_t> labels;
};

/** \brief Finds the planes a state asks for.
 * \throws UsageError or WorkError as the detector does */
FoundPlanes
findPlanes (const ViewState& state,
            DetectorOptions options,
            const XyzCloud::ConstPtr& cloud);

/** \brief The color of the points of a plane, by its number or its orientation.
 * \param[in] id its position plus 1; 0: of points on no plane */
pcl::RGB
colorOfPlane (const FoundPlanes& found, const ViewState& state, std::uint32_t id);

/** \brief The color of each point; where a plane is selected, all others are light
 * gray. \param[in] input the colors of the file, one per point */
std::vector<pcl::RGB>
colorsOfPoints (const FoundPlanes& found,
                const ViewState& state,
                const std::vector<pcl::RGB>& input);

/** \brief Number, orientation, size, area and equation of a plane.
 * \param[in] id its position plus 1
 * \param[in] shift zero of the frame of the planes in the frame of the file */
std::string
planeText (const FoundPlanes& found, std::uint32_t id, const Eigen::Vector3d& shift);

/** \brief What the window says: the keys, the cloud, the planes, which parameter to
 * change where none was found, and the selected plane. \param[in] file the cloud's name
 */
std::string
statusText (const std::string& file,
            const FoundPlanes& found,
            const ViewState& state,
            const Eigen::Vector3d& shift);

} // namespace pcl_ops::apps
