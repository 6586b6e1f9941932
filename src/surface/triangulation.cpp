// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <pcl_ops/surface/triangulation.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <cmath>

namespace pcl_ops {

namespace {

double
twiceTheArea (const PlanarPoints& outline, const Triangle& triangle)
{
  const Eigen::Vector2d first = outline[triangle[1]] - outline[triangle[0]];
  const Eigen::Vector2d second = outline[triangle[2]] - outline[triangle[0]];
  return first.x() * second.y() - first.y() * second.x();
}

bool
coverTheOutline (const std::vector<Triangle>& triangles, const PlanarPoints& outline)
{
  double covered = 0.0;
  for (const Triangle& triangle : triangles)
    covered += std::abs (twiceTheArea (outline, triangle));
  double whole = 0.0;
  for (std::size_t i = 2; i < outline.size(); ++i)
    whole += twiceTheArea (outline, {0, i - 1, i});
  constexpr double tolerance = 1e-6;
  return std::abs (covered - whole) < tolerance * whole;
}

void
setOutline (vtkPolyData& mesh, const PlanarPoints& outline)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  polygons->InsertNextCell (static_cast<int> (outline.size()));
  for (const Eigen::Vector2d& corner : outline)
    polygons->InsertCellPoint (points->InsertNextPoint (corner.x(), corner.y(), 0.0));
  mesh.SetPoints (points);
  mesh.SetPolys (polygons);
}

} // namespace

std::vector<Triangle>
triangulate (const PlanarPoints& outline)
{
  constexpr vtkIdType corners = 3;
  if (outline.size() < corners)
    return {};
  vtkNew<vtkPolyData> mesh;
  setOutline (*mesh, outline);
  vtkNew<vtkTriangleFilter> filter;
  filter->SetInputData (mesh);
  filter->Update();
  std::vector<Triangle> triangles;
  vtkNew<vtkIdList> ids;
  vtkCellArray* const polygons = filter->GetOutput()->GetPolys();
  for (polygons->InitTraversal(); polygons->GetNextCell (ids) != 0;) {
    if (ids->GetNumberOfIds() != corners)
      return {};
    Triangle triangle{};
    for (vtkIdType corner = 0; corner < corners; ++corner)
      triangle[static_cast<std::size_t> (corner)] =
          static_cast<std::size_t> (ids->GetId (corner));
    if (twiceTheArea (outline, triangle) < 0.0)
      std::swap (triangle[1], triangle[2]);
    triangles.push_back (triangle);
  }
  return coverTheOutline (triangles, outline) ? triangles : std::vector<Triangle>();
}

} // namespace pcl_ops
