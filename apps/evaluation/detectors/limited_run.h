// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "detectors.h"

#include <optional>

namespace pcl_ops::evaluation {

/** \brief Memory that a process has in common with its children. */
class SharedMemory {
public:
  /** \throw std::bad_alloc if there is not so much */
  explicit SharedMemory (std::size_t bytes);
  SharedMemory (const SharedMemory&) = delete;
  SharedMemory&
  operator= (const SharedMemory&) = delete;
  ~SharedMemory();

  void*
  begin () const
  {
    return begin_;
  }

private:
  std::size_t bytes_;
  void* begin_;
};

/** \brief Does something in a process of its own, of which nothing stays but what it
 * writes to shared memory.
 * \param[in] seconds of wall time, after which it is ended; 0: none
 * \return false if that was reached
 * \throw std::runtime_error if it fails, however it does */
bool
runInChild (const std::function<void()>& work, unsigned seconds);

/** \brief Runs a detector in a process of its own.
 * \param[in] seconds, and errors, as of \ref runInChild
 * \return nothing if it takes longer */
std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds);

} // namespace pcl_ops::evaluation
