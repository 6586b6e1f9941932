// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "errors.h"
#include "parse_number.h"

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl_ops::apps {

using StoreText = std::function<void (const std::string&)>;

struct Argument {
  std::string name, help;
  std::size_t max_count;
  StoreText store;
};

/** \brief An option; without a placeholder it has no value. */
struct Option {
  std::string name, placeholder;
  StoreText store;
  std::string meaning = {};
  /** \brief Another name that is taken, which the help leaves out; empty for none. */
  std::string old_name = {};
  bool may_be_repeated = false;

  Option&
  help (const std::string& text)
  {
    meaning = text;
    return *this;
  }

  Option&
  onceCalled (const std::string& other_name)
  {
    old_name = other_name;
    return *this;
  }

  /** \brief It may be given several times, each of which is stored. */
  Option&
  repeated ()
  {
    may_be_repeated = true;
    return *this;
  }
};

/** \brief The name in "name PLACEHOLDER". */
inline std::string
nameOf (const std::string& usage)
{
  return usage.substr (0, usage.find (' '));
}

struct OptionGroup {
  std::string title;
  std::vector<Option> options = {};
};

/** \brief The command line of a program: `--long x`, `--long=x` and PCL's `-long x`,
 * each also by the start of its name, positional arguments, --help and --version.
 * Declare arguments and options with where to store them, then parse. */
class CommandLine {
public:
  /** \param[in] program the name, with the subcommand where there is one */
  CommandLine (const std::string& program,
               const std::string& summary,
               const std::string& version);

  void
  addArgument (const std::string& name, std::string& target, const std::string& help)
  {
    const auto store = [&target] (const std::string& text) { target = text; };
    arguments_.push_back ({name, help, 1, store});
  }

  /** \brief One or more. */
  void
  addArguments (const std::string& name,
                std::vector<std::string>& targets,
                const std::string& help)
  {
    const auto store = [&targets] (auto& text) { targets.push_back (text); };
    arguments_.push_back ({name, help, std::numeric_limits<std::size_t>::max(), store});
  }

  /** \brief Replaces what --help derives from the arguments after "Usage: program"; the
   * explanation goes below the summary. */
  void
  setUsage (const std::vector<std::string>& ways, const std::string& explanation)
  {
    ways_ = ways;
    explanation_ = explanation;
  }

  /** \brief Begins a group of options, of which --help lists the names and --help-all
   * the rest. */
  void
  beginGroup (const std::string& title);

  /** \brief Declares an option: add ("jobs N", store).help ("...").
   * \param[in] usage "name PLACEHOLDER", or only "name" where the option has no value
   * \param[in] store may throw a UsageError */
  Option&
  add (const std::string& usage, const StoreText& store);

  Option&
  add (const std::string& usage, bool& target)
  {
    return add (usage, [&target] (const std::string&) { target = true; });
  }

  /** \brief Any text but an empty one. */
  Option&
  add (const std::string& usage, std::string& target);

  /** \brief One of \p choices, which are the placeholder where \p usage has none. */
  Option&
  add (const std::string& usage,
       std::string& target,
       const std::vector<std::string>& choices);

  /** \param[out] target a number, or a std::optional of one */
  template <typename Target>
  Option&
  add (const std::string& usage, Target& target, const Range& range)
  {
    const std::string option = "--" + nameOf (usage);
    return add (usage, [option, range, &target] (const std::string& text) {
      target = parseNumber<typename NumberOf<Target>::type> (option, text, range);
    });
  }

  /** \brief Declares --up, a direction or "camera". */
  template <typename Target>
  Option&
  addUpAxis (Target& target)
  {
    return add ("up x,y,z", [&target] (const std::string& text) {
      target = parseUpAxis ("--up", text);
    });
  }

  /** \brief Stores what the command line says, or prints the help or the version.
   * \return false if it printed and the program is done
   * \throws UsageError on anything undeclared, missing, ambiguous, given twice, wrong */
  bool
  parse (int argc, const char* const* argv);

  bool
  isGiven (const std::string& name) const
  {
    return given_.count (name) > 0;
  }

  std::vector<std::string>
  givenOf (const std::string& title) const;

  /** \brief \throws UsageError if both options were given */
  void
  forbidTogether (const std::string& first, const std::string& second) const
  {
    if (isGiven (first) && isGiven (second))
      throw UsageError ("--" + first,
                        "contradicts --" + second + "; give only one of them");
  }

  /** \brief The text of --help, or of --help-all. */
  std::string
  help (bool is_full = false) const;

private:
  template <typename T>
  struct NumberOf {
    using type = T;
  };
  template <typename T>
  struct NumberOf<std::optional<T>> {
    using type = T;
  };

  /** \brief What is in front of the options in the help. */
  std::string
  usage () const;

  std::string program_, summary_, version_, explanation_;
  std::vector<std::string> ways_;
  std::vector<Argument> arguments_;
  /** \brief New options go to the last. */
  std::vector<OptionGroup> groups_;
  std::set<std::string> given_;
};

} // namespace pcl_ops::apps
