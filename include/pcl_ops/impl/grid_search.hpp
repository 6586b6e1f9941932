// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/grid_search.h>

// Compiles GridSearch for the point type T, as PCL_INSTANTIATE asks for. The template
// itself is wholly in the header above.
#define PCL_INSTANTIATE_GridSearch(T)                                                  \
  template class PCL_OPS_EXPORT pcl_ops::GridSearch<T>;
