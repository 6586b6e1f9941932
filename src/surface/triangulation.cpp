// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ear_clipping.h"
#include "geometry/planar_area.h"
#include "keyholes.h"
#include <pcl_ops/surface/triangulation.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace pcl_ops {

namespace {

using namespace internal;

double
signedArea (const Triangle& triangle, const PlanarPoints& corners)
{
  const auto& [a, b, c] = triangle;
  return 0.5 * twiceTheArea (corners[a], corners[b], corners[c]);
}

/** \brief The triangles if they cover an area; else none. */
std::vector<Triangle>
unlessParted (std::vector<Triangle> triangles, const PlanarPoints& corners, double area)
{
  constexpr double tolerance = 1e-6;
  double covered = 0.0;
  for (const Triangle& triangle : triangles)
    covered += signedArea (triangle, corners);
  if (!(std::abs (covered - area) < tolerance * area))
    triangles.clear();
  return triangles;
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
    if (signedArea (triangle, outline) < 0.0)
      std::swap (triangle[1], triangle[2]);
    triangles.push_back (triangle);
  }
  return unlessParted (std::move (triangles), outline, areaOf (outline));
}

std::vector<Triangle>
triangulateRings (const PlanarRings& rings)
{
  if (rings.empty() || rings.front().empty())
    return {};
  PlanarRings filled;
  std::copy_if (rings.begin(),
                rings.end(),
                std::back_inserter (filled),
                [] (const PlanarPoints& ring) { return !ring.empty(); });
  if (filled.size() < 2)
    return triangulate (filled.front());
  PlanarPoints corners;
  double area = 0.0;
  for (const PlanarPoints& ring : rings) {
    corners.insert (corners.end(), ring.begin(), ring.end());
    area += areaOf (ring);
  }
  return unlessParted (
      clipEars (throughKeyholes (filled, corners), corners), corners, area);
}

} // namespace pcl_ops
