// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "options.h"

#include "texts.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <detection/method_options.h>
#include <io/output_file.h>

namespace pcl_ops::apps {

namespace {

std::string
summary ()
{
  return "Shows a point cloud with its planes in a window. Lengths are in the unit of "
         "the\ncloud, metres by default; angles in degrees. Keys in the window:\n\n" +
         keysText();
}

Coloring
coloringCalled (const std::string& name)
{
  return name == "planes"         ? Coloring::Planes
         : name == "orientations" ? Coloring::Orientations
                                  : Coloring::Input;
}

/** \brief "1280x960". */
void
storeSize (const std::string& text, ViewOptions& options)
{
  constexpr double smallest = 200;
  constexpr double largest = 8192;
  const Range range = Range::from (smallest).upTo (largest);
  const std::size_t cross = text.find ('x');
  if (cross == std::string::npos)
    throw UsageError ("--size", text + " is no size; give one such as 1280x960");
  options.width = parseNumber<int> ("--size", text.substr (0, cross), range);
  options.height = parseNumber<int> ("--size", text.substr (cross + 1), range);
}

/** \brief What the first view shows; everything but the size can be changed by keys. */
void
declareView (CommandLine& line,
             ViewOptions& options,
             std::string& coloring,
             bool& before)
{
  line.addChoice ("color",
                  {"planes", "orientations", "input"},
                  coloring,
                  "what colours tell (planes)");
  line.addFlag ("hulls", options.state.hulls, "draw the outline of each plane");
  line.addFlag ("edges", options.state.edges, "draw edges and corners where they meet");
  line.addFlag ("normals", options.state.normals, "draw the normal of each plane");
  line.addFlag ("before-merging", before, "show the planes before they are merged");
  line.addText ("screenshot",
                "FILE.png",
                options.screenshot,
                "write the first view to a file and open no window");
  line.addValue ("size",
                 "WxH",
                 "of the window in pixels (1280x960)",
                 [&] (const std::string& text) { storeSize (text, options); });
}

void
checkScreenshot (const std::string& file)
{
  if (file.empty())
    return;
  if (extensionOf (file) != ".png")
    throw UsageError ("--screenshot",
                      file + " has an unknown extension; give a file .png");
  checkWritable (file);
}

} // namespace

bool
readOptions (int argc, const char* const* argv, ViewOptions& options)
{
  std::string coloring = "planes";
  bool before = false;
  CommandLine line ("pcl_ops_view", summary(), PCL_OPS_VERSION);
  line.addArgument (
      "CLOUD", options.input, "the cloud, a .pcd, .ply, .las or text file");
  declareView (line, options, coloring, before);
  declareMethodOptions (line, options.state.run.method, options.detector);
  if (!line.parse (argc, argv))
    return false;
  options.state.run.preset = options.detector.preset;
  options.state.run.merging = !before;
  options.state.coloring = coloringCalled (coloring);
  options.state.help = options.screenshot.empty();
  checkScreenshot (options.screenshot);
  return true;
}

} // namespace pcl_ops::apps
