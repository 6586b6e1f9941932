// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "outlines.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief Twice the area within a ring as seen from above, negative for a clockwise
 * one. */
double
areaFromAbove (const Ring& ring)
{
  double area = 0.0;
  // From the first corner: areas far from zero would have few digits left.
  for (std::size_t i = 2; i < ring.size(); ++i)
    area += (ring[i - 1] - ring[0]).cross (ring[i] - ring[0]).z();
  return area;
}

/** \brief How a format writes rings. */
struct Notation {
  const char *begin, *end, *begin_corner, *between_numbers, *end_corner;
};

constexpr Notation wkt = {"(", ")", "", " ", ""};
constexpr Notation json = {"[", "]", "[", ",", "]"};

void
writeCorner (const Eigen::Vector3d& corner,
             const Notation& notation,
             int decimals,
             std::ostream& stream)
{
  // A coordinate that is rounded to zero has no sign.
  const double smallest = 0.5 * std::pow (10.0, -decimals);
  stream << notation.begin_corner;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    stream << (axis > 0 ? notation.between_numbers : "")
           << (std::abs (corner[axis]) <= smallest ? 0.0 : corner[axis]);
  stream << notation.end_corner;
}

std::string
written (const Rings& rings, const Notation& notation, int decimals)
{
  std::ostringstream text;
  text.imbue (std::locale::classic());
  text << std::fixed << std::setprecision (decimals) << notation.begin;
  for (const Ring& ring : rings) {
    text << (&ring == &rings.front() ? "" : ",") << notation.begin;
    for (const Eigen::Vector3d& corner : ring) {
      writeCorner (corner, notation, decimals, text);
      text << ",";
    }
    writeCorner (ring.front(), notation, decimals, text);
    text << notation.end;
  }
  text << notation.end;
  return text.str();
}

} // namespace

Rings
seenFromAbove (Rings rings)
{
  for (Ring& ring : rings) {
    const bool is_hole = &ring != &rings.front();
    const double area = areaFromAbove (ring);
    if (is_hole ? area > 0.0 : area < 0.0)
      std::reverse (ring.begin(), ring.end());
  }
  return rings;
}

int
decimalsFor (const std::vector<PlaneExtent>& extents)
{
  constexpr int min_decimals = 3, max_decimals = 12;
  int decimals = min_decimals;
  for (const PlaneExtent& extent : extents)
    if (extent.width > 0.0)
      decimals = std::max (
          decimals,
          static_cast<int> (std::ceil (min_decimals - std::log10 (extent.width))));
  return std::min (decimals, max_decimals);
}

std::string
toWkt (const Rings& rings, int decimals)
{
  return "POLYGON Z " + (rings.empty() ? "EMPTY" : written (rings, wkt, decimals));
}

std::string
toGeoJsonGeometry (const Rings& rings, int decimals)
{
  return rings.empty() ? "null"
                       : R"({"type":"Polygon","coordinates":)" +
                             written (rings, json, decimals) + "}";
}

} // namespace pcl_ops::apps
