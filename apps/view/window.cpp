// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "window.h"

#include <pcl/common/angles.h>
#include <pcl/common/centroid.h>
#include <pcl/common/point_tests.h>
#include <pcl/visualization/pcl_visualizer.h>

#include "found_planes.h"
#include "shapes.h"
#include <cli/program.h>
#include <io/output_file.h>
#include <picture/view.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPointPicker.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>

namespace pcl_ops::apps {

namespace {

using pcl::visualization::MouseEvent;
using pcl::visualization::PCLVisualizer;
using ColoredCloud = pcl::PointCloud<pcl::PointXYZRGB>;

constexpr const char* cloud_id = "cloud";

/** \brief A window that shows one state after the other. */
class Window {
public:
  Window (const ViewOptions& options, const ViewedCloud& cloud)
  : options_ (options)
  , cloud_ (cloud)
  , found_ (findPlanes (options.state, options.detector, cloud.coordinates))
  , viewer_ ("pcl_ops_view " + options.input, false)
  , window_ (*viewer_.getRenderWindow())
  , renderer_ (*viewer_.getRendererCollection()->GetFirstRenderer())
  {
    for (std::size_t i = 0; i < cloud.coordinates->size(); ++i)
      if (pcl::isXYZFinite ((*cloud.coordinates)[i]))
        drawn_.push_back (static_cast<pcl::index_t> (i));
    window_.SetMultiSamples (0); // without a graphics card they cost most of the time
    window_.SetOffScreenRendering (options.screenshot.empty() ? 0 : 1);
    viewer_.setSize (options.width, options.height);
    viewer_.setBackgroundColor (1.0, 1.0, 1.0);
    viewer_.setShowFPS (false);
    viewer_.addPointCloud<pcl::PointXYZRGB> (pcl::make_shared<ColoredCloud>(),
                                             cloud_id);
    closeGaps();
    draw();
    resetCamera();
  }

  /** \brief Handles clicks, and keys before PCLVisualizer does, until the user closes
   * the window. */
  void
  run ()
  {
    constexpr float before_others = 1.0f;
    viewer_.createInteractor();
    vtkRenderWindowInteractor& interactor = *window_.GetInteractor();
    for (const auto event : {vtkCommand::KeyPressEvent, vtkCommand::CharEvent})
      interactor.AddObserver (event, this, &Window::onKey, before_others);
    viewer_.registerMouseCallback ([this] (const auto& event) { onMouse (event); });
    viewer_.spin();
  }

  void
  savePicture ()
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
  /** \return whether PCLVisualizer does not get the key */
  bool
  onKey (vtkObject* /*caller*/, unsigned long event, void* /*data*/)
  {
    if (event == vtkCommand::CharEvent) // follows the same press of a key
      return is_own_key_;
    vtkRenderWindowInteractor& interactor = *window_.GetInteractor();
    const std::string key (1, interactor.GetKeyCode());
    const bool has_modifier =
        interactor.GetControlKey() != 0 || interactor.GetAltKey() != 0;
    ViewState next = options_.state;
    is_own_key_ = !has_modifier && (pressKey (key, next) || key == reset_key);
    if (key == reset_key)
      resetCamera();
    if (is_own_key_)
      show (next);
    return is_own_key_;
  }

  /** A click that does not turn the cloud asks for a plane. */
  void
  onMouse (const MouseEvent& event)
  {
    constexpr int still = 3; // [pixel]
    if (event.getButton() != MouseEvent::LeftButton)
      return;
    const Eigen::Vector2i pixel (static_cast<int> (event.getX()),
                                 static_cast<int> (event.getY()));
    if (event.getType() == MouseEvent::MouseButtonPress)
      pressed_at_ = pixel;
    if (event.getType() != MouseEvent::MouseButtonRelease ||
        (pixel - pressed_at_).lpNorm<Eigen::Infinity>() > still)
      return;
    ViewState next = options_.state;
    next.selected = labelAt (pixel);
    show (next);
    if (next.selected != 0)
      std::cout << planeText (found_, next.selected, cloud_.shift) << std::endl;
  }

  std::uint32_t
  labelAt (const Eigen::Vector2i& pixel)
  {
    vtkNew<vtkPointPicker> picker;
    picker->SetTolerance (0.0025); // of the diagonal of the window
    picker->PickFromListOn();
    picker->AddPickList (viewer_.getCloudActorMap()->at (cloud_id).actor);
    picker->Pick (pixel.x(), pixel.y(), 0.0, &renderer_);
    if (picker->GetPointId() < 0)
      return 0;
    const auto point = static_cast<std::size_t> (picker->GetPointId());
    return found_.labels[static_cast<std::size_t> (drawn_[point])];
  }

  /** The window stays as it was where a detector refuses its parameters. */
  void
  show (const ViewState& state)
  {
    try {
      if (!state.hasSamePlanes (options_.state))
        found_ = findPlanes (state, options_.detector, cloud_.coordinates);
      options_.state = state;
      draw();
    }
    catch (const std::exception& error) {
      warn (error.what());
    }
    window_.Render();
  }

  void
  draw ()
  {
    const ViewState& state = options_.state;
    drawPoints();
    drawShapes (viewer_, found_, state);
    viewer_.addText (statusText (options_.input, found_, state, cloud_.shift),
                     12,
                     12,
                     15,
                     0,
                     0,
                     0,
                     "status");
    auto& text =
        dynamic_cast<vtkTextActor&> (*viewer_.getShapeActorMap()->at ("status"));
    text.GetTextProperty()->SetBackgroundColor (1.0, 1.0, 1.0);
    text.GetTextProperty()->SetBackgroundOpacity (0.75);
    text.GetTextProperty()->BoldOff();
  }

  void
  drawPoints ()
  {
    const auto points = pcl::make_shared<ColoredCloud>();
    const std::vector<pcl::RGB> colors =
        pointColors (found_, options_.state, cloud_.colors);
    for (const pcl::index_t index : drawn_) {
      const pcl::PointXYZ& point = (*cloud_.coordinates)[index];
      const pcl::RGB& color = colors[static_cast<std::size_t> (index)];
      points->emplace_back (point.x, point.y, point.z, color.r, color.g, color.b);
    }
    viewer_.updatePointCloud (ColoredCloud::ConstPtr (points), cloud_id);
  }

  /** Gives points a size just large enough to close the gaps between them. */
  void
  closeGaps ()
  {
    constexpr double filled = 1.6;
    const double pixels = static_cast<double> (options_.width) * options_.height;
    const double side =
        std::sqrt (filled * pixels / static_cast<double> (drawn_.size()));
    viewer_.setPointCloudRenderingProperties (
        pcl::visualization::PCL_VISUALIZER_POINT_SIZE,
        std::round (std::clamp (side, 2.0, 6.0)),
        cloud_id);
  }

  /** Looks at the cloud as its picture does (\ref chooseView). */
  void
  resetCamera ()
  {
    const View view = chooseView (
        *cloud_.coordinates, found_.planes, found_.up, options_.width, options_.height);
    const Eigen::Vector2f middle (0.5f * static_cast<float> (options_.width),
                                  0.5f * static_cast<float> (options_.height));
    // The axis of the picture need not go through its middle; that of a window does.
    const Eigen::Vector2f aside = (middle - view.center) / view.focal;
    const Eigen::Vector3d ray =
        (view.axes.transpose() * aside.homogeneous()).cast<double>();
    Eigen::Vector4f centroid;
    pcl::compute3DCentroid (*cloud_.coordinates, centroid);
    const float depth = view.axes.row (2).dot (centroid.head<3>() - view.eye);
    const Eigen::Vector3d eye = view.eye.cast<double>();
    // What the mouse turns the cloud around.
    const Eigen::Vector3d target = eye + (depth > 0.0f ? depth : 1.0) * ray;
    const Eigen::Vector3d up = -view.axes.row (1).transpose().cast<double>();
    const double angle = 2.0 * std::atan2 (middle.y(), view.focal);
    vtkCamera& camera = *renderer_.GetActiveCamera();
    camera.SetParallelProjection (0);
    camera.SetPosition (eye.data());
    camera.SetFocalPoint (target.data());
    camera.SetViewUp (up.data());
    camera.SetViewAngle (pcl::rad2deg (angle));
    camera.SetParallelScale (camera.GetDistance() * std::tan (0.5 * angle));
    renderer_.ResetCameraClippingRange();
  }

  /** With the state that is shown. */
  ViewOptions options_;
  const ViewedCloud& cloud_;
  FoundPlanes found_;
  /** The points with coordinates: VTK would stumble over the others. */
  pcl::Indices drawn_;
  PCLVisualizer viewer_;
  vtkRenderWindow& window_;
  vtkRenderer& renderer_;
  bool is_own_key_ = false;
  Eigen::Vector2i pressed_at_ = Eigen::Vector2i::Zero();
};

} // namespace

void
showCloud (const ViewOptions& options, const ViewedCloud& cloud)
{
  Window window (options, cloud);
  if (options.screenshot.empty())
    window.run();
  else
    window.savePicture();
}

} // namespace pcl_ops::apps
