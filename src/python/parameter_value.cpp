// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_value.h"

#include <cstring>

namespace pcl_ops::python {

const Names<Sampling>&
namesOf (Sampling)
{
  static const Names<Sampling> names = {{"points", Sampling::Points},
                                        {"surfels", Sampling::Surfels}};
  return names;
}

const Names<Strategy>&
namesOf (Strategy)
{
  static const Names<Strategy> names = {
      {"detect_then_divide", Strategy::DetectThenDivide},
      {"divide_then_detect", Strategy::DivideThenDetect}};
  return names;
}

const Names<Verification>&
namesOf (Verification)
{
  static const Names<Verification> names = {{"samples", Verification::Samples},
                                            {"all_points", Verification::AllPoints}};
  return names;
}

const Names<AssignmentRule>&
namesOf (AssignmentRule)
{
  static const Names<AssignmentRule> names = {{"nearest", AssignmentRule::Nearest},
                                              {"first", AssignmentRule::First}};
  return names;
}

const Names<LocalInliers>&
namesOf (LocalInliers)
{
  static const Names<LocalInliers> names = {{"sphere", LocalInliers::Sphere},
                                            {"samples", LocalInliers::Samples}};
  return names;
}

void
throwWrongType (const std::string& name, const char* expected, const py::handle& given)
{
  constexpr std::size_t longest = 80;
  std::string text = py::str (py::repr (given));
  if (text.size() > longest)
    text = text.substr (0, longest) + "...";
  throw py::type_error (name + ": not " + expected + ": " + text);
}

long long
wholeNumber (const std::string& name,
             const py::handle& given,
             long long least,
             long long most)
{
  if (PyIndex_Check (given.ptr()) == 0 || PyBool_Check (given.ptr()))
    throwWrongType (name, "a whole number", given);
  int overflow = 0;
  const auto index = py::reinterpret_steal<py::object> (PyNumber_Index (given.ptr()));
  if (!index)
    throw py::error_already_set();
  const long long value = PyLong_AsLongLongAndOverflow (index.ptr(), &overflow);
  if (overflow != 0 || value < least || value > most)
    throw py::value_error (name + ": " + std::string (py::str (index)) +
                           " is not between " + std::to_string (least) + " and " +
                           std::to_string (most));
  return value;
}

std::size_t
oneOf (const std::string& name,
       const std::vector<const char*>& words,
       const py::handle& given)
{
  std::string all;
  for (const char* word : words)
    all += (all.empty() ? "'" : " or '") + std::string (word) + "'";
  if (!py::isinstance<py::str> (given))
    throwWrongType (name, all.c_str(), given);
  const auto word = given.cast<std::string>();
  for (std::size_t i = 0; i < words.size(); ++i)
    if (word == words[i])
      return i;
  throw py::value_error (name + ": '" + word + "' is not " + all);
}

void
setValue (const std::string& name, double& value, const py::handle& given)
{
  if (PyNumber_Check (given.ptr()) == 0 || PyBool_Check (given.ptr()))
    throwWrongType (name, "a number", given);
  value = PyFloat_AsDouble (given.ptr());
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throwWrongType (name, "a number", given);
  }
}

void
setValue (const std::string& name, bool& value, const py::handle& given)
{
  const bool is_numpys =
      std::strcmp (Py_TYPE (given.ptr())->tp_name, "numpy.bool_") == 0;
  if (!PyBool_Check (given.ptr()) && !is_numpys)
    throwWrongType (name, "True or False", given);
  value = PyObject_IsTrue (given.ptr()) == 1;
}

void
setValue (const std::string& name, Eigen::Vector3d& value, const py::handle& given)
{
  const bool is_sequence =
      PySequence_Check (given.ptr()) == 1 && !py::isinstance<py::str> (given);
  if (!is_sequence || py::len (given) != 3)
    throwWrongType (name, "three numbers (x, y, z)", given);
  const auto numbers = py::reinterpret_borrow<py::sequence> (given);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    setValue (name, value[axis], numbers[static_cast<std::size_t> (axis)]);
}

Eigen::Vector3d
placeOf (const std::string& name, const py::handle& given)
{
  Eigen::Vector3d place;
  setValue (name, place, given);
  if (!place.allFinite())
    throw py::value_error (name + ": has to be finite");
  return place;
}

void
setValue (const std::string& name, Eigen::Vector3f& value, const py::handle& given)
{
  Eigen::Vector3d exact;
  setValue (name, exact, given);
  value = exact.cast<float>();
}

void
setValue (const std::string& name,
          std::optional<double>& value,
          const py::handle& given)
{
  if (given.is_none())
    value.reset();
  else
    setValue (name, value.emplace(), given);
}

} // namespace pcl_ops::python
