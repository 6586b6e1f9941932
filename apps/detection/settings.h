// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace pcl_ops::apps {

/** \brief Nothing, where a value is not known, or what a parameter is set to. */
using SettingValue = std::variant<std::monostate,
                                  bool,
                                  std::int64_t,
                                  double,
                                  std::string,
                                  std::vector<double>>;

/** \brief What a detector was run with, in the order of a report. */
using Settings = std::vector<std::pair<std::string, SettingValue>>;

} // namespace pcl_ops::apps
