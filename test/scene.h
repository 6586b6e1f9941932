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

// clang-format off
constexpr double operator"" _m (long double meters) { return static_cast<double> (meters); }
constexpr double operator"" _m (unsigned long long meters) { return static_cast<double> (meters); }
constexpr double operator"" _cm (unsigned long long centimeters) { return 1e-2 * static_cast<double> (centimeters); }
constexpr double operator"" _mm (unsigned long long millimeters) { return 1e-3 * static_cast<double> (millimeters); }
constexpr double operator"" _percent (unsigned long long percent) { return 1e-2 * static_cast<double> (percent); }
constexpr double operator"" _deg (long double degrees) { return static_cast<double> (degrees) * pi / 180.0; }
constexpr double operator"" _deg (unsigned long long degrees) { return static_cast<double> (degrees) * pi / 180.0; }
// clang-format on

/** \brief A seed from the running test's name (FNV-1a): no two tests share random
 * numbers, and adding a test changes those of no other. */
std::uint32_t
seedOfTest ();

/** \brief Standard normal draw (Box & Muller). */
double
drawNormal (RandomGenerator& generator);

/** \brief Three of them. */
Eigen::Vector3d
drawNormals (RandomGenerator& generator);

Eigen::Quaterniond
drawTurn (RandomGenerator& generator);

pcl::PointXYZ
toPoint (const Eigen::Vector3d& position);

/** \brief 0, 1, 2, ..., as many as asked for. */
template <typename Indices = std::vector<std::uint32_t>>
Indices
upTo (std::size_t number)
{
  Indices numbers (number);
  std::iota (numbers.begin(), numbers.end(), 0);
  return numbers;
}

/** \brief A parallelogram: corner + s first + t second with s and t in 0 .. 1. */
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

/** \brief Anywhere on a surface, or beside it by a noise along its normal. */
Eigen::Vector3d
drawPointOf (const Surface& surface, double noise, RandomGenerator& generator);

/** \brief A cloud with its truth: the surface of each point, or -1 for clutter. */
struct LabelledScene {
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
  /** \brief A horizontal rectangle from (0, 0). */
  Scene&
  floor (double width, double depth, double height = 0.0)
  {
    return surface ({0, 0, height}, {width, 0, 0}, {0, depth, 0});
  }
  /** \brief An upright rectangle over the line between two points of the floor. */
  Scene&
  wall (const Eigen::Vector2d& from, const Eigen::Vector2d& to, double height)
  {
    const Eigen::Vector2d along = to - from;
    return surface ({from.x(), from.y(), 0}, {along.x(), along.y(), 0}, {0, 0, height});
  }
  /** \brief Mean distance between neighboring points of a surface. */
  Scene&
  spacing (double meters)
  {
    spacing_ = meters;
    return *this;
  }
  /** \brief Standard deviation of the points along their surface's normal. */
  Scene&
  noise (double meters)
  {
    noise_ = meters;
    return *this;
  }
  /** \brief Points anywhere in the scene's bounding box, as a share of all points. */
  Scene&
  clutter (double share)
  {
    clutter_ = share;
    return *this;
  }
  /** \brief Moves the whole scene. */
  Scene&
  movedBy (const Eigen::Vector3d& shift)
  {
    shift_ = shift;
    return *this;
  }

  LabelledScene
  build ();

private:
  void
  add (LabelledScene& scene, const Eigen::Vector3d& point, int label) const
  {
    scene.cloud->push_back (toPoint (point + shift_));
    scene.labels.push_back (label);
  }
  void
  addClutter (LabelledScene& scene);

  RandomGenerator generator_;
  std::vector<Surface> surfaces_;
  double spacing_ = 4_cm;
  double noise_ = 0.0;
  double clutter_ = 0.0;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
};

/** \brief A floor of 4 m x 3 m with two walls of 2.5 m, some 18,000 points, and a
 * little clutter. With a millimeter of noise the normal of any one point is good enough
 * for a whole surface: nobody has to be lucky. */
Scene
room (std::uint32_t seed = seedOfTest());

/** \brief The same with points as near to each other as a depth camera sees them: some
 * 300 in a sphere of FSPF's default radius. */
Scene
denseRoom ();

/** \brief What a depth camera at the origin, looking along z, sees of a floor 1 m below
 * it (y down) and a wall 3 m ahead: organized, with pixels that saw nothing as NaN. */
pcl::PointCloud<pcl::PointXYZ>::Ptr
roomSeenByCamera (std::uint32_t width, std::uint32_t height);

/** \brief Those of columns x rows points evenly spread over a surface.
 * \param[in] noise points lie so far before and behind the surface in turn [m] */
pcl_ops::Moments
momentsOf (const Surface& surface, int columns, int rows, double noise = 0.0);

/** \brief Points of a cloud as a plane with this normal. */
pcl_ops::PlaneSegment
planeOfPoints (const pcl::PointCloud<pcl::PointXYZ>& cloud,
               const pcl::Indices& inliers,
               const Eigen::Vector3d& normal);

/** \brief Angle between two directions, whatever their signs [rad]. */
double
angleBetween (const Eigen::Vector3d& first, const Eigen::Vector3d& second);

/** \brief Whether the plane's normal is within \p angle of the truth's, and the plane
 * passes within \p offset of the truth's center. */
bool
isNear (const pcl_ops::Plane& plane, const Surface& truth, double angle, double offset);

/** \brief Every surface of the scene is one of the planes, with nine tenths of its
 * points, and there is no plane besides; angle and offset as in \ref isNear. */
void
expectFindsEverySurface (const std::vector<pcl_ops::PlaneSegment>& planes,
                         const LabelledScene& scene,
                         double angle = 1_deg,
                         double offset = 1_cm);
