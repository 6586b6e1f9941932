// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "drawing.h"

#include <Eigen/Geometry>

#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkGlyph3D.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>

namespace pcl_ops::apps {

namespace {

/** \brief Points of one colour each, to draw lines or arrows with. */
class ColoredPoints {
public:
  ColoredPoints() { colors_->SetNumberOfComponents (3); }

  vtkIdType
  add (const Eigen::Vector3d& point, const pcl::RGB& color)
  {
    colors_->InsertNextValue (color.r);
    colors_->InsertNextValue (color.g);
    colors_->InsertNextValue (color.b);
    return points_->InsertNextPoint (point.data());
  }

  vtkSmartPointer<vtkPolyData>
  toPolyData () const
  {
    vtkNew<vtkPolyData> data;
    data->SetPoints (points_);
    data->GetPointData()->SetScalars (colors_);
    return data;
  }

private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkUnsignedCharArray> colors_;
};

/** \brief The planes' own colours would be lost among their points. */
pcl::RGB
darker (const pcl::RGB& color)
{
  const auto part = [] (std::uint8_t bright) {
    return static_cast<std::uint8_t> (bright / 2);
  };
  return {part (color.r), part (color.g), part (color.b)};
}

/** \brief Diagonal of the box around all outlines. */
double
diagonalOf (const std::vector<PlaneExtent>& extents)
{
  Eigen::AlignedBox3d box;
  for (const PlaneExtent& extent : extents)
    for (const Eigen::Vector3d& corner : extent.hull)
      box.extend (corner);
  return box.isEmpty() ? 1.0 : box.diagonal().norm();
}

/** \brief Lines or points that those of the cloud do not hide. */
vtkSmartPointer<vtkActor>
beforePoints (const vtkSmartPointer<vtkPolyData>& data)
{
  constexpr double towards_eye = -8.0;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData (data);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters (towards_eye, towards_eye);
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter (towards_eye);
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper (mapper);
  actor->GetProperty()->LightingOff();
  return actor;
}

double
arrowLength (const PlaneExtent& extent, double diagonal)
{
  constexpr double of_side = 0.3;
  constexpr double shortest = 0.02;
  constexpr double longest = 0.05;
  return std::clamp (
      of_side * std::sqrt (extent.area), shortest * diagonal, longest * diagonal);
}

} // namespace

vtkSmartPointer<vtkActor>
outlinesOf (const FoundPlanes& found, const std::vector<pcl::RGB>& colors)
{
  constexpr float line_width = 2.5f;
  ColoredPoints corners;
  vtkNew<vtkCellArray> lines;
  for (std::size_t i = 0; i < found.extents.size(); ++i) {
    const std::vector<Eigen::Vector3d>& hull = found.extents[i].hull;
    if (hull.empty())
      continue;
    lines->InsertNextCell (static_cast<int> (hull.size() + 1));
    vtkIdType last = 0;
    for (const Eigen::Vector3d& corner : hull) {
      last = corners.add (corner, darker (colors[i]));
      lines->InsertCellPoint (last);
    }
    lines->InsertCellPoint (last + 1 - static_cast<vtkIdType> (hull.size()));
  }
  const vtkSmartPointer<vtkPolyData> data = corners.toPolyData();
  data->SetLines (lines);
  const vtkSmartPointer<vtkActor> actor = beforePoints (data);
  actor->GetProperty()->SetLineWidth (line_width);
  return actor;
}

vtkSmartPointer<vtkActor>
edgesOf (const FoundPlanes& found)
{
  constexpr float line_width = 4.0f;
  const pcl::RGB black (0, 0, 0);
  ColoredPoints ends;
  vtkNew<vtkCellArray> lines;
  for (const PlaneEdge& edge : found.edges.edges) {
    lines->InsertNextCell (2);
    lines->InsertCellPoint (ends.add (edge.from, black));
    lines->InsertCellPoint (ends.add (edge.to, black));
  }
  const vtkSmartPointer<vtkPolyData> data = ends.toPolyData();
  data->SetLines (lines);
  const vtkSmartPointer<vtkActor> actor = beforePoints (data);
  actor->GetProperty()->SetLineWidth (line_width);
  return actor;
}

vtkSmartPointer<vtkActor>
cornersOf (const FoundPlanes& found)
{
  constexpr float point_size = 14.0f;
  const pcl::RGB red (220, 0, 0);
  ColoredPoints corners;
  vtkNew<vtkCellArray> points;
  for (const PlaneCorner& corner : found.edges.corners) {
    points->InsertNextCell (1);
    points->InsertCellPoint (corners.add (corner.position, red));
  }
  const vtkSmartPointer<vtkPolyData> data = corners.toPolyData();
  data->SetVerts (points);
  const vtkSmartPointer<vtkActor> actor = beforePoints (data);
  actor->GetProperty()->SetPointSize (point_size);
  actor->GetProperty()->RenderPointsAsSpheresOn();
  return actor;
}

vtkSmartPointer<vtkActor>
normalsOf (const FoundPlanes& found, const std::vector<pcl::RGB>& colors)
{
  constexpr int sides = 12;
  const double diagonal = diagonalOf (found.extents);
  ColoredPoints centroids;
  vtkNew<vtkFloatArray> directions;
  directions->SetNumberOfComponents (3);
  for (std::size_t i = 0; i < found.planes.size(); ++i) {
    const PlaneSegment& plane = found.planes[i];
    const Eigen::Vector3d arrow =
        arrowLength (found.extents[i], diagonal) * plane.normal;
    centroids.add (plane.centroid, darker (colors[i]));
    directions->InsertNextTuple (arrow.data());
  }
  const vtkSmartPointer<vtkPolyData> data = centroids.toPolyData();
  data->GetPointData()->SetVectors (directions);
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipResolution (sides);
  arrow->SetShaftResolution (sides);
  vtkNew<vtkGlyph3D> glyphs;
  glyphs->SetInputData (data);
  glyphs->SetSourceConnection (arrow->GetOutputPort());
  glyphs->SetVectorModeToUseVector();
  glyphs->SetScaleModeToScaleByVector();
  glyphs->SetColorModeToColorByScalar();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection (glyphs->GetOutputPort());
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper (mapper);
  return actor;
}

vtkSmartPointer<vtkTextActor>
textIn (const Corner& corner)
{
  constexpr int font_size = 15;
  constexpr double margin = 0.012;
  constexpr double opacity = 0.75;
  constexpr double line_spacing = 1.15;
  const auto text = vtkSmartPointer<vtkTextActor>::New();
  text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  text->SetPosition (corner.is_right ? 1.0 - margin : margin,
                     corner.is_top ? 1.0 - margin : margin);
  vtkTextProperty* const style = text->GetTextProperty();
  style->SetFontSize (font_size);
  style->SetColor (0.0, 0.0, 0.0);
  style->SetBackgroundColor (1.0, 1.0, 1.0);
  style->SetBackgroundOpacity (opacity);
  style->SetLineSpacing (line_spacing);
  if (corner.is_right)
    style->SetJustificationToRight();
  if (corner.is_top)
    style->SetVerticalJustificationToTop();
  return text;
}

} // namespace pcl_ops::apps
