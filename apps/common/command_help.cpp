// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.h"
#include "help_text.h"

#include <sstream>
#include <utility>

namespace po = boost::program_options;

namespace pcl_ops::apps {

namespace {

/** \brief The options of a group without their values, as lines of the help. */
std::string
namesOf (const po::options_description& options, std::size_t width)
{
  std::string lines, line = " ";
  for (const auto& option : options.options()) {
    const std::string name = " --" + option->long_name();
    if (line.size() + name.size() > width) {
      lines += line + "\n";
      line = " ";
    }
    line += name;
  }
  return lines + line + "\n";
}

} // namespace

std::string
CommandLine::help() const
{
  std::ostringstream text;
  text << usage();
  bool follows_brief = false;
  for (const Group& group : groups_) {
    text << (follows_brief && group.is_brief ? "" : "\n");
    if (group.is_brief)
      text << group.title << ":\n" << namesOf (group.options, kHelpWidth);
    else
      text << group.options;
    follows_brief = group.is_brief;
  }
  return text.str();
}

std::string
CommandLine::fullHelp() const
{
  std::ostringstream text;
  text << usage() << allOptions();
  return text.str();
}

std::string
CommandLine::usage() const
{
  std::ostringstream text;
  std::string before = "Usage: ";
  for (const std::string& way : waysToCall()) {
    text << before << program_ << " " << way << "\n";
    before = "       ";
  }
  text << summary_ << "\n\n" << explanation_;
  std::vector<std::pair<std::string, std::string>> entries;
  for (const Argument& argument : arguments_)
    if (!argument.help.empty())
      entries.emplace_back (argument.name, argument.help);
  if (!entries.empty())
    text << "Arguments:\n" << listed (entries, kHelpWidth);
  return text.str();
}

std::vector<std::string>
CommandLine::waysToCall() const
{
  if (!ways_.empty())
    return ways_;
  std::string way;
  for (const Argument& argument : arguments_) {
    const std::string name = argument.name + (argument.most > 1 ? "..." : "");
    way += (argument.fewest == 0 ? "[" + name + "]" : name) + " ";
  }
  return {way + "[options]"};
}

po::options_description
CommandLine::allOptions() const
{
  po::options_description all ("", kHelpWidth, kHelpWidth / 2);
  for (const Group& group : groups_)
    all.add (group.options);
  return all;
}

} // namespace pcl_ops::apps
