// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "texts.h"

#include <cmath>
#include <filesystem>
#include <iomanip>
#include <sstream>

namespace pcl_ops::apps {

namespace {

const char*
nameOf (Coloring coloring)
{
  switch (coloring) {
  case Coloring::Planes:
    return "each plane a colour, no plane grey";
  case Coloring::Orientations:
    return "horizontal green, vertical blue, other orange, no plane grey";
  default:
    return "colours of the input";
  }
}

/** \brief The equation a x + b y + c z + d = 0. */
std::string
equationOf (const Plane& plane)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision (4);
  const auto add = [&] (double number, const char* unknown) {
    const bool is_first = text.tellp() == std::streampos (0);
    text << (is_first       ? (number < 0.0 ? "-" : "")
             : number < 0.0 ? " - "
                            : " + ")
         << std::abs (number) << unknown;
  };
  add (plane.normal.x(), " x");
  add (plane.normal.y(), " y");
  add (plane.normal.z(), " z");
  add (plane.offset, " = 0");
  return text.str();
}

} // namespace

std::string
statusText (const std::string& file, const FoundPlanes& found, const ViewState& state)
{
  const std::size_t number = found.planes.size();
  std::ostringstream text;
  text << std::filesystem::path (file).filename().string() << ", "
       << found.labels.size() << (found.labels.size() == 1 ? " point\n" : " points\n")
       << methodCalled (state.run.method).title << ", " << state.run.preset
       << " preset\n"
       << number << (number == 1 ? " plane" : " planes")
       << (state.run.merging ? "" : " before merging") << "\n"
       << nameOf (state.coloring);
  if (!found.up_note.empty())
    text << "\n" << wrapped (found.up_note);
  if (number == 0)
    text << "\n" << wrapped ("No plane found: " + found.advice);
  return text.str();
}

std::string
wrapped (const std::string& text)
{
  constexpr std::size_t line_width = 64;
  std::istringstream words (text);
  std::string lines, word;
  std::size_t length = 0;
  while (words >> word) {
    const bool fits = length + 1 + word.size() <= line_width;
    lines += (lines.empty() ? "" : fits ? " " : "\n") + word;
    length = fits ? length + 1 + word.size() : word.size();
  }
  return lines;
}

std::string
keysText ()
{
  std::string text;
  for (const Key& key : allKeys())
    text += key.name + "  " + key.help + "\n";
  return text + "click  say which plane this is";
}

std::string
planeText (const FoundPlanes& found, std::uint32_t id, const Eigen::Vector3d& shift)
{
  PlaneSegment plane = found.planes[id - 1];
  plane.centroid += shift;
  std::ostringstream text;
  text << "plane " << id << ": " << toString (plane.orientation) << ", "
       << plane.inliers.size() << " points, area " << std::fixed
       << std::setprecision (3) << found.extents[id - 1].area << "\n"
       << equationOf (plane.plane());
  return text.str();
}

} // namespace pcl_ops::apps
