// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
// Comparison with CGAL's function for the same purpose, built where CGAL is found.
#include "scene.h"
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/property_map.h>
#include <CGAL/Shape_regularization/regularize_planes.h>
#include <pcl_ops/buildings/plane_regularization.h>

using Eigen::Vector3d;
using namespace pcl_ops;

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/** \brief Six sides of a box with edges of 2 m, with a noise of 5 mm: sides i and i + 3
 * are opposite, and the angle between them is 0.4 degrees. */
struct Box {
  std::vector<PlaneSegment> planes = {};
  std::vector<Kernel::Point_3> points = {};
  std::vector<int> plane_of_point = {};

  Box()
  {
    RandomGenerator generator (seedOfTest());
    for (int side = 0; side < 6; ++side) {
      const double tilt = side < 3 ? 0.2_deg : -0.2_deg;
      const Vector3d across = Vector3d::Unit (side % 3);
      const Vector3d along = Vector3d::Unit ((side + 1) % 3);
      const Vector3d corner = side < 3 ? Vector3d::Zero() : Vector3d (2.0 * across);
      const Vector3d normal = std::cos (tilt) * across + std::sin (tilt) * along;
      const Vector3d first_edge = std::cos (tilt) * along - std::sin (tilt) * across;
      const Vector3d second_edge = Vector3d::Unit ((side + 2) % 3);
      Moments moments;
      for (int i = 0; i < 900; ++i) {
        const Vector3d point = corner + 2.0 * drawUnit (generator) * first_edge +
                               2.0 * drawUnit (generator) * second_edge +
                               5_mm * drawGaussian (generator) * normal;
        moments.add (point.x(), point.y(), point.z());
        points.emplace_back (point.x(), point.y(), point.z());
        plane_of_point.push_back (side);
      }
      const PlaneFit fit = *fitPlane (moments);
      PlaneSegment& plane = planes.emplace_back();
      plane.centroid = fit.centroid;
      plane.normal = fit.plane.normal;
      plane.moments = moments.about (fit.centroid);
    }
  }

  /** \brief The normals of the planes after CGAL regularized them.
   * \param[in] max_angle largest angle between planes made parallel [rad] */
  std::vector<Vector3d>
  normalsOfCgal (double max_angle) const
  {
    std::vector<Kernel::Plane_3> regularized;
    for (const PlaneSegment& plane : planes) {
      const Plane equation = plane.plane();
      regularized.emplace_back (equation.normal.x(),
                                equation.normal.y(),
                                equation.normal.z(),
                                equation.offset);
    }
    CGAL::Shape_regularization::Planes::regularize_planes (
        regularized,
        points,
        CGAL::parameters::plane_map (CGAL::Identity_property_map<Kernel::Plane_3>())
            .point_map (CGAL::Identity_property_map<Kernel::Point_3>())
            .plane_index_map (CGAL::make_property_map (plane_of_point))
            .regularize_axis_symmetry (false)
            .maximum_angle (max_angle * 180.0 / pi)
            .maximum_offset (1_mm)); // no two sides are so near each other
    std::vector<Vector3d> normals;
    for (const Kernel::Plane_3& plane : regularized)
      normals.push_back (Vector3d (plane.a(), plane.b(), plane.c()).normalized());
    return normals;
  }
};

} // namespace

TEST (PlaneRegularization, IsNearThatOfCgal)
{
  const Box box;
  const PlaneRegularizationParameters parameters;
  const RegularizedPlanes found = regularizePlanes (box.planes, parameters);
  const std::vector<Vector3d> normals = box.normalsOfCgal (parameters.max_angle);
  for (std::size_t i = 0; i < normals.size(); ++i) {
    EXPECT_LT (angleBetween (found.planes[i].normal, normals[i]), 0.1_deg);
    for (std::size_t j = 0; j < i; ++j) {
      const bool are_opposite = i == j + 3; // else neighbors
      const double expected = are_opposite ? 1.0 : 0.0;
      const double cosine = found.planes[i].normal.dot (found.planes[j].normal);
      EXPECT_NEAR (std::abs (cosine), expected, 1e-12);
      // Without its symmetry about an axis CGAL does not make neighbors exactly
      // orthogonal: they are only as orthogonal as the mean normals of opposite sides.
      // Before CGAL their cosines are about 3.5e-3.
      const double tolerance = are_opposite ? 1e-12 : 2e-3;
      EXPECT_NEAR (std::abs (normals[i].dot (normals[j])), expected, tolerance)
          << "CGAL's";
    }
  }
}
