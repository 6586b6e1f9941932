// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"
#include "parameter_list.h"
#include <cli/command_line.h>
#include <numbers/angles.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <type_traits>

namespace pcl_ops::apps {

/** \brief Lists of parameters, as objects. */
inline constexpr auto shared_numbers = [] (auto& parameters, auto&& visit) {
  visitShared (parameters, visit);
};
inline constexpr auto own_numbers = [] (auto& parameters, auto&& visit) {
  visitOwn (parameters, visit);
};

/** \brief Sets a number of a parameter list to what a text says.
 * \throws UsageError if it is none or out of range */
template <typename Number>
void
setNumber (const NumberOption& option, const std::string& text, Number&& number)
{
  using Type = std::decay_t<Number>;
  const std::string name = std::string ("--") + option.name;
  if constexpr (std::is_arithmetic_v<Type>)
    number = parseNumber<Type> (name, text, option.range);
  else {
    const auto real = parseNumber<double> (name, text, option.range);
    if constexpr (std::is_same_v<Type, Degrees>)
      number.radians = toRadians (real);
    else if constexpr (std::is_same_v<Type, ZeroIfNone>)
      number.length = real == 0.0 ? std::optional<double>() : real;
    else
      number = real;
  }
}

template <typename Number>
SettingValue
settingOf (const Number& number)
{
  if constexpr (std::is_integral_v<Number>)
    return static_cast<std::int64_t> (number);
  else if constexpr (std::is_same_v<Number, Degrees>)
    return toDegrees (number.radians);
  else if constexpr (std::is_same_v<Number, ZeroIfNone>)
    return number.length.value_or (0.0);
  else if constexpr (std::is_same_v<Number, double>)
    return number;
  else
    return number ? SettingValue (*number) : SettingValue (std::string ("auto"));
}

/** \brief The numbers of a parameter list under the names of their options.
 * \param[in] list one of those above */
template <typename List, typename Parameters>
Settings
settingsOf (const List& list, Parameters parameters)
{
  Settings settings;
  list (parameters, [&] (const NumberOption& option, const auto& number) {
    std::string key = option.name;
    std::replace (key.begin(), key.end(), '-', '_');
    settings.emplace_back (key, settingOf (number));
  });
  return settings;
}

/** \brief Sets the parameters whose options were given.
 * \throws UsageError as \ref setNumber */
template <typename List, typename Parameters>
void
apply (const List& list, const GivenNumbers& given, Parameters& parameters)
{
  list (parameters, [&] (const NumberOption& option, auto&& number) {
    const auto text = given.find (option.name);
    if (text != given.end())
      setNumber (option, text->second, number);
  });
}

/** \brief Declares the options of a list.
 * \param[in] notes what follows the help of an option, by its name
 * \param[out] given those on the parsed line, checked */
template <typename List, typename Parameters>
void
declare (const List& list,
         Parameters parameters,
         const std::map<std::string, std::string>& notes,
         CommandLine& line,
         GivenNumbers& given)
{
  list (parameters, [&] (const NumberOption& option, const auto&) {
    const std::string name = option.name;
    const auto note = notes.find (name);
    line.addValue (name,
                   option.placeholder,
                   option.help + (note == notes.end() ? "" : " (" + note->second + ")"),
                   [=, &given] (const std::string& text) {
                     Parameters checked = parameters;
                     apply (list, {{name, text}}, checked);
                     given[name] = text;
                   });
  });
}

} // namespace pcl_ops::apps
