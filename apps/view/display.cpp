// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "display.h"

#include <cli/errors.h>
#include <cli/program.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <cstdio>
#include <cstdlib>
#include <string>

namespace pcl_ops::apps {

namespace {

/** \brief Tries to draw, silently. Aborts if VTK finds no display or no driver. */
bool
tryToDraw (bool has_window)
{
  const rlimit no_core{0, 0};
  setrlimit (RLIMIT_CORE, &no_core);
  for (std::FILE* const stream : {stdout, stderr})
    if (std::freopen ("/dev/null", "w", stream) == nullptr)
      return false;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering (has_window ? 0 : 1);
  return window->SupportsOpenGL() != 0;
}

/** \brief As \ref tryToDraw, in a process that may die of it. */
bool
canDraw (bool has_window)
{
  const pid_t child = fork();
  if (child == 0)
    _exit (tryToDraw (has_window) ? ExitCode::done : ExitCode::work_failed);
  int status = 0;
  return child > 0 && waitpid (child, &status, 0) == child && WIFEXITED (status) &&
         WEXITSTATUS (status) == ExitCode::done;
}

} // namespace

void
checkDisplay (bool has_window)
{
#ifndef __APPLE__ // whose windows need no display, and no process may draw
                  // after a fork
  if (canDraw (has_window))
    return;
  const char* const given = std::getenv ("DISPLAY");
  const std::string name = given == nullptr ? "" : given;
  throw WorkError ("DISPLAY",
                   (name.empty() ? "is not set: there is no display"
                                 : name + " cannot be opened or offers no OpenGL 3.2") +
                       "; start the viewer in a graphical session, or without one by "
                       "xvfb-run -a pcl_ops_view CLOUD --screenshot FILE.png");
#else
  static_cast<void> (has_window);
#endif
}

} // namespace pcl_ops::apps
