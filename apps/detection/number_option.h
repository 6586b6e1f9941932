// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "methods.h"
#include "settings.h"
#include <cli/command_line.h>
#include <cli/option_value.h>

#include <algorithm>
#include <cstddef>
#include <sstream>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace pcl_ops::apps {

/** \brief All there is to say about an option that sets a number among a detector's
 * parameters. In a report its name has '_' for '-'. */
template <typename Parameters>
struct NumberOption {
  std::string name;
  std::string placeholder;
  Range range;
  /** \brief The number among the parameters. */
  std::variant<int& (*)(Parameters&),
               unsigned& (*)(Parameters&),
               std::size_t& (*)(Parameters&),
               double& (*)(Parameters&)>
      member;
  /** \brief The values of the presets follow in the help. */
  std::string help;
};

/** \brief The options one method has and no other. */
template <typename Parameters>
using OptionTable = std::vector<NumberOption<Parameters>>;

/** \brief The help of an option, with the value of each preset. */
template <typename Number>
std::string
withPresets (const std::string& help, Number usual, Number paper)
{
  std::ostringstream text;
  text << help << " (" << usual;
  if (usual != paper)
    text << "; paper " << paper;
  text << ")";
  return text.str();
}

/** \brief Declares the options. \param[out] given those on the parsed line, checked */
template <typename Parameters>
void
declare (const OptionTable<Parameters>& table, CommandLine& line, GivenNumbers& given)
{
  Parameters usual, paper = Parameters::paper();
  for (const NumberOption<Parameters>& option : table)
    std::visit (
        [&] (auto member) {
          using Number = std::decay_t<decltype (member (usual))>;
          line.addValue (option.name,
                         option.placeholder,
                         withPresets (option.help, member (usual), member (paper)),
                         [name = option.name, range = option.range, &given] (
                             const std::string& text) {
                           parseNumber<Number> ("--" + name, text, range);
                           given[name] = text;
                         });
        },
        option.member);
}

/** \brief Sets the parameters whose options were given. */
template <typename Parameters>
void
apply (const OptionTable<Parameters>& table,
       const GivenNumbers& given,
       Parameters& parameters)
{
  for (const NumberOption<Parameters>& option : table) {
    const auto text = given.find (option.name);
    if (text == given.end())
      continue;
    std::visit (
        [&] (auto member) {
          using Number = std::decay_t<decltype (member (parameters))>;
          member (parameters) =
              parseNumber<Number> ("--" + option.name, text->second, option.range);
        },
        option.member);
  }
}

/** \brief The parameters under the names of their options. */
template <typename Parameters>
Settings
settingsOf (const OptionTable<Parameters>& table, Parameters parameters)
{
  Settings settings;
  for (const NumberOption<Parameters>& option : table) {
    std::string key = option.name;
    std::replace (key.begin(), key.end(), '-', '_');
    std::visit (
        [&] (auto member) {
          using Number = std::decay_t<decltype (member (parameters))>;
          using Value =
              std::conditional_t<std::is_integral_v<Number>, std::int64_t, double>;
          settings.emplace_back (key, static_cast<Value> (member (parameters)));
        },
        option.member);
  }
  return settings;
}

} // namespace pcl_ops::apps
