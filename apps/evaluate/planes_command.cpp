// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// The command planes: matches the planes of two results and tells how far they are
// apart.
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

/** End of messages on a file that is no list of planes. */
constexpr const char* fix =
    "; give planes as pcl_ops_segment --planes FILE.json and pcl_ops_tiles write them";
/** Largest absolute value of a number in a file: above any float, while its fourth
 * power is still a finite double (\ref AreaIntegrals). */
constexpr double max_number = 1e40;

/** A value in a JSON file. All functions but \ref has throw a WorkError that names the
 * value if it is not what they read. */
struct Entry {
  const std::string& file;
  /** Keys and indices that lead to the value: "planes[2].hull". */
  std::string path;
  const Json& value;

  void
  require (bool condition, const std::string& problem) const
  {
    if (!condition)
      throw WorkError (file, path + " " + problem + fix);
  }

  bool
  has (const char* key) const
  {
    return value.is_object() && value.contains (key);
  }

  Entry
  at (const char* key) const
  {
    const std::string path_of_key = path.empty() ? key : path + "." + key;
    Entry{file, path_of_key, value}.require (has (key), "is missing");
    return {file, path_of_key, value.at (key)};
  }

  std::vector<Entry>
  list () const
  {
    require (value.is_array(), "is no list");
    std::vector<Entry> entries;
    for (const Json& element : value)
      entries.push_back (
          {file, path + "[" + std::to_string (entries.size()) + "]", element});
    return entries;
  }

  double
  number (double min = -max_number, double max = max_number) const
  {
    require (value.is_number() && std::isfinite (value.get<double>()), "is no number");
    const auto number = value.get<double>();
    require (number <= max && number >= -max_number, "is too large");
    require (number >= min, "is too small");
    return number;
  }

  /** Returns a list of exactly \p size numbers. */
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

/** Integrals over an area in space, with positions x relative to a given center. */
struct AreaIntegrals {
  double area = 0.0;                  // of 1 [m^2]
  Vector3d first = Vector3d::Zero();  // of x [m^3]
  Matrix3d second = Matrix3d::Zero(); // of x x^T [m^4]
};

/** Integrates over an outline, triangle by triangle. The area of a triangle is signed:
 * holes, and triangles outside a concave outline, are subtracted.
 * \param[in] rings counter-clockwise about the normal, holes clockwise */
AreaIntegrals
integralsOver (const std::vector<Ring>& rings,
               const Vector3d& normal,
               const Vector3d& center)
{
  AreaIntegrals integrals;
  for (const Ring& ring : rings)
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
      Matrix3d corners;
      corners << ring[0], ring[i], ring[i + 1];
      corners.colwise() -= center;
      const Vector3d side = corners.col (1) - corners.col (0);
      const Vector3d other_side = corners.col (2) - corners.col (0);
      const Vector3d sum = corners.rowwise().sum();
      const double area = 0.5 * normal.dot (side.cross (other_side));
      // Over a triangle of area A with corners c_i and their sum s, the integral of x
      // is A/3 s, and that of x x^T is A/12 (s s^T + sum of c_i c_i^T).
      integrals.area += area;
      integrals.first += area / 3.0 * sum;
      integrals.second +=
          area / 12.0 * (sum * sum.transpose() + corners * corners.transpose());
    }
  return integrals;
}

/** Moves the centroid of a plane to that of the area inside its outline, and sets the
 * moments to those of points spread evenly over this area. Without an outline the
 * centroid stays, and the points have a standard deviation of 1000 km along the plane.
 * \param[in] rings outlines counter-clockwise about the normal, holes clockwise
 * \param[in] rms root mean square distance of the points to the plane [m]
 * \param[in] count number of points of the plane */
void
setExtent (const std::vector<Ring>& rings,
           double rms,
           double count,
           PlaneSegment& plane)
{
  constexpr double unknown_deviation = 1e6; // [m]
  const Matrix3d along_normal = plane.normal * plane.normal.transpose();
  Matrix3d covariance =
      unknown_deviation * unknown_deviation * (Matrix3d::Identity() - along_normal);
  const AreaIntegrals integrals = integralsOver (rings, plane.normal, plane.centroid);
  if (integrals.area != 0.0) {
    const Vector3d mean = integrals.first / integrals.area;
    covariance = integrals.second / integrals.area - mean * mean.transpose();
    plane.centroid += mean;
  }
  covariance += rms * rms * along_normal;
  plane.moments = Moments::of (count, plane.centroid, covariance);
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
  constexpr double max_points = 1e15; // a double has all whole numbers up to 2^53
  PlaneSegment plane;
  const double count = entry.at ("points").number (1.0, max_points);
  const double rms = entry.at ("rms").number (0.0);
  const Entry orientation = entry.at ("orientation");
  const std::optional<Orientation> named_orientation = orientationCalled (
      orientation.value.is_string() ? orientation.value.get<std::string>() : "");
  orientation.require (named_orientation.has_value(),
                       "is not horizontal, vertical or other");
  plane.orientation = *named_orientation;
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

/** Planes of a file and the id of each; the planes have no inliers. */
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

/** Matches planes in a frame whose origin is the mean centroid of the first result, as
 * matchPlanes takes the rotation error of the pose for one about the origin. */
PlaneMatches
matchAboutMeanCentroid (std::vector<PlaneSegment> first,
                        std::vector<PlaneSegment> second,
                        const PlaneMatchingParameters& parameters)
{
  Vector3d sum = Vector3d::Zero();
  for (const PlaneSegment& plane : first)
    sum += plane.centroid;
  const double count = double (std::max<std::size_t> (1, first.size()));
  for (std::vector<PlaneSegment>* planes : {&first, &second})
    for (PlaneSegment& plane : *planes)
      plane.moveBy (-sum / count);
  return matchPlanes (first, second, Eigen::Isometry3d::Identity(), parameters);
}

Answer
comparePlanes (const PlaneList& first,
               const PlaneList& second,
               const PlaneMatchingParameters& parameters)
{
  const PlaneMatches matches =
      matchAboutMeanCentroid (first.planes, second.planes, parameters);
  const std::size_t no_partner = second.planes.size();
  std::vector<std::size_t> partner_of (first.planes.size(), no_partner);
  Answer matched = Answer::array();
  Answer only_a = Answer::array();
  Answer only_b = Answer::array();
  for (std::size_t i = 0; i < second.planes.size(); ++i)
    if (matches.previous[i] == no_plane)
      only_b.push_back (second.ids[i]);
    else
      partner_of[std::size_t (matches.previous[i])] = i;
  for (std::size_t i = 0; i < first.planes.size(); ++i) {
    const std::size_t partner = partner_of[i];
    if (partner == no_partner) {
      only_a.push_back (first.ids[i]);
      continue;
    }
    const PlaneSegment& plane_a = first.planes[i];
    const PlaneSegment& plane_b = second.planes[partner];
    matched.push_back ({{"a", first.ids[i]},
                        {"b", second.ids[partner]},
                        {"orientation", toString (plane_a.orientation)},
                        {"angle", toDegrees (angleBetween (plane_a, plane_b))},
                        {"offset", plane_a.plane().distance (plane_b.centroid)},
                        {"points_a", std::size_t (plane_a.moments.count)},
                        {"points_b", std::size_t (plane_b.moments.count)}});
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
  std::string first_file;
  std::string second_file;
  PlaneMatchingParameters matching;
  double rotation_error = toDegrees (matching.rotation_error);
  bool prints_json = false;
  CommandLine line (
      "pcl_ops_evaluate planes",
      "Tells which planes of two results are one, and how far they are apart. The\n"
      "results are those of clouds in one frame: --planes FILE.json of "
      "pcl_ops_segment\n"
      "or planes.json of pcl_ops_tiles.",
      PCL_OPS_VERSION);
  line.addArgument ("A", first_file, "planes, .json");
  line.addArgument ("B", second_file, "planes, .json");
  line.add ("rotation-error DEG", rotation_error, from (0).upTo (90))
      .help ("standard deviation of the rotation between both frames (3)");
  line.add ("translation-error M", matching.translation_error, from (0))
      .help ("standard deviation of the shift between both (0.05)");
  line.add ("min-overlap X", matching.min_overlap, from (0).upTo (1))
      .help ("share of the smaller plane that has to lie over the other (0.3)");
  line.add ("json", prints_json).help ("print JSON instead of text");
  if (!line.parse (argc, argv))
    return ExitCode::done;
  matching.rotation_error = toRadians (rotation_error);
  const PlaneList first = loadPlaneList (first_file);
  const PlaneList second = loadPlaneList (second_file);
  print (comparePlanes (first, second, matching), prints_json);
  return ExitCode::done;
}

} // namespace pcl_ops::evaluation
