// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include "errors.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <limits>
#include <utility>

namespace pcl_ops::apps {

namespace {

/** \brief Refuses what a variable of the shell that is not set leaves of a name. */
void
requireText (const std::string& subject, const std::string& text)
{
  if (text.empty())
    throw UsageError (subject, "is empty; give a value or leave it out");
}

/** \brief Numbers do not, so that `--up -1,0,0` has a value. */
bool
looksLikeOption (const std::string& token)
{
  return token.size() > 1 && token[0] == '-' &&
         (token[1] == '-' || std::isalpha (static_cast<unsigned char> (token[1])) != 0);
}

/** \brief The name in `--long`, `--long=x` and `-long`. */
std::string
nameIn (const std::string& token)
{
  const std::size_t begin = token[1] == '-' ? 2 : 1;
  return token == "-h" ? "help" : token.substr (begin, token.find ('=') - begin);
}

/** \brief The value of an option, behind its equals sign or in the next token, to which
 * \p token goes on. */
std::string
takeValue (const std::string& option, const char* const*& token, const char* const* end)
{
  const std::string text = *token;
  const std::size_t equals = text.find ('=');
  const bool is_joined = equals != std::string::npos;
  const bool has_next = token + 1 != end && !looksLikeOption (token[1]);
  if (is_joined ? equals + 1 == text.size() : !has_next)
    throw UsageError (option, "needs a value; see --help");
  return is_joined ? text.substr (equals + 1) : *++token;
}

/** \brief Refuses a value of an option that has none. */
std::string
noValue (const std::string& option, const std::string& token)
{
  if (token.find ('=') != std::string::npos)
    throw UsageError (option, "takes no value; leave it out");
  return {};
}

} // namespace

CommandLine::CommandLine (const std::string& program,
                          const std::string& summary,
                          const std::string& version)
: page_{program, summary}, version_ (version)
{
  beginGroup ("Options");
  addValue ("help", "", "print this and exit", {});
  addValue ("version", "", "print the version and exit", {});
}

void
CommandLine::addArgument (const std::string& name,
                          std::string& target,
                          const std::string& help)
{
  page_.arguments.push_back (
      {name, help, 1, [&target] (const std::string& text) { target = text; }});
}

void
CommandLine::addArguments (const std::string& name,
                           std::vector<std::string>& targets,
                           const std::string& help)
{
  const auto store = [&targets] (const std::string& text) { targets.push_back (text); };
  page_.arguments.push_back (
      {name, help, std::numeric_limits<std::size_t>::max(), store});
}

void
CommandLine::setUsage (const std::vector<std::string>& ways,
                       const std::string& explanation)
{
  page_.ways = ways;
  page_.explanation = explanation;
}

void
CommandLine::beginGroup (const std::string& title)
{
  page_.groups.push_back ({title});
}

void
CommandLine::beginBriefGroup (const std::string& title)
{
  if (std::none_of (page_.groups.begin(),
                    page_.groups.end(),
                    [] (const OptionGroup& group) { return group.is_brief; }))
    page_.groups.front().options.push_back (
        {"help-all", "", "explain the options of the groups below, too", {}});
  page_.groups.push_back ({title, {}, true});
}

void
CommandLine::addFlag (const std::string& name, bool& target, const std::string& help)
{
  addValue (name, "", help, [&target] (const std::string&) { target = true; });
}

void
CommandLine::addText (const std::string& name,
                      const std::string& placeholder,
                      std::string& target,
                      const std::string& help)
{
  addValue (name, placeholder, help, [name, &target] (const std::string& text) {
    requireText ("--" + name, text);
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
  page_.groups.back().options.push_back ({name, placeholder, help, store});
}

const Option&
CommandLine::find (const std::string& start) const
{
  std::vector<const Option*> candidates;
  std::string names;
  for (const OptionGroup& group : page_.groups)
    for (const Option& option : group.options) {
      if (option.name == start)
        return option;
      if (option.name.rfind (start, 0) == 0) {
        candidates.push_back (&option);
        names += (names.empty() ? "--" : " or --") + option.name;
      }
    }
  if (candidates.empty() || start.empty())
    throw UsageError ("--" + start, "is no option of this program; see --help");
  if (candidates.size() > 1)
    throw UsageError ("--" + start, "is ambiguous; write " + names + " in full");
  return *candidates.front();
}

void
CommandLine::storeArguments (const std::vector<std::string>& given) const
{
  std::size_t next = 0;
  for (const Argument& argument : page_.arguments) {
    std::size_t taken = 0;
    for (; taken < argument.max_count && next < given.size(); ++taken, ++next) {
      requireText (argument.name, given[next]);
      argument.store (given[next]);
    }
    if (taken == 0)
      throw UsageError (argument.name, "is missing; see --help");
  }
  if (next < given.size())
    throw UsageError (given[next], "is one argument too many; see --help");
}

bool
CommandLine::parse (int argc, const char* const* argv)
{
  std::vector<std::pair<const Option*, std::string>> options;
  std::vector<std::string> arguments;
  const char* const* const end = argv + argc;
  for (const char* const* token = argv + std::min (argc, 1); token != end; ++token) {
    if (std::string (*token) == "--") {
      arguments.insert (arguments.end(), token + 1, end);
      break;
    }
    if (!looksLikeOption (*token)) {
      arguments.emplace_back (*token);
      continue;
    }
    const Option& option = find (nameIn (*token));
    const std::string name = "--" + option.name;
    options.emplace_back (&option,
                          option.placeholder.empty() ? noValue (name, *token)
                                                     : takeValue (name, token, end));
    if (!given_.insert (option.name).second)
      throw UsageError (name, "is given twice; keep one");
  }
  if (isGiven ("help") || isGiven ("help-all"))
    std::cout << (isGiven ("help") ? page_.brief() : page_.full());
  else if (isGiven ("version"))
    std::cout << page_.program << " " << version_ << "\n";
  else {
    for (const auto& [option, value] : options)
      option->store (value);
    storeArguments (arguments);
    return true;
  }
  return false;
}

bool
CommandLine::isGiven (const std::string& name) const
{
  return given_.count (name) > 0;
}

std::vector<std::string>
CommandLine::givenOf (const std::string& title) const
{
  std::vector<std::string> given;
  for (const OptionGroup& group : page_.groups)
    for (const Option& option : group.options)
      if (group.title == title && isGiven (option.name))
        given.push_back (option.name);
  return given;
}

void
CommandLine::forbidTogether (const std::string& first, const std::string& second) const
{
  if (isGiven (first) && isGiven (second))
    throw UsageError ("--" + first,
                      "contradicts --" + second + "; give only one of them");
}

} // namespace pcl_ops::apps
