// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/random.h"
#include "geometry/angles.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

using pcl_ops::internal::drawBelow;
using pcl_ops::internal::drawUnit;
using pcl_ops::internal::pi;
using pcl_ops::internal::RandomGenerator;

/** \brief For calls whose result does not depend on the number of threads. */
constexpr unsigned one_thread = 1;

// The types that C++ gives numbers before a suffix: with a decimal point, and without.
using DecimalLiteral = long double;
using WholeLiteral = unsigned long long;

// Lengths become meters, angles radians, per cent a share.
// clang-format off
constexpr double operator"" _m (DecimalLiteral x) { return double (x); }
constexpr double operator"" _m (WholeLiteral x) { return double (x); }
constexpr double operator"" _cm (WholeLiteral x) { return 1e-2 * double (x); }
constexpr double operator"" _mm (WholeLiteral x) { return 1e-3 * double (x); }
constexpr double operator"" _percent (WholeLiteral x) { return 1e-2 * double (x); }
constexpr double operator"" _deg (DecimalLiteral x) { return double (x) * pi / 180.0; }
constexpr double operator"" _deg (WholeLiteral x) { return double (x) * pi / 180.0; }
// clang-format on

/** \brief theta_h in tests of the paper's methods: the farthest that a point of a plane
 * is from it [m]. */
constexpr double theta_h = 5_cm;

/** \brief Returns a seed hashed from the name of the running test (FNV-1a). Each test
 * has random numbers of its own, which stay the same if other tests are added. Only a
 * running test may call this. */
std::uint32_t
seedOfTest ();

/** \brief A number drawn from the normal distribution of mean 0 and variance 1 (Box &
 * Muller). */
double
drawGaussian (RandomGenerator& generator);

/** \brief Three independent draws of \ref drawGaussian. Normalized they are a random
 * direction, uniform on the sphere. */
Eigen::Vector3d
drawGaussians (RandomGenerator& generator);

/** \brief A random rotation, uniform over all rotations. */
Eigen::Quaterniond
drawTurn (RandomGenerator& generator);

/** \brief The position in single precision. */
pcl::PointXYZ
toPoint (const Eigen::Vector3d& position);

/** \brief The numbers 0, 1, ..., \p number - 1. */
template <typename Indices = std::vector<std::uint32_t>>
Indices
upTo (std::size_t number)
{
  Indices numbers (number);
  std::iota (numbers.begin(), numbers.end(), 0);
  return numbers;
}

/** \brief A parallelogram with a corner and two edge vectors [m]: its points are
 * corner + s first + t second with s and t from 0 to 1. */
struct Surface {
  Eigen::Vector3d corner, first, second;

  Eigen::Vector3d
  at (double s, double t) const
  {
    return corner + s * first + t * second;
  }
  Eigen::Vector3d
  center () const
  {
    return at (0.5, 0.5);
  }
  /** \brief Unit vector along the cross product of the first and the second edge. */
  Eigen::Vector3d
  normal () const
  {
    return first.cross (second).normalized();
  }
  double
  area () const
  {
    return first.cross (second).norm();
  }
};

/** \brief Draws a point uniformly on a surface and moves it along the normal.
 * \param[in] noise standard deviation of the Gaussian offset along the normal [m] */
Eigen::Vector3d
drawPointOf (const Surface& surface, double noise, RandomGenerator& generator);

/** \brief A cloud with its ground truth. The label of each point is an index into
 * surfaces, or -1 for clutter. */
struct LabeledScene {
  pcl::PointCloud<pcl::PointXYZ>::Ptr cloud;
  std::vector<int> labels;
  std::vector<Surface> surfaces;
};

/** \brief Builds small unorganized clouds of flat surfaces, z up. */
class Scene {
public:
  explicit Scene (std::uint32_t seed = seedOfTest()) : generator_ (seed) {}

  Scene&
  surface (const Eigen::Vector3d& corner,
           const Eigen::Vector3d& first,
           const Eigen::Vector3d& second)
  {
    surfaces_.push_back ({corner, first, second});
    return *this;
  }
  /** \brief Adds a horizontal rectangle with a corner at (0, 0, height). */
  Scene&
  floor (double width, double depth, double height = 0.0)
  {
    return surface ({0, 0, height}, {width, 0, 0}, {0, depth, 0});
  }
  /** \brief Adds a vertical rectangle above the line between two points at z = 0. */
  Scene&
  wall (const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height)
  {
    const Eigen::Vector2d along = to - from;
    return surface ({from.x(), from.y(), 0}, {along.x(), along.y(), 0}, {0, 0, height});
  }
  /** \brief Mean distance between neighboring points of a surface [m]. */
  Scene&
  spacing (double meters)
  {
    spacing_ = meters;
    return *this;
  }
  /** \brief Standard deviation of the points along their surface's normal [m]. */
  Scene&
  noise (double meters)
  {
    noise_ = meters;
    return *this;
  }
  /** \brief Share of all points that are clutter: drawn uniformly in the bounding box
   * of the surfaces. */
  Scene&
  clutter (double share)
  {
    share_of_clutter_ = share;
    return *this;
  }
  /** \brief Moves all surfaces and the clutter by a shift [m]. */
  Scene&
  movedBy (const Eigen::Vector3d& shift)
  {
    shift_ = shift;
    return *this;
  }

  /** \brief Draws the points of one surface after the other, then the clutter. Each
   * call draws other points. */
  LabeledScene
  build ();

private:
  /** \brief Adds a point, moved by the shift of the scene. */
  void
  add (LabeledScene& scene, const Eigen::Vector3d& point, int label) const
  {
    scene.cloud->push_back (toPoint (point + shift_));
    scene.labels.push_back (label);
  }
  void
  addClutter (LabeledScene& scene);

  RandomGenerator generator_;
  std::vector<Surface> surfaces_;
  double spacing_ = 4_cm;
  double noise_ = 0.0;
  double share_of_clutter_ = 0.0;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
};

/** \brief A floor of 4 m x 3 m with two walls 2.5 m high: some 18,400 points, and 2 %
 * clutter. The noise is 1 mm: the normal estimated at any point fits its whole
 * surface, so that no test depends on a lucky sample. */
Scene
room (std::uint32_t seed = seedOfTest());

/** \brief \ref room with a point every 2 cm, as of a depth camera: FSPF's outer sphere,
 * by default with a radius of 20 cm, holds some 300 points of a surface. */
Scene
denseRoom ();

/** \brief An organized cloud of a depth camera at the origin that looks along z (y
 * down). It sees a floor at y = 1 m and a wall at z = 3 m; a tenth of the points is
 * NaN.
 * \param[in] width,height of the image [pixels] */
pcl::PointCloud<pcl::PointXYZ>::Ptr
roomSeenByCamera (std::uint32_t width, std::uint32_t height);

/** \brief Moments of points evenly spread over a surface: so many columns along its
 * first edge, and so many rows along its second edge.
 * \param[in] noise points lie by turns this far in front of the surface and behind it,
 * so this is their rms distance to it [m] */
pcl_ops::Moments
momentsOf (const Surface& surface, int columns, int rows, double noise = 0.0);

/** \brief A plane with this normal, and the moments and the centroid of its inliers.
 * \param[in] inliers at least one index into the cloud */
pcl_ops::PlaneSegment
planeOfPoints (const pcl::PointCloud<pcl::PointXYZ>& cloud,
               const pcl::Indices& inliers,
               const Eigen::Vector3d& normal);

/** \brief Angle between two lines of these directions, 0 to pi / 2 [rad]. */
double
angleBetween (const Eigen::Vector3d& first, const Eigen::Vector3d& second);

/** \brief Whether the normals of the plane and the true surface differ by at most
 * \p max_angle [rad], whatever their signs, and the center of the surface is at most
 * \p max_distance [m] from the plane. */
bool
isNear (const pcl_ops::Plane& plane,
        const Surface& truth,
        double max_angle,
        double max_distance);

/** \brief Fails the test unless there are as many planes as surfaces, and the first
 * plane near each surface (\ref isNear) has at least 90 % of the surface's points. */
void
expectFindsEverySurface (const std::vector<pcl_ops::PlaneSegment>& planes,
                         const LabeledScene& scene,
                         double max_angle = 1_deg,
                         double max_distance = 1_cm);
