// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parameters.h"
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <limits>
#include <optional>
#include <type_traits>

namespace pybind11::detail {

/** \brief Enumerations are strings to Python. */
template <typename Enum>
struct type_caster<Enum, std::enable_if_t<std::is_enum_v<Enum>>> {
  PYBIND11_TYPE_CASTER (Enum, const_name ("str"));

  bool
  load (handle given, bool /*convert*/)
  {
    for (const auto& [name, meaning] : pcl_ops::python::names<Enum>)
      if (isinstance<str> (given) && given.equal (str (name))) {
        value = meaning;
        return true;
      }
    return false;
  }

  static handle
  cast (Enum value, return_value_policy /*policy*/, handle /*parent*/)
  {
    for (const auto& [name, meaning] : pcl_ops::python::names<Enum>)
      if (meaning == value)
        return str (name).release();
    return none().release();
  }
};

} // namespace pybind11::detail

namespace pcl_ops::python {

namespace py = pybind11;

/** \brief What a value has to be: for a message, and as an annotation of Python. */
struct TypeName {
  std::string message;
  std::string annotation;
};

/** \brief Value, also where it is optional. */
template <typename Value>
struct Given {
  using Type = Value;
};
template <typename Value>
struct Given<std::optional<Value>> {
  using Type = Value;
};

template <typename Value>
TypeName
typeName ()
{
  using Limits = std::numeric_limits<Value>;
  if constexpr (std::is_same_v<Value, bool>)
    return {"True or False", "bool"};
  else if constexpr (std::is_integral_v<Value>)
    return {"a whole number from " + std::to_string (Limits::min()) + " to " +
                std::to_string (Limits::max()),
            "int"};
  else if constexpr (std::is_floating_point_v<Value>)
    return {"a number", "float"};
  else if constexpr (std::is_enum_v<Value>) {
    std::string words;
    for (const auto& [name, meaning] : names<Value>)
      words += (words.empty() ? "'" : ", '") + std::string (name) + "'";
    return {"one of " + words, "Literal[" + words + "]"};
  }
  else if constexpr (!std::is_same_v<Value, typename Given<Value>::Type>) {
    const TypeName name = typeName<typename Value::value_type>();
    return {name.message + " or None", "Optional[" + name.annotation + "]"};
  }
  else
    return {"three numbers (x, y, z)", "Vector"};
}

/** \throw py::value_error for a number or string that is out of range, py::type_error
 * for anything else that is wrong; either names the parameter */
template <typename Value>
void
setValue (const std::string& name, const py::handle& given, Value& value)
{
  py::detail::make_caster<Value> caster;
  // Everything converts to bool.
  if (caster.load (given, !std::is_same_v<Value, bool>)) {
    value = py::detail::cast_op<Value> (std::move (caster));
    return;
  }
  const std::string problem = py::str ("{}: has to be {}, not {!r:.80}")
                                  .format (name, typeName<Value>().message, given);
  using Type = typename Given<Value>::Type;
  const bool is_out_of_range =
      std::is_enum_v<Type> ? py::isinstance<py::str> (given)
                           : std::is_integral_v<Type> && PyIndex_Check (given.ptr());
  if (is_out_of_range)
    throw py::value_error (problem);
  throw py::type_error (problem);
}

template <typename Parameters>
void
setParameter (Parameters& parameters,
              const std::string& wanted,
              const py::handle& given)
{
  std::string names;
  bool is_known = false;
  visit (parameters, [&] (const std::string& name, auto& value) {
    names += (names.empty() ? "" : ", ") + name;
    if (name != wanted)
      return;
    setValue (name, given, value);
    is_known = true;
  });
  if (!is_known)
    throw py::value_error (wanted + ": unknown parameter; there are " + names);
}

/** \brief Parameters with those given set.
 * \throw py::value_error, py::type_error which name the parameter at fault */
template <typename Parameters>
Parameters
withGiven (const Parameters& preset, const py::dict& given)
{
  Parameters parameters = preset;
  for (const auto& [name, value] : given)
    setParameter (parameters, py::str (name), value);
  const std::string problem = validate (parameters);
  if (problem.empty())
    return parameters;
  for (const auto& [name, value] : given) {
    Parameters alone = preset;
    setParameter (alone, py::str (name), value);
    if (validate (alone) == problem)
      throw py::value_error (std::string (py::str (name)) + ": " + problem);
  }
  throw py::value_error (problem);
}

/** \brief Name, value and annotation of each parameter. */
template <typename Parameters>
py::list
listOf (Parameters parameters)
{
  py::list all;
  visit (parameters, [&] (const std::string& name, auto& value) {
    const auto annotation = typeName<std::decay_t<decltype (value)>>().annotation;
    py::object shown = py::cast (value);
    if (annotation == "Vector")
      shown = py::tuple (shown.attr ("tolist")());
    all.append (py::make_tuple (name, shown, annotation));
  });
  return all;
}

} // namespace pcl_ops::python
