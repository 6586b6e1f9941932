// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_lists.h"

#include "detectors.h"
#include <pcl_ops/up_axis.h>
#include <pybind11/eigen.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::python {

namespace {

using PlaneObjects = std::vector<const PlaneObject*>;

PlaneObjects
objectsOf (const py::list& planes)
{
  PlaneObjects objects;
  for (const py::handle& plane : planes) {
    if (!py::isinstance<PlaneObject> (plane))
      throwWrongType ("planes", "a list of pcl_ops.Plane", plane);
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

} // namespace

py::tuple
mergedPlanes (const py::list& planes,
              const py::dict& orientation,
              const py::dict& merging)
{
  const PlaneDetectorParameters named_by = orientationParameters (orientation);
  const PlaneObjects objects = objectsOf (planes);
  checkAreOfOneArray (objects);
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
  const py::array_t<std::int32_t> merged_into (
      static_cast<py::ssize_t> (merged.merged_into.size()), merged.merged_into.data());
  return py::make_tuple (found, merged_into);
}

py::object
upAxisOf (const py::list& planes,
          const py::object& viewpoint,
          const py::dict& parameters)
{
  std::vector<PlaneSegment> segments;
  for (const PlaneObject* object : objectsOf (planes))
    segments.push_back (object->segment);
  const Eigen::Vector3d sensor = placeOf ("viewpoint", viewpoint);
  const UpAxisParameters decided = withGiven (
      upAxisFields(), UpAxisParameters(), parameters, [] (const UpAxisParameters&) {
        return std::string();
      });
  const std::optional<UpAxis> found = estimateUpAxis (segments, sensor, decided);
  if (!found)
    return py::none();
  return py::make_tuple (found->direction, found->confidence);
}

} // namespace pcl_ops::python
