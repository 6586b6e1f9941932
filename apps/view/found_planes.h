// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_types.h>

#include <boost/format.hpp>

#include <detection/methods.h>
#include <pcl_ops/plane_extent.h>
#include <picture/colors.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief What the window shows, as far as keys and clicks change it; the camera is not
 * part of it. */
struct ViewState {
  /** \brief The name of the detector: Method::name. */
  std::string method = "ops";
  /** \brief Options of the detector. Keys change only its preset. */
  DetectorOptions detector;
  /** \brief What colors show: "planes" or "orientations". */
  std::string coloring = "planes";
  /** \brief Whether the window lists the keys. */
  bool shows_keys = true;
  /** \brief The plane that was clicked, counted from 1; 0 for none. */
  std::uint32_t selected = 0;
};

/** \brief The keys of the viewer, one in each line, for the window and --help. */
inline constexpr const char* list_of_keys =
    R"(1  color by plane
2  color by orientation: horizontal green, vertical blue, other orange
m  next method: OPS, FSPF, 3D-KHT
p  preset: default or paper
h  this list on or off
r  view as at the start
+  larger points
-  smaller points
q  quit
shift and click  say which plane this is)";

/** \brief Changes a state as the keys 1, 2, h, m and p do; other keys do not change it.
 * As another method or preset finds other planes, m and p clear the selection.
 * \return whether it was one of these keys */
inline bool
pressKey (char key, ViewState& state)
{
  switch (key) {
  case '1':
    state.coloring = "planes";
    return true;
  case '2':
    state.coloring = "orientations";
    return true;
  case 'h':
    state.shows_keys = !state.shows_keys;
    return true;
  case 'm': {
    const Method* const next = &methodCalled (state.method) + 1;
    const bool was_last = next > &allMethods().back();
    state.method = was_last ? allMethods().front().name : next->name;
    break;
  }
  case 'p':
    state.detector.preset = state.detector.preset == "paper" ? "default" : "paper";
    break;
  default:
    return false;
  }
  state.selected = 0;
  return true;
}

/** \brief A cloud and the planes found in it. */
struct FoundPlanes {
  XyzCloud::ConstPtr cloud;
  Detected detected;
  /** \brief For each point: 0 for no plane, else the index of its plane plus 1. */
  std::vector<std::uint32_t> labels;
};

/** \brief Finds planes by the method and preset of a state.
 * \throws UsageError or WorkError as the detector does */
inline FoundPlanes
findPlanes (const ViewState& state, const XyzCloud::ConstPtr& cloud)
{
  FoundPlanes found{
      cloud, runMethod (methodCalled (state.method), state.detector, cloud), {}};
  found.labels = labelsOf (found.detected.planes, cloud->size());
  return found;
}

/** \brief Returns the color of a point; light gray if another plane is selected. */
inline pcl::RGB
colorOfPoint (const FoundPlanes& found, const ViewState& state, std::size_t point)
{
  constexpr std::uint8_t light_gray = 215;
  const std::uint32_t label = found.labels[point];
  if (state.selected != 0 && state.selected != label)
    return {light_gray, light_gray, light_gray};
  return label != 0 && state.coloring == "orientations"
             ? colorOf (found.detected.planes[label - 1].orientation)
             : colorOfLabel (label);
}

/** \brief Returns number, orientation, number of points, area and equation of the
 * selected plane, in the frame of the file.
 * \param[in] state must have a selected plane
 * \param[in] shift origin of the frame of the planes in the frame of the file */
inline std::string
planeText (const FoundPlanes& found,
           const ViewState& state,
           const Eigen::Vector3d& shift)
{
  PlaneSegment segment = found.detected.planes[state.selected - 1];
  const double area = planeExtent (*found.cloud, segment).area;
  segment.centroid += shift;
  const Plane plane = segment.plane();
  return str (boost::format ("plane %1%: %2%, %3% points, area %4$.3f\n"
                             "%5$+.4f x %6$+.4f y %7$+.4f z %8$+.4f = 0") %
              state.selected % toString (segment.orientation) % segment.inliers.size() %
              area % plane.normal.x() % plane.normal.y() % plane.normal.z() %
              plane.offset);
}

/** \brief Returns the text in the window: keys, number of planes, notes of the
 * detector, and the selected plane. */
inline std::string
statusText (const FoundPlanes& found,
            const ViewState& state,
            const Eigen::Vector3d& shift)
{
  const Detected& detected = found.detected;
  const std::size_t planes = detected.planes.size();
  std::string text;
  if (state.shows_keys)
    text = list_of_keys + std::string ("\n\n");
  text += std::to_string (found.labels.size()) + " points\n";
  text +=
      methodCalled (state.method).title + ", " + state.detector.preset + " preset\n";
  text += std::to_string (planes) + (planes == 1 ? " plane" : " planes");
  std::vector<std::string> notes = detected.hints;
  notes.push_back (detected.up_note);
  if (detected.planes.empty())
    notes.push_back (detected.advice);
  if (state.selected != 0)
    notes.push_back (planeText (found, state, shift));
  for (const std::string& note : notes)
    text += (note.empty() ? "" : "\n") + note;
  return text;
}

} // namespace pcl_ops::apps
