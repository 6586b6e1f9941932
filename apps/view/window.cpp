// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "window.h"

#include <pcl/common/angles.h>
#include <pcl/common/point_tests.h>
#include <pcl/visualization/pcl_visualizer.h>

#include "camera.h"
#include "drawing.h"
#include "interaction.h"
#include "picking.h"
#include "point_colors.h"
#include "texts.h"
#include <cli/errors.h>
#include <io/output_file.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <exception>
#include <iostream>
#include <memory>

namespace pcl_ops::apps {

namespace {

using pcl::visualization::PCLVisualizer;

constexpr const char* cloud_id = "cloud";

/** \brief A PCLVisualizer that shows one state after the other. */
class Window {
public:
  Window (const ViewOptions& options, const ViewedCloud& cloud);

  void
  waitUntilClosed ();
  void
  savePicture (const std::string& file);

private:
  void
  createViewer ();
  bool
  pressKey (const std::string& key);
  void
  click (int x, int y);
  void
  show (const ViewState& state);
  void
  drawPlanes ();
  void
  resetCamera ();
  std::uint32_t
  labelAt (int x, int y) const;

  ViewOptions options_;
  const ViewedCloud& cloud_;
  PlaneFinder finder_;
  ViewState state_;
  const FoundPlanes* found_ = nullptr;
  Camera first_view_;
  /** \brief The points with coordinates: VTK would stumble over the others. */
  pcl::Indices drawn_;

  vtkNew<vtkRenderer> renderer_;
  vtkNew<vtkRenderWindow> window_;
  vtkNew<Interaction> interaction_;
  std::unique_ptr<PCLVisualizer> viewer_;
  vtkSmartPointer<vtkActor> outlines_, edges_, corners_, normals_;
  vtkSmartPointer<vtkTextActor> status_ = textIn ({false, true});
  vtkSmartPointer<vtkTextActor> keys_ = textIn ({false, false});
  vtkSmartPointer<vtkTextActor> plane_ = textIn ({true, true});
};

Window::Window (const ViewOptions& options, const ViewedCloud& cloud)
: options_ (options)
, cloud_ (cloud)
, finder_ (options.detector, cloud.coordinates)
, state_ (options.state)
{
  for (std::size_t i = 0; i < cloud.coordinates->size(); ++i)
    if (pcl::isXYZFinite ((*cloud.coordinates)[i]))
      drawn_.push_back (static_cast<pcl::index_t> (i));
  state_.point_size = pointSizeFor (drawn_.size(), options.width, options.height);
  found_ = &finder_.find (state_.run);
  first_view_ = cameraFor (
      *cloud.coordinates, found_->planes, found_->up, options.width, options.height);
  createViewer();
  for (const auto& text : {status_, keys_, plane_})
    renderer_->AddActor2D (text);
  keys_->SetInput (keysText().c_str());
  viewer_->addPointCloud<pcl::PointXYZRGB> (
      pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>(), cloud_id);
  show (state_);
  resetCamera();
}

void
Window::createViewer()
{
  const bool has_window = options_.screenshot.empty();
  if (has_window)
    window_->SetMultiSamples (0); // without a graphics card they cost most of the time
  else
    window_->SetOffScreenRendering (1);
  int no_arguments = 0;
  viewer_ = std::make_unique<PCLVisualizer> (no_arguments,
                                             nullptr,
                                             renderer_.Get(),
                                             window_.Get(),
                                             "pcl_ops_view " + options_.input,
                                             interaction_.Get(),
                                             has_window);
  viewer_->setBackgroundColor (1.0, 1.0, 1.0);
  window_->SetSize (options_.width, options_.height);
  interaction_->on_key = [this] (const std::string& key) { return pressKey (key); };
  interaction_->on_click = [this] (int x, int y) { click (x, y); };
}

bool
Window::pressKey (const std::string& key)
{
  if (key == reset_key) {
    resetCamera();
    window_->Render();
    return true;
  }
  const std::optional<ViewState> next = afterKey (state_, key);
  if (!next)
    return false;
  if (!(next->run == state_.run)) {
    status_->SetInput ("looking for planes ...");
    window_->Render();
  }
  try {
    found_ = &finder_.find (next->run);
    show (*next);
  }
  catch (const std::exception& error) { // the window stays as it was
    status_->SetInput (wrapped (error.what()).c_str());
  }
  window_->Render();
  return true;
}

void
Window::click (int x, int y)
{
  ViewState next = state_;
  next.selected = labelAt (x, y);
  show (next);
  if (next.selected != 0)
    std::cout << planeText (*found_, next.selected, cloud_.shift) << std::endl;
  window_->Render();
}

std::uint32_t
Window::labelAt (int x, int y) const
{
  constexpr double radius = 4.0;
  const int* const size = window_->GetSize();
  Projection projection;
  projection.size = Eigen::Vector2d (size[0], size[1]);
  const vtkMatrix4x4* const matrix =
      renderer_->GetActiveCamera()->GetCompositeProjectionTransformMatrix (
          renderer_->GetTiledAspectRatio(), -1.0, 1.0);
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column)
      projection.to_cube (row, column) = matrix->GetElement (row, column);
  const std::optional<pcl::index_t> point =
      pointAt (Eigen::Vector2d (x, y), radius, *cloud_.coordinates, projection);
  return point ? found_->labels[static_cast<std::size_t> (*point)] : 0;
}

void
Window::show (const ViewState& state)
{
  state_ = state;
  drawPlanes();
  status_->SetInput (statusText (options_.input, *found_, state).c_str());
  keys_->SetVisibility (state.help ? 1 : 0);
  plane_->SetInput (state.selected == 0
                        ? ""
                        : planeText (*found_, state.selected, cloud_.shift).c_str());
}

void
Window::drawPlanes()
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  const std::vector<pcl::RGB> colors = pointColors (*found_, state_, cloud_.colors);
  for (const pcl::index_t index : drawn_) {
    const pcl::PointXYZ& point = (*cloud_.coordinates)[index];
    const pcl::RGB& color = colors[static_cast<std::size_t> (index)];
    cloud->emplace_back (point.x, point.y, point.z, color.r, color.g, color.b);
  }
  viewer_->updatePointCloud (pcl::PointCloud<pcl::PointXYZRGB>::ConstPtr (cloud),
                             cloud_id);
  viewer_->setPointCloudRenderingProperties (
      pcl::visualization::PCL_VISUALIZER_POINT_SIZE, state_.point_size, cloud_id);
  for (const auto& actor : {outlines_, edges_, corners_, normals_})
    renderer_->RemoveActor (actor);
  const std::vector<pcl::RGB> plane_colors = planeColors (*found_, state_);
  outlines_ = outlinesOf (*found_, plane_colors);
  normals_ = normalsOf (*found_, plane_colors);
  if (state_.hulls)
    renderer_->AddActor (outlines_);
  if (state_.normals)
    renderer_->AddActor (normals_);
  if (!state_.edges)
    return;
  edges_ = edgesOf (*found_);
  corners_ = cornersOf (*found_);
  renderer_->AddActor (edges_);
  renderer_->AddActor (corners_);
}

void
Window::resetCamera()
{
  vtkCamera* const camera = renderer_->GetActiveCamera();
  camera->SetParallelProjection (0);
  camera->SetPosition (first_view_.eye.data());
  camera->SetFocalPoint (first_view_.target.data());
  camera->SetViewUp (first_view_.up.data());
  camera->SetViewAngle (first_view_.angle);
  camera->SetParallelScale (camera->GetDistance() *
                            std::tan (0.5 * pcl::deg2rad (first_view_.angle)));
  renderer_->ResetCameraClippingRange();
}

void
Window::waitUntilClosed()
{
  viewer_->spin();
}

void
Window::savePicture (const std::string& file)
{
  window_->Render();
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput (window_);
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection (image->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const png = writer->GetResult();
  writeFile (file, [&] (std::ostream& stream) {
    stream.write (reinterpret_cast<const char*> (png->GetPointer (0)),
                  png->GetNumberOfValues());
  });
}

} // namespace

void
showCloud (const ViewOptions& options, const ViewedCloud& cloud)
{
  Window window (options, cloud);
  if (options.screenshot.empty())
    window.waitUntilClosed();
  else
    window.savePicture (options.screenshot);
}

} // namespace pcl_ops::apps
