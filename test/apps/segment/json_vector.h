// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include <nlohmann/json.hpp>

inline Eigen::Vector3d
toVector (const nlohmann::json& array)
{
  return {array[0].get<double>(), array[1].get<double>(), array[2].get<double>()};
}
