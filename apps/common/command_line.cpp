// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/parsers.hpp>
#include <boost/program_options/value_semantic.hpp>

#include <algorithm>
#include <cctype>
#include <iostream>
#include <limits>
#include <sstream>

namespace po = boost::program_options;

namespace pcl_ops::apps {

namespace {

constexpr const char* kPositional = "positional arguments";

bool
looksLikeOption (const std::string& token)
{
  return token.size() > 1 && token[0] == '-' &&
         (token[1] == '-' || std::isalpha (static_cast<unsigned char> (token[1])) != 0);
}

/** \brief PCL's single dash: lets Boost see `-name` as `--name`. Numbers stay as they
 * are, so that `--up -1,0,0` has a value. Boost calls it on each token in turn. */
std::vector<po::option>
readSingleDashAsDouble (std::vector<std::string>& tokens)
{
  std::string& token = tokens.front();
  if (looksLikeOption (token) && token[1] != '-')
    token = token == "-h" ? "--help" : "-" + token;
  return {};
}

std::string
dashed (const std::string& name)
{
  return "--" + name.substr (std::min (name.find_first_not_of ('-'), name.size()));
}

/** \brief Boost takes the next option for the value of one that lacks its own. */
void
refuseOptionsAsValues (const po::parsed_options& parsed)
{
  for (const po::option& option : parsed.options) {
    const bool value_is_next_token = option.original_tokens.size() == 2;
    if (option.position_key < 0 && value_is_next_token &&
        looksLikeOption (option.original_tokens[1]))
      throw UsageError (dashed (option.string_key), "needs a value; see --help");
  }
}

po::parsed_options
parseTokens (const std::vector<std::string>& tokens,
             const po::options_description& options)
{
  namespace style = po::command_line_style;
  po::positional_options_description positional;
  positional.add (kPositional, -1);
  try {
    return po::command_line_parser (tokens)
        .options (options)
        .positional (positional)
        .style (style::allow_long | style::long_allow_adjacent |
                style::long_allow_next | style::allow_guessing)
        .extra_style_parser (readSingleDashAsDouble)
        .run();
  }
  catch (const po::ambiguous_option& error) {
    std::string names;
    for (const std::string& name : error.alternatives())
      names += (names.empty() ? "" : " or ") + dashed (name);
    throw UsageError (dashed (error.get_option_name()),
                      "is ambiguous; write " + names + " in full");
  }
  catch (const po::unknown_option& error) {
    throw UsageError (dashed (error.get_option_name()),
                      "is no option of this program; see --help");
  }
  catch (const po::invalid_command_line_syntax& error) {
    const bool has_extra_value = error.kind() == po::invalid_syntax::extra_parameter;
    throw UsageError (dashed (error.get_option_name()),
                      has_extra_value ? "takes no value; leave it out"
                                      : "needs a value; see --help");
  }
}

} // namespace

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
  groups_.push_back (
      {title, po::options_description (title, kHelpWidth, kHelpWidth / 2)});
}

void
CommandLine::beginBriefGroup (const std::string& title)
{
  const bool is_first =
      std::none_of (groups_.begin(), groups_.end(), [] (const Group& group) {
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
  po::options_description all = allOptions();
  all.add_options() (kPositional, po::value<std::vector<std::string>>());
  const std::vector<std::string> tokens (argv + std::min (argc, 1), argv + argc);
  const po::parsed_options parsed = parseTokens (tokens, all);
  refuseOptionsAsValues (parsed);
  try {
    po::store (parsed, values_);
  }
  catch (const po::multiple_occurrences& error) {
    throw UsageError (dashed (error.get_option_name()), "is given twice; keep one");
  }
  if (values_.count ("help") > 0)
    std::cout << help();
  else if (values_.count ("help-all") > 0)
    std::cout << fullHelp();
  else if (values_.count ("version") > 0)
    std::cout << program_ << " " << version_ << "\n";
  else {
    po::notify (values_);
    const po::variable_value& given = values_[kPositional];
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
  for (const Group& group : groups_)
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

} // namespace pcl_ops::apps
