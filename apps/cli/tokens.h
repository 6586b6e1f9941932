// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>

#include <string>
#include <vector>

namespace pcl_ops::apps {

/** \brief The name under which Boost stores arguments that belong to no option. */
constexpr const char* positional_arguments = "positional arguments";

/** \brief The name of an option with two dashes, however it was written. */
std::string
dashed (const std::string& name);

/** \brief Takes apart what follows a program's name: `--long x`, `--long=x` and PCL's
 * single dash `-long x`.
 * \throws UsageError on options that are undeclared, ambiguous or lack their value */
boost::program_options::parsed_options
parseTokens (const std::vector<std::string>& tokens,
             const boost::program_options::options_description& options);

} // namespace pcl_ops::apps
