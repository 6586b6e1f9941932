// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <thread>

namespace pcl_ops::python {

/** \brief Calls \p work without Python's global lock (GIL), so that other threads of
 * Python run meanwhile. \p work must not use Python's objects.
 *
 * If Python ends meanwhile, PyEval_RestoreThread unwinds the stack to end the thread.
 * Destructors in the callers would then release Python's objects without the GIL. To
 * prevent this, the thread sleeps until the process has ended. */
template <typename Work>
void
whileOthersRun (const Work& work)
{
  PyThreadState* const state = PyEval_SaveThread();
  std::exception_ptr exception;
  try {
    work();
  }
  catch (...) {
    exception = std::current_exception();
  }
  try {
    PyEval_RestoreThread (state);
  }
  catch (...) {
    while (true)
      std::this_thread::sleep_for (std::chrono::hours (1));
  }
  if (exception)
    std::rethrow_exception (exception);
}

/** \brief Raises an exception of Python.
 * \param[in] text may have the name of a file, which need not be UTF-8 */
[[noreturn]] inline void
raise (PyObject* exception, const char* text)
{
  if (PyObject* const message = PyUnicode_DecodeFSDefault (text)) {
    PyErr_SetObject (exception, message);
    Py_DECREF (message);
  }
  throw pybind11::error_already_set();
}

} // namespace pcl_ops::python
