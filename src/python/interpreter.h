// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <thread>

namespace pcl_ops::python {

/** \brief Does work without the GIL, so that other threads of Python run meanwhile. The
 * work must not use Python's objects.
 *
 * If Python ends meanwhile, PyEval_RestoreThread unwinds the thread to end it. Then
 * destructors in the callers would release Python's objects without the GIL.
 * So the thread sleeps until the process has ended. */
template <typename Work>
void
whileOthersRun (const Work& work)
{
  PyThreadState* const state = PyEval_SaveThread();
  std::exception_ptr problem;
  try {
    work();
  }
  catch (...) {
    problem = std::current_exception();
  }
  try {
    PyEval_RestoreThread (state);
  }
  catch (...) {
    while (true)
      std::this_thread::sleep_for (std::chrono::hours (1));
  }
  if (problem)
    std::rethrow_exception (problem);
}

} // namespace pcl_ops::python
