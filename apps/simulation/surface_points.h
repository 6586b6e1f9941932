// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "draws.h"
#include "scene.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

/** \brief An upright cone without its base. */
struct Cone {
  Eigen::Vector3d apex = Eigen::Vector3d::Zero();
  double height = 1.0;
  /** \brief Of the base [m]. */
  double radius = 0.5;
};

/** \brief A lying torus. */
struct Torus {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** \brief From the centre to the middle of the ring [m]. */
  double radius = 0.5;
  /** \brief Half the ring's thickness [m]. */
  double tube_radius = 0.15;
};

/** \brief The top of a sphere: what is seen of one far larger than the scene. */
struct Dome {
  /** \brief Of the sphere. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 1.0;
  /** \brief From the lowest point to the highest [m]. */
  double height = 0.1;
};

/** \brief The part of a round shape within an angle about its upright axis, around the
 * direction +y from there. */
template <typename Shape>
struct Sector {
  Shape shape;
  /** \brief Of a full turn. */
  double share = 1.0;
};

/** \brief A point of a surface and the direction its distance errs in. */
struct SurfacePoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
};

/** \brief Uniform draw from a shape's surface; of a cylinder from its side only, its
 * ends are as small as they are few. */
SurfacePoint
drawPoint (const Rectangle& rectangle, internal::RandomGenerator& generator);
SurfacePoint
drawPoint (const Sphere& sphere, internal::RandomGenerator& generator);
SurfacePoint
drawPoint (const Dome& dome, internal::RandomGenerator& generator);
SurfacePoint
drawPoint (const Cylinder& cylinder, internal::RandomGenerator& generator);
SurfacePoint
drawPoint (const Cone& cone, internal::RandomGenerator& generator);
SurfacePoint
drawPoint (const Torus& torus, internal::RandomGenerator& generator);

/** \brief Of a whole shape, turned about its axis into the sector. */
SurfacePoint
foldIntoSector (const SurfacePoint& whole,
                const Eigen::Vector3d& on_axis,
                double share);

inline Eigen::Vector3d
pointOnAxis (const Cylinder& cylinder)
{
  return cylinder.center;
}

inline Eigen::Vector3d
pointOnAxis (const Cone& cone)
{
  return cone.apex;
}

inline Eigen::Vector3d
pointOnAxis (const Torus& torus)
{
  return torus.center;
}

template <typename Shape>
SurfacePoint
drawPoint (const Sector<Shape>& sector, internal::RandomGenerator& generator)
{
  return foldIntoSector (
      drawPoint (sector.shape, generator), pointOnAxis (sector.shape), sector.share);
}

/** \brief The area that points are drawn from [m^2]. */
double
area (const Rectangle& rectangle);
double
area (const Sphere& sphere);
double
area (const Dome& dome);
double
area (const Cylinder& cylinder);
double
area (const Cone& cone);
double
area (const Torus& torus);

template <typename Shape>
double
area (const Sector<Shape>& sector)
{
  return sector.share * area (sector.shape);
}

inline SurfaceId
surfaceOf (const Rectangle& rectangle)
{
  return rectangle.surface;
}

/** \brief Of what is round. */
template <typename Shape>
SurfaceId
surfaceOf (const Shape&)
{
  return no_surface;
}

/** \brief Points spread over shapes by area, one shape after the other, with the
 * identity of their surface as label.
 * \param[in] forEachShape calls what it is given with every shape
 * \param[in] points exact number of points; none if the shapes have no area
 * \param[in] sigma standard deviation along the normal [m]
 * \param[in,out] generator advanced by as many draws as it takes */
template <typename ForEachShape>
pcl::PointCloud<pcl::PointXYZL>
drawPoints (const ForEachShape& forEachShape,
            std::size_t points,
            double sigma,
            internal::RandomGenerator& generator)
{
  pcl::PointCloud<pcl::PointXYZL> cloud;
  double whole_area = 0.0;
  forEachShape ([&] (const auto& shape) { whole_area += area (shape); });
  if (!(whole_area > 0.0))
    return cloud;
  cloud.reserve (points);
  double area_so_far = 0.0;
  forEachShape ([&] (const auto& shape) {
    area_so_far += area (shape);
    // Rounding the running total gives every shape its share and all of them \p points.
    const double share = std::min (1.0, area_so_far / whole_area);
    const auto end = std::size_t (std::llround (share * double (points)));
    while (cloud.size() < end) {
      const SurfacePoint exact = drawPoint (shape, generator);
      const double error = sigma * drawGaussian (generator);
      pcl::PointXYZL point;
      point.getVector3fMap() = (exact.position + error * exact.normal).cast<float>();
      point.label = surfaceOf (shape);
      cloud.push_back (point);
    }
  });
  return cloud;
}

} // namespace pcl_ops::simulation
