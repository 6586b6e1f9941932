// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "found_planes.h"

#include <detection/up_search.h>
#include <picture/colors.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iomanip>
#include <numeric>
#include <sstream>
#include <utility>

namespace pcl_ops::apps {

namespace {

/** \brief The plane that most of a plane's points lie on after merging; 0 for none. */
std::uint32_t
mergedInto (const PlaneSegment& plane, const FoundPlanes& after)
{
  std::vector<std::size_t> votes (after.planes.size() + 1, 0);
  for (const pcl::index_t index : plane.inliers)
    ++votes[after.labels[static_cast<std::size_t> (index)]];
  votes[0] = 0;
  return static_cast<std::uint32_t> (std::max_element (votes.begin(), votes.end()) -
                                     votes.begin());
}

/** \brief A color between two: 0 for the first, 1 for the second. */
pcl::RGB
blend (const pcl::RGB& first, const pcl::RGB& second, double share)
{
  const auto part = [share] (std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t> (std::lround (from + share * (to - from)));
  };
  return {part (first.r, second.r), part (first.g, second.g), part (first.b, second.b)};
}

pcl::RGB
shaded (const pcl::RGB& color, const Eigen::Vector3d& normal)
{
  constexpr double darkest = 0.35;
  const Eigen::Vector3d light = Eigen::Vector3d (0.3, 0.55, 0.78).normalized();
  return blend (color, {0, 0, 0}, darkest * (1.0 - std::abs (normal.dot (light))));
}

} // namespace

std::vector<std::uint32_t>
colorsBeforeMerging (const FoundPlanes& before, const FoundPlanes& after)
{
  std::vector<bool> is_taken (after.planes.size() + 1, false);
  is_taken[0] = true;
  auto last = static_cast<std::uint32_t> (after.planes.size());
  std::vector<std::uint32_t> colors;
  for (const PlaneSegment& plane : before.planes) { // by falling size
    const std::uint32_t merged = mergedInto (plane, after);
    colors.push_back (is_taken[merged] ? ++last : merged);
    is_taken[merged] = true;
  }
  return colors;
}

FoundPlanes
findPlanes (const ViewState& state,
            DetectorOptions options,
            const XyzCloud::ConstPtr& cloud)
{
  options.preset = state.preset;
  options.merging = state.merging;
  Detected detected = runMethod (methodCalled (state.method), options, cloud);
  FoundPlanes found;
  found.up = detected.up;
  found.planes = std::move (detected.planes);
  found.labels = labelsOf (found.planes, cloud->size());
  for (const PlaneSegment& plane : found.planes)
    found.extents.push_back (planeExtent (*cloud, plane));
  found.edges = findPlaneEdges (*cloud, found.planes);
  found.colors.resize (found.planes.size());
  std::iota (found.colors.begin(), found.colors.end(), 1);
  found.notes = detected.up_note;
  for (const std::string& hint : detected.hints)
    found.notes += (found.notes.empty() ? "" : "\n") + hint;
  if (found.planes.empty())
    found.notes += (found.notes.empty() ? "" : "\n") + detected.advice;
  if (!state.merging) {
    ViewState after = state;
    after.merging = true;
    found.colors = colorsBeforeMerging (found, findPlanes (after, options, cloud));
  }
  return found;
}

std::vector<pcl::RGB>
planeColors (const FoundPlanes& found, const ViewState& state)
{
  std::vector<pcl::RGB> colors;
  for (std::size_t i = 0; i < found.planes.size(); ++i) {
    const PlaneSegment& plane = found.planes[i];
    colors.push_back (state.coloring == Coloring::Orientations
                          ? shaded (colorOf (plane.orientation), plane.normal)
                          : colorOfLabel (found.colors[i]));
  }
  return colors;
}

std::vector<pcl::RGB>
pointColors (const FoundPlanes& found,
             const ViewState& state,
             const std::vector<pcl::RGB>& input)
{
  constexpr double faded_share = 0.75;
  const pcl::RGB light_gray (215, 215, 215);
  const std::vector<pcl::RGB> planes = planeColors (found, state);
  std::vector<pcl::RGB> colors;
  colors.reserve (found.labels.size());
  for (std::size_t i = 0; i < found.labels.size(); ++i) {
    const std::uint32_t label = found.labels[i];
    const pcl::RGB color = state.coloring == Coloring::Input ? input[i]
                           : label == 0                      ? colorOfLabel (0)
                                                             : planes[label - 1];
    const bool fades = state.selected != 0 && state.selected != label;
    colors.push_back (fades ? blend (color, light_gray, faded_share) : color);
  }
  return colors;
}

std::string
planeText (const FoundPlanes& found, std::uint32_t id, const Eigen::Vector3d& shift)
{
  PlaneSegment segment = found.planes[id - 1];
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
  std::ostringstream text;
  if (state.help)
    text << keysText() << "\n\n";
  text << std::filesystem::path (file).filename().string() << ", "
       << found.labels.size() << " points\n"
       << methodCalled (state.method).title << ", " << state.preset << " preset\n"
       << found.planes.size() << (found.planes.size() == 1 ? " plane" : " planes")
       << (state.merging ? "" : " before merging");
  if (!found.notes.empty())
    text << "\n" << found.notes;
  if (state.selected != 0)
    text << "\n" << planeText (found, state.selected, shift);
  return text.str();
}

} // namespace pcl_ops::apps
