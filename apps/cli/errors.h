// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace pcl_ops::apps {

/** \brief What a program ends with where it cannot go on. Its text reads "subject: what
 * is wrong; what to do", where the subject is the option or file it is about. */
struct ProgramError : std::runtime_error {
  ProgramError (const std::string& subject, std::string what_and_fix)
  : std::runtime_error (subject + ": " + what_and_fix)
  , problem (std::move (what_and_fix))
  {}
  /** \brief The text without its subject. */
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

} // namespace pcl_ops::apps
