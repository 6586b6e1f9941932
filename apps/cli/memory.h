// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "errors.h"

#include <new>
#include <stdexcept>
#include <string>

namespace pcl_ops::apps {

/** \brief Calls \p work and returns what it returns.
 * \param[in] subject what the memory is needed for: an option or file
 * \param[in] fix what to do where there is too little
 * \throws WorkError of these where it runs out, and whatever else \p work throws */
template <typename Work>
auto
inMemory (const std::string& subject, const std::string& fix, Work&& work)
{
  try {
    return work();
  }
  catch (const std::bad_alloc&) {
    throw WorkError (subject, "needs more memory than there is; " + fix);
  }
  catch (const std::length_error&) {
    throw WorkError (subject, "needs more memory than there can be; " + fix);
  }
}

} // namespace pcl_ops::apps
