// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace pcl_ops::apps {

/** \brief Calls \p work with 0, 1, ... \p count - 1, begun in this order, several at a
 * time. What it throws ends the run once the calls under way have returned, and is
 * thrown again.
 * \param[in] jobs calls at a time; 0: as many as there are processors; fewer where the
 * system starts no more threads */
void
runInParallel (std::size_t count,
               unsigned jobs,
               const std::function<void (std::size_t)>& work);

} // namespace pcl_ops::apps
