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

FileCloud
load (const std::string& file)
{
  FileCloud cloud;
  try {
    pcl_ops::python::whileOthersRun ([&] { cloud = pcl_ops::apps::loadCloud (file); });
  }
  catch (const pcl_ops::apps::ProgramError& error) {
    throw py::value_error (error.what());
  }
  return cloud;
}

py::array
dataOf (const py::object& cloud)
{
  const auto& data = cloud.cast<const FileCloud&>().points.data;
  return py::array_t<std::uint8_t> (
      static_cast<py::ssize_t> (data.size()), data.data(), cloud);
}

} // namespace

// A FileCloud has the parts of a PointCloud2, so that from_message decodes it.
PYBIND11_MODULE (_reader, module)
{
  using pcl::PCLPointField;
  py::class_<PCLPointField> (module, "Field")
      .def_readonly ("name", &PCLPointField::name)
      .def_readonly ("offset", &PCLPointField::offset)
      .def_readonly ("datatype", &PCLPointField::datatype)
      .def_readonly ("count", &PCLPointField::count);
  const auto part = [] (auto member) {
    return [member] (const FileCloud& cloud) { return cloud.points.*member; };
  };
  using Points = pcl::PCLPointCloud2;
  py::class_<FileCloud> (module, "FileCloud")
      .def_property_readonly ("width", part (&Points::width))
      .def_property_readonly ("height", part (&Points::height))
      .def_property_readonly ("fields", part (&Points::fields))
      .def_property_readonly ("is_bigendian", part (&Points::is_bigendian))
      .def_property_readonly ("point_step", part (&Points::point_step))
      .def_property_readonly ("row_step", part (&Points::row_step))
      .def_property_readonly ("data", &dataOf)
      .def_property_readonly ("viewpoint",
                              [] (const FileCloud& cloud) -> Eigen::Vector3f {
                                return cloud.origin.head<3>();
                              });
  module.def ("load", &load);
}
