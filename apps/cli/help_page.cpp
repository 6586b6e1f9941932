// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "help_page.h"

#include <algorithm>
#include <sstream>

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
HelpPage::brief() const
{
  std::ostringstream text;
  text << usage();
  bool follows_brief = false;
  for (const OptionGroup& group : groups) {
    text << (follows_brief && group.is_brief ? "" : "\n");
    if (group.is_brief)
      text << group.title << ":\n" << namesOf (group.options, help_width);
    else
      text << group.options;
    follows_brief = group.is_brief;
  }
  return text.str();
}

std::string
HelpPage::full() const
{
  std::ostringstream text;
  text << usage() << joined (groups);
  return text.str();
}

std::string
HelpPage::usage() const
{
  std::ostringstream text;
  std::string before = "Usage: ";
  for (const std::string& way : ways) {
    text << before << program << " " << way << "\n";
    before = "       ";
  }
  text << summary << "\n\n" << explanation;
  if (!arguments.empty())
    text << "Arguments:\n" << listed (arguments, help_width);
  return text.str();
}

po::options_description
joined (const std::vector<OptionGroup>& groups)
{
  po::options_description all ("", help_width, help_width / 2);
  for (const OptionGroup& group : groups)
    all.add (group.options);
  return all;
}

std::string
listed (const Entries& entries, std::size_t width)
{
  constexpr std::size_t margin = 2, gap = 3;
  std::size_t longest = 0;
  for (const auto& entry : entries)
    longest = std::max (longest, entry.first.size());
  const std::size_t column = margin + longest + gap;
  std::string text;
  for (const auto& [name, meaning] : entries) {
    std::string line = std::string (margin, ' ') + name;
    line.resize (column - 1, ' ');
    std::istringstream words (meaning);
    for (std::string word; words >> word;) {
      if (line.size() > column && line.size() + 1 + word.size() > width) {
        text += line + "\n";
        line.assign (column - 1, ' ');
      }
      line += ' ' + word;
    }
    text += line + "\n";
  }
  return text;
}

} // namespace pcl_ops::apps
