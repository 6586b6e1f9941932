// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parameter_names.h"
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

// pybind11 3 has a caster of enumerations of its own, which this turns off.
#if defined(PYBIND11_HAS_NATIVE_ENUM)
template <typename E>
struct pybind11::detail::
    type_caster_enum_type_enabled<E, std::enable_if_t<std::is_enum_v<E>>>
: std::false_type {};
#endif

/** \brief Converts enumerations to strings in Python and back, by \ref words. */
template <typename E>
struct pybind11::detail::type_caster<E, std::enable_if_t<std::is_enum_v<E>>> {
  PYBIND11_TYPE_CASTER (E, const_name ("str"));

  bool
  load (handle source, bool)
  {
    for (const auto& [word, meaning] : std::get<Words<E>> (pcl_ops::python::words))
      if (isinstance<str> (source) && source.equal (str (word))) {
        value = meaning;
        return true;
      }
    return false;
  }
  static handle
  cast (E enum_value, return_value_policy, handle)
  {
    for (const auto& [word, meaning] : std::get<Words<E>> (pcl_ops::python::words))
      if (meaning == enum_value)
        return str (word).release();
    return none().release();
  }

private:
  template <typename T>
  using Words = pcl_ops::python::Words<T>;
};

namespace pcl_ops::python {

namespace py = pybind11;

/** \brief Python's annotation for a parameter that is a word of an enumeration:
 * "Literal['first', 'nearest']" and the like. */
template <typename WordsOfEnum>
std::string
literalOf (const WordsOfEnum& words_of_enum)
{
  std::string all;
  for (const auto& [word, value] : words_of_enum)
    all += (all.empty() ? "'" : ", '") + std::string (word) + "'";
  return "Literal[" + all + "]";
}

/** \brief Python's annotation for the type of a parameter. */
template <typename T>
std::string
annotationOf ()
{
  if constexpr (std::is_assignable_v<T&, std::nullopt_t>)
    return "Optional[" + annotationOf<typename T::value_type>() + "]";
  else if constexpr (std::is_enum_v<T>)
    return literalOf (std::get<Words<T>> (words));
  else if constexpr (std::is_same_v<T, std::array<double, 2>>)
    return "Tuple[float, float]";
  else if constexpr (std::is_same_v<T, std::array<double, 3>>)
    return "Tuple[float, float, float]";
  else if constexpr (std::is_arithmetic_v<T>)
    return std::is_same_v<T, bool> ? "bool" : std::is_integral_v<T> ? "int" : "float";
  else
    return "Vector";
}

/** \brief A value for Python, with a vector as a tuple and not an array. To copy an
 * array numpy releases the GIL; if Python ended meanwhile, the stack of this thread
 * would be unwound (\ref whileOthersRun). An optional vector is None by default, and an
 * array if it is set. */
template <typename T>
py::object
pythonValueOf (const T& member)
{
  if constexpr (std::is_base_of_v<Eigen::MatrixBase<T>, T>)
    return py::make_tuple (member[0], member[1], member[2]);
  else
    return py::cast (member);
}

/** \brief Defines a struct of parameters as a class of Python. Its method "problem"
 * returns what is wrong with the values, empty for nothing; "values_and_annotations" a
 * dict of (value, annotation) by name; "set" sets one parameter, and does nothing for
 * an unknown name. */
template <typename P>
py::class_<P>
defineParameters (py::module_& module, const char* name_of_struct)
{
  return py::class_<P> (module, name_of_struct)
      .def (py::init<>())
      .def (py::init<const P&>())
      .def ("problem", [] (const P& p) { return validate (p); })
      .def ("values_and_annotations",
            [] (P& p) {
              py::dict all;
              visit_parameters (p, [&] (const char* key, const auto& member) {
                using Member = std::decay_t<decltype (member)>;
                all[key] =
                    py::make_tuple (pythonValueOf (member), annotationOf<Member>());
              });
              return all;
            })
      .def ("set", [] (P& p, const std::string& name, const py::object& value) {
        visit_parameters (p, [&] (const char* key, auto& member) {
          if (key == name)
            member = value.cast<std::decay_t<decltype (member)>>();
        });
      });
}

} // namespace pcl_ops::python
