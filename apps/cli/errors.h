// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <utility>

namespace pcl_ops::apps {

/** \brief An error that ends a program. Its message is "SUBJECT: what is wrong; what to
 * do", where the subject is an option or a file. */
struct ProgramError : std::runtime_error {
  ProgramError (const std::string& subject, std::string what_and_fix)
  : std::runtime_error (subject + ": " + what_and_fix)
  , problem (std::move (what_and_fix))
  {}
  /** \brief The message without the subject. */
  std::string problem;
};

/** \brief The program was called wrongly: exit code 2. */
struct UsageError : ProgramError {
  using ProgramError::ProgramError;
};

/** \brief The call was right, but the program could not do its work: exit code 1. */
struct WorkError : ProgramError {
  using ProgramError::ProgramError;
};

/** \brief An output could not be written. Work on further inputs is useless then, as
 * their outputs would most likely fail, too. */
struct OutputError : WorkError {
  using WorkError::WorkError;
};

/** \brief Calls \p work, which may run out of memory, and returns its result.
 * \throws WorkError about \p subject, with \p fix, if memory runs out, and whatever
 * else \p work throws */
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
