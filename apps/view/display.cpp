// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "display.h"

#include <common/program.h>

#include <cstdlib>
#include <string>

#ifdef PCL_OPS_VIEW_ON_X11
// Last: its macros, such as None and Bool, go on for the rest of the file.
#include <X11/Xlib.h>
#endif

namespace pcl_ops::apps {

#ifdef PCL_OPS_VIEW_ON_X11

void
checkDisplay ()
{
  constexpr const char* kMend =
      "; start it in a graphical session, or without one by xvfb-run -a pcl_ops_view "
      "CLOUD --screenshot FILE.png";
  const char* const given = std::getenv ("DISPLAY");
  const std::string name = given == nullptr ? "" : given;
  if (name.empty())
    throw WorkError ("DISPLAY",
                     std::string ("is not set, there is no display") + kMend);
  Display* const display = XOpenDisplay (name.c_str());
  if (display == nullptr)
    throw WorkError ("DISPLAY", "the display " + name + " cannot be opened" + kMend);
  int opcode = 0;
  int event = 0;
  int error = 0;
  const bool can_draw = XQueryExtension (display, "GLX", &opcode, &event, &error) != 0;
  XCloseDisplay (display);
  if (!can_draw)
    throw WorkError ("DISPLAY",
                     "the display " + name + " has no OpenGL (GLX extension)" + kMend);
}

#else

void
checkDisplay ()
{}

#endif

} // namespace pcl_ops::apps
