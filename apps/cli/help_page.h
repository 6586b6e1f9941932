// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief A positional argument; \c store gets its text. */
struct Argument {
  std::string name, help;
  std::size_t max_count;
  std::function<void (const std::string&)> store;
};

/** \brief An option; without a placeholder it has no value. */
struct Option {
  std::string name, placeholder, help;
  std::function<void (const std::string&)> store;
};

struct OptionGroup {
  std::string title;
  std::vector<Option> options = {};
  /** \brief Named in one line by --help; --help-all explains its options. */
  bool is_brief = false;
};

struct HelpPage {
  std::string program, summary;
  /** \brief To call the program, one a line: what follows its name. */
  std::vector<std::string> ways = {};
  std::string explanation = {};
  std::vector<Argument> arguments = {};
  /** \brief New options go to the last. */
  std::vector<OptionGroup> groups = {};

  std::string
  brief () const;

  /** \brief The text of --help-all, which explains the options of brief groups, too. */
  std::string
  full () const;

private:
  std::string
  usage () const;
};

} // namespace pcl_ops::apps
