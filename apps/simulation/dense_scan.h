// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <algorithm>
#include <cmath>

namespace pcl_ops::simulation {

/** \brief A round surface about an upright axis, or a part of one. */
struct RoundShape {
  enum class Kind {
    /** \brief The top of a sphere: what is seen of one far larger than the scene. */
    Dome,
    /** \brief Without its ends. */
    Cylinder,
    /** \brief Without its base. */
    Cone,
    Torus
  };
  Kind kind = Kind::Dome;
  /** \brief Of the dome its sphere's; of the cone its apex. */
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  /** \brief Of the sphere, the cylinder, the cone's base or the middle of the torus's
   * ring [m]. */
  double radius = 1.0;
  /** \brief Height of the dome or the cone, half that of the cylinder or the torus [m].
   */
  double height = 0.1;
  /** \brief Of a full turn, around the direction +y from the axis; 1 of a dome. */
  double share = 1.0;

  double
  area () const;
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
drawPoint (const Cylinder& cylinder, Random& random);
SurfacePoint
drawPoint (const RoundShape& shape, Random& random);

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
