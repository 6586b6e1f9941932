// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/algorithm/string/replace.hpp>

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

constexpr double millimeters_of_meter = 1000.0;
constexpr double paper_margin = 10.0; // [mm]

/** \brief Returns text in a form that XML allows. */
std::string
escaped (const std::string& text)
{
  std::string characters = validUtf8 (text);
  // U+FFFE and U+FFFF, which XML does not allow, become U+FFFD.
  for (const char* const forbidden : {"\xef\xbf\xbe", "\xef\xbf\xbf"})
    boost::replace_all (characters, forbidden, "\xef\xbf\xbd");
  std::string xml;
  for (const char c : characters)
    switch (c) {
    case '&':
      xml += "&amp;";
      break;
    case '<':
      xml += "&lt;";
      break;
    case '>':
      xml += "&gt;";
      break;
    case '"':
      xml += "&quot;";
      break;
    default:
      xml += static_cast<unsigned char> (c) < ' ' ? ' ' : c;
    }
  return xml;
}

/** \brief The sheet for a drawing. On paper lengths are in mm, and y points down. */
struct Paper {
  /** \brief The bounding box of all lines of the drawing [m]. */
  Eigen::AlignedBox2d box;
  /** \brief The denominator of the scale: 100 for 1:100. */
  double scale;

  /** \brief Returns the position on paper [mm] of a point of the drawing [m]. */
  Eigen::Vector2d
  onPaper (const Eigen::Vector3d& point) const
  {
    const double factor = millimeters_of_meter / scale;
    return {paper_margin + factor * (point.x() - box.min().x()),
            paper_margin + factor * (box.max().y() - point.y())};
  }

  /** \brief Returns width and height of the paper [mm]. */
  Eigen::Vector2d
  size () const
  {
    constexpr double scale_bar_height = 12.0; // with the space above it [mm]
    return (millimeters_of_meter / scale * box.sizes()).array() + 2.0 * paper_margin +
           Eigen::Array2d (0.0, scale_bar_height);
  }
};

/** \brief Returns a paper at the largest usual scale at which the drawing fits on A3.
 */
Paper
paperFor (const Drawing& drawing)
{
  Eigen::AlignedBox2d box;
  for (const DrawnLine& line : drawing.lines)
    for (const Eigen::Vector3d& corner : line.corners)
      box.extend (corner.head<2>().eval());
  if (box.isEmpty())
    box = {Eigen::Vector2d (0, 0), Eigen::Vector2d (1, 1)};
  // What is free for the drawing on A3, 420 mm x 297 mm, without the margins, the scale
  // bar, and the border that printers leave white.
  constexpr double max_width = 380.0, max_height = 250.0; // [mm]
  const Eigen::Vector2d sizes = millimeters_of_meter * box.sizes();
  const double min_scale = std::max (sizes.x() / max_width, sizes.y() / max_height);
  const double usual_scales[] = {20, 50, 100, 200, 500, 1000, 2000, 5000, 10'000};
  const double* const scale =
      std::lower_bound (std::begin (usual_scales), std::end (usual_scales), min_scale);
  return {box, scale == std::end (usual_scales) ? std::ceil (min_scale) : *scale};
}

/** \brief Writes a scale bar with its length and the scale. The length is 1, 2 or 5
 * times a power of ten [m]. */
void
putScaleBar (const Paper& paper, std::ostream& svg)
{
  // Lengths on paper [mm].
  constexpr double max_width = 50.0;
  constexpr double tick = 1.5; // height of the bar's ends
  constexpr double gap = 3.0;  // between the bar and its text
  const double max_length = max_width * paper.scale / millimeters_of_meter; // [m]
  double length = std::pow (10.0, std::floor (std::log10 (max_length)));
  for (const double factor : {5.0, 2.0})
    if (factor * length <= max_length) {
      length *= factor;
      break;
    }
  const double y = paper.size().y() - paper_margin;
  const double width = length * millimeters_of_meter / paper.scale;
  svg << "<path d=\"M" << paper_margin << ' ' << y - tick << "v" << tick << "h" << width
      << "v" << -tick
      << "\" fill=\"none\" stroke=\"#000\" stroke-width=\"0.25\"/>\n<text x=\""
      << paper_margin + width + gap << "\" y=\"" << y << "\" font-size=\"4\">" << length
      << " m, 1:" << paper.scale << "</text>\n";
}

void
putSvgLine (const DrawnLine& line,
            const Layer& layer,
            const Paper& paper,
            std::ostream& svg)
{
  svg << "<path d=\"";
  for (std::size_t i = 0; i < line.corners.size(); ++i) {
    const Eigen::Vector2d corner = paper.onPaper (line.corners[i]);
    svg << (i == 0 ? 'M' : 'L') << corner.x() << ' ' << corner.y();
  }
  svg << (line.is_closed ? "Z" : "") << "\" stroke=\"" << layer.web_color
      << "\" stroke-width=\"" << layer.width << "\"/>\n";
}

/** \brief Writes a text, centered at DrawnText::middle. */
void
putSvgText (const DrawnText& text,
            const Layer& layer,
            const Paper& paper,
            std::ostream& svg)
{
  constexpr double font_size_by_height = 1.4; // height of capital letters
  const Eigen::Vector2d middle = paper.onPaper (text.middle);
  const double height = text.height * millimeters_of_meter / paper.scale; // [mm]
  svg << "<text x=\"" << middle.x() << "\" y=\"" << middle.y() + 0.5 * height
      << "\" font-size=\"" << font_size_by_height * height
      << "\" text-anchor=\"middle\" fill=\"" << layer.web_color << "\">"
      << escaped (text.text) << "</text>\n";
}

} // namespace

std::string
toSvg (const Drawing& drawing, const std::string& title)
{
  const Paper paper = paperFor (drawing);
  std::ostringstream svg;
  svg.imbue (std::locale::classic());
  constexpr int digits = 7; // of each number
  svg << std::setprecision (digits);
  const Eigen::Vector2d size = paper.size();
  svg << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << size.x()
      << "mm\" height=\"" << size.y() << "mm\" viewBox=\"0 0 " << size.x() << ' '
      << size.y() << "\" font-family=\"sans-serif\">\n<title>" << escaped (title)
      << "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n";
  for (const Layer& layer : drawing.layers) {
    svg << "<g id=\"" << escaped (layer.name) << "\" fill=\"none\" "
        << (layer.style == LineStyle::Dashed ? "stroke-dasharray=\"2 1\""
                                             : "stroke-linecap=\"square\"")
        << ">\n";
    for (const DrawnLine& line : drawing.lines)
      if (line.layer == layer.name)
        putSvgLine (line, layer, paper, svg);
    for (const DrawnText& text : drawing.texts)
      if (text.layer == layer.name)
        putSvgText (text, layer, paper, svg);
    svg << "</g>\n";
  }
  putScaleBar (paper, svg);
  return svg.str() + "</svg>\n";
}

} // namespace pcl_ops::apps
