// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <detection/plane_list.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Colors in CAD; the values are their numbers in the AutoCAD Color Index. */
enum class CadColor { Red = 1, Green = 3, Blue = 5, BlackOrWhite = 7, Gray = 8 };

enum class LineStyle { Solid, Dashed };

/** \brief How the lines and texts of a layer look. */
struct Layer {
  std::string name;
  CadColor cad_color;
  /** \brief The color in browsers, "#rrggbb". */
  std::string web_color;
  /** \brief Width of its lines on paper [mm]. */
  double width;
  LineStyle style = LineStyle::Solid;
};

/** \brief Corners joined by straight lines. */
struct DrawnLine {
  /** \brief Name of the layer. */
  std::string layer;
  /** \brief In the unit of the drawing. */
  Ring corners;
  /** \brief Whether a straight line also joins the last corner to the first one. */
  bool is_closed = false;
};

/** \brief A horizontal text, centered at a point. */
struct DrawnText {
  /** \brief Name of the layer. */
  std::string layer;
  /** \brief The point at the middle of the text, in the unit of the drawing. */
  Eigen::Vector3d middle;
  /** \brief One line in UTF-8. */
  std::string text;
  /** \brief Height of capital letters, in the unit of the drawing. */
  double height;
};

/** \brief Lines and texts on layers. */
struct Drawing {
  /** \brief Length of a meter in the unit of the coordinates. */
  double meter = 1.0;
  std::vector<Layer> layers;
  std::vector<DrawnLine> lines;
  std::vector<DrawnText> texts;
};

/** \brief Returns a drawing as ASCII DXF of AutoCAD 2000 (AC1015), which all programs
 * read. $INSUNITS has the unit of the drawing by Drawing::meter: 6 for meters, 2 for
 * feet, 1, 5 and 4 for inches, centimeters and millimeters, else 0. A text is a TEXT.
 * An open line with two corners is a LINE; any other line is an LWPOLYLINE if z of all
 * its corners is 0, else a POLYLINE in space. */
std::string
toDxf (const Drawing& drawing);

/** \brief Returns an SVG of a drawing as seen from above (against z), with a scale bar.
 * The scale is the largest usual one (1:20, 1:50, ... 1:10000) at which the lines fit
 * on A3; a smaller one if they fit at no usual scale.
 * \param[in] drawing in meters; lines and texts of layers that it does not have are
 * left out */
std::string
toSvg (const Drawing& drawing, const std::string& title);

} // namespace pcl_ops::apps
