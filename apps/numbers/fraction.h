// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace pcl_ops::apps {

/** \brief part / whole, or \p of_nothing where the whole is 0. */
inline double
fraction (std::size_t part, std::size_t whole, double of_nothing)
{
  return whole == 0 ? of_nothing
                    : static_cast<double> (part) / static_cast<double> (whole);
}

} // namespace pcl_ops::apps
