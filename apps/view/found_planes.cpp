// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "found_planes.h"

#include <detection/up_search.h>
#include <picture/colors.h>

#include <filesystem>
#include <iomanip>
#include <sstream>

namespace pcl_ops::apps {

namespace {

struct Key {
  char name;
  const char* help;
  /** \brief Null for keys that change the camera, or that PCLVisualizer handles. */
  void (*press) (ViewState&);
};

std::string
methodAfter (const std::string& name)
{
  const std::vector<Method>& methods = allMethods();
  for (std::size_t i = 0; i + 1 < methods.size(); ++i)
    if (methods[i].name == name)
      return methods[i + 1].name;
  return methods.front().name;
}

const Key keys[] = {
    {'1', "color by plane", [] (ViewState& s) { s.coloring = "planes"; }},
    {'2',
     "color by orientation: horizontal green, vertical blue, other orange",
     [] (ViewState& s) { s.coloring = "orientations"; }},
    {'3', "colors of the input", [] (ViewState& s) { s.coloring = "input"; }},
    {'b', "before or after merging", [] (ViewState& s) { s.merging = !s.merging; }},
    {'m',
     "next method: OPS, FSPF, 3D-KHT",
     [] (ViewState& s) { s.method = methodAfter (s.method); }},
    {'p',
     "preset: default or paper",
     [] (ViewState& s) { s.preset = s.preset == "paper" ? "default" : "paper"; }},
    {'l', "outlines on or off", [] (ViewState& s) { s.hulls = !s.hulls; }},
    {'e',
     "edges where planes meet on or off",
     [] (ViewState& s) { s.edges = !s.edges; }},
    {'n', "normals on or off", [] (ViewState& s) { s.normals = !s.normals; }},
    {'h', "this list on or off", [] (ViewState& s) { s.help = !s.help; }},
    {'r', "view as at the start", nullptr},
    {'+', "larger points", nullptr},
    {'-', "smaller points", nullptr},
    {'o', "perspective or parallel projection", nullptr},
    {'q', "quit", nullptr}};

} // namespace

std::string
keysText ()
{
  std::ostringstream text;
  for (const Key& key : keys)
    text << key.name << "  " << key.help << "\n";
  text << "click  say which plane this is";
  return text.str();
}

bool
pressKey (char key, ViewState& state)
{
  for (const Key& own : keys) {
    if (own.name != key || own.press == nullptr)
      continue;
    const ViewState before = state;
    own.press (state);
    if (!state.hasSamePlanes (before))
      state.selected = 0;
    return true;
  }
  return false;
}

FoundPlanes
findPlanes (const ViewState& state,
            DetectorOptions options,
            const XyzCloud::ConstPtr& cloud)
{
  options.preset = state.preset;
  options.merging = state.merging;
  FoundPlanes found{
      runMethod (methodCalled (state.method), options, cloud), {}, {}, {}};
  const std::vector<PlaneSegment>& planes = found.detected.planes;
  for (const PlaneSegment& plane : planes)
    found.extents.push_back (planeExtent (*cloud, plane));
  found.edges = findPlaneEdges (*cloud, planes);
  found.labels = labelsOf (planes, cloud->size());
  return found;
}

pcl::RGB
colorOfPlane (const FoundPlanes& found, const ViewState& state, std::uint32_t id)
{
  return id != 0 && state.coloring == "orientations"
             ? colorOf (found.detected.planes[id - 1].orientation)
             : colorOfLabel (id);
}

std::vector<pcl::RGB>
colorsOfPoints (const FoundPlanes& found,
                const ViewState& state,
                const std::vector<pcl::RGB>& input)
{
  std::vector<pcl::RGB> colors;
  colors.reserve (input.size());
  for (std::size_t i = 0; i < input.size(); ++i) {
    const std::uint32_t label = found.labels[i];
    colors.push_back (state.selected != 0 && state.selected != label
                          ? pcl::RGB (215, 215, 215)
                      : state.coloring == "input" ? input[i]
                                                  : colorOfPlane (found, state, label));
  }
  return colors;
}

std::string
planeText (const FoundPlanes& found, std::uint32_t id, const Eigen::Vector3d& shift)
{
  PlaneSegment segment = found.detected.planes[id - 1];
  segment.centroid += shift;
  const Plane plane = segment.plane();
  std::ostringstream text;
  text << "plane " << id << ": " << toString (segment.orientation) << ", "
       << segment.inliers.size() << " points, area " << std::fixed
       << std::setprecision (3) << found.extents[id - 1].area << "\n"
       << std::setprecision (4) << std::showpos << plane.normal.x() << " x "
       << plane.normal.y() << " y " << plane.normal.z() << " z " << plane.offset
       << " = 0";
  return text.str();
}

std::string
statusText (const std::string& file,
            const FoundPlanes& found,
            const ViewState& state,
            const Eigen::Vector3d& shift)
{
  const Detected& detected = found.detected;
  std::ostringstream text;
  if (state.help)
    text << keysText() << "\n\n";
  text << std::filesystem::path (file).filename().string() << ", "
       << found.labels.size() << " points\n"
       << methodCalled (state.method).title << ", " << state.preset << " preset\n"
       << detected.planes.size() << (detected.planes.size() == 1 ? " plane" : " planes")
       << (state.merging ? "" : " before merging");
  std::vector<std::string> notes = detected.hints;
  notes.push_back (detected.up_note);
  if (detected.planes.empty())
    notes.push_back (detected.advice);
  if (state.selected != 0)
    notes.push_back (planeText (found, state.selected, shift));
  for (const std::string& note : notes)
    text << (note.empty() ? "" : "\n") << note;
  return text.str();
}

} // namespace pcl_ops::apps
