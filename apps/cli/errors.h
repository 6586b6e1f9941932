// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace pcl_ops::apps {

/** \brief What a program ends with where it cannot go on: "option or file: what is
 * wrong; what to do". */
struct ProgramError : std::runtime_error {
  ProgramError (const std::string& subject, std::string what_and_fix)
  : std::runtime_error (subject + ": " + what_and_fix)
  , problem (std::move (what_and_fix))
  {}
  std::string problem;
};

/** \brief The program was called wrongly: exit code 2. */
struct UsageError : ProgramError {
  using ProgramError::ProgramError;
};

/** \brief The program was called rightly but could not do its work: exit code 1. */
struct WorkError : ProgramError {
  using ProgramError::ProgramError;
};

/** \brief An output could not be written: there is no use in going on with others. */
struct OutputError : WorkError {
  using WorkError::WorkError;
};

/** \brief What \p work returns.
 * \throws WorkError with this fix where the memory runs out */
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
