// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_lists.h"

#include "detectors.h"
#include <pcl_ops/plane_filter.h>
#include <pcl_ops/plane_matching.h>
#include <pcl_ops/up_axis.h>
#include <pybind11/eigen.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::python {

namespace {

using PlaneObjects = std::vector<const PlaneObject*>;

PlaneObjects
objectsOf (const py::list& planes, const char* name = "planes")
{
  PlaneObjects objects;
  for (const py::handle& plane : planes) {
    if (!py::isinstance<PlaneObject> (plane))
      throwWrongType (name, "a list of pcl_ops.Plane", plane);
    objects.push_back (plane.cast<const PlaneObject*>());
  }
  return objects;
}

void
checkAreOfOneArray (const PlaneObjects& planes)
{
  for (const PlaneObject* plane : planes)
    if (!plane->points.is (planes.front()->points))
      throw py::value_error ("planes: they are of different arrays, whose rows cannot "
                             "be told apart");
}

void
checkShareNoPoints (const PlaneObjects& planes)
{
  std::vector<bool> is_taken;
  for (const PlaneObject* plane : planes)
    for (const pcl::index_t inlier : plane->segment.inliers) {
      const auto row = static_cast<std::size_t> (inlier);
      is_taken.resize (std::max (is_taken.size(), row + 1));
      if (is_taken[row])
        throw py::value_error ("planes: some share points, which would count twice; "
                               "give those of one segment");
      is_taken[row] = true;
    }
}

/** \brief The plane that some planes went into.
 * \param[in] members by falling size */
PlaneSegment
joined (const PlaneObjects& members, const Moments& moments, const PlaneFit& fit)
{
  PlaneSegment plane;
  plane.centroid = fit.centroid;
  const Eigen::Vector3d& normal = fit.plane.normal;
  const bool is_turned = normal.dot (members.front()->segment.normal) < 0.0;
  plane.normal = is_turned ? -normal : normal;
  plane.moments = moments.about (fit.centroid);
  for (const PlaneObject* member : members) {
    const pcl::Indices& inliers = member->segment.inliers;
    plane.inliers.insert (plane.inliers.end(), inliers.begin(), inliers.end());
  }
  std::sort (plane.inliers.begin(), plane.inliers.end());
  return plane;
}

std::vector<PlaneSegment>
joinedPlanes (const PlaneObjects& planes, const MergedPlanes& merged)
{
  std::vector<PlaneObjects> members (merged.fits.size());
  for (std::size_t i = 0; i < planes.size(); ++i)
    if (const std::int32_t into = merged.merged_into[i]; into != no_plane)
      members[static_cast<std::size_t> (into)].push_back (planes[i]);
  std::vector<PlaneSegment> all;
  for (std::size_t i = 0; i < members.size(); ++i) {
    std::stable_sort (members[i].begin(), members[i].end(), [] (auto one, auto other) {
      return one->segment.moments.count > other->segment.moments.count;
    });
    all.push_back (joined (members[i], merged.moments[i], merged.fits[i]));
  }
  return all;
}

Fields<UpAxisParameters>
upAxisFields ()
{
  using P = UpAxisParameters;
  return {field<P> ("angle_tolerance", &P::angle_tolerance),
          field<P> ("least_share", &P::least_share),
          field<P> ("least_confidence", &P::least_confidence)};
}

std::vector<PlaneSegment>
segmentsOf (const PlaneObjects& objects)
{
  std::vector<PlaneSegment> segments;
  for (const PlaneObject* object : objects)
    segments.push_back (object->segment);
  return segments;
}

py::array_t<std::int32_t>
arrayOf (const Labels& labels)
{
  return py::array_t<std::int32_t> (static_cast<py::ssize_t> (labels.size()),
                                    labels.data());
}

Fields<PlaneMatchingParameters>
matchingFields ()
{
  using P = PlaneMatchingParameters;
  return {field<P> ("rotation_error", &P::rotation_error),
          field<P> ("translation_error", &P::translation_error),
          field<P> ("min_overlap", &P::min_overlap)};
}

/** \brief A rigid motion.
 * \throw py::value_error for any other matrix */
Eigen::Isometry3d
motionOf (const py::object& pose)
{
  const auto rows = pose.cast<py::array_t<double>>();
  Eigen::Matrix4d matrix;
  for (Eigen::Index row = 0; row < 4; ++row)
    for (Eigen::Index column = 0; column < 4; ++column)
      matrix (row, column) = rows.at (row, column);
  constexpr double rounding = 1e-4; // of single precision, multiplied a few times
  const Eigen::Matrix3d turn = matrix.topLeftCorner<3, 3>();
  if (!matrix.allFinite() || !(turn * turn.transpose()).isIdentity (rounding) ||
      turn.determinant() < 0.0 ||
      !matrix.row (3).isApprox (Eigen::RowVector4d (0, 0, 0, 1)))
    throw py::value_error ("pose: is no 4 x 4 matrix of a rotation and a translation");
  return Eigen::Isometry3d (matrix);
}

void
add (const DroppedPlanes& more, DroppedPlanes& sum)
{
  sum.by_orientation += more.by_orientation;
  sum.by_direction += more.by_direction;
  sum.by_points += more.by_points;
  sum.by_area += more.by_area;
  sum.by_width += more.by_width;
}

PlaneFilter
filterOf (const py::dict& given)
{
  PlaneFilter filter;
  for (const auto& [key, value] : given) {
    const auto name = key.cast<std::string>();
    const bool may_be_none =
        name == "orientation" || name == "direction" || name == "max_planes";
    if (may_be_none && value.is_none())
      continue;
    if (name == "orientation")
      filter.orientation = static_cast<Orientation> (
          oneOf (name, {"horizontal", "vertical", "other"}, value));
    else if (name == "direction")
      setValue (name, filter.direction.emplace(), value);
    else if (name == "direction_tolerance")
      setValue (name, filter.direction_tolerance, value);
    else if (name == "min_points")
      setValue (name, filter.min_points, value);
    else if (name == "min_area")
      setValue (name, filter.min_area, value);
    else if (name == "min_width")
      setValue (name, filter.min_width, value);
    else
      setValue (name, filter.max_planes.emplace(), value);
    const std::string problem = problemOf (filter);
    if (!problem.empty())
      throw py::value_error (name + ": " + problem);
  }
  return filter;
}

} // namespace

py::tuple
filteredPlanes (const py::list& planes, const py::dict& given)
{
  const PlaneFilter filter = filterOf (given);
  const PlaneObjects objects = objectsOf (planes);
  // One at a time: it is for the objects of Python to be kept or dropped, not for
  // copies.
  PlaneFilter of_each = filter;
  of_each.max_planes.reset();
  DroppedPlanes dropped;
  py::list kept;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    std::vector<PlaneSegment> one = {objects[i]->segment};
    const auto extent = [&] (const PlaneSegment& /*plane*/) {
      return planes[i].cast<PlaneObject&>().extent();
    };
    add (filterPlanes (one, of_each, extent), dropped);
    if (one.empty())
      continue;
    if (filter.max_planes && kept.size() >= *filter.max_planes)
      ++dropped.by_number;
    else
      kept.append (planes[i]);
  }
  py::dict counts;
  counts["orientation"] = dropped.by_orientation;
  counts["direction"] = dropped.by_direction;
  counts["min_points"] = dropped.by_points;
  counts["min_area"] = dropped.by_area;
  counts["min_width"] = dropped.by_width;
  counts["max_planes"] = dropped.by_number;
  return py::make_tuple (kept, counts);
}

py::tuple
matchedPlanes (const py::list& previous,
               const py::list& current,
               const py::object& pose,
               const py::dict& parameters)
{
  const PlaneMatches matches =
      matchPlanes (segmentsOf (objectsOf (previous, "previous")),
                   segmentsOf (objectsOf (current, "current")),
                   motionOf (pose),
                   withGiven (matchingFields(),
                              PlaneMatchingParameters(),
                              parameters,
                              [] (const PlaneMatchingParameters& given) {
                                return problemOf (given);
                              }));
  return py::make_tuple (arrayOf (matches.previous),
                         Eigen::Matrix4d (matches.pose.matrix()));
}

py::tuple
mergedPlanes (const py::list& planes,
              const py::dict& orientation,
              const py::dict& merging)
{
  const PlaneDetectorParameters named_by = orientationParameters (orientation);
  const PlaneObjects objects = objectsOf (planes);
  checkAreOfOneArray (objects);
  checkShareNoPoints (objects);
  std::vector<Moments> moments;
  for (const PlaneObject* object : objects)
    moments.push_back (object->segment.moments);
  const MergedPlanes merged = mergePlanes (moments, mergingParameters (merging));
  std::vector<PlaneSegment> segments = joinedPlanes (objects, merged);
  nameOrientations (
      segments, named_by.up_axis.cast<double>(), named_by.angle_tolerance);
  py::list found;
  for (PlaneSegment& segment : segments)
    found.append (
        PlaneObject{std::move (segment), objects.front()->points, std::nullopt});
  return py::make_tuple (found, arrayOf (merged.merged_into));
}

py::object
upAxisOf (const py::list& planes,
          const py::object& viewpoint,
          const py::dict& parameters)
{
  const std::vector<PlaneSegment> segments = segmentsOf (objectsOf (planes));
  const Eigen::Vector3d sensor = placeOf ("viewpoint", viewpoint);
  const UpAxisParameters decided = withGiven (
      upAxisFields(), UpAxisParameters(), parameters, [] (const UpAxisParameters& all) {
        return problemOf (all);
      });
  const std::optional<UpAxis> found = estimateUpAxis (segments, sensor, decided);
  if (!found)
    return py::none();
  return py::make_tuple (found->direction, found->confidence);
}

} // namespace pcl_ops::python
