// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "window.h"

#include <pcl/common/angles.h>
#include <pcl/common/centroid.h>
#include <pcl/common/common.h>
#include <pcl/common/point_tests.h>

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

using namespace pcl::visualization;
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
    window_.SetMultiSamples (0); // without a graphics card they cost most of the time
    window_.SetOffScreenRendering (options.screenshot.empty() ? 0 : 1);
    viewer_.setSize (options.width, options.height);
    viewer_.setBackgroundColor (1.0, 1.0, 1.0);
    viewer_.setShowFPS (false);
    Eigen::Vector4f least, most;
    pcl::getMinMax3D (*cloud.coordinates, cloud.finite, least, most);
    arrow_length_ = 0.04 * (most - least).head<3>().norm();
    addCloud();
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
  /** Points just large enough to close the gaps between them, behind the lines that are
   * drawn among them. */
  void
  addCloud ()
  {
    constexpr double filled = 1.6, behind = 8.0;
    viewer_.addPointCloud<pcl::PointXYZRGB> (pcl::make_shared<ColoredCloud>(),
                                             cloud_id);
    const double pixels = static_cast<double> (options_.width) * options_.height;
    const double side =
        std::sqrt (filled * pixels / static_cast<double> (cloud_.finite.size()));
    viewer_.setPointCloudRenderingProperties (
        PCL_VISUALIZER_POINT_SIZE, std::round (std::clamp (side, 2.0, 6.0)), cloud_id);
    vtkMapper& mapper = *viewer_.getCloudActorMap()->at (cloud_id).actor->GetMapper();
    mapper.SetResolveCoincidentTopologyToPolygonOffset();
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter (behind);
  }

  /** \return whether PCLVisualizer does not get the key */
  bool
  onKey (vtkObject* /*caller*/, unsigned long event, void* /*data*/)
  {
    if (event == vtkCommand::CharEvent) // follows the same press of a key
      return is_own_key_;
    vtkRenderWindowInteractor& interactor = *window_.GetInteractor();
    const char key = interactor.GetKeyCode();
    ViewState next = options_.state;
    is_own_key_ = interactor.GetControlKey() == 0 && interactor.GetAltKey() == 0 &&
                  (key == 'r' || pressKey (key, next));
    if (!is_own_key_)
      return false;
    if (key == 'r')
      resetCamera();
    show (next);
    return true;
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
    return found_.labels[static_cast<std::size_t> (cloud_.finite[point])];
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
    const auto points = pcl::make_shared<ColoredCloud>();
    const std::vector<pcl::RGB> colors =
        colorsOfPoints (found_, options_.state, cloud_.colors);
    for (const pcl::index_t index : cloud_.finite) {
      const pcl::PointXYZ& point = (*cloud_.coordinates)[index];
      const pcl::RGB& color = colors[static_cast<std::size_t> (index)];
      points->emplace_back (point.x, point.y, point.z, color.r, color.g, color.b);
    }
    viewer_.updatePointCloud (ColoredCloud::ConstPtr (points), cloud_id);
    drawShapes (viewer_, found_, options_.state, arrow_length_);
    drawText();
  }

  void
  drawText ()
  {
    const std::string id = "status";
    viewer_.addText (statusText (options_.input, found_, options_.state, cloud_.shift),
                     12,
                     12,
                     15,
                     0.0,
                     0.0,
                     0.0,
                     id);
    auto& text = dynamic_cast<vtkTextActor&> (*viewer_.getShapeActorMap()->at (id));
    text.GetTextProperty()->SetBackgroundColor (1.0, 1.0, 1.0);
    text.GetTextProperty()->SetBackgroundOpacity (0.75);
    text.GetTextProperty()->BoldOff();
  }

  /** Looks at the cloud as its picture does (\ref chooseView). */
  void
  resetCamera ()
  {
    const int width = options_.width, height = options_.height;
    const View view = chooseView (
        *cloud_.coordinates, found_.detected.planes, found_.detected.up, width, height);
    Eigen::Vector4f centroid;
    pcl::compute3DCentroid (*cloud_.coordinates, centroid);
    const Eigen::Vector3d eye = view.eye.cast<double>();
    const Eigen::Vector3d down = view.axes.row (1).cast<double>();
    const Eigen::Vector3d ahead = view.axes.row (2).cast<double>();
    const double depth = ahead.dot (centroid.head<3>().cast<double>() - eye);
    // What the mouse turns the cloud around.
    const Eigen::Vector3d target = eye + (depth > 0.0 ? depth : 1.0) * ahead;
    const double half_height = 0.5 * height / view.focal; // 1 m ahead
    vtkCamera& camera = *renderer_.GetActiveCamera();
    camera.SetParallelProjection (0);
    camera.SetPosition (eye.data());
    camera.SetFocalPoint (target.data());
    camera.SetViewUp (-down.x(), -down.y(), -down.z());
    camera.SetWindowCenter (1.0 - 2.0 * view.center.x() / width,
                            2.0 * view.center.y() / height - 1.0);
    camera.SetViewAngle (pcl::rad2deg (2.0 * std::atan (half_height)));
    camera.SetParallelScale (camera.GetDistance() * half_height);
    renderer_.ResetCameraClippingRange();
  }

  /** With the state that is shown. */
  ViewOptions options_;
  const ViewedCloud& cloud_;
  FoundPlanes found_;
  PCLVisualizer viewer_;
  vtkRenderWindow& window_;
  vtkRenderer& renderer_;
  double arrow_length_ = 0.0;
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
