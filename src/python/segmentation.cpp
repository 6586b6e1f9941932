// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "segmentation.h"

#include "detectors.h"
#include "interpreter.h"
#include "point_array.h"
#include <pybind11/eigen.h>

#include <numeric>

namespace pcl_ops::python {

namespace {

std::vector<PlaneSegment>
detect (const Detect& detector,
        const PointArray& points,
        const Eigen::Vector3d& viewpoint)
{
  pcl::Indices all (points.view().size);
  std::iota (all.begin(), all.end(), 0);
  const DetectorInput input{points.view(), all, viewpoint - points.origin(), nullptr};
  std::vector<PlaneSegment> planes = detector (input).planes;
  for (PlaneSegment& plane : planes)
    plane.moveBy (points.origin());
  return planes;
}

py::array_t<std::int32_t>
labelsOf (const std::vector<PlaneSegment>& planes, py::ssize_t points)
{
  py::array_t<std::int32_t> array (points);
  std::int32_t* const labels = array.mutable_data();
  std::fill_n (labels, points, no_plane);
  for (std::size_t i = 0; i < planes.size(); ++i)
    for (const pcl::index_t inlier : planes[i].inliers)
      labels[inlier] = static_cast<std::int32_t> (i);
  return array;
}

py::list
objectsOf (std::vector<PlaneSegment>&& planes, const py::array& points)
{
  py::list objects;
  for (PlaneSegment& plane : planes)
    objects.append (PlaneObject{std::move (plane), points, std::nullopt});
  return objects;
}

} // namespace

py::tuple
segment (const py::array& points,
         const py::object& method,
         const py::object& preset,
         const py::object& viewpoint,
         const py::dict& parameters)
{
  const Detect detector = detectorOf (method, preset, parameters);
  const Eigen::Vector3d sensor = placeOf ("viewpoint", viewpoint);
  const PointArray array (points);
  std::vector<PlaneSegment> planes;
  whileOthersRun ([&] { planes = detect (detector, array, sensor); });
  const py::array labels = labelsOf (planes, points.shape (0));
  return py::make_tuple (labels, objectsOf (std::move (planes), points));
}

} // namespace pcl_ops::python
