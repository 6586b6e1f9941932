// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Writes the pages that show a cloud in a browser (page/page.h). This is an extension
// module of its own, which is loaded only if a page is written.
#include "interpreter.h"
#include <cli/errors.h>
#include <page/page.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace {

/** \brief Writes a page that shows points in the colors of their planes.
 * \param[in] description what the page says, JSON as for savePage
 * \param[in] points relative to \p shift, of shape (N, 3)
 * \param[in] labels of each point 0 for no plane, else the position of its plane plus 1
 * \param[in] plane_count number of planes
 * \param[in] max_points largest number of points on the page; of more, a sample is
 * shown */
void
save (const std::string& file,
      const std::string& description,
      const py::array_t<float>& points,
      const Eigen::Vector3d& shift,
      const std::vector<std::uint32_t>& labels,
      std::size_t plane_count,
      std::size_t max_points)
{
  const auto coordinates = points.unchecked<2>();
  const auto position_of = [&] (std::size_t i) {
    const auto row = static_cast<py::ssize_t> (i);
    return Eigen::Vector3d (
        coordinates (row, 0), coordinates (row, 1), coordinates (row, 2));
  };
  try {
    pcl_ops::python::whileOthersRun ([&] {
      using namespace pcl_ops::apps;
      savePage (file,
                description,
                groupPoints (labels, plane_count, position_of, max_points),
                shift);
    });
  }
  catch (const pcl_ops::apps::ProgramError& error) {
    pcl_ops::python::raise (PyExc_OSError, error.what());
  }
}

} // namespace

PYBIND11_MODULE (_page, module) { module.def ("save", &save); }
