// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "geometry/planar_area.h"
#include <pcl_ops/surface/triangulation.h>

using pcl_ops::PlanarPoints;

namespace {

/** \brief Total area of the triangles of rings; fails if a triangle runs clockwise. */
double
areaOfTriangles (const pcl_ops::PlanarRings& rings)
{
  PlanarPoints corners;
  for (const PlanarPoints& ring : rings)
    corners.insert (corners.end(), ring.begin(), ring.end());
  double area = 0.0;
  for (const auto& [a, b, c] : pcl_ops::triangulate (rings)) {
    const double area_of_triangle =
        pcl_ops::internal::areaOf ({corners[a], corners[b], corners[c]});
    EXPECT_GE (area_of_triangle, 0.0);
    area += area_of_triangle;
  }
  return area;
}

const PlanarPoints square_of_3_m = {{0, 0}, {3, 0}, {3, 3}, {0, 3}};

} // namespace

TEST (Triangulation, CoversASquareAndAnL)
{
  const PlanarPoints square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const PlanarPoints l = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  EXPECT_EQ (pcl_ops::triangulate ({square}).size(), 2u);
  EXPECT_NEAR (areaOfTriangles ({square}), 1.0, 1e-9);
  EXPECT_NEAR (areaOfTriangles ({l}), 3.0, 1e-9) << "without its notch";
}

TEST (Triangulation, OfACombWithAHundredTeethCoversEveryTooth)
{
  PlanarPoints comb = {{0, -1}, {100, -1}};
  for (int tooth = 99; tooth >= 0; --tooth) {
    comb.emplace_back (tooth + 1.0, 0.0);
    comb.emplace_back (tooth + 0.5, 1.0);
  }
  comb.emplace_back (0.0, 0.0);
  constexpr double area_of_handle = 100.0 * 1.0;
  constexpr double area_of_teeth = 100 * 0.5;
  EXPECT_NEAR (areaOfTriangles ({comb}), area_of_handle + area_of_teeth, 1e-6);
}

TEST (Triangulation, OfRingsWithoutAreaHasNoTriangles)
{
  EXPECT_TRUE (pcl_ops::triangulate ({}).empty());
  EXPECT_TRUE (pcl_ops::triangulate ({{{0, 0}, {1, 1}}}).empty());
  EXPECT_TRUE (pcl_ops::triangulate ({{{0, 0}, {1, 1}, {2, 2}}}).empty());
}

TEST (Triangulation, CoversNoneOfManyHoles)
{
  constexpr double hole_edge = 0.2; // [m]
  pcl_ops::PlanarRings sieve = {square_of_3_m};
  for (int x = 0; x < 5; ++x)
    for (int y = 0; y < 5; ++y) {
      const double min_x = 0.2 + 0.6 * x;
      const double min_y = 0.2 + 0.6 * y;
      sieve.push_back ({{min_x, min_y},
                        {min_x, min_y + hole_edge},
                        {min_x + hole_edge, min_y + hole_edge},
                        {min_x + hole_edge, min_y}});
    }
  EXPECT_NEAR (areaOfTriangles (sieve), 9.0 - 25 * hole_edge * hole_edge, 1e-9);
}

TEST (Triangulation, IgnoresAHoleWithoutCornersAndIsEmptyIfTheOuterRingIs)
{
  const auto without_hole = pcl_ops::triangulate ({square_of_3_m});
  EXPECT_EQ (pcl_ops::triangulate ({square_of_3_m, {}}), without_hole);
  EXPECT_TRUE (pcl_ops::triangulate ({{}, square_of_3_m}).empty());
}
