// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl/common/angles.h>
#include <pcl/common/centroid.h>
#include <pcl/common/point_tests.h>
#include <pcl/visualization/pcl_visualizer.h>

#include "found_planes.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <detection/known_sensor.h>
#include <detection/plane_list.h>
#include <io/output_file.h>
#include <page/plane_page.h>
#include <picture/view.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersionMacros.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>

namespace pcl_ops::apps {

namespace {

using ColoredCloud = pcl::PointCloud<pcl::PointXYZRGB>;

/** \brief Size of the window [pixel], chosen by hand. */
constexpr int width = 1280, height = 960;

struct ViewOptions {
  std::string input;
  /** \brief File of a picture to make in place of a window; empty for none. */
  std::string screenshot;
  /** \brief File of a page to make in place of a window; empty for none. */
  std::string page;
  /** \brief The length of a meter in the unit of the cloud. */
  double meter = 1.0;
  ViewState state;
};

/** \brief Reads the command line and checks it, without reading the cloud.
 * \return false if --help or --version was answered, and the program should end
 * \throws UsageError, or WorkError if an output cannot be written */
bool
readOptions (int argc, const char* const* argv, ViewOptions& options)
{
  const std::string summary =
      "Shows a point cloud with its planes in a window. Lengths are in the unit of "
      "the\ncloud, meters by default; angles in degrees. Keys in the window:\n\n";
  ViewState& state = options.state;
  CommandLine line ("pcl_ops_view", summary + list_of_keys, PCL_OPS_VERSION);
  line.addArgument (
      "CLOUD", options.input, "the cloud, a .pcd, .ply, .las or text file");
  line.add ("color", state.coloring, {"planes", "orientations"})
      .help ("what the colors show (planes)");
  line.add ("screenshot FILE.png", options.screenshot)
      .help ("write the first view to a file and open no window");
  line.add ("view FILE.html", options.page)
      .help ("write a page to look at them in a browser, and open no window");
  declareMeter (line, options.meter);
  declareMethodOptions (line, state.method, state.detector);
  if (!line.parse (argc, argv))
    return false;
  state.shows_keys = options.screenshot.empty();
  checkExtension ("--screenshot", options.screenshot, {".png"});
  checkExtension ("--view", options.page, {".html"});
  if (!options.screenshot.empty() && !options.page.empty())
    throw UsageError ("--view", "opens no window to take --screenshot of; keep one");
  for (const std::string& output : {options.screenshot, options.page})
    if (!output.empty())
      checkWritable (output);
  return true;
}

/** \brief Whether this window can be shown. Without a display, VTK 9.4 and later make a
 * window that draws into memory (EGL, OSMesa), with which PCL crashes. */
bool
canShow (vtkRenderWindow& window)
{
#if VTK_MAJOR_VERSION > 9 || (VTK_MAJOR_VERSION == 9 && VTK_MINOR_VERSION >= 4)
  const std::string kind = window.GetClassName();
  if (kind.find ("EGL") != std::string::npos ||
      kind.find ("OSOpenGL") != std::string::npos)
    return false;
#endif
  return window.SupportsOpenGL() != 0;
}

/** \brief Checks that a window can be shown: in a child process that prints nothing, as
 * VTK aborts the process if it finds no display or driver.
 * \throws WorkError if no window can be shown */
void
checkDisplay ()
{
#ifndef __APPLE__ // macOS needs no X11 display, and a child process may not draw
  const pid_t child = fork();
  if (child == 0) {
    const rlimit no_core{0, 0};
    setrlimit (RLIMIT_CORE, &no_core);
    if (std::freopen ("/dev/null", "w", stderr) == nullptr)
      _exit (ExitCode::work_failed);
    vtkNew<vtkRenderWindow> window;
    window->SetOffScreenRendering (1);
    _exit (canShow (*window) ? ExitCode::done : ExitCode::work_failed);
  }
  int status = 0;
  if (child > 0 && waitpid (child, &status, 0) == child && WIFEXITED (status) &&
      WEXITSTATUS (status) == ExitCode::done)
    return;
  const char* const display = std::getenv ("DISPLAY");
  throw WorkError ("DISPLAY",
                   (display == nullptr ? std::string ("is not set")
                                       : display + std::string (" cannot be opened or "
                                                                "offers no OpenGL")) +
                       "; start the viewer in a graphical session, or without one by "
                       "xvfb-run -a pcl_ops_view CLOUD --screenshot FILE.png");
#endif
}

/** \brief The window of the viewer; with --screenshot it is not shown, but drawn into
 * memory. */
class Window {
public:
  /** \param[in] finite indices of the points with finite coordinates, as VTK draws no
   * others */
  Window (const ViewOptions& options, const ShiftedCloud& shifted, pcl::Indices finite)
  : options_ (options)
  , shift_ (shifted.shift)
  , finite_ (std::move (finite))
  , found_ (findPlanes (options.state, shifted.cloud))
  , viewer_ ("pcl_ops_view " + options.input, false)
  , window_ (*viewer_.getRenderWindow())
  {
    window_.SetMultiSamples (0); // antialiasing is slow without a graphics card
    window_.SetOffScreenRendering (options.screenshot.empty() ? 0 : 1);
    viewer_.setSize (width, height);
    viewer_.setBackgroundColor (1.0, 1.0, 1.0);
    viewer_.setShowFPS (false);
    constexpr double point_size = 3.0; // [pixel]
    viewer_.addPointCloud<pcl::PointXYZRGB> (pcl::make_shared<ColoredCloud>());
    viewer_.setPointCloudRenderingProperties (
        pcl::visualization::PCL_VISUALIZER_POINT_SIZE, point_size, "cloud");
    draw();
    resetCamera();
  }

  /** \brief Shows the window until the user closes it. Handles keys before
   * PCLVisualizer does. */
  void
  run ()
  {
    constexpr float before_others = 1.0f; // priority; that of PCLVisualizer is 0
    viewer_.createInteractor();
    for (const auto event : {vtkCommand::KeyPressEvent, vtkCommand::CharEvent})
      window_.GetInteractor()->AddObserver (event, this, &Window::onKey, before_others);
    viewer_.registerPointPickingCallback ([this] (const auto& event) {
      ViewState next = options_.state;
      const int point = event.getPointIndex();
      next.selected = point < 0 ? 0 : found_.labels[finite_[point]];
      show (next);
      if (next.selected != 0)
        std::cout << planeText (found_, next, shift_) << std::endl;
    });
    viewer_.spin();
  }

  /** \brief Writes the first view as a PNG. */
  void
  saveScreenshot ()
  {
    window_.Render();
    vtkNew<vtkWindowToImageFilter> image;
    image->SetInput (&window_);
    image->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection (image->GetOutputPort());
    writer->WriteToMemoryOn();
    writer->Write();
    vtkUnsignedCharArray* const png = writer->GetResult();
    writeFile (options_.screenshot, [&] (std::ostream& stream) {
      stream.write (reinterpret_cast<const char*> (png->GetPointer (0)),
                    png->GetNumberOfValues());
    });
  }

private:
  /** \return true for a key of the viewer, which PCLVisualizer then does not get */
  bool
  onKey (vtkObject* /*caller*/, unsigned long event, void* /*data*/)
  {
    if (event == vtkCommand::CharEvent) // follows the KeyPressEvent of the same key
      return is_own_key_;
    vtkRenderWindowInteractor& interactor = *window_.GetInteractor();
    const char key = interactor.GetKeyCode();
    ViewState next = options_.state;
    const bool has_modifier =
        interactor.GetControlKey() != 0 || interactor.GetAltKey() != 0;
    is_own_key_ = !has_modifier && (key == 'r' || pressKey (key, next));
    if (key == 'r' && is_own_key_)
      resetCamera();
    if (is_own_key_)
      show (next);
    return is_own_key_;
  }

  /** \brief Shows a state, and finds planes again if its method or preset is another
   * one. Keeps the old state if a detector refuses its parameters. */
  void
  show (const ViewState& state)
  {
    try {
      if (state.method != options_.state.method ||
          state.detector.preset != options_.state.detector.preset)
        found_ = findPlanes (state, found_.cloud);
      options_.state = state;
      draw();
    }
    catch (const std::exception& error) {
      warn (error.what());
    }
    window_.Render();
  }

  /** \brief Colors the points, and writes the text, for the current state. */
  void
  draw ()
  {
    const auto points = pcl::make_shared<ColoredCloud>();
    for (std::size_t i = 0; i < finite_.size(); ++i) {
      const pcl::PointXYZ& point = (*found_.cloud)[finite_[i]];
      const pcl::RGB color = colorOfPoint (found_, options_.state, finite_[i]);
      points->emplace_back (point.x, point.y, point.z, color.r, color.g, color.b);
    }
    viewer_.updatePointCloud (ColoredCloud::ConstPtr (points));
    viewer_.removeAllShapes();
    constexpr int margin = 12, letter_height = 15; // [pixel]
    const std::string text = statusText (found_, options_.state, shift_);
    viewer_.addText (text, margin, margin, letter_height, 0.0, 0.0, 0.0); // black
  }

  /** \brief Sets the camera to the view of \ref chooseView, as in pictures. */
  void
  resetCamera ()
  {
    const View view = chooseView (
        *found_.cloud, found_.detected.planes, found_.detected.up, width, height);
    Eigen::Vector4d centroid = Eigen::Vector4d::Zero();
    pcl::compute3DCentroid (*found_.cloud, centroid);
    const Eigen::Vector3d eye = view.eye.cast<double>();
    const Eigen::Vector3d down = view.axes.row (1).cast<double>();
    const Eigen::Vector3d ahead = view.axes.row (2).cast<double>();
    const double depth = ahead.dot (centroid.head<3>() - eye);
    // The position around which the mouse turns the cloud: at the depth of the
    // centroid.
    const Eigen::Vector3d target = eye + (depth > 0.0 ? depth : 1.0) * ahead;
    const double vertical_field_of_view = 2.0 * std::atan (0.5 * height / view.focal);
    vtkRenderer& renderer = *viewer_.getRendererCollection()->GetFirstRenderer();
    vtkCamera& camera = *renderer.GetActiveCamera();
    camera.SetPosition (eye.data());
    camera.SetFocalPoint (target.data());
    camera.SetViewUp (-down.x(), -down.y(), -down.z());
    camera.SetWindowCenter (1.0 - 2.0 * view.center.x() / width,
                            2.0 * view.center.y() / height - 1.0);
    camera.SetViewAngle (pcl::rad2deg (vertical_field_of_view));
    renderer.ResetCameraClippingRange();
  }

  /** \brief Options, with the state that is shown now. */
  ViewOptions options_;
  /** \brief Origin of the frame of the planes in the frame of the file. */
  Eigen::Vector3d shift_;
  /** \brief Indices of the points with finite coordinates: those of the shown points.
   */
  pcl::Indices finite_;
  FoundPlanes found_;
  pcl::visualization::PCLVisualizer viewer_;
  vtkRenderWindow& window_;
  /** \brief Whether the key that was pressed last is one of the viewer. Each key has
   * two events: the first sets this, the second reads it. */
  bool is_own_key_ = false;
};

/** \brief Writes the page of --view.
 * \param[in] sensor position of the sensor in the frame of the file, if it is known */
void
savePage (const ViewOptions& options,
          const ShiftedCloud& shifted,
          const std::optional<Eigen::Vector3d>& sensor)
{
  const FoundPlanes found = findPlanes (options.state, shifted.cloud);
  std::vector<PlaneSegment> planes = found.detected.planes;
  std::vector<PlaneExtent> extents;
  std::vector<std::uint32_t> ids;
  for (PlaneSegment& plane : planes) {
    // Points on the plane in two dimensions, which are the same in the frame of the
    // cloud and, after moveBy, in that of the file.
    const PlanarPoints points = pointsOnPlane (
        *shifted.cloud, plane, PlaneFrame (plane.centroid, plane.normal));
    plane.moveBy (shifted.shift);
    extents.push_back (extentOf (
        {convexHull (points)}, points, PlaneFrame (plane.centroid, plane.normal)));
    ids.push_back (static_cast<std::uint32_t> (ids.size() + 1));
  }
  const std::string title = std::filesystem::path (options.input).filename().string();
  const Eigen::Vector3f& up = found.detected.up;
  const std::vector<PlaneKind> kinds =
      planeKinds (planes, extents, up.cast<double>(), options.meter, sensor);
  savePlanePage (
      options.page,
      {title, shifted, planes, planeObjects (planes, extents, kinds, ids, up), up});
}

/** \brief Shows the window, or writes the page or the screenshot. */
void
view (const ViewOptions& options)
{
  std::optional<FileCloud> cloud = loadCloud (options.input);
  const ShiftedCloud shifted = shiftedCloudOf (*cloud);
  if (const std::string damage = damageOf (shifted); !damage.empty())
    warn (options.input + ": " + damage);
  pcl::Indices finite;
  for (std::size_t i = 0; i < shifted.cloud->size(); ++i)
    if (pcl::isXYZFinite ((*shifted.cloud)[i]))
      finite.push_back (i);
  if (finite.empty())
    throw WorkError (options.input,
                     "has no point with finite coordinates, so there is nothing to "
                     "show; give another cloud");
  if (!options.page.empty())
    return savePage (options, shifted, knownSensor (*cloud, shifted));
  cloud.reset();
  checkDisplay();
  Window window (options, shifted, std::move (finite));
  options.screenshot.empty() ? window.run() : window.saveScreenshot();
}

} // namespace

} // namespace pcl_ops::apps

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  return runProgram ("pcl_ops_view", [&] {
    ViewOptions options;
    if (readOptions (argc, argv, options))
      inMemory (options.input, "give a smaller cloud", [&options] { view (options); });
    return ExitCode::done;
  });
}
