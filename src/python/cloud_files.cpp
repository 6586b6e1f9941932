// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Reads and writes files as the programs do. This is an extension module of its own, as
// it takes long to load: it may need a library of PCL.
#include "interpreter.h"
#include <cli/errors.h>
#include <io/cloud_file.h>
#include <io/las_file.h>
#include <io/las_unit.h>
#include <io/output_file.h>
#include <picture/colors.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace py = pybind11;
using namespace pcl_ops::apps;

namespace {

/** \brief Unit of x and y by the reference system of a .las or .laz: "meter", "foot" or
 * "degree"; None if it is not known. */
py::object
unitOf (const FileCloud& cloud)
{
  switch (cloud.las ? unitOf (*cloud.las) : LasUnit::Unknown) {
  case LasUnit::Meter:
    return py::str ("meter");
  case LasUnit::Foot:
    return py::str ("foot");
  case LasUnit::Degree:
    return py::str ("degree");
  case LasUnit::Unknown:
    break;
  }
  return py::none();
}

using Labels = py::array_t<std::uint32_t, py::array::c_style>;
using Distances = py::array_t<float, py::array::c_style>;

template <typename Number, int Flags>
std::vector<Number>
vectorOf (const py::array_t<Number, Flags>& numbers)
{
  return {numbers.data(), numbers.data() + numbers.size()};
}

/** \brief Calls \p work, which reads or writes files, while other threads of Python
 * run.
 * \param[in] exception type that Python raises for a ProgramError of \p work */
template <typename Work>
void
doFileWork (PyObject* exception, const Work& work)
{
  try {
    pcl_ops::python::whileOthersRun (work);
  }
  catch (const ProgramError& error) {
    pcl_ops::python::raise (exception, error.what());
  }
}

/** \brief A cloud as an object like a PointCloud2, which from_message decodes. */
py::object
load (const std::string& file)
{
  auto cloud = std::make_unique<FileCloud>();
  doFileWork (PyExc_ValueError, [&] { *cloud = loadCloud (file); });
  const py::object make_object = py::module_::import ("types").attr ("SimpleNamespace");
  using py::arg;
  py::list fields;
  for (const pcl::PCLPointField& field : cloud->points.fields)
    fields.append (make_object (arg ("name") = field.name,
                                arg ("offset") = field.offset,
                                arg ("datatype") = field.datatype,
                                arg ("count") = field.count));
  const pcl::PCLPointCloud2& points = cloud->points;
  const Eigen::Vector3d viewpoint = cloud->origin;
  const Eigen::Quaterniond& turn = cloud->orientation;
  const py::tuple orientation = py::make_tuple (turn.w(), turn.x(), turn.y(), turn.z());
  const py::object unit = unitOf (*cloud);
  // Keeps the cloud as long as the array of its bytes exists.
  const py::capsule owner (cloud.release(), [] (void* released) {
    delete static_cast<FileCloud*> (released);
  });
  const py::array_t<std::uint8_t> data (
      static_cast<py::ssize_t> (points.data.size()), points.data.data(), owner);
  return make_object (arg ("width") = points.width,
                      arg ("height") = points.height,
                      arg ("fields") = fields,
                      arg ("is_bigendian") = points.is_bigendian,
                      arg ("point_step") = points.point_step,
                      arg ("row_step") = points.row_step,
                      arg ("data") = data,
                      arg ("viewpoint") = viewpoint,
                      arg ("orientation") = orientation,
                      arg ("unit") = unit);
}

using Bytes = py::array_t<std::uint8_t, py::array::c_style>;

/** \brief Name, datatype (pcl::PCLPointField) and count of a field. The fields of a
 * point follow each other without gaps. */
using Field = std::tuple<std::string, std::uint8_t, pcl::uindex_t>;

/** \brief Writes a .pcd or .ply.
 * \param[in] data the bytes of all points, one point after the other
 * \param[in] height number of rows of the image, or 1
 * \param[in] viewpoint position of the sensor
 * \param[in] orientation of the sensor, a quaternion w, x, y, z
 * \param[in] labels plane of each point, from 1 on, 0 for none; or empty
 * \param[in] distances of each point to its plane, or empty
 * \param[in] keeps_color if there are labels: whether points keep the colors of the
 * cloud; else they get those of their planes */
void
writeCloud (const std::string& file,
            const std::vector<Field>& fields,
            const Bytes& data,
            pcl::uindex_t height,
            const Eigen::Vector3d& viewpoint,
            const Eigen::Vector4d& orientation,
            const Labels& labels,
            const Distances& distances,
            bool keeps_color)
{
  FileCloud cloud;
  for (const auto& [name, datatype, count] : fields)
    addField (name, datatype, cloud.points, count);
  cloud.points.data = vectorOf (data);
  cloud.points.height = height;
  cloud.points.width = static_cast<pcl::uindex_t> (cloud.points.data.size() /
                                                   cloud.points.point_step / height);
  cloud.points.row_step = cloud.points.point_step * cloud.points.width;
  cloud.origin = viewpoint;
  cloud.orientation = {orientation[0], orientation[1], orientation[2], orientation[3]};
  const std::vector<std::uint32_t> plane_labels = vectorOf (labels);
  const std::vector<float> distances_of_points = vectorOf (distances);
  doFileWork (PyExc_OSError, [&] {
    if (plane_labels.empty())
      saveCloud (file, cloud);
    else
      saveLabeledCloud (file, cloud, plane_labels, distances_of_points, keeps_color);
  });
}

/** \brief Writes a .las or .laz with all that is in \p source, and fields for labels
 * and distances. Raises ValueError if \p source has other points than \p points.
 * \param[in] labels, distances as for \ref writeCloud; distances may be empty */
void
writeLas (const std::string& file,
          const std::string& source,
          const py::array_t<double, py::array::c_style>& points,
          const Labels& labels,
          const Distances& distances)
{
  const double* next_point = points.data();
  const auto point_count = static_cast<std::uint64_t> (points.shape (0));
  const std::vector<std::uint32_t> plane_labels = vectorOf (labels);
  const std::vector<float> distances_of_points = vectorOf (distances);
  std::shared_ptr<LasFile> las;
  doFileWork (PyExc_ValueError, [&] {
    las = openLas (source);
    const std::string problem =
        las->validate (distances_of_points.empty()
                           ? std::vector<LasField>{label_field}
                           : std::vector<LasField>{label_field, distance_field});
    if (!problem.empty())
      throw WorkError (source, problem);
    bool is_same = las->size() == point_count;
    if (is_same)
      las->forPositions ([&] (const Eigen::Vector3d& point_of_source) {
        is_same &= point_of_source == Eigen::Map<const Eigen::Vector3d> (next_point);
        next_point += 3;
      });
    if (!is_same)
      throw WorkError (
          source,
          "has other points than the cloud, and a .las is written with all "
          "that is in the one it was read from; write a .pcd or .ply");
  });
  doFileWork (PyExc_OSError,
              [&] { saveLabeledLas (file, *las, plane_labels, distances_of_points); });
}

/** \brief Writes a file in one step, with the errors of the programs. */
void
replaceFile (const std::string& file, const std::string& content)
{
  doFileWork (PyExc_OSError, [&] { writeTextFile (file, content); });
}

} // namespace

PYBIND11_MODULE (_files, module)
{
  module.def ("load", &load);
  module.def ("replace", &replaceFile);
  module.def ("save", &writeCloud);
  module.def ("save_las", &writeLas);
}
