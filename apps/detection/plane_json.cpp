// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_json.h"

#include <cli/errors.h>
#include <io/inputs.h>
#include <nlohmann/json.hpp>
#include <numbers/angles.h>
#include <pcl_ops/orientation.h>
#include <pcl_ops/plane_extent.h>

#include <cmath>

namespace pcl_ops::apps {

namespace {

nlohmann::ordered_json
toObject (const PlaneExtent& extent)
{
  nlohmann::ordered_json object;
  object["length"] = extent.length;
  object["width"] = extent.width;
  object["center"] = toArray (extent.center);
  object["axes"] = {toArray (extent.long_axis), toArray (extent.short_axis)};
  return object;
}

nlohmann::ordered_json
toArray (const Ring& ring)
{
  nlohmann::ordered_json corners = nlohmann::ordered_json::array();
  for (const Eigen::Vector3d& corner : ring)
    corners.push_back (apps::toArray (corner));
  return corners;
}

template <typename Iterator>
nlohmann::ordered_json
toArray (Iterator first, Iterator last)
{
  nlohmann::ordered_json rings = nlohmann::ordered_json::array();
  for (; first != last; ++first)
    rings.push_back (toArray (*first));
  return rings;
}

Ring
ringIn (const nlohmann::ordered_json& corners)
{
  Ring ring;
  for (const auto& corner : corners)
    ring.push_back (toVector (corner));
  return ring;
}

using Json = nlohmann::json;
using Eigen::Vector3d;

constexpr const char* fix =
    "; give planes as pcl_ops_segment --planes FILE.json and pcl_ops_tiles write them";

/** \brief Beyond any cloud in single precision, and its fourth power is finite. */
constexpr double largest = 1e40;

class Entry {
public:
  Entry (std::string file, std::string name, const Json& value)
  : file_ (std::move (file)), name_ (std::move (name)), value_ (value)
  {}

  [[noreturn]] void
  fail (const std::string& problem) const
  {
    throw WorkError (file_, name_ + " " + problem + fix);
  }

  bool
  has (const char* key) const
  {
    return value_.is_object() && value_.contains (key);
  }

  Entry
  at (const char* key) const
  {
    const Entry entry (file_, name_.empty() ? key : name_ + "." + key, value_);
    if (!has (key))
      entry.fail ("is missing");
    return {file_, entry.name_, value_.at (key)};
  }

  std::vector<Entry>
  list () const
  {
    if (!value_.is_array())
      fail ("is no list");
    std::vector<Entry> entries;
    for (const Json& one : value_)
      entries.emplace_back (
          file_, name_ + "[" + std::to_string (entries.size()) + "]", one);
    return entries;
  }

  double
  number (double least) const
  {
    const double number = value_.is_number() ? value_.get<double>() : NAN;
    if (!std::isfinite (number))
      fail ("is no number");
    if (std::abs (number) > largest)
      fail ("is too large");
    if (number < least)
      fail ("is too small");
    return number;
  }

  template <int size>
  Eigen::Matrix<double, size, 1>
  vector () const
  {
    const std::vector<Entry> entries = list();
    if (entries.size() != size)
      fail ("has not " + std::to_string (size) + " numbers");
    Eigen::Matrix<double, size, 1> result;
    for (int i = 0; i < size; ++i)
      result[i] = entries[static_cast<std::size_t> (i)].number (-largest);
    return result;
  }

  std::uint64_t
  id () const
  {
    if (!value_.is_number_unsigned())
      fail ("is no whole number from 0");
    return value_.get<std::uint64_t>();
  }

  Orientation
  orientation () const
  {
    if (const auto known =
            orientationCalled (value_.is_string() ? value_.get<std::string>() : ""))
      return *known;
    fail ("is not horizontal, vertical or other");
  }

private:
  std::string file_, name_;
  const Json& value_;
};

void
setExtent (const std::vector<Vector3d>& hull,
           double rms,
           double count,
           PlaneSegment& plane)
{
  constexpr double endless = 1e6;
  const Eigen::Matrix3d along_normal = plane.normal * plane.normal.transpose();
  Eigen::Matrix3d spread =
      endless * endless * (Eigen::Matrix3d::Identity() - along_normal);
  double area = 0.0;
  Vector3d sum = Vector3d::Zero();
  Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
  for (std::size_t i = 1; i + 1 < hull.size(); ++i) {
    Eigen::Matrix3d corners;
    corners << hull[0], hull[i], hull[i + 1];
    corners.colwise() -= plane.centroid;
    // Signed, so that the triangles of a hollow outline take away what they have too
    // much.
    const Vector3d edge = corners.col (1) - corners.col (0);
    const double part =
        0.5 * plane.normal.dot (edge.cross (corners.col (2) - corners.col (0)));
    const Vector3d total = corners.rowwise().sum();
    area += part;
    sum += part / 3.0 * total;
    products +=
        part / 12.0 * (total * total.transpose() + corners * corners.transpose());
  }
  if (area != 0.0) {
    const Vector3d mean = sum / area;
    spread = products / area - mean * mean.transpose();
    plane.centroid += mean;
  }
  plane.moments =
      Moments::of (count, plane.centroid, spread + rms * rms * along_normal);
}

PlaneSegment
planeOf (const Entry& entry)
{
  PlaneSegment plane;
  const double count = entry.at ("points").number (1.0);
  const double rms = entry.at ("rms").number (0.0);
  plane.orientation = entry.at ("orientation").orientation();
  plane.centroid = entry.at ("centroid").vector<3>();
  const Entry coefficients = entry.at ("coefficients");
  const Vector3d normal = coefficients.vector<4>().head<3>();
  if (!(normal.norm() > 0.0))
    coefficients.fail ("has the normal 0 0 0");
  plane.normal = normal.normalized();
  std::vector<Vector3d> hull;
  if (entry.has ("hull"))
    for (const Entry& corner : entry.at ("hull").list())
      hull.push_back (corner.vector<3>());
  setExtent (hull, rms, count, plane);
  return plane;
}

} // namespace

nlohmann::ordered_json
toArray (const Eigen::Vector3d& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

Eigen::Vector3d
toVector (const nlohmann::ordered_json& array)
{
  return {array.at (0).get<double>(),
          array.at (1).get<double>(),
          array.at (2).get<double>()};
}

std::string
jsonText (const nlohmann::ordered_json& json)
{
  constexpr int indent = 2;
  return json.dump (indent) + "\n";
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

Attitude
attitudeOf (const PlaneSegment& plane, const Eigen::Vector3d& up)
{
  Attitude attitude;
  attitude.slope = toDegrees (slopeOf (plane.normal, up));
  attitude.height = plane.centroid.dot (up);
  const bool is_downward =
      plane.orientation != Orientation::Vertical && plane.normal.dot (up) < 0.0;
  const Eigen::Vector3d normal = is_downward ? -plane.normal : plane.normal;
  if (up != Eigen::Vector3d::UnitZ() || normal.head<2>().isZero (0.0))
    return attitude;
  constexpr double full_turn = 360.0;
  const double angle = toDegrees (std::atan2 (normal.x(), normal.y()));
  attitude.aspect = angle < 0.0 ? angle + full_turn : angle;
  return attitude;
}

void
turnUp (std::vector<PlaneSegment>& planes, const Eigen::Vector3d& up)
{
  for (PlaneSegment& plane : planes)
    if (plane.orientation != Orientation::Vertical && plane.normal.dot (up) < 0.0)
      plane.normal = -plane.normal;
}

nlohmann::ordered_json
planeObject (std::size_t id,
             const PlaneSegment& segment,
             const PlaneExtent& extent,
             const Attitude& attitude,
             const Polygons& parts)
{
  const Plane plane = segment.plane();
  nlohmann::ordered_json object;
  object["id"] = id;
  object["orientation"] = toString (segment.orientation);
  object["points"] = static_cast<std::size_t> (segment.moments.count);
  object["coefficients"] = {
      plane.normal.x(), plane.normal.y(), plane.normal.z(), plane.offset};
  object["centroid"] = toArray (segment.centroid);
  object["normal"] = toArray (segment.normal);
  object["rms"] = segment.rms();
  object["area"] = extent.area;
  object["slope"] = attitude.slope;
  object["aspect"] =
      attitude.aspect ? nlohmann::ordered_json (*attitude.aspect) : nullptr;
  object["height"] = attitude.height;
  object["extent"] = toObject (extent);
  object["hull"] = toArray (extent.hull);
  object["holes"] = toArray (extent.holes.begin(), extent.holes.end());
  for (const Rings& part : parts)
    object["parts"].push_back (toArray (part.begin(), part.end()));
  return object;
}

Polygons
polygonsIn (const nlohmann::ordered_json& plane)
{
  if (plane.at ("hull").empty())
    return {};
  Polygons polygons = {{ringIn (plane.at ("hull"))}};
  for (const auto& hole : plane.at ("holes"))
    polygons.front().push_back (ringIn (hole));
  if (plane.contains ("parts"))
    for (const auto& part : plane.at ("parts")) {
      polygons.emplace_back();
      for (const auto& ring : part)
        polygons.back().push_back (ringIn (ring));
    }
  return polygons;
}

PlaneList
loadPlaneList (const std::string& file)
{
  const std::string text = readTextFile (file, "a .json file of planes");
  const Json json = Json::parse (text, nullptr, false);
  if (json.is_discarded())
    throw WorkError (file, std::string ("is no JSON") + fix);
  PlaneList list;
  for (const Entry& entry : Entry (file, "", json).at ("planes").list()) {
    list.ids.push_back (entry.at ("id").id());
    list.planes.push_back (planeOf (entry));
  }
  return list;
}

} // namespace pcl_ops::apps
