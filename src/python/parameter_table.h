// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "parameter_value.h"

#include <functional>
#include <string>
#include <vector>

namespace pcl_ops::python {

/** \brief A field of a struct of parameters, by its name. */
template <typename P>
struct Field {
  std::string name;
  std::function<void (const std::string& name, P&, const py::handle&)> set;
  std::function<py::object (const P&)> get;
};

template <typename P>
using Fields = std::vector<Field<P>>;

/** \param[in] member of \p P or of a base of it */
template <typename P, typename Member>
Field<P>
field (const char* name, Member member)
{
  return {name,
          [member] (const std::string& full_name, P& p, const py::handle& given) {
            setValue (full_name, p.*member, given);
          },
          [member] (const P& p) { return valueOf (p.*member); }};
}

/** \brief Adds the fields of a struct within another: their names follow its own. */
template <typename P, typename Member, typename Inner>
void
append (Fields<P>& fields,
        const std::string& prefix,
        Member member,
        const Fields<Inner>& inner)
{
  for (const Field<Inner>& one : inner)
    fields.push_back (
        {prefix + one.name,
         [member, one] (const std::string& name, P& p, const py::handle& given) {
           one.set (name, p.*member, given);
         },
         [member, one] (const P& p) { return one.get (p.*member); }});
}

/** \brief The names of all fields, for a message. */
template <typename P>
std::string
allNames (const Fields<P>& fields)
{
  std::string names;
  for (const Field<P>& one : fields)
    names += (names.empty() ? "" : ", ") + one.name;
  return names;
}

template <typename P>
void
setField (const Fields<P>& fields,
          const std::string& name,
          const py::handle& given,
          P& parameters)
{
  for (const Field<P>& one : fields)
    if (one.name == name)
      return one.set (name, parameters, given);
  throw py::value_error (name + ": unknown parameter; there are " + allNames (fields));
}

/** \brief Parameters with those given set.
 * \param[in] problem_of says what is wrong with them all, as a sentence or empty
 * \throw py::value_error, py::type_error which name the parameter at fault */
template <typename P, typename ProblemOf>
P
withGiven (const Fields<P>& fields,
           const P& preset,
           const py::dict& given,
           const ProblemOf& problem_of)
{
  P parameters = preset;
  for (const auto& [name, value] : given)
    setField (fields, utf8Of (name), value, parameters);
  const std::string problem = problem_of (parameters);
  if (problem.empty())
    return parameters;
  for (const auto& [name, value] : given) {
    P alone = preset;
    setField (fields, utf8Of (name), value, alone);
    if (problem_of (alone) == problem)
      throw py::value_error (utf8Of (name) + ": " + problem);
  }
  throw py::value_error (problem);
}

template <typename P>
py::dict
toDict (const Fields<P>& fields, const P& parameters)
{
  py::dict values;
  for (const Field<P>& one : fields)
    values[py::str (one.name)] = one.get (parameters);
  return values;
}

} // namespace pcl_ops::python
