// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"

#include <boost/algorithm/string/join.hpp>

#include "similar_name.h"

#include <algorithm>
#include <cctype>
#include <iostream>
#include <sstream>

namespace pcl_ops::apps {

namespace {

/** \brief Width of a console [letters]. */
constexpr std::size_t console_width = 80;

/** \brief Number of blanks in front of a name in the help, as usual in help texts. */
constexpr std::size_t margin = 2;

/** \brief Returns a line with further words, a blank in front of each. Goes on in a new
 * line where one would be longer than \p width.
 * \param[in] column number of blanks in front of the first word of a new line; a line
 * shorter than this gets a word even if it is too long then */
std::string
wrapped (std::string line,
         const std::string& words,
         std::size_t column,
         std::size_t width)
{
  std::string text;
  std::istringstream stream (words);
  for (std::string word; stream >> word;) {
    if (line.size() >= column && line.size() + 1 + word.size() > width) {
      text += line + "\n";
      line.assign (column - 1, ' ');
    }
    line += ' ' + word;
  }
  return text + line + "\n";
}

/** \brief Returns the help on one option or argument: its name, and from \p column
 * on its meaning. A name that is too long for that has a line of its own. */
std::string
entry (const std::string& name, const std::string& meaning, std::size_t column)
{
  std::string name_line;
  std::string line = std::string (margin, ' ') + name;
  if (line.size() >= column) {
    name_line = line + "\n";
    line.clear();
  }
  line.resize (column - 1, ' ');
  // A meaning leaves the last column free: behind a letter there some consoles begin a
  // new line.
  return name_line + wrapped (line, meaning, column, console_width - 1);
}

/** \brief Returns the number of letters of the longest name with its placeholder in a
 * group. */
std::size_t
nameWidth (const OptionGroup& group)
{
  std::size_t width = 0;
  for (const Option& option : group.options)
    width = std::max (width, option.name.size() + option.placeholder.size());
  return width;
}

/** \brief Returns the help on a group: its title and an entry for each option.
 * \param[in] name_width number of letters of names and placeholders for which there is
 * room in front of the meanings */
std::string
explained (const OptionGroup& group, std::size_t name_width)
{
  // Two dashes, and a blank on each side of the placeholder.
  constexpr std::size_t dashes_and_blanks = 4;
  constexpr std::size_t min_column = 24; // as in help texts of boost::program_options
  constexpr std::size_t max_column = console_width / 2; // half is left for the meaning
  const std::size_t column =
      std::clamp (margin + name_width + dashes_and_blanks, min_column, max_column);
  std::string text = "\n" + group.title + ":\n";
  for (const Option& option : group.options)
    text +=
        entry ("--" + option.name + " " + option.placeholder, option.meaning, column);
  return text;
}

/** \brief Whether a token begins like an option: two dashes, or a dash and a letter. A
 * dash and a digit begin a number, so that `--up -1,0,0` has a value. */
bool
looksLikeOption (const std::string& token)
{
  return token.size() > 1 && token[0] == '-' &&
         (token[1] == '-' || std::isalpha (static_cast<unsigned char> (token[1])) != 0);
}

/** \brief Returns the name in a token such as --name or --name=value; -h is help.
 * \param[in] token that \ref looksLikeOption */
std::string
nameIn (const std::string& token)
{
  const std::size_t dashes = token[1] == '-' ? 2 : 1;
  return token == "-h" ? "help" : token.substr (dashes, token.find ('=') - dashes);
}

/** \brief Refuses a token that must be a file name: it begins with one dash, as an
 * option may, but has a point or a slash, as no name of an option has.
 * \param[in] token that \ref looksLikeOption */
void
refuseFileName (const std::string& token)
{
  const std::string name = token.substr (0, token.find ('='));
  const bool has_one_dash = token[1] != '-';
  if (has_one_dash && name.find_first_of ("./") != std::string::npos)
    throw UsageError (token,
                      "is no option of this program; if it is a file give ./" + token);
}

/** \brief Returns the value of an option: the text after its =, or else the next token;
 * empty if the option takes no value.
 * \param[in,out] token pointer to the token of the option; advanced to the next token
 * if that is the value
 * \param[in] end pointer to after the last token */
std::string
takeValue (const Option& option, const char* const*& token, const char* const* end)
{
  const std::string text = *token;
  const std::string name = "--" + option.name;
  const std::size_t equals = text.find ('=');
  const bool has_equals = equals != std::string::npos;
  if (option.placeholder.empty()) {
    if (has_equals)
      throw UsageError (name, "takes no value; leave it out");
    return {};
  }
  const char* const* const next = token + 1;
  const bool is_value_after_equals = has_equals && equals + 1 < text.size();
  const bool is_value_next = !has_equals && next != end && !looksLikeOption (*next);
  if (!is_value_after_equals && !is_value_next)
    throw UsageError (name, "needs a value; see --help");
  if (has_equals)
    return text.substr (equals + 1);
  token = next;
  return *next;
}

/** \brief Refuses the start of a name that several options share.
 * \param[in] candidates the options whose names begin with \p start */
[[noreturn]] void
refuseAmbiguous (const std::string& start, const std::vector<const Option*>& candidates)
{
  std::vector<std::string> names;
  for (const Option* candidate : candidates)
    names.push_back ("--" + candidate->name);
  throw UsageError ("--" + start,
                    "is ambiguous; write " + boost::join (names, " or ") + " in full");
}

/** \brief Refuses a name that no option has. */
[[noreturn]] void
refuseUnknown (const std::string& name, const std::vector<OptionGroup>& groups)
{
  std::vector<std::string> names;
  for (const OptionGroup& group : groups)
    for (const Option& option : group.options)
      names.push_back (option.name);
  const std::string similar = similarName (name, names);
  throw UsageError (
      "--" + name,
      "is no option of this program; " +
          (similar.empty() ? "see --help" : "did you mean --" + similar + "?"));
}

/** \brief Returns the option with this name or old name, or else the only one whose
 * name begins with it.
 * \throws UsageError if there is no such option, or several */
const Option&
findOption (const std::vector<OptionGroup>& groups, const std::string& name)
{
  std::vector<const Option*> candidates;
  for (const OptionGroup& group : groups)
    for (const Option& option : group.options) {
      if (option.name == name || (!name.empty() && option.old_name == name))
        return option;
      if (option.name.rfind (name, 0) == 0)
        candidates.push_back (&option);
    }
  if (candidates.empty() || name.empty())
    refuseUnknown (name, groups);
  if (candidates.size() > 1)
    refuseAmbiguous (name, candidates);
  return *candidates.front();
}

/** \brief Stores the given values in the arguments, in order; each argument takes as
 * many values as it can. */
void
storeArguments (const std::vector<Argument>& arguments,
                const std::vector<std::string>& given)
{
  std::size_t next = 0;
  for (const Argument& argument : arguments) {
    std::size_t taken = 0;
    for (; taken < argument.max_count && next < given.size(); ++taken, ++next)
      argument.store (given[next]);
    if (taken == 0)
      throw UsageError (argument.name, "is missing; see --help");
  }
  if (next < given.size())
    throw UsageError (given[next], "is one argument too many; see --help");
}

} // namespace

void
requireText (const std::string& subject, const std::string& text)
{
  if (text.empty())
    throw UsageError (subject, "is empty; give a value or leave it out");
}

std::string
CommandLine::usage() const
{
  std::string names;
  std::size_t name_width = 0; // letters of the longest argument with help
  for (const Argument& argument : arguments_) {
    names += argument.name + (argument.max_count > 1 ? "... " : " ");
    if (!argument.help.empty())
      name_width = std::max (name_width, argument.name.size());
  }
  const std::vector<std::string> derived_way = {names + "[options]"};
  std::string text;
  std::string indent = "Usage: ";
  for (const std::string& way : ways_.empty() ? derived_way : ways_) {
    text += indent + program_ + " " + way + "\n";
    indent = "       ";
  }
  text += summary_ + "\n\n" + explanation_ + (name_width > 0 ? "Arguments:\n" : "");
  constexpr std::size_t gap = 3; // blanks between the longest name and its meaning
  for (const Argument& argument : arguments_)
    if (!argument.help.empty())
      text += entry (argument.name, argument.help, margin + name_width + gap);
  return text;
}

std::string
CommandLine::help (bool is_full) const
{
  std::size_t width = nameWidth (groups_.front());
  if (is_full) // one letter more: help2man wants two blanks in front of each meaning
    for (const OptionGroup& group : groups_)
      width = std::max (width, nameWidth (group) + 1);
  std::string text = usage() + explained (groups_.front(), width);
  for (std::size_t i = 1; i < groups_.size(); ++i) {
    std::string names;
    for (const Option& option : groups_[i].options)
      names += " --" + option.name;
    text += is_full ? explained (groups_[i], width)
                    : (i == 1 ? "\n" : "") + groups_[i].title + ":\n" +
                          wrapped (" ", names, margin, console_width);
  }
  return text;
}

CommandLine::CommandLine (const std::string& program,
                          const std::string& summary,
                          const std::string& version)
: program_ (program), summary_ (summary), version_ (version), groups_{{"Options"}}
{
  add ("help", StoreText()).help ("print this and exit");
  add ("version", StoreText()).help ("print the version and exit");
}

void
CommandLine::beginGroup (const std::string& title)
{
  if (groups_.size() == 1)
    add ("help-all", StoreText()).help ("explain the options of the groups below, too");
  groups_.push_back ({title});
}

Option&
CommandLine::add (const std::string& usage, const StoreText& store)
{
  const std::string name = nameOf (usage);
  const std::string placeholder =
      usage.substr (std::min (usage.size(), name.size() + 1));
  return groups_.back().options.emplace_back (Option{name, placeholder, store});
}

Option&
CommandLine::add (const std::string& usage, std::string& target)
{
  return add (usage, [name = nameOf (usage), &target] (const std::string& text) {
    requireText ("--" + name, text);
    target = text;
  });
}

Option&
CommandLine::add (const std::string& usage,
                  std::string& target,
                  const std::vector<std::string>& choices)
{
  const std::string name = nameOf (usage);
  const std::string list = boost::join (choices, "|");
  const auto store = [name, choices, list, &target] (const std::string& text) {
    if (std::find (choices.begin(), choices.end(), text) == choices.end())
      throw UsageError ("--" + name, "'" + text + "' is unknown; give " + list);
    target = text;
  };
  return add (name == usage ? name + " " + list : usage, store);
}

bool
CommandLine::parse (int argc, const char* const* argv)
{
  struct GivenOption {
    const Option* option;
    std::string value;
  };
  std::vector<GivenOption> options;
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
    refuseFileName (*token);
    const Option& option = findOption (groups_, nameIn (*token));
    options.push_back ({&option, takeValue (option, token, end)});
    const bool is_new = given_.insert (option.name).second;
    if (!is_new && !option.may_be_repeated)
      throw UsageError ("--" + option.name, "is given twice; keep one");
  }
  if (isGiven ("help") || isGiven ("help-all"))
    std::cout << help (!isGiven ("help"));
  else if (isGiven ("version"))
    std::cout << program_ << " " << version_ << "\n";
  else {
    for (const auto& [option, value] : options)
      option->store (value);
    storeArguments (arguments_, arguments);
    return true;
  }
  return false;
}

std::vector<std::string>
CommandLine::givenOf (const std::string& title) const
{
  std::vector<std::string> given;
  for (const OptionGroup& group : groups_)
    for (const Option& option : group.options)
      if (group.title == title && isGiven (option.name))
        given.push_back (option.name);
  return given;
}

} // namespace pcl_ops::apps
