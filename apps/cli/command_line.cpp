// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/value_semantic.hpp>
#include <boost/program_options/variables_map.hpp>

#include "errors.h"
#include "help_page.h"
#include "tokens.h"

#include <algorithm>
#include <iostream>
#include <limits>
#include <utility>

namespace po = boost::program_options;

namespace pcl_ops::apps {

namespace {

struct Argument {
  std::string name;
  std::string help;
  std::size_t min_count;
  std::size_t max_count;
  std::function<void (const std::string&)> store;
};

/** \brief Refuses what a variable of the shell that is not set leaves of a name. */
void
requireText (const std::string& subject, const std::string& text)
{
  if (text.empty())
    throw UsageError (subject, "is empty; give a value or leave it out");
}

void
storeArguments (const std::vector<Argument>& arguments,
                const std::vector<std::string>& given)
{
  std::size_t next = 0;
  for (const Argument& argument : arguments) {
    std::size_t taken = 0;
    for (; taken < argument.max_count && next < given.size(); ++taken, ++next) {
      requireText (argument.name, given[next]);
      argument.store (given[next]);
    }
    if (taken < argument.min_count)
      throw UsageError (argument.name, "is missing; see --help");
  }
  if (next < given.size())
    throw UsageError (given[next], "is one argument too many; see --help");
}

/** \brief What follows a program's name. */
std::string
wayToCall (const std::vector<Argument>& arguments)
{
  std::string way;
  for (const Argument& argument : arguments) {
    const std::string name = argument.name + (argument.max_count > 1 ? "..." : "");
    way += (argument.min_count == 0 ? "[" + name + "]" : name) + " ";
  }
  return way + "[options]";
}

} // namespace

struct CommandLine::State {
  HelpPage page;
  std::string version;
  std::vector<Argument> arguments = {};
  po::variables_map values = {};

  /** \brief Where the next option goes to. */
  po::options_description&
  options ()
  {
    return page.groups.back().options;
  }
};

CommandLine::CommandLine (const std::string& program,
                          const std::string& summary,
                          const std::string& version)
: state_ (new State{{program, summary}, version})
{
  beginGroup ("Options");
  state_->options().add_options() ("help", "print this and exit") (
      "version", "print the version and exit");
}

CommandLine::~CommandLine() = default;

void
CommandLine::addArgument (const std::string& name,
                          std::string& target,
                          const std::string& help)
{
  state_->arguments.push_back (
      {name, help, 1, 1, [&target] (const std::string& text) { target = text; }});
}

void
CommandLine::addOptionalArgument (const std::string& name,
                                  std::string& target,
                                  const std::string& help)
{
  addArgument (name, target, help);
  state_->arguments.back().min_count = 0;
}

void
CommandLine::addArguments (const std::string& name,
                           std::vector<std::string>& targets,
                           std::size_t min_count,
                           const std::string& help)
{
  state_->arguments.push_back (
      {name,
       help,
       min_count,
       std::numeric_limits<std::size_t>::max(),
       [&targets] (const std::string& text) { targets.push_back (text); }});
}

void
CommandLine::setUsage (const std::vector<std::string>& ways,
                       const std::string& explanation)
{
  state_->page.ways = ways;
  state_->page.explanation = explanation;
}

void
CommandLine::beginGroup (const std::string& title)
{
  state_->page.groups.emplace_back (title);
}

void
CommandLine::beginBriefGroup (const std::string& title)
{
  const bool is_first =
      std::none_of (state_->page.groups.begin(),
                    state_->page.groups.end(),
                    [] (const OptionGroup& group) { return group.is_brief; });
  if (is_first)
    state_->page.groups.front().options.add_options() (
        "help-all", "explain the options of the groups below, too");
  beginGroup (title);
  state_->page.groups.back().is_brief = true;
}

void
CommandLine::addFlag (const std::string& name, bool& target, const std::string& help)
{
  state_->options().add_options() (name.c_str(),
                                   po::bool_switch()->notifier ([&target] (bool given) {
                                     target = target || given;
                                   }),
                                   help.c_str());
}

void
CommandLine::addText (const std::string& name,
                      const std::string& placeholder,
                      std::string& target,
                      const std::string& help)
{
  addValue (name, placeholder, help, [name, &target] (const std::string& text) {
    requireText (dashed (name), text);
    target = text;
  });
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
  state_->options().add_options() (
      name.c_str(),
      po::value<std::string>()->value_name (placeholder)->notifier (store),
      help.c_str());
}

bool
CommandLine::parse (int argc, const char* const* argv)
{
  po::options_description all = joined (state_->page.groups);
  all.add_options() (positional_arguments, po::value<std::vector<std::string>>());
  const std::vector<std::string> tokens (argv + std::min (argc, 1), argv + argc);
  const po::parsed_options parsed = parseTokens (tokens, all);
  try {
    po::store (parsed, state_->values);
  }
  catch (const po::multiple_occurrences& error) {
    throw UsageError (dashed (error.get_option_name()), "is given twice; keep one");
  }
  if (state_->values.count ("help") > 0)
    std::cout << help().brief();
  else if (state_->values.count ("help-all") > 0)
    std::cout << help().full();
  else if (state_->values.count ("version") > 0)
    std::cout << state_->page.program << " " << state_->version << "\n";
  else {
    po::notify (state_->values);
    const po::variable_value& given = state_->values[positional_arguments];
    storeArguments (state_->arguments,
                    given.empty() ? std::vector<std::string>()
                                  : given.as<std::vector<std::string>>());
    return true;
  }
  return false;
}

bool
CommandLine::isGiven (const std::string& name) const
{
  return state_->values.count (name) > 0 && !state_->values[name].defaulted();
}

std::vector<std::string>
CommandLine::givenOf (const std::string& title) const
{
  std::vector<std::string> given;
  for (const OptionGroup& group : state_->page.groups)
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

HelpPage
CommandLine::help() const
{
  HelpPage page = state_->page;
  if (page.ways.empty())
    page.ways = {wayToCall (state_->arguments)};
  for (const Argument& argument : state_->arguments)
    if (!argument.help.empty())
      page.arguments.emplace_back (argument.name, argument.help);
  return page;
}

} // namespace pcl_ops::apps
