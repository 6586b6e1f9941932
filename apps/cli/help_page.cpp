// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "help_page.h"

#include <algorithm>
#include <sstream>

namespace pcl_ops::apps {

namespace {

constexpr std::size_t help_width = 80;

/** \brief A name and its meaning in two columns. */
std::string
entry (const std::string& name, const std::string& meaning, std::size_t column)
{
  std::string text, line = "  " + name;
  if (line.size() >= column) {
    text = line + "\n";
    line.clear();
  }
  line.resize (column - 1, ' ');
  std::istringstream words (meaning);
  for (std::string word; words >> word;) {
    // A console goes on in the next line by itself where the last column is taken.
    if (line.size() >= column && line.size() + 1 + word.size() >= help_width) {
      text += line + "\n";
      line.assign (column - 1, ' ');
    }
    line += ' ' + word;
  }
  return text + line + "\n";
}

/** \brief Columns that the names of options and their placeholders take. */
std::size_t
widthOf (const OptionGroup& group)
{
  std::size_t width = 0;
  for (const Option& option : group.options)
    width = std::max (width, option.name.size() + option.placeholder.size());
  return width;
}

std::string
explained (const OptionGroup& group, std::size_t width)
{
  constexpr std::size_t around = 6; // margin, dashes, and a blank on either side
  constexpr std::size_t min_column = 24;
  const std::size_t column = std::clamp (width + around, min_column, help_width / 2);
  std::string text = "\n" + group.title + ":\n";
  for (const Option& option : group.options)
    text += entry ("--" + option.name + " " + option.placeholder, option.help, column);
  return text;
}

} // namespace

std::string
HelpPage::usage() const
{
  std::string derived, text, before = "Usage: ";
  std::size_t longest = 0;
  for (const Argument& argument : arguments) {
    derived += argument.name + (argument.max_count > 1 ? "... " : " ");
    if (!argument.help.empty())
      longest = std::max (longest, argument.name.size());
  }
  const std::vector<std::string> one_way = {derived + "[options]"};
  for (const std::string& way : ways.empty() ? one_way : ways) {
    text += before + program + " " + way + "\n";
    before = "       ";
  }
  text += summary + "\n\n" + explanation + (longest > 0 ? "Arguments:\n" : "");
  constexpr std::size_t margin = 2, gap = 3;
  for (const Argument& argument : arguments)
    if (!argument.help.empty())
      text += entry (argument.name, argument.help, margin + longest + gap);
  return text;
}

std::string
HelpPage::brief() const
{
  std::string text = usage();
  bool follows_brief = false;
  for (const OptionGroup& group : groups) {
    if (!group.is_brief)
      text += explained (group, widthOf (group));
    else {
      text += (follows_brief ? "" : "\n") + group.title + ":\n";
      std::string line = " ";
      for (const Option& option : group.options) {
        if (line.size() + 3 + option.name.size() > help_width) {
          text += line + "\n";
          line = " ";
        }
        line += " --" + option.name;
      }
      text += line + "\n";
    }
    follows_brief = group.is_brief;
  }
  return text;
}

std::string
HelpPage::full() const
{
  std::string text = usage();
  std::size_t width = 0;
  for (const OptionGroup& group : groups)
    width = std::max (width, widthOf (group));
  // help2man wants two blanks in front of every meaning.
  for (const OptionGroup& group : groups)
    text += explained (group, width + 1);
  return text;
}

} // namespace pcl_ops::apps
