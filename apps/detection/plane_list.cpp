// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Boost 1.74 prints a deprecation note on one of its own headers in every build.
#define BOOST_ALLOW_DEPRECATED_HEADERS
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/register/linestring.hpp>
#include <boost/geometry/geometries/register/point.hpp>
#undef BOOST_ALLOW_DEPRECATED_HEADERS

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "geopackage.h"
#include "plane_list.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <io/output_file.h>
#include <numbers/angles.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>

BOOST_GEOMETRY_REGISTER_POINT_3D (Eigen::Vector3d, double, cs::cartesian, x(), y(), z())
BOOST_GEOMETRY_REGISTER_LINESTRING (pcl_ops::apps::Ring)

namespace pcl_ops::apps {

namespace {

/** \brief Returns twice the area of a ring as seen from above (against z); negative if
 * its corners go around clockwise. */
double
twiceAreaFromAbove (const Ring& ring)
{
  double twice_area = 0.0;
  // Relative to the first corner: far from zero the products would lose digits.
  for (std::size_t i = 2; i < ring.size(); ++i)
    twice_area += (ring[i - 1] - ring[0]).cross (ring[i] - ring[0]).z();
  return twice_area;
}

/** \brief How WKT or GeoJSON writes nested lists of corners. */
struct Notation {
  const char *begin_list, *begin_corner, *between_numbers, *end_corner, *end_list;
  /** \brief Number of decimals of coordinates. */
  int decimals;

  void
  write (const Eigen::Vector3d& corner, std::ostream& stream) const
  {
    // A coordinate that is rounded to zero becomes 0.000 instead of -0.000.
    const double max_rounded_to_zero = 0.5 * std::pow (10.0, -decimals);
    const Eigen::Vector3d shown =
        (corner.array().abs() <= max_rounded_to_zero).select (0.0, corner);
    stream << begin_corner << shown.x() << between_numbers << shown.y()
           << between_numbers << shown.z() << end_corner;
  }

  template <typename Part>
  void
  write (const std::vector<Part>& parts, std::ostream& stream) const
  {
    stream << begin_list;
    for (const Part& part : parts) {
      stream << (&part == &parts.front() ? "" : ",");
      write (part, stream);
    }
    stream << end_list;
  }

  /** \brief Returns polygons as text, with closed rings. A single polygon has no list
   * around it. */
  std::string
  text (Polygons polygons) const
  {
    std::ostringstream text;
    text.imbue (std::locale::classic());
    text << std::fixed << std::setprecision (decimals);
    for (Rings& rings : polygons)
      for (Ring& ring : rings)
        ring.push_back (ring.front());
    if (polygons.size() == 1)
      write (polygons.front(), text);
    else
      write (polygons, text);
    return text.str();
  }
};

/** \brief Returns the mean of the corners from index first up to index last, which is
 * included. An index i of ring.size() or more means the corner i - ring.size(). */
Eigen::Vector3d
meanOf (const Ring& ring, std::size_t first, std::size_t last)
{
  Eigen::Vector3d from_first = Eigen::Vector3d::Zero();
  for (std::size_t i = first; i <= last; ++i)
    from_first += (ring[i % ring.size()] - ring[first]) / double (last - first + 1);
  return from_first + ring[first];
}

/** \brief Makes the corner farthest from the mean of all corners the first one, as
 * simplification never removes the first corner. */
void
beginAtFarthestCorner (Ring& ring)
{
  const Eigen::Vector3d mean = meanOf (ring, 0, ring.size() - 1);
  const auto farthest =
      std::max_element (ring.begin(), ring.end(), [&] (const auto& a, const auto& b) {
        return (a - mean).squaredNorm() < (b - mean).squaredNorm();
      });
  std::rotate (ring.begin(), farthest, ring.end());
}

using Line = Eigen::ParametrizedLine<double, 3>;

/** \brief Fits a least squares line to the corners from index first to last, as in \ref
 * meanOf. */
Line
lineAlong (const Ring& ring, std::size_t first, std::size_t last)
{
  const Eigen::Vector3d mean = meanOf (ring, first, last);
  Eigen::Matrix3d scatter = Eigen::Matrix3d::Zero();
  for (std::size_t i = first; i <= last; ++i) {
    const Eigen::Vector3d from_mean = ring[i % ring.size()] - mean;
    scatter += from_mean * from_mean.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes (scatter);
  constexpr Eigen::Index longest = 2; // eigenvalues ascend
  return {mean, axes.eigenvectors().col (longest)};
}

/** \brief Returns where the lines through two adjacent sides of a ring meet: the point
 * midway between the nearest points of both lines.
 * \param[in] corner of both sides, which is returned if the sides are nearly parallel,
 * or meet farther from the corner than the tolerance */
Eigen::Vector3d
meetingPointOf (const Line& a,
                const Line& b,
                const Eigen::Vector3d& corner,
                double tolerance)
{
  // Of an angle of 15 degrees between the lines: at smaller ones a little noise would
  // move the meeting point far along both.
  constexpr double min_squared_sine = 0.07;
  const double cosine = a.direction().dot (b.direction());
  const double squared_sine = 1.0 - cosine * cosine;
  if (squared_sine < min_squared_sine)
    return corner;
  const Eigen::Vector3d between = a.origin() - b.origin();
  const double along_a = a.direction().dot (between);
  const double along_b = b.direction().dot (between);
  // Where on the lines the nearest points are: distances from the origins.
  const double on_a = (cosine * along_b - along_a) / squared_sine;
  const double on_b = (along_b - cosine * along_a) / squared_sine;
  const Eigen::Vector3d meeting =
      0.5 * (a.pointAt (on_a) + b.origin() + on_b * b.direction());
  return (meeting - corner).norm() <= tolerance ? meeting : corner;
}

/** \brief Returns the kept corners. They are moved: between two kept corners a line is
 * fitted to all corners of the ring, and a kept corner moves to where two such lines
 * meet (\ref meetingPointOf). Without this the ring would lose area, as noise has moved
 * some of the corners between the kept ones outwards.
 * \param[in] kept ascending indices of corners of the ring */
Ring
withFittedSides (const Ring& ring, std::vector<std::size_t> kept, double tolerance)
{
  kept.push_back (ring.size() + kept.front()); // closes the ring
  Ring fitted;
  Line side_before = lineAlong (ring, kept[kept.size() - 2], kept.back());
  for (std::size_t k = 0; k + 1 < kept.size(); ++k) {
    const Line side_after = lineAlong (ring, kept[k], kept[k + 1]);
    fitted.push_back (
        meetingPointOf (side_before, side_after, ring[kept[k]], tolerance));
    side_before = side_after;
  }
  return fitted;
}

/** \brief Simplifies a ring as \ref simplified says.
 * \return the ring with fewer corners; may have fewer than three */
Ring
withFewerCorners (Ring ring, double tolerance)
{
  beginAtFarthestCorner (ring);
  Ring closed = ring;
  closed.push_back (ring.front());
  Ring fewer;
  boost::geometry::simplify (closed, fewer, tolerance);
  fewer.pop_back();
  std::vector<std::size_t> kept; // indices in ring of the corners of fewer
  for (std::size_t i = 0; i < ring.size() && kept.size() < fewer.size(); ++i)
    if (ring[i] == fewer[kept.size()])
      kept.push_back (i);
  return kept.empty() ? Ring() : withFittedSides (ring, kept, tolerance);
}

/** \brief Leaves out corners that are as near as the tolerance to the line between
 * others (Douglas & Peucker), and moves the other corners (\ref withFittedSides). If
 * the outline would keep fewer than three corners, the tolerance is halved, for the
 * holes too, until the outline keeps three. Holes that keep fewer than three corners
 * are dropped. */
Rings
simplified (const Rings& rings, double tolerance)
{
  constexpr std::size_t min_corners = 3;
  // Then the tolerance is next to 0; the outline stays as it is, without holes.
  constexpr int max_halvings = 50;
  Rings simple;
  for (const Ring& ring : rings) {
    const bool is_outline = simple.empty();
    Ring fewer = withFewerCorners (ring, tolerance);
    for (int i = 0; is_outline && fewer.size() < min_corners && i < max_halvings; ++i) {
      tolerance *= 0.5;
      fewer = withFewerCorners (ring, tolerance);
    }
    if (fewer.size() >= min_corners)
      simple.push_back (std::move (fewer));
    else if (is_outline)
      return {ring};
  }
  return simple;
}

using Json = nlohmann::ordered_json;

/** \brief What is in front of the number of a reference system. */
const std::string prefix_of_crs = "EPSG:";

/** \brief Whether the text is EPSG:N, with N of 1 to 7 digits. */
bool
isCrs (const std::string& text)
{
  constexpr std::size_t max_digits = 7; // numbers of EPSG in use are shorter
  if (text.compare (0, prefix_of_crs.size(), prefix_of_crs) != 0)
    return false;
  const std::string number = text.substr (prefix_of_crs.size());
  return !number.empty() && number.size() <= max_digits &&
         number.find_first_not_of ("0123456789") == std::string::npos;
}

/** \brief A column of a list of planes, and its value for a plane: a number, a text or
 * null. */
struct PlaneColumn {
  std::string name;
  Json value;
};

/** \brief Returns all columns for a plane.
 * \param[in] plane as of \ref planeObject */
std::vector<PlaneColumn>
columnsOf (const Json& plane)
{
  const Json& coefficients = plane.at ("coefficients");
  const Json& centroid = plane.at ("centroid");
  const Json& normal = plane.at ("normal");
  const Json& extent = plane.at ("extent");
  std::vector<PlaneColumn> columns = {
      {"id", plane.at ("id")},
      {"orientation", plane.at ("orientation")},
      {"kind", plane.value ("kind", Json())}, // lists of earlier versions have none
      {"points", plane.at ("points")},
      {"a", coefficients.at (0)},
      {"b", coefficients.at (1)},
      {"c", coefficients.at (2)},
      {"d", coefficients.at (3)},
      {"centroid_x", centroid.at (0)},
      {"centroid_y", centroid.at (1)},
      {"centroid_z", centroid.at (2)},
      {"normal_x", normal.at (0)},
      {"normal_y", normal.at (1)},
      {"normal_z", normal.at (2)},
      {"rms", plane.at ("rms")},
      {"area", plane.at ("area")},
      {"length", extent.at ("length")},
      {"width", extent.at ("width")},
      {"slope", plane.at ("slope")},
      {"aspect", plane.at ("aspect")},
      {"height", plane.at ("height")}};
  // A piece also has the id of the plane it lies on.
  if (plane.contains ("plane"))
    columns.insert (columns.begin() + 1, PlaneColumn{"plane", plane.at ("plane")});
  return columns;
}

/** \brief Returns the number of decimals of coordinates: as many as a thousandth of the
 * smallest width of a plane needs, but at least 3 and at most 12, all that a double
 * near 1000 has. */
int
decimalsFor (const Json& planes)
{
  constexpr int min_decimals = 3;
  constexpr int max_decimals = 12;
  double decimals = min_decimals;
  for (const Json& plane : planes)
    if (const double width = plane.at ("extent").at ("width"); width > 0.0)
      decimals = std::max (decimals, std::ceil (min_decimals - std::log10 (width)));
  return static_cast<int> (std::min<double> (decimals, max_decimals));
}

/** \brief Returns the parts of a plane for a map, simplified if the options ask for it.
 * Seen from above outlines are counter-clockwise and holes clockwise, as maps require;
 * a ring without area seen from above keeps its direction. */
Polygons
outlineOf (const Json& plane, const MapOptions& options)
{
  Polygons polygons = polygonsIn (plane);
  for (Rings& rings : polygons) {
    if (options.simplify > 0.0)
      rings = simplified (rings, options.simplify);
    for (Ring& ring : rings) {
      const double twice_area = twiceAreaFromAbove (ring);
      const bool is_outline = &ring == &rings.front();
      if (is_outline ? twice_area < 0.0 : twice_area > 0.0)
        std::reverse (ring.begin(), ring.end());
    }
  }
  return polygons;
}

/** \brief Returns the WKT "POLYGON Z ((x y z, ...), ...)" (OGC 06-103r4), or a
 * MULTIPOLYGON Z. */
std::string
toWkt (const Polygons& polygons, int decimals)
{
  if (polygons.empty())
    return "POLYGON Z EMPTY";
  return (polygons.size() > 1 ? "MULTIPOLYGON Z " : "POLYGON Z ") +
         Notation{"(", "", " ", "", ")", decimals}.text (polygons);
}

/** \brief Returns polygons as the text of a geometry of GeoJSON (RFC 7946), "null" if
 * there are none. */
std::string
toGeoJsonGeometry (const Polygons& polygons, int decimals)
{
  if (polygons.empty())
    return "null";
  return std::string (R"({"type":")") +
         (polygons.size() > 1 ? "MultiPolygon" : "Polygon") + R"(","coordinates":)" +
         Notation{"[", "[", ",", "]", "]", decimals}.text (polygons) + "}";
}

/** \brief Returns all rings of a vertical plane, such as a facade, as a geometry of
 * closed lines: a polygon without area on the map is not valid (OGC
 * 06-103r4, 6.1.11.1). "null" if there are none. */
std::string
toGeoJsonLines (const Polygons& polygons, int decimals)
{
  if (polygons.empty())
    return "null";
  Rings rings;
  for (const Rings& polygon : polygons)
    rings.insert (rings.end(), polygon.begin(), polygon.end());
  return R"({"type":"MultiLineString","coordinates":)" +
         Notation{"[", "[", ",", "]", "]", decimals}.text (Polygons{rings}) + "}";
}

/** \brief Whether a plane has the orientation "vertical", or the area of its outline on
 * the map is less than a thousandth of its area. */
bool
isUpright (const Json& plane)
{
  constexpr double min_cosine = 0.001;
  return std::abs (plane.at ("normal").at (2).get<double>()) < min_cosine ||
         plane.at ("orientation") == toString (Orientation::Vertical);
}

/** \brief Returns a .csv with a line for each plane.
 * \param[in] planes an array of \ref planeObject */
std::string
toCsv (const Json& planes, const MapOptions& options)
{
  std::string csv;
  // An empty list still gets the header of all columns.
  Json example = planeObject (0, {}, {}, {});
  if (!planes.empty())
    example = planes.front();
  for (const auto& [name, value] : columnsOf (example))
    csv += name + ",";
  csv += "wkt\n";
  const int decimals = decimalsFor (planes);
  for (const Json& plane : planes) {
    for (const auto& [name, value] : columnsOf (plane)) {
      const std::string text = value.is_null() ? "" : value.dump();
      csv += (value.is_string() ? std::string (value) : text) + ",";
    }
    csv += "\"" + toWkt (outlineOf (plane, options), decimals) + "\"\n";
  }
  return csv;
}

/** \brief Returns a GeoJSON map with a feature for each plane.
 * \param[in] planes an array of \ref planeObject */
std::string
toGeoJson (const Json& planes, const MapOptions& options)
{
  const std::string prefix_of_normal = "normal_"; // the property of normal_x is nx
  std::vector<std::string> features;
  const int decimals = decimalsFor (planes);
  for (const Json& plane : planes) {
    Json properties;
    for (const auto& [name, value] : columnsOf (plane)) {
      const bool is_of_normal = name.rfind (prefix_of_normal, 0) == 0;
      properties[is_of_normal ? "n" + name.substr (prefix_of_normal.size()) : name] =
          value;
    }
    features.push_back (
        "{\"type\":\"Feature\",\"id\":" + plane.at ("id").dump() + ",\"geometry\":" +
        (isUpright (plane) ? toGeoJsonLines (outlineOf (plane, options), decimals)
                           : toGeoJsonGeometry (outlineOf (plane, options), decimals)) +
        ",\"properties\":" + properties.dump() + "}");
  }
  return featureCollection (features, options.crs);
}

/** \brief Whether a file has a format of maps. */
bool
isMap (const std::string& file)
{
  return hasExtension (file, {".geojson", ".gpkg"});
}

/** \throws UsageError if the file is a GeoPackage and this build has no SQLite */
void
checkCanWrite (const std::string& map)
{
  if (extensionOf (map) == ".gpkg" && !hasSqlite())
    throw UsageError (map,
                      "is a GeoPackage, which this build has no SQLite for; build it "
                      "with libsqlite3-dev, or write a .geojson and run ogr2ogr " +
                          map + " on it");
}

/** \brief Returns the "aspect" of \ref planeObject, or null. */
Json
aspectOf (const PlaneSegment& plane, const Eigen::Vector3d& up)
{
  const bool is_downward =
      plane.orientation != Orientation::Vertical && plane.normal.dot (up) < 0.0;
  const Eigen::Vector3d normal = is_downward ? -plane.normal : plane.normal;
  if (up != Eigen::Vector3d::UnitZ() || normal.head<2>().isZero (0.0))
    return nullptr;
  constexpr double full_turn = 360.0;
  const double angle = toDegrees (std::atan2 (normal.x(), normal.y()));
  return angle < 0.0 ? angle + full_turn : angle;
}

} // namespace

std::string
jsonText (const Json& json)
{
  constexpr int indent = 2;
  return json.dump (indent) + "\n";
}

std::string
featureCollection (const std::vector<std::string>& features, const std::string& crs)
{
  std::string text = "{\"type\":\"FeatureCollection\",";
  if (!crs.empty())
    text += R"("crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::)" +
            crs.substr (prefix_of_crs.size()) + "\"}},";
  text += "\"features\":[";
  for (const std::string& feature : features)
    text += (&feature == &features.front() ? "\n" : ",\n") + feature;
  return text + "\n]}\n";
}

std::string
mapFor (const std::string& file, const std::string& geo_json, const std::string& layer)
{
  return extensionOf (file) == ".gpkg" ? geoPackageOf (geo_json, layer) : geo_json;
}

std::optional<Orientation>
orientationCalled (const std::string& name)
{
  for (const Orientation known :
       {Orientation::Horizontal, Orientation::Vertical, Orientation::Other})
    if (name == toString (known))
      return known;
  return {};
}

std::optional<PlaneKind>
kindCalled (const std::string& name)
{
  for (const PlaneKind known : {PlaneKind::Floor,
                                PlaneKind::Ceiling,
                                PlaneKind::Wall,
                                PlaneKind::Slab,
                                PlaneKind::Roof,
                                PlaneKind::Ramp,
                                PlaneKind::Table,
                                PlaneKind::Other})
    if (name == toString (known))
      return known;
  return {};
}

void
turnUp (std::vector<PlaneSegment>& planes, const Eigen::Vector3d& up)
{
  for (PlaneSegment& plane : planes)
    if (plane.orientation != Orientation::Vertical && plane.normal.dot (up) < 0.0)
      plane.normal = -plane.normal;
}

void
turnToScanners (std::vector<PlaneSegment>& planes, const std::vector<Scan>& scans)
{
  if (scans.empty())
    return;
  const auto is_before = [] (std::size_t point, const Scan& scan) {
    return point < scan.first;
  };
  for (PlaneSegment& plane : planes) {
    // Number of inliers whose scanner is on the side of the normal, minus the others.
    std::ptrdiff_t votes = 0;
    for (const pcl::index_t point : plane.inliers) {
      const Scan& scan = *std::prev (std::upper_bound (
          scans.begin(), scans.end(), std::size_t (point), is_before));
      votes += plane.normal.dot (scan.position - plane.centroid) < 0.0 ? -1 : 1;
    }
    if (votes < 0)
      plane.normal = -plane.normal;
  }
}

Json
planeObject (std::size_t id,
             const PlaneSegment& segment,
             const PlaneExtent& extent,
             PlaneKind kind,
             const Eigen::Vector3d& up,
             const Polygons& parts)
{
  const Plane plane = segment.plane();
  Json object;
  object["id"] = id;
  object["orientation"] = toString (segment.orientation);
  object["kind"] = toString (kind);
  object["points"] = static_cast<std::size_t> (segment.moments.count);
  object["coefficients"] = {
      plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset};
  object["centroid"] = segment.centroid;
  object["normal"] = segment.normal;
  object["rms"] = segment.rms();
  if (segment.noise)
    object["noise"] = *segment.noise;
  object["area"] = extent.area;
  object["slope"] = toDegrees (slopeOf (segment.normal, up));
  object["aspect"] = aspectOf (segment, up);
  object["height"] = segment.centroid.dot (up);
  object["extent"] = {{"length", extent.length},
                      {"width", extent.width},
                      {"center", extent.center},
                      {"axes", {extent.long_axis, extent.short_axis}}};
  object["hull"] = extent.hull;
  object["holes"] = extent.holes;
  if (!parts.empty())
    object["parts"] = parts;
  return object;
}

Polygons
polygonsIn (const Json& plane)
{
  Rings largest = {plane.at ("hull").get<Ring>()};
  if (largest.front().empty())
    return {};
  for (const auto& hole : plane.at ("holes"))
    largest.push_back (hole.get<Ring>());
  Polygons polygons = {std::move (largest)};
  for (Rings& part : plane.value ("parts", Polygons()))
    if (!part.empty() && !part.front().empty())
      polygons.push_back (std::move (part));
  for (Rings& rings : polygons)
    rings.erase (std::remove_if (rings.begin(),
                                 rings.end(),
                                 [] (const Ring& ring) { return ring.empty(); }),
                 rings.end());
  return polygons;
}

void
declareMeter (CommandLine& line, double& meter)
{
  constexpr double max_meter = 1e6; // for a cloud in micrometers
  line.add ("meter N", meter, from (1.0 / max_meter).upTo (max_meter))
      .help ("units of the cloud in a meter, for kinds and plans: 1000 of mm (1)");
}

void
declareMap (CommandLine& line, MapOptions& options)
{
  line.add ("crs EPSG:N",
            [&options] (const std::string& text) {
              if (!isCrs (text))
                throw UsageError ("--crs",
                                  "'" + text +
                                      "' is not EPSG:N; give a number, as EPSG:25832");
              options.crs = text;
            })
      .help ("reference system to name in .geojson and .gpkg");
  line.add ("simplify M", options.simplify, from (0))
      .help ("straighten outlines in maps and .csv: move corners by M at most (0)");
}

void
checkMap (const CommandLine& line,
          const std::string& planes,
          const std::vector<std::string>& maps)
{
  const std::string extension = extensionOf (planes);
  const bool has_map = isMap (planes) || std::any_of (maps.begin(), maps.end(), isMap);
  if (line.isGiven ("crs") && !has_map)
    throw UsageError ("--crs", "is about --planes FILE.geojson or .gpkg; give one");
  if (line.isGiven ("simplify") && !isMap (planes) && extension != ".csv")
    throw UsageError ("--simplify",
                      "is about --planes FILE.csv, .geojson or .gpkg; give one");
  checkCanWrite (planes);
  std::for_each (maps.begin(), maps.end(), checkCanWrite);
}

std::string
planesFor (const std::string& file, const Json& list, const MapOptions& options)
{
  const std::string extension = extensionOf (file);
  if (extension == ".csv")
    return toCsv (list.at ("planes"), options);
  if (isMap (file))
    return mapFor (file, toGeoJson (list.at ("planes"), options), "planes");
  return jsonText (list);
}

} // namespace pcl_ops::apps
