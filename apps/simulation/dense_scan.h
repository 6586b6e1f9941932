// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

/** \brief An upright cone without its base. */
struct Cone {
  Eigen::Vector3d apex = Eigen::Vector3d::Zero();
  double height = 1.0;
  /** \brief Of the base [m]. */
  double radius = 0.5;

  double
  area () const
  {
    return pi * radius * std::hypot (radius, height);
  }
};

/** \brief A lying torus. */
struct Torus {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** \brief From the center to the middle of the ring [m]. */
  double radius = 0.5;
  /** \brief Half the ring's thickness [m]. */
  double tube_radius = 0.15;

  double
  area () const
  {
    return 4.0 * pi * pi * radius * tube_radius;
  }
};

/** \brief The top of a sphere: what is seen of one far larger than the scene. */
struct Dome {
  /** \brief Of the sphere. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 1.0;
  /** \brief From the lowest point to the highest [m]. */
  double height = 0.1;

  double
  area () const
  {
    return 2.0 * pi * radius * height;
  }
};

/** \brief The part of a round shape within an angle about its upright axis, around the
 * direction +y from there. */
template <typename Shape>
struct Sector {
  Shape shape;
  /** \brief Of a full turn. */
  double share = 1.0;

  double
  area () const
  {
    return share * shape.area();
  }
};

/** \brief A point of a surface and the direction its distance errs in. */
struct SurfacePoint {
  Eigen::Vector3d position;
  Eigen::Vector3d normal;
};

/** \brief Uniform draw from a shape's surface; of a cylinder from its side only, its
 * ends are as small as they are few. */
SurfacePoint
drawPoint (const Rectangle& rectangle, Random& random);
SurfacePoint
drawPoint (const Sphere& sphere, Random& random);
SurfacePoint
drawPoint (const Dome& dome, Random& random);
SurfacePoint
drawPoint (const Cylinder& cylinder, Random& random);
SurfacePoint
drawPoint (const Cone& cone, Random& random);
SurfacePoint
drawPoint (const Torus& torus, Random& random);

/** \brief A point of a whole shape, turned about its axis into the sector. */
SurfacePoint
foldIntoSector (const SurfacePoint& whole,
                const Eigen::Vector3d& on_axis,
                double share);

template <typename Shape>
Eigen::Vector3d
pointOnAxis (const Shape& shape)
{
  return shape.center;
}

inline Eigen::Vector3d
pointOnAxis (const Cone& cone)
{
  return cone.apex;
}

template <typename Shape>
SurfacePoint
drawPoint (const Sector<Shape>& sector, Random& random)
{
  const SurfacePoint whole = drawPoint (sector.shape, random);
  return sector.share < 1.0
             ? foldIntoSector (whole, pointOnAxis (sector.shape), sector.share)
             : whole;
}

/** \brief Points spread over shapes by area, one shape after the other, with the
 * identity of their surface as label.
 * \param[in] forEach calls what it is given with every shape
 * \param[in] points exact number of points; none if the shapes have no area
 * \param[in] sigma standard deviation along the normal [m]
 * \param[in,out] random source of all points */
template <typename ForEach>
pcl::PointCloud<pcl::PointXYZL>
drawPoints (const ForEach& forEach, std::size_t points, double sigma, Random& random)
{
  pcl::PointCloud<pcl::PointXYZL> cloud;
  double whole_area = 0.0;
  forEach ([&] (const auto& shape) { whole_area += shape.area(); });
  if (!(whole_area > 0.0))
    return cloud;
  cloud.reserve (points);
  double area_so_far = 0.0;
  forEach ([&] (const auto& shape) {
    area_so_far += shape.area();
    // Rounding the running total gives every shape its share and all of them \p points.
    const double share = std::min (1.0, area_so_far / whole_area);
    const auto end = std::size_t (std::llround (share * double (points)));
    while (cloud.size() < end) {
      const SurfacePoint exact = drawPoint (shape, random);
      const double error = sigma * random.gaussian();
      cloud.push_back (
          pointAt (exact.position + error * exact.normal, surfaceOf (shape)));
    }
  });
  return cloud;
}

/** \brief Standard deviation of a terrestrial laser scanner's distances [m]. */
constexpr double laser_sigma = 0.003;

/** \brief Scans all surfaces of a scene evenly, whatever hides them: a registered scan
 * from everywhere. The points follow the surfaces one after the other. The sensor's
 * origin is the middle of the first body, the room's shell.
 * \param[in] points exact number of points; none if the scene is empty
 * \param[in] noise_scale factor on \ref laser_sigma, the noise along the normal */
SimulatedCloud
scanDensely (const Scene& scene,
             std::size_t points,
             double noise_scale,
             std::uint32_t seed);

} // namespace pcl_ops::simulation
