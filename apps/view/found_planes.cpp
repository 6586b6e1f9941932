// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "found_planes.h"

#include <boost/format.hpp>

#include <detection/methods.h>
#include <pcl_ops/plane_extent.h>
#include <picture/colors.h>

namespace pcl_ops::apps {

namespace {

std::string
methodAfter (const std::string& name)
{
  const Method* const next = &methodCalled (name) + 1;
  return (next > &allMethods().back() ? allMethods().front() : *next).name;
}

} // namespace

std::string
keysText ()
{
  return "1  color by plane\n"
         "2  color by orientation: horizontal green, vertical blue, other orange\n"
         "m  next method: OPS, FSPF, 3D-KHT\n"
         "p  preset: default or paper\n"
         "h  this list on or off\n"
         "r  view as at the start\n"
         "+  larger points\n"
         "-  smaller points\n"
         "q  quit\n"
         "shift and click  say which plane this is";
}

bool
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
    state.help = !state.help;
    return true;
  case 'm':
    state.method = methodAfter (state.method);
    break;
  case 'p':
    state.preset = state.preset == "paper" ? "default" : "paper";
    break;
  default:
    return false;
  }
  state.selected = 0;
  return true;
}

FoundPlanes
findPlanes (const ViewState& state,
            DetectorOptions options,
            const XyzCloud::ConstPtr& cloud)
{
  options.preset = state.preset;
  FoundPlanes found{cloud, runMethod (methodCalled (state.method), options, cloud), {}};
  found.labels = labelsOf (found.detected.planes, cloud->size());
  return found;
}

pcl::RGB
colorOfPoint (const FoundPlanes& found, const ViewState& state, std::size_t point)
{
  const std::uint32_t label = found.labels[point];
  if (state.selected != 0 && state.selected != label)
    return {215, 215, 215};
  return label != 0 && state.coloring == "orientations"
             ? colorOf (found.detected.planes[label - 1].orientation)
             : colorOfLabel (label);
}

std::string
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

std::string
statusText (const FoundPlanes& found,
            const ViewState& state,
            const Eigen::Vector3d& shift)
{
  const Detected& detected = found.detected;
  const std::size_t planes = detected.planes.size();
  std::string text =
      str (boost::format ("%1%%2% points\n%3%, %4% preset\n%5% plane%6%") %
           (state.help ? keysText() + "\n\n" : "") % found.labels.size() %
           methodCalled (state.method).title % state.preset % planes %
           (planes == 1 ? "" : "s"));
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
