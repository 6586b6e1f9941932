// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/value_semantic.hpp>

#include "errors.h"
#include "tokens.h"

#include <algorithm>
#include <iostream>
#include <limits>

namespace po = boost::program_options;

namespace pcl_ops::apps {

CommandLine::CommandLine (std::string program, std::string summary, std::string version)
: program_ (std::move (program))
, summary_ (std::move (summary))
, version_ (std::move (version))
{
  beginGroup ("Options");
  groups_.back().options.add_options() ("help", "print this and exit") (
      "version", "print the version and exit");
}

void
CommandLine::addArgument (const std::string& name,
                          std::string& target,
                          const std::string& help)
{
  arguments_.push_back (
      {name, help, 1, 1, [&target] (const std::string& text) { target = text; }});
}

void
CommandLine::addOptionalArgument (const std::string& name,
                                  std::string& target,
                                  const std::string& help)
{
  addArgument (name, target, help);
  arguments_.back().fewest = 0;
}

void
CommandLine::addArguments (const std::string& name,
                           std::vector<std::string>& targets,
                           std::size_t fewest,
                           const std::string& help)
{
  arguments_.push_back (
      {name,
       help,
       fewest,
       std::numeric_limits<std::size_t>::max(),
       [&targets] (const std::string& text) { targets.push_back (text); }});
}

void
CommandLine::setUsage (const std::vector<std::string>& ways,
                       const std::string& explanation)
{
  ways_ = ways;
  explanation_ = explanation;
}

void
CommandLine::beginGroup (const std::string& title)
{
  groups_.emplace_back (title);
}

void
CommandLine::beginBriefGroup (const std::string& title)
{
  const bool is_first =
      std::none_of (groups_.begin(), groups_.end(), [] (const OptionGroup& group) {
        return group.is_brief;
      });
  if (is_first)
    groups_.front().options.add_options() (
        "help-all", "explain the options of the groups below, too");
  beginGroup (title);
  groups_.back().is_brief = true;
}

void
CommandLine::addFlag (const std::string& name, bool& target, const std::string& help)
{
  groups_.back().options.add_options() (
      name.c_str(),
      po::bool_switch()->notifier (
          [&target] (bool given) { target = target || given; }),
      help.c_str());
}

void
CommandLine::addText (const std::string& name,
                      const std::string& placeholder,
                      std::string& target,
                      const std::string& help)
{
  addValue (
      name, placeholder, help, [&target] (const std::string& text) { target = text; });
}

void
CommandLine::addChoice (const std::string& name,
                        const std::vector<std::string>& choices,
                        std::string& target,
                        const std::string& help,
                        const std::string& placeholder)
{
  std::string list;
  for (const std::string& choice : choices)
    list += (list.empty() ? "" : "|") + choice;
  const auto store = [name, choices, list, &target] (const std::string& text) {
    if (std::find (choices.begin(), choices.end(), text) == choices.end())
      throw UsageError ("--" + name, "'" + text + "' is unknown; give " + list);
    target = text;
  };
  addValue (name, placeholder.empty() ? list : placeholder, help, store);
}

void
CommandLine::addValue (const std::string& name,
                       const std::string& placeholder,
                       const std::string& help,
                       const std::function<void (const std::string&)>& store)
{
  groups_.back().options.add_options() (
      name.c_str(),
      po::value<std::string>()->value_name (placeholder)->notifier (store),
      help.c_str());
}

bool
CommandLine::parse (int argc, const char* const* argv)
{
  po::options_description all = joined (groups_);
  all.add_options() (positional_arguments, po::value<std::vector<std::string>>());
  const std::vector<std::string> tokens (argv + std::min (argc, 1), argv + argc);
  const po::parsed_options parsed = parseTokens (tokens, all);
  try {
    po::store (parsed, values_);
  }
  catch (const po::multiple_occurrences& error) {
    throw UsageError (dashed (error.get_option_name()), "is given twice; keep one");
  }
  if (values_.count ("help") > 0)
    std::cout << help().brief();
  else if (values_.count ("help-all") > 0)
    std::cout << help().full();
  else if (values_.count ("version") > 0)
    std::cout << program_ << " " << version_ << "\n";
  else {
    po::notify (values_);
    const po::variable_value& given = values_[positional_arguments];
    storeArguments (given.empty() ? std::vector<std::string>()
                                  : given.as<std::vector<std::string>>());
    return true;
  }
  return false;
}

std::vector<std::string>
CommandLine::givenOf (const std::string& title) const
{
  std::vector<std::string> given;
  for (const OptionGroup& group : groups_)
    if (group.title == title)
      for (const auto& option : group.options.options())
        if (isGiven (option->long_name()))
          given.push_back (option->long_name());
  return given;
}

void
CommandLine::forbidTogether (const std::string& first, const std::string& second) const
{
  if (isGiven (first) && isGiven (second))
    throw UsageError ("--" + first,
                      "contradicts --" + second + "; give only one of them");
}

void
CommandLine::storeArguments (const std::vector<std::string>& given) const
{
  std::size_t next = 0;
  for (const Argument& argument : arguments_) {
    std::size_t taken = 0;
    for (; taken < argument.most && next < given.size(); ++taken, ++next)
      argument.store (given[next]);
    if (taken < argument.fewest)
      throw UsageError (argument.name, "is missing; see --help");
  }
  if (next < given.size())
    throw UsageError (given[next], "is one argument too many; see --help");
}

HelpPage
CommandLine::help() const
{
  HelpPage page{program_, ways_, summary_, explanation_, {}, groups_};
  if (ways_.empty())
    page.ways = {wayToCall()};
  for (const Argument& argument : arguments_)
    if (!argument.help.empty())
      page.arguments.emplace_back (argument.name, argument.help);
  return page;
}

std::string
CommandLine::wayToCall() const
{
  std::string way;
  for (const Argument& argument : arguments_) {
    const std::string name = argument.name + (argument.most > 1 ? "..." : "");
    way += (argument.fewest == 0 ? "[" + name + "]" : name) + " ";
  }
  return way + "[options]";
}

} // namespace pcl_ops::apps
