// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "program.h"

#include <pcl/console/print.h>

#include "errors.h"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <new>

namespace pcl_ops::apps {

namespace {

std::string&
runningProgram ()
{
  static std::string name;
  return name;
}

int
fail (const std::string& message, ExitCode code)
{
  std::cout.flush();
  warn (message);
  return code;
}

} // namespace

std::string
errorLine (std::string message)
{
  std::replace (message.begin(), message.end(), '\n', ' ');
  return runningProgram() + ": " + message;
}

void
warn (const std::string& message)
{
  std::cerr << errorLine (message) + "\n" << std::flush;
}

int
runProgram (const std::string& name, const std::function<int()>& body)
{
  runningProgram() = name;
  std::signal (SIGXFSZ, SIG_IGN);
  pcl::console::setVerbosityLevel (pcl::console::L_ALWAYS);
  try {
    const int code = body();
    if (!std::cout.flush())
      throw WorkError ("standard output", "cannot be written; is its disk full?");
    return code;
  }
  catch (const UsageError& error) {
    return fail (error.what(), ExitCode::wrong_usage);
  }
  catch (const std::bad_alloc&) {
    return fail ("not enough memory; try a smaller cloud", ExitCode::work_failed);
  }
  catch (const std::exception& error) {
    const std::string reason = error.what();
    // What libstdc++ says where a locale of the user's finds no room, or does not
    // exist.
    const bool is_about_language =
        reason.find ("_S_create_c_locale") != std::string::npos;
    return fail (is_about_language ? "LANG cannot be set up: not enough memory, or it "
                                     "is none; try a smaller cloud or LANG=C"
                                   : reason,
                 ExitCode::work_failed);
  }
}

} // namespace pcl_ops::apps
