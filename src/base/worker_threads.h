// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <functional>

namespace pcl_ops::internal {

/** \brief How many threads can run at the same time. */
std::size_t
availableProcessors ();

/** \brief Has a task called by up to so many other threads, each when it has time:
 * after this has returned, and perhaps never. The threads are started when first
 * needed, fewer where the system starts no more, and sleep in between. \param[in]
 * number of calls \param[in] task called concurrently; must not throw */
void
callOnWorkers (std::size_t number, const std::function<void()>& task);

} // namespace pcl_ops::internal
