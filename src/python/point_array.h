// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/cloud_view.h>
#include <pybind11/numpy.h>

#include <vector>

namespace pcl_ops::python {

namespace py = pybind11;

/** \brief The points of a numpy array as the library reads them: in the array's own
 * memory where that has single precision and rows in order, else copied. */
class PointArray {
public:
  /** \param[in] array aligned, float32 or float64 in the machine's order of bytes, of
   * shape (N, 3); not to be changed while this is used */
  explicit PointArray (const py::array& array);

  const CloudView&
  view () const
  {
    return view_;
  }
  /** \brief Where in the frame of the array the zero of the view is. Zero for float32,
   * and for float64 if single precision holds its numbers exactly; else near most
   * points, so that the view keeps the millimetres of coordinates in the millions. */
  const Eigen::Vector3d&
  origin () const
  {
    return origin_;
  }

private:
  void
  readFloats ();
  void
  readDoubles ();

  py::array array_;
  std::vector<float> copied_;
  CloudView view_;
  Eigen::Vector3d origin_ = Eigen::Vector3d::Zero();
};

} // namespace pcl_ops::python
