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

/** \brief Three noisy sides of a box with edges of 2 m. */
struct Box {
  std::vector<PlaneSegment> planes = {};
  std::vector<Kernel::Point_3> points = {};
  std::vector<int> plane_of_point = {};

  Box()
  {
    RandomGenerator generator (seedOfTest());
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d normal = Vector3d::Unit (axis),
                     u = Vector3d::Unit ((axis + 1) % 3),
                     v = Vector3d::Unit ((axis + 2) % 3);
      Moments moments;
      for (int i = 0; i < 900; ++i) {
        const Vector3d point = 2.0 * drawUnit (generator) * u +
                               2.0 * drawUnit (generator) * v +
                               5_mm * drawGaussian (generator) * normal;
        moments.add (point.x(), point.y(), point.z());
        points.emplace_back (point.x(), point.y(), point.z());
        plane_of_point.push_back (axis);
      }
      const PlaneFit fit = *fitPlane (moments);
      PlaneSegment& plane = planes.emplace_back();
      plane.centroid = fit.centroid;
      plane.normal = fit.plane.normal;
      plane.moments = moments.about (fit.centroid);
    }
  }

  /** \brief The normals of the planes after CGAL regularized them. */
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
            .maximum_offset (1e-3));
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
      EXPECT_NEAR (found.planes[i].normal.dot (found.planes[j].normal), 0.0, 1e-12);
      // CGAL leaves an error of a thousandth of a radian.
      EXPECT_NEAR (normals[i].dot (normals[j]), 0.0, 2e-3) << "CGAL's";
    }
  }
}
