// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// The programs' reader of files, apart from the other extension: it loads PCL's io
// module, and with that some 60 libraries.
#include "interpreter.h"
#include <cli/errors.h>
#include <io/cloud_file.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace py = pybind11;
using pcl_ops::apps::FileCloud;

namespace {

/** \brief A cloud with the parts of a PointCloud2, so that from_message decodes it. */
py::object
load (const std::string& file)
{
  auto cloud = std::make_unique<FileCloud>();
  try {
    pcl_ops::python::whileOthersRun ([&] { *cloud = pcl_ops::apps::loadCloud (file); });
  }
  catch (const pcl_ops::apps::ProgramError& error) {
    throw py::value_error (error.what());
  }
  const py::object parts = py::module_::import ("types").attr ("SimpleNamespace");
  using py::arg;
  py::list fields;
  for (const pcl::PCLPointField& field : cloud->points.fields)
    fields.append (parts (arg ("name") = field.name,
                          arg ("offset") = field.offset,
                          arg ("datatype") = field.datatype,
                          arg ("count") = field.count));
  const pcl::PCLPointCloud2& points = cloud->points;
  const Eigen::Vector3f viewpoint = cloud->origin.head<3>();
  const py::capsule owner (cloud.release(),
                           [] (void* it) { delete static_cast<FileCloud*> (it); });
  const py::array_t<std::uint8_t> data (
      static_cast<py::ssize_t> (points.data.size()), points.data.data(), owner);
  return parts (arg ("width") = points.width,
                arg ("height") = points.height,
                arg ("fields") = fields,
                arg ("is_bigendian") = points.is_bigendian,
                arg ("point_step") = points.point_step,
                arg ("row_step") = points.row_step,
                arg ("data") = data,
                arg ("viewpoint") = viewpoint);
}

} // namespace

PYBIND11_MODULE (_reader, module) { module.def ("load", &load); }
