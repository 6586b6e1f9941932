// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <exception>

namespace pcl_ops::python {

/** \brief Lets other threads of Python run during some work that does not touch it.
 *
 * Not pybind11's gil_scoped_release: where Python ends meanwhile, PyEval_RestoreThread
 * ends the thread by unwinding it, and from a destructor that would end the program. */
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
  PyEval_RestoreThread (state);
  if (problem)
    std::rethrow_exception (problem);
}

} // namespace pcl_ops::python
