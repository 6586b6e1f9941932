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

/** \brief Stores the text of a value where the program wants it. */
using StoreText = std::function<void (const std::string& value)>;

/** \brief A positional argument, as an input file. */
struct Argument {
  std::string name;
  /** \brief Its meaning for --help; empty: not listed there. */
  std::string help;
  /** \brief The largest number of values that it takes. */
  std::size_t max_count;
  /** \brief Is called for each value. */
  StoreText store;
};

/** \brief An option of the command line. Its functions complete a declaration:
 * add ("floor-plan FILE", file).help ("...").onceCalled ("plan"). */
struct Option {
  /** \brief Its name without dashes. */
  std::string name;
  /** \brief What stands for the value in --help; empty if the option takes none. */
  std::string placeholder;
  /** \brief Is called with the value; with an empty text if the option takes none. */
  StoreText store;
  /** \brief Its meaning for --help. */
  std::string meaning = {};
  /** \brief Another name that is accepted but not shown in the help; empty for none. */
  std::string old_name = {};
  bool may_be_repeated = false;

  /** \brief Sets \ref meaning. */
  Option&
  help (const std::string& text)
  {
    meaning = text;
    return *this;
  }

  /** \brief Sets \ref old_name. */
  Option&
  onceCalled (const std::string& other_name)
  {
    old_name = other_name;
    return *this;
  }

  /** \brief Lets the option be given several times; each value is stored. */
  Option&
  repeated ()
  {
    may_be_repeated = true;
    return *this;
  }
};

/** \brief Returns the name in the usage of an option, "name" of "name PLACEHOLDER". */
inline std::string
nameOf (const std::string& usage)
{
  return usage.substr (0, usage.find (' '));
}

/** \brief Refuses an empty text, such as an unset shell variable gives.
 * \throws UsageError about \p subject */
void
requireText (const std::string& subject, const std::string& text);

/** \brief Options that --help shows below one title. */
struct OptionGroup {
  std::string title;
  std::vector<Option> options = {};
};

/** \brief The command line of a program: options `--long x`, `--long=x` or PCL's `-long
 * x`, positional arguments, --help and --version. An option may be shortened to any
 * unique start of its name. Declare arguments and options with their targets, then call
 * \ref parse. */
class CommandLine {
public:
  /** \param[in] program its name, followed by the subcommand if there is one */
  CommandLine (const std::string& program,
               const std::string& summary,
               const std::string& version);

  /** \brief Declares an argument that takes one value, which must not be empty. */
  void
  addArgument (const std::string& name, std::string& target, const std::string& help)
  {
    const auto store = [name, &target] (const std::string& text) {
      requireText (name, text);
      target = text;
    };
    arguments_.push_back ({name, help, 1, store});
  }

  /** \brief Declares an argument that takes one or more values, none of them empty. */
  void
  addArguments (const std::string& name,
                std::vector<std::string>& targets,
                const std::string& help)
  {
    addArguments (
        name,
        [name, &targets] (const std::string& text) {
          requireText (name, text);
          targets.push_back (text);
        },
        help);
  }

  /** \brief Declares an argument that takes one or more values.
   * \param[in] store is called with each value, which may be empty; it may throw a
   * UsageError */
  void
  addArguments (const std::string& name,
                const StoreText& store,
                const std::string& help)
  {
    arguments_.push_back ({name, help, std::numeric_limits<std::size_t>::max(), store});
  }

  /** \brief Replaces what --help shows behind "Usage: program": else the names of the
   * arguments.
   * \param[in] ways of calling the program, without its name; each gets a line
   * \param[in] explanation goes below the summary */
  void
  setUsage (const std::vector<std::string>& ways, const std::string& explanation)
  {
    ways_ = ways;
    explanation_ = explanation;
  }

  /** \brief Begins a group, to which the options declared next belong. --help lists
   * only their names; --help-all explains them. */
  void
  beginGroup (const std::string& title);

  /** \brief Declares an option; see \ref Option.
   * \param[in] usage "name PLACEHOLDER", or only "name" where the option has no value
   * \param[in] store may throw a UsageError
   * \return the declared option; valid until the next one is declared */
  Option&
  add (const std::string& usage, const StoreText& store);

  /** \brief Declares an option without a value.
   * \param[out] target becomes true if the option is given */
  Option&
  add (const std::string& usage, bool& target)
  {
    return add (usage, [&target] (const std::string&) { target = true; });
  }

  /** \brief Declares an option that takes any text but an empty one. */
  Option&
  add (const std::string& usage, std::string& target);

  /** \brief Declares an option that takes one of \p choices, which are its placeholder
   * if \p usage has none. */
  Option&
  add (const std::string& usage,
       std::string& target,
       const std::vector<std::string>& choices);

  /** \brief Declares an option that takes a number in a range.
   * \param[out] target a number, or a std::optional of a number */
  template <typename Target>
  Option&
  add (const std::string& usage, Target& target, const Range& range)
  {
    const std::string option = "--" + nameOf (usage);
    return add (usage, [option, range, &target] (const std::string& text) {
      target = parseNumber<typename NumberOf<Target>::type> (option, text, range);
    });
  }

  /** \brief Declares --up, which takes a direction or "camera". */
  template <typename Target>
  Option&
  addUpAxis (Target& target)
  {
    return add ("up x,y,z", [&target] (const std::string& text) {
      target = parseUpAxis ("--up", text);
    });
  }

  /** \brief Stores the values of the command line, those of the options first, or
   * prints the help or the version.
   * \return false if it printed and the program should end
   * \throws UsageError on anything undeclared, missing, ambiguous, given twice or wrong
   */
  bool
  parse (int argc, const char* const* argv);

  /** \brief Whether the command line has the option with this name. */
  bool
  isGiven (const std::string& name) const
  {
    return given_.count (name) > 0;
  }

  /** \brief Returns the names of the given options of the group with this title. */
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

  /** \brief The text of --help, or of --help-all if \p is_full. */
  std::string
  help (bool is_full = false) const;

private:
  /** \brief The type of the number that an option stores: of a std::optional the type
   * of what it may hold. */
  template <typename T>
  struct NumberOf {
    using type = T;
  };
  template <typename T>
  struct NumberOf<std::optional<T>> {
    using type = T;
  };

  /** \brief Returns the part of the help before the options. */
  std::string
  usage () const;

  std::string program_, summary_, version_, explanation_;
  /** \brief The ways of calling the program, as of \ref setUsage; empty: one way,
   * derived from the arguments. */
  std::vector<std::string> ways_;
  std::vector<Argument> arguments_;
  /** \brief The groups in the order of the help; \ref add appends to the last one. */
  std::vector<OptionGroup> groups_;
  /** \brief The names of the options on the command line. */
  std::set<std::string> given_;
};

} // namespace pcl_ops::apps
