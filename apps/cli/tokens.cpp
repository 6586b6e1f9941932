// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "tokens.h"

#include <boost/program_options/errors.hpp>
#include <boost/program_options/positional_options.hpp>

#include "errors.h"

#include <algorithm>
#include <cctype>

namespace po = boost::program_options;

namespace pcl_ops::apps {

namespace {

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
readTokens (const std::vector<std::string>& tokens,
            const po::options_description& options)
{
  namespace style = po::command_line_style;
  po::positional_options_description positional;
  positional.add (positional_arguments, -1);
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

std::string
dashed (const std::string& name)
{
  return "--" + name.substr (std::min (name.find_first_not_of ('-'), name.size()));
}

po::parsed_options
parseTokens (const std::vector<std::string>& tokens,
             const po::options_description& options)
{
  po::parsed_options parsed = readTokens (tokens, options);
  refuseOptionsAsValues (parsed);
  return parsed;
}

} // namespace pcl_ops::apps
