// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <pcl_ops/surface/triangulation.h>

#include <cmath>

using pcl_ops::PlanarPoints;

namespace {

/** \brief The areas of the triangles, each of which runs counter-clockwise. */
double
areaOfTriangles (const PlanarPoints& outline)
{
  double area = 0.0;
  for (const pcl_ops::Triangle& triangle : pcl_ops::triangulate (outline)) {
    const Eigen::Vector2d first = outline[triangle[1]] - outline[triangle[0]];
    const Eigen::Vector2d second = outline[triangle[2]] - outline[triangle[0]];
    const double twice = first.x() * second.y() - first.y() * second.x();
    EXPECT_GE (twice, 0.0);
    area += 0.5 * twice;
  }
  return area;
}

} // namespace

TEST (Triangulation, OfASquareIsTwoTriangles)
{
  const PlanarPoints square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  EXPECT_EQ (pcl_ops::triangulate (square).size(), 2u);
  EXPECT_NEAR (areaOfTriangles (square), 1.0, 1e-9);
}

TEST (Triangulation, OfAnLLeavesItsNotchFree)
{
  EXPECT_NEAR (
      areaOfTriangles ({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}), 3.0, 1e-9);
}

TEST (Triangulation, OfACombWithAHundredTeethCoversEveryTooth)
{
  PlanarPoints comb = {{0, -1}, {100, -1}};
  for (int tooth = 99; tooth >= 0; --tooth) {
    comb.emplace_back (tooth + 1.0, 0.0);
    comb.emplace_back (tooth + 0.5, 1.0);
  }
  comb.emplace_back (0.0, 0.0);
  EXPECT_NEAR (areaOfTriangles (comb), 100.0 + 50.0, 1e-6);
}

TEST (Triangulation, OfNoAreaIsNone)
{
  EXPECT_TRUE (pcl_ops::triangulate ({}).empty());
  EXPECT_TRUE (pcl_ops::triangulate ({{0, 0}, {1, 1}}).empty());
  EXPECT_TRUE (pcl_ops::triangulate ({{0, 0}, {1, 1}, {2, 2}}).empty());
}
