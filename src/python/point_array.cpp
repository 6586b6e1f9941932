// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "point_array.h"

#include "interpreter.h"
#include <io/median_place.h>

#include <cmath>

namespace pcl_ops::python {

namespace {

using Rows = py::detail::unchecked_reference<double, 2>;

/** \brief Whether the library can read an array of single precision where it is. */
bool
hasRowsInOrder (const py::array& array)
{
  constexpr auto number = static_cast<py::ssize_t> (sizeof (float));
  return array.strides (1) == number && array.strides (0) >= 3 * number &&
         array.strides (0) % number == 0;
}

/** \return whether single precision holds all numbers but NaN exactly */
bool
copyRelativeTo (const Eigen::Vector3d& origin,
                const Rows& rows,
                std::vector<float>& copied)
{
  bool is_exact = true;
  auto to = copied.begin();
  for (py::ssize_t row = 0; row < rows.shape (0); ++row)
    for (py::ssize_t axis = 0; axis < 3; ++axis) {
      const double relative = rows (row, axis) - origin[axis];
      const auto single = static_cast<float> (relative);
      is_exact &= static_cast<double> (single) == relative || std::isnan (relative);
      *to++ = single;
    }
  return is_exact;
}

} // namespace

PointArray::PointArray (const py::array& array) : array_ (array)
{
  view_.size = static_cast<std::size_t> (array_.shape (0));
  if (py::isinstance<py::array_t<float>> (array_))
    readFloats();
  else
    readDoubles();
}

void
PointArray::readFloats()
{
  if (!hasRowsInOrder (array_))
    array_ = py::array_t<float, py::array::c_style | py::array::forcecast> (array_);
  view_.first = static_cast<const float*> (array_.data());
  view_.stride = static_cast<std::size_t> (array_.strides (0)) / sizeof (float);
}

void
PointArray::readDoubles()
{
  const Rows rows = py::array_t<double> (array_).unchecked<2>();
  whileOthersRun ([&] {
    copied_.resize (3 * view_.size);
    if (copyRelativeTo (origin_, rows, copied_))
      return;
    origin_ = apps::usualPlace (view_.size, [&] (std::size_t i) {
      const auto row = static_cast<py::ssize_t> (i);
      return Eigen::Vector3d (rows (row, 0), rows (row, 1), rows (row, 2));
    });
    copyRelativeTo (origin_, rows, copied_);
  });
  view_.first = copied_.data();
  view_.stride = 3;
}

} // namespace pcl_ops::python
