// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/colors.h>
#include <pcl/common/point_tests.h>
#include <pcl/conversions.h>

#include "window.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <detection/method_options.h>
#include <io/cloud_fields.h>
#include <io/cloud_file.h>
#include <io/output_file.h>
#include <io/shifted_cloud.h>
#include <numbers/quantile.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace pcl_ops::apps {

namespace {

/** \brief "1280x960". */
void
storeSize (const std::string& text, ViewOptions& options)
{
  const Range range = Range::from (200).upTo (8192);
  const std::size_t cross = text.find ('x');
  if (cross == std::string::npos)
    throw UsageError ("--size", text + " is no size; give one such as 1280x960");
  options.width = parseNumber<int> ("--size", text.substr (0, cross), range);
  options.height = parseNumber<int> ("--size", text.substr (cross + 1), range);
}

void
checkScreenshot (const std::string& file)
{
  if (extensionOf (file) != ".png")
    throw UsageError ("--screenshot",
                      file + " has an unknown extension; give a file .png");
  checkWritable (file);
}

/** \return false if --help or --version was answered and nothing is left to do */
bool
readOptions (int argc, const char* const* argv, ViewOptions& options)
{
  const std::string summary =
      "Shows a point cloud with its planes in a window. Lengths are in the unit of "
      "the\ncloud, meters by default; angles in degrees. Keys in the window:\n\n" +
      keysText();
  ViewState& state = options.state;
  bool before = false;
  CommandLine line ("pcl_ops_view", summary, PCL_OPS_VERSION);
  line.addArgument (
      "CLOUD", options.input, "the cloud, a .pcd, .ply, .las or text file");
  line.addChoice ("color",
                  {"planes", "orientations", "input"},
                  state.coloring,
                  "what the colors show (planes)");
  line.addFlag ("hulls", state.hulls, "draw the outline of each plane");
  line.addFlag ("edges", state.edges, "draw edges and corners where they meet");
  line.addFlag ("normals", state.normals, "draw the normal of each plane");
  line.addFlag ("before-merging", before, "show the planes before they are merged");
  line.addText ("screenshot",
                "FILE.png",
                options.screenshot,
                "write the first view to a file and open no window");
  line.addValue ("size",
                 "WxH",
                 "of the window in pixels (1280x960)",
                 [&] (const std::string& text) { storeSize (text, options); });
  declareMethodOptions (line, state.method, options.detector);
  if (!line.parse (argc, argv))
    return false;
  state.preset = options.detector.preset;
  state.merging = !before;
  state.help = options.screenshot.empty();
  if (!options.screenshot.empty())
    checkScreenshot (options.screenshot);
  return true;
}

/** \brief The colors of the file; where it has none, the height from blue to yellow. */
std::vector<pcl::RGB>
inputColors (const FileCloud& file, const ViewedCloud& cloud)
{
  pcl::PointCloud<pcl::RGB> in_file;
  if (hasField (file, "rgb") || hasField (file, "rgba"))
    pcl::fromPCLPointCloud2 (file.points, in_file);
  if (!in_file.empty())
    return {in_file.begin(), in_file.end()};
  std::vector<float> heights;
  for (const pcl::index_t index : cloud.finite)
    heights.push_back ((*cloud.coordinates)[index].z);
  const float low = quantile (heights, 0.01); // outliers would leave one color to all
  const float high = quantile (heights, 0.99);
  constexpr float last = 255.0f; // of the table
  std::vector<pcl::RGB> colors (cloud.coordinates->size());
  for (const pcl::index_t index : cloud.finite) {
    const float share = ((*cloud.coordinates)[index].z - low) / (high - low);
    const float clamped = share > 0.0f ? std::min (share, 1.0f) : 0.0f; // 0 for NaN
    colors[static_cast<std::size_t> (index)] =
        pcl::ViridisLUT::at (static_cast<std::size_t> (last * clamped));
  }
  return colors;
}

/** \brief Whether VTK finds a display and a driver: where it does not, it aborts, so a
 * child process tries, silently. */
bool
canDraw ()
{
#ifdef __APPLE__ // whose windows need no X11 display, and no child may draw
  return true;
#else
  const pid_t child = fork();
  if (child == 0) {
    const rlimit no_core{0, 0};
    setrlimit (RLIMIT_CORE, &no_core);
    if (std::freopen ("/dev/null", "w", stderr) == nullptr)
      _exit (ExitCode::work_failed);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering (1);
    _exit (window->SupportsOpenGL() != 0 ? ExitCode::done : ExitCode::work_failed);
  }
  int status = 0;
  return child > 0 && waitpid (child, &status, 0) == child && WIFEXITED (status) &&
         WEXITSTATUS (status) == ExitCode::done;
#endif
}

/** \throws WorkError where nothing can be drawn */
void
checkDisplay ()
{
  if (canDraw())
    return;
  const char* const display = std::getenv ("DISPLAY");
  throw WorkError ("DISPLAY",
                   (display == nullptr ? std::string ("is not set")
                                       : display + std::string (" cannot be opened or "
                                                                "offers no OpenGL")) +
                       "; start the viewer in a graphical session, or without one by "
                       "xvfb-run -a pcl_ops_view CLOUD --screenshot FILE.png");
}

/** \throws WorkError for a cloud that has nothing to show */
ViewedCloud
loadViewed (const std::string& file)
{
  const FileCloud cloud = loadCloud (file);
  const ShiftedCloud shifted = shiftedCloudOf (cloud);
  const std::string damage = damageOf (shifted);
  if (!damage.empty())
    warn (file + ": " + damage);
  ViewedCloud viewed{shifted.cloud, shifted.shift, {}, {}};
  for (std::size_t i = 0; i < shifted.cloud->size(); ++i)
    if (pcl::isXYZFinite ((*shifted.cloud)[i]))
      viewed.finite.push_back (static_cast<pcl::index_t> (i));
  if (viewed.finite.empty())
    throw WorkError (file,
                     "has no point with finite coordinates, so there is nothing to "
                     "show; give another cloud");
  viewed.colors = inputColors (cloud, viewed);
  return viewed;
}

int
view (int argc, const char* const* argv)
{
  ViewOptions options;
  if (readOptions (argc, argv, options))
    inMemory (options.input, "give a smaller cloud", [&] {
      const ViewedCloud cloud = loadViewed (options.input);
      checkDisplay();
      showCloud (options, cloud);
    });
  return ExitCode::done;
}

} // namespace

} // namespace pcl_ops::apps

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  return runProgram ("pcl_ops_view", [&] { return view (argc, argv); });
}
