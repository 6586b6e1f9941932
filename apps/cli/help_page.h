// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options/options_description.hpp>

#include <string>
#include <utility>
#include <vector>

namespace pcl_ops::apps {

/** \brief Columns of a help page. */
constexpr unsigned help_width = 80;

/** \brief Options under a title of their own. */
struct OptionGroup {
  explicit OptionGroup (const std::string& group_title)
  : title (group_title), options (group_title, help_width, help_width / 2)
  {}

  std::string title;
  boost::program_options::options_description options;
  /** \brief Named in one line by --help; --help-all explains its options. */
  bool is_brief = false;
};

/** \brief Names and what they mean. */
using Entries = std::vector<std::pair<std::string, std::string>>;

/** \brief What --help and --help-all print. */
struct HelpPage {
  std::string program, summary;
  /** \brief To call the program, one a line: what follows its name. */
  std::vector<std::string> ways = {};
  std::string explanation = {};
  Entries arguments = {};
  /** \brief New options go to the last. */
  std::vector<OptionGroup> groups = {};

  /** \brief The text of --help. */
  std::string
  brief () const;

  /** \brief The text of --help-all, which explains the options of brief groups, too. */
  std::string
  full () const;

private:
  std::string
  usage () const;
};

/** \brief All options of the groups, as one list. */
boost::program_options::options_description
joined (const std::vector<OptionGroup>& groups);

/** \brief Entries in two columns, as Boost prints options; help2man reads entries of a
 * manual page in it. \param[in] width columns after which a meaning goes on in the next
 * line */
std::string
listed (const Entries& entries, std::size_t width);

} // namespace pcl_ops::apps
