// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "drawing.h"
#include <cli/text.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace pcl_ops::apps {

namespace {

constexpr double millimeters = 1000.0; // of a meter
constexpr double margin = 10.0;        // on paper [mm]

std::string
escaped (const std::string& text)
{
  std::string written;
  for (const char c : validUtf8 (text))
    switch (c) {
    case '&':
      written += "&amp;";
      break;
    case '<':
      written += "&lt;";
      break;
    case '>':
      written += "&gt;";
      break;
    case '"':
      written += "&quot;";
      break;
    default:
      written += static_cast<unsigned char> (c) < ' ' ? ' ' : c;
    }
  return written;
}

/** \brief Transforms meters to millimeters on paper, where y points down. */
struct Paper {
  Eigen::AlignedBox2d box;
  double scale;

  Eigen::Vector2d
  at (const Eigen::Vector3d& place) const
  {
    const double factor = millimeters / scale;
    return {margin + factor * (place.x() - box.min().x()),
            margin + factor * (box.max().y() - place.y())};
  }
  Eigen::Vector2d
  size () const
  {
    constexpr double foot = 12.0; // for the scale bar [mm]
    return (millimeters / scale * box.sizes()).array() + 2.0 * margin +
           Eigen::Array2d (0.0, foot);
  }
};

Paper
paperFor (const Drawing& drawing)
{
  Eigen::AlignedBox2d box;
  for (const DrawnLine& line : drawing.lines)
    for (const Eigen::Vector3d& corner : line.corners)
      box.extend (corner.head<2>().eval());
  if (box.isEmpty())
    box = {Eigen::Vector2d (0, 0), Eigen::Vector2d (1, 1)};
  constexpr double width = 380.0;
  constexpr double height = 250.0; // of A3 without margins [mm]
  const Eigen::Vector2d sizes = millimeters * box.sizes();
  const double least = std::max (sizes.x() / width, sizes.y() / height);
  const double usual[] = {20, 50, 100, 200, 500, 1000, 2000, 5000, 10'000};
  const double* const scale =
      std::lower_bound (std::begin (usual), std::end (usual), least);
  return {box, scale == std::end (usual) ? std::ceil (least) : *scale};
}

void
putBar (const Paper& paper, std::ostream& svg)
{
  // At most 5 cm on paper, and 1, 2 or 5 times a power of ten [m].
  const double longest = 50.0 * paper.scale / millimeters;
  double length = std::pow (10.0, std::floor (std::log10 (longest)));
  for (const double factor : {5.0, 2.0})
    if (factor * length <= longest) {
      length *= factor;
      break;
    }
  const double y = paper.size().y() - margin;
  const double width = length * millimeters / paper.scale;
  svg << "<path d=\"M" << margin << ' ' << y - 1.5 << "v1.5h" << width
      << "v-1.5\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.25\"/>\n<text x=\""
      << margin + width + 3 << "\" y=\"" << y << "\" font-size=\"4\">" << length
      << " m, 1:" << paper.scale << "</text>\n";
}

void
putLine (const DrawnLine& line,
         const Layer& layer,
         const Paper& paper,
         std::ostream& svg)
{
  svg << "<path d=\"";
  for (std::size_t i = 0; i < line.corners.size(); ++i) {
    const Eigen::Vector2d at = paper.at (line.corners[i]);
    svg << (i == 0 ? 'M' : 'L') << at.x() << ' ' << at.y();
  }
  svg << (line.is_closed ? "Z" : "") << "\" stroke=\"" << layer.web_color
      << "\" stroke-width=\"" << layer.width << "\"/>\n";
}

} // namespace

std::string
toSvg (const Drawing& drawing, const std::string& title)
{
  const Paper paper = paperFor (drawing);
  std::ostringstream svg;
  svg.imbue (std::locale::classic());
  svg << std::setprecision (7);
  const Eigen::Vector2d size = paper.size();
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << size.x()
      << "mm\" height=\"" << size.y() << "mm\" viewBox=\"0 0 " << size.x() << ' '
      << size.y() << "\" font-family=\"sans-serif\">\n<title>" << escaped (title)
      << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  for (const Layer& layer : drawing.layers) {
    svg << "<g id=\"" << escaped (layer.name) << "\" fill=\"none\" "
        << (layer.is_dashed ? "stroke-dasharray=\"2 1\"" : "stroke-linecap=\"square\"")
        << ">\n";
    for (const DrawnLine& line : drawing.lines)
      if (line.layer == layer.name)
        putLine (line, layer, paper, svg);
    for (const DrawnText& text : drawing.texts)
      if (text.layer == layer.name) {
        const Eigen::Vector2d at = paper.at (text.at);
        const double height = text.height * millimeters / paper.scale;
        svg << "<text x=\"" << at.x() << "\" y=\"" << at.y() + 0.5 * height
            << "\" font-size=\"" << 1.4 * height << "\" text-anchor=\"middle\" fill=\""
            << layer.web_color << "\">" << escaped (text.text) << "</text>\n";
      }
    svg << "</g>\n";
  }
  putBar (paper, svg);
  return svg.str() + "</svg>\n";
}

} // namespace pcl_ops::apps
