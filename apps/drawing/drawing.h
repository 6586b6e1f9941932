// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <detection/plane_list.h>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief Numbers of colors in CAD (AutoCAD Color Index). */
enum class CadColor { Red = 1, Green = 3, Blue = 5, BlackOrWhite = 7, Gray = 8 };

enum class LineStyle { Solid, Dashed };

struct Layer {
  std::string name;
  CadColor cad_color;
  /** \brief The color in browsers, "#rrggbb". */
  std::string web_color;
  /** \brief Width of lines on paper [mm]. */
  double width;
  LineStyle style = LineStyle::Solid;
};

/** \brief Corners joined by straight lines, in the unit of the drawing. */
struct DrawnLine {
  /** \brief Name of the layer. */
  std::string layer;
  Ring corners;
  bool is_closed = false;
};

struct DrawnText {
  /** \brief Name of the layer. */
  std::string layer;
  /** \brief Position of its middle. */
  Eigen::Vector3d middle;
  /** \brief In UTF-8, one line. */
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

/** \return ASCII DXF of AutoCAD 2000 (AC1015), which all programs read, with its unit
 * in $INSUNITS, 6 for meters, 0 for an unknown one. A text is a TEXT; an open line with
 * two corners is a LINE, any other an LWPOLYLINE where all z are 0, else a POLYLINE in
 * space */
std::string
toDxf (const Drawing& drawing);

/** \param[in] drawing in meters; only what is on its layers is drawn
 * \return SVG of the drawing from above, with a scale bar, at the largest usual scale
 * (1:20, 1:50, ... 1:10000) at which its lines fit on A3, or a smaller one if they fit
 * at none */
std::string
toSvg (const Drawing& drawing, const std::string& title);

} // namespace pcl_ops::apps
