// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "parameter_value.h"

#include <string_view>

namespace pcl_ops::python {

namespace {

/** \brief Whether it is of one of numpy's types whose name begins so: its booleans and
 * complex numbers pass for numbers. */
bool
isNumpys (std::string_view kind, const py::handle& given)
{
  const std::string_view type = Py_TYPE (given.ptr())->tp_name;
  constexpr std::string_view numpy = "numpy.";
  return type.substr (0, numpy.size()) == numpy &&
         type.substr (numpy.size(), kind.size()) == kind;
}

bool
isBoolean (const py::handle& given)
{
  return PyBool_Check (given.ptr()) || isNumpys ("bool", given);
}

/** \brief Forgets that a value has the wrong type or is too large; passes on all else
 * that Python raised. */
void
clearWrongType ()
{
  for (PyObject* known :
       {PyExc_TypeError, PyExc_ValueError, PyExc_OverflowError, PyExc_LookupError})
    if (PyErr_ExceptionMatches (known) != 0)
      return PyErr_Clear();
  throw py::error_already_set();
}

} // namespace

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

std::string
utf8Of (const py::handle& text)
{
  return py::bytes (text.attr ("encode") ("utf-8", "backslashreplace"));
}

void
throwWrongType (const std::string& name, const char* expected, const py::handle& given)
{
  constexpr py::ssize_t longest = 80;
  const py::str whole = py::repr (given);
  const auto begin =
      py::reinterpret_steal<py::str> (PyUnicode_Substring (whole.ptr(), 0, longest));
  throw py::type_error (name + ": not " + expected + ": " + utf8Of (begin) +
                        (py::len (whole) > py::len (begin) ? "..." : ""));
}

long long
wholeNumber (const std::string& name,
             const py::handle& given,
             long long least,
             long long most)
{
  if (PyIndex_Check (given.ptr()) == 0 || isBoolean (given))
    throwWrongType (name, "a whole number", given);
  int overflow = 0;
  const auto index = py::reinterpret_steal<py::object> (PyNumber_Index (given.ptr()));
  if (!index) {
    clearWrongType();
    throwWrongType (name, "a whole number", given);
  }
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
  const std::string word = utf8Of (given);
  for (std::size_t i = 0; i < words.size(); ++i)
    if (word == words[i])
      return i;
  throw py::value_error (name + ": '" + word + "' is not " + all);
}

void
setValue (const std::string& name, double& value, const py::handle& given)
{
  if (PyNumber_Check (given.ptr()) == 0 || isBoolean (given) ||
      isNumpys ("complex", given))
    throwWrongType (name, "a number", given);
  value = PyFloat_AsDouble (given.ptr());
  if (PyErr_Occurred() != nullptr) {
    clearWrongType();
    throwWrongType (name, "a number", given);
  }
}

void
setValue (const std::string& name, bool& value, const py::handle& given)
{
  if (!isBoolean (given))
    throwWrongType (name, "True or False", given);
  value = PyObject_IsTrue (given.ptr()) == 1;
}

void
setValue (const std::string& name, Eigen::Vector3d& value, const py::handle& given)
{
  const bool is_sequence =
      PySequence_Check (given.ptr()) == 1 && !py::isinstance<py::str> (given);
  const auto numbers = py::reinterpret_steal<py::object> (
      is_sequence ? PySequence_Tuple (given.ptr()) : PyTuple_New (0));
  if (!numbers)
    clearWrongType();
  if (!numbers || py::len (numbers) != 3)
    throwWrongType (name, "three numbers (x, y, z)", given);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    setValue (name, value[axis], numbers[py::int_ (axis)]);
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
