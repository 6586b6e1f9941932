// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "answer.h"
#include "commands.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <detection/plane_list.h>
#include <io/inputs.h>
#include <numbers/angles.h>
#include <pcl_ops/plane_matching.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl_ops::evaluation {

using namespace apps;

namespace {

using Json = nlohmann::json;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr const char* fix =
    "; give planes as pcl_ops_segment --planes FILE.json and pcl_ops_tiles write them";
/** Largest number accepted: above any float, while its fourth power is a finite double.
 */
constexpr double largest = 1e40;

/** A JSON value with its file and its path of keys, for messages. */
struct Entry {
  const std::string& file;
  std::string name;
  const Json& value;

  void
  require (bool is_fine, const std::string& problem) const
  {
    if (!is_fine)
      throw WorkError (file, name + " " + problem + fix);
  }

  bool
  has (const char* key) const
  {
    return value.is_object() && value.contains (key);
  }

  Entry
  at (const char* key) const
  {
    const std::string path = name.empty() ? key : name + "." + key;
    Entry{file, path, value}.require (has (key), "is missing");
    return {file, path, value.at (key)};
  }

  std::vector<Entry>
  list () const
  {
    require (value.is_array(), "is no list");
    std::vector<Entry> entries;
    for (const Json& one : value)
      entries.push_back (
          {file, name + "[" + std::to_string (entries.size()) + "]", one});
    return entries;
  }

  double
  number (double least = -largest, double most = largest) const
  {
    require (value.is_number() && std::isfinite (value.get<double>()), "is no number");
    const auto number = value.get<double>();
    require (number <= most && number >= -largest, "is too large");
    require (number >= least, "is too small");
    return number;
  }

  template <int size>
  Eigen::Matrix<double, size, 1>
  vector () const
  {
    const std::vector<Entry> entries = list();
    require (entries.size() == size, "has not " + std::to_string (size) + " numbers");
    Eigen::Matrix<double, size, 1> result;
    for (int i = 0; i < size; ++i)
      result[i] = entries[std::size_t (i)].number();
    return result;
  }
};

using Ring = std::vector<Vector3d>;

/** Moves the centroid of a plane to that of the area of its outline, and sets the
 * moments of points spread evenly inside. Without an outline the standard deviation
 * along the plane is 1000 km.
 * \param[in] rings counter-clockwise, holes clockwise
 * \param[in] rms distance of the points to the plane
 * \param[in] count number of points of the moments */
void
setExtent (const std::vector<Ring>& rings,
           double rms,
           double count,
           PlaneSegment& plane)
{
  constexpr double endless = 1e6; // [m]
  const Matrix3d along_normal = plane.normal * plane.normal.transpose();
  Matrix3d spread = endless * endless * (Matrix3d::Identity() - along_normal);
  double area = 0.0;
  Vector3d sum = Vector3d::Zero();
  Matrix3d products = Matrix3d::Zero();
  for (const Ring& ring : rings)
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      Matrix3d corners;
      corners << ring[0], ring[i], ring[i + 1];
      corners.colwise() -= plane.centroid;
      // The area is signed: holes, and triangles outside a concave outline, are
      // subtracted.
      const Vector3d edge = corners.col (1) - corners.col (0);
      const Vector3d other = corners.col (2) - corners.col (0);
      const Vector3d total = corners.rowwise().sum();
      const double part = 0.5 * plane.normal.dot (edge.cross (other));
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
  spread += rms * rms * along_normal;
  plane.moments = Moments::of (count, plane.centroid, spread);
}

Ring
ringOf (const Entry& entry)
{
  Ring ring;
  for (const Entry& corner : entry.list())
    ring.push_back (corner.vector<3>());
  return ring;
}

/** Adds the outline of a plane, or of one of its parts, and its holes. */
void
addRings (const Entry& entry, std::vector<Ring>& rings)
{
  if (entry.has ("hull"))
    rings.push_back (ringOf (entry.at ("hull")));
  if (entry.has ("holes"))
    for (const Entry& hole : entry.at ("holes").list())
      rings.push_back (ringOf (hole));
}

PlaneSegment
planeOf (const Entry& entry)
{
  constexpr double most_points = 1e15; // below 2^53: exact as double
  PlaneSegment plane;
  const double count = entry.at ("points").number (1.0, most_points);
  const double rms = entry.at ("rms").number (0.0);
  const Entry orientation = entry.at ("orientation");
  const auto known = orientationCalled (
      orientation.value.is_string() ? orientation.value.get<std::string>() : "");
  orientation.require (known.has_value(), "is not horizontal, vertical or other");
  plane.orientation = *known;
  plane.centroid = entry.at ("centroid").vector<3>();
  const Entry coefficients = entry.at ("coefficients");
  const Vector3d normal = coefficients.vector<4>().head<3>();
  coefficients.require (normal.norm() > 0.0, "has the normal 0 0 0");
  plane.normal = normal.normalized();
  std::vector<Ring> rings;
  addRings (entry, rings);
  if (entry.has ("parts"))
    for (const Entry& part : entry.at ("parts").list())
      addRings (part, rings);
  setExtent (rings, rms, count, plane);
  return plane;
}

/** Planes of a file with their ids; the planes have no inliers. */
struct PlaneList {
  std::vector<std::uint64_t> ids;
  std::vector<PlaneSegment> planes;
};

PlaneList
loadPlaneList (const std::string& file)
{
  const std::string text = readTextFile (file, "a .json file of planes");
  const Json json = Json::parse (text, nullptr, false);
  if (json.is_discarded())
    throw WorkError (file, std::string ("is no JSON") + fix);
  PlaneList list;
  for (const Entry& entry : Entry{file, "", json}.at ("planes").list()) {
    const Entry id = entry.at ("id");
    id.require (id.value.is_number_unsigned(), "is no whole number from 0");
    list.ids.push_back (id.value.get<std::uint64_t>());
    list.planes.push_back (planeOf (entry));
  }
  return list;
}

/** Matches planes in a frame whose origin is the mean centroid of the first result: for
 * matchPlanes the rotation error of the pose is about the origin. */
PlaneMatches
matchAboutMiddle (std::vector<PlaneSegment> first,
                  std::vector<PlaneSegment> second,
                  const PlaneMatchingParameters& parameters)
{
  Vector3d sum = Vector3d::Zero();
  for (const PlaneSegment& plane : first)
    sum += plane.centroid;
  for (auto* planes : {&first, &second})
    for (PlaneSegment& plane : *planes)
      plane.moveBy (-sum / double (std::max<std::size_t> (1, first.size())));
  return matchPlanes (first, second, Eigen::Isometry3d::Identity(), parameters);
}

Answer
comparePlanes (const PlaneList& first,
               const PlaneList& second,
               const PlaneMatchingParameters& parameters)
{
  const auto matches = matchAboutMiddle (first.planes, second.planes, parameters);
  std::vector<std::size_t> partner_of (first.planes.size(), second.planes.size());
  Answer matched = Answer::array();
  Answer only_a = matched;
  Answer only_b = matched;
  for (std::size_t i = 0; i < second.planes.size(); ++i)
    if (matches.previous[i] == no_plane)
      only_b.push_back (second.ids[i]);
    else
      partner_of[std::size_t (matches.previous[i])] = i;
  for (std::size_t i = 0; i < first.planes.size(); ++i) {
    const std::size_t partner = partner_of[i];
    if (partner == second.planes.size()) {
      only_a.push_back (first.ids[i]);
      continue;
    }
    const PlaneSegment& one = first.planes[i];
    const PlaneSegment& other = second.planes[partner];
    matched.push_back ({{"a", first.ids[i]},
                        {"b", second.ids[partner]},
                        {"orientation", toString (one.orientation)},
                        {"angle", toDegrees (angleBetween (one, other))},
                        {"offset", one.plane().distance (other.centroid)},
                        {"points_a", std::size_t (one.moments.count)},
                        {"points_b", std::size_t (other.moments.count)}});
  }
  const double angle = Eigen::AngleAxisd (matches.pose.linear()).angle();
  return {{"planes_a", first.planes.size()},
          {"planes_b", second.planes.size()},
          {"matched", matched},
          {"only_a", only_a},
          {"only_b", only_b},
          {"angle_of_b", toDegrees (angle)},
          {"shift_of_b", matches.pose.translation().norm()}};
}

} // namespace

int
planesCommand (int argc, const char* const* argv)
{
  std::string first;
  std::string second;
  PlaneMatchingParameters matching;
  double rotation_error = toDegrees (matching.rotation_error);
  bool json = false;
  CommandLine line (
      "pcl_ops_evaluate planes",
      "Tells which planes of two results are one, and how far they are apart. The\n"
      "results are those of clouds in one frame: --planes FILE.json of "
      "pcl_ops_segment\n"
      "or planes.json of pcl_ops_tiles.",
      PCL_OPS_VERSION);
  line.addArgument ("A", first, "planes, .json");
  line.addArgument ("B", second, "planes, .json");
  line.add ("rotation-error DEG", rotation_error, from (0).upTo (90))
      .help ("standard deviation of the rotation between both frames (3)");
  line.add ("translation-error M", matching.translation_error, from (0))
      .help ("standard deviation of the shift between both (0.05)");
  line.add ("min-overlap X", matching.min_overlap, from (0).upTo (1))
      .help ("share of the smaller plane that has to lie over the other (0.3)");
  line.add ("json", json).help ("print JSON instead of text");
  if (!line.parse (argc, argv))
    return ExitCode::done;
  matching.rotation_error = toRadians (rotation_error);
  const PlaneList planes = loadPlaneList (first);
  print (comparePlanes (planes, loadPlaneList (second), matching), json);
  return ExitCode::done;
}

} // namespace pcl_ops::evaluation
