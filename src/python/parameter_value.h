// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pybind11/pybind11.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::python {

namespace py = pybind11;

/** \brief What Python calls the values of an enumeration. */
template <typename Enum>
using Names = std::vector<std::pair<const char*, Enum>>;

const Names<Sampling>& namesOf (Sampling);
const Names<Strategy>& namesOf (Strategy);
const Names<Verification>& namesOf (Verification);
const Names<AssignmentRule>& namesOf (AssignmentRule);
const Names<LocalInliers>& namesOf (LocalInliers);

/** \brief A Python string; what UTF-8 cannot hold of it as numbers. */
std::string
utf8Of (const py::handle& text);

/** \brief Says of a parameter that it is not what it has to be, and what was given. */
[[noreturn]] void
throwWrongType (const std::string& name, const char* expected, const py::handle& given);

/** \brief A whole number from \p least to \p most. */
long long
wholeNumber (const std::string& name,
             const py::handle& given,
             long long least,
             long long most);

/** \brief One of some words, as its position. */
std::size_t
oneOf (const std::string& name,
       const std::vector<const char*>& words,
       const py::handle& given);

/** \defgroup values What Python gives for a parameter, and what it gets to see of one.
 * \throw py::type_error, py::value_error which name the parameter */
/** @{ */
void
setValue (const std::string& name, double& value, const py::handle& given);
void
setValue (const std::string& name, bool& value, const py::handle& given);
void
setValue (const std::string& name, Eigen::Vector3d& value, const py::handle& given);
void
setValue (const std::string& name, Eigen::Vector3f& value, const py::handle& given);
void
setValue (const std::string& name,
          std::optional<double>& value,
          const py::handle& given);

/** \brief A finite place. */
Eigen::Vector3d
placeOf (const std::string& name, const py::handle& given);

template <typename Number>
std::enable_if_t<std::is_integral_v<Number>>
setValue (const std::string& name, Number& value, const py::handle& given)
{
  using Limits = std::numeric_limits<Number>;
  constexpr long long most = sizeof (Number) < sizeof (long long)
                                 ? static_cast<long long> (Limits::max())
                                 : std::numeric_limits<long long>::max();
  value = static_cast<Number> (
      wholeNumber (name, given, static_cast<long long> (Limits::min()), most));
}

template <typename Enum>
std::enable_if_t<std::is_enum_v<Enum>>
setValue (const std::string& name, Enum& value, const py::handle& given)
{
  const Names<Enum>& names = namesOf (Enum());
  std::vector<const char*> words;
  for (const auto& [word, meaning] : names)
    words.push_back (word);
  value = names[oneOf (name, words, given)].second;
}

template <typename Value>
py::object
valueOf (const Value& value)
{
  if constexpr (std::is_enum_v<Value>) {
    for (const auto& [word, meaning] : namesOf (Value()))
      if (meaning == value)
        return py::str (word);
    return py::none();
  }
  else
    return py::cast (value);
}

inline py::object
valueOf (const std::optional<double>& value)
{
  return value ? py::object (py::float_ (*value)) : py::none();
}

inline py::object
valueOf (const Eigen::Vector3f& value)
{
  return py::make_tuple (value.x(), value.y(), value.z());
}
/** @} */

} // namespace pcl_ops::python
