// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "base/random.h"
#include <pcl_ops/plane.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

constexpr double pi = 3.14159265358979323846;

// clang-format off
constexpr double operator"" _m (long double metres) { return static_cast<double> (metres); }
constexpr double operator"" _m (unsigned long long metres) { return static_cast<double> (metres); }
constexpr double operator"" _cm (unsigned long long centimetres) { return 1e-2 * static_cast<double> (centimetres); }
constexpr double operator"" _mm (unsigned long long millimetres) { return 1e-3 * static_cast<double> (millimetres); }
constexpr double operator"" _percent (unsigned long long percent) { return 1e-2 * static_cast<double> (percent); }
constexpr double operator"" _deg (long double degrees) { return static_cast<double> (degrees) * pi / 180.0; }
constexpr double operator"" _deg (unsigned long long degrees) { return static_cast<double> (degrees) * pi / 180.0; }
// clang-format on

/** \brief A seed from the running test's name (FNV-1a): no two tests share random
 * numbers, and adding a test changes those of no other. */
inline std::uint32_t
seedOfTest ()
{
  const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
  std::uint32_t hash = 2166136261u;
  for (const char letter : std::string (test->test_suite_name()) + "." + test->name())
    hash = (hash ^ static_cast<unsigned char> (letter)) * 16777619u;
  return hash;
}

/** \brief Standard normal draw (Box & Muller). */
inline double
drawNormal (pcl_ops::RandomGenerator& generator)
{
  const double radius =
      std::sqrt (-2.0 * std::log (1.0 - pcl_ops::drawUnit (generator)));
  return radius * std::cos (2.0 * pi * pcl_ops::drawUnit (generator));
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
  centre () const
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
  /** \brief Mean distance between neighbouring points of a surface. */
  Scene&
  spacing (double metres)
  {
    spacing_ = metres;
    return *this;
  }
  /** \brief Standard deviation of the points along their surface's normal. */
  Scene&
  noise (double metres)
  {
    noise_ = metres;
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
    const Eigen::Vector3f p = (point + shift_).cast<float>();
    scene.cloud->push_back ({p.x(), p.y(), p.z()});
    scene.labels.push_back (label);
  }
  void
  addSurface (LabelledScene& scene, const Surface& surface, int label);
  void
  addClutter (LabelledScene& scene);

  pcl_ops::RandomGenerator generator_;
  std::vector<Surface> surfaces_;
  double spacing_ = 4_cm;
  double noise_ = 0.0;
  double clutter_ = 0.0;
  Eigen::Vector3d shift_ = Eigen::Vector3d::Zero();
};

inline LabelledScene
Scene::build()
{
  LabelledScene scene{
      pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(), {}, surfaces_};
  for (std::size_t i = 0; i < surfaces_.size(); ++i)
    addSurface (scene, surfaces_[i], static_cast<int> (i));
  addClutter (scene);
  for (Surface& surface : scene.surfaces)
    surface.corner += shift_;
  return scene;
}

inline void
Scene::addSurface (LabelledScene& scene, const Surface& surface, int label)
{
  const auto count = std::lround (surface.area() / (spacing_ * spacing_));
  for (long i = 0; i < count; ++i) {
    const double s = pcl_ops::drawUnit (generator_);
    const double t = pcl_ops::drawUnit (generator_);
    const double height = noise_ > 0.0 ? noise_ * drawNormal (generator_) : 0.0;
    add (scene, surface.at (s, t) + height * surface.normal(), label);
  }
}

inline void
Scene::addClutter (LabelledScene& scene)
{
  Eigen::AlignedBox3d box;
  for (const Surface& surface : surfaces_)
    for (const int corner : {0, 1, 2, 3})
      box.extend (surface.at (corner & 1, corner >> 1));
  const auto count = std::lround (clutter_ / (1.0 - clutter_) *
                                  static_cast<double> (scene.cloud->size()));
  for (long i = 0; i < count; ++i) {
    const Eigen::Vector3d share (pcl_ops::drawUnit (generator_),
                                 pcl_ops::drawUnit (generator_),
                                 pcl_ops::drawUnit (generator_));
    add (scene, box.min() + share.cwiseProduct (box.sizes()), -1);
  }
}

/** \brief A floor of 4 m x 3 m with two walls of 2.5 m, some 18,000 points, and a
 * little clutter. With a millimetre of noise the normal of any one point is good enough
 * for a whole surface: nobody has to be lucky. */
inline Scene
room ()
{
  return Scene()
      .floor (4_m, 3_m)
      .wall ({0, 0}, {4, 0}, 2.5_m)
      .wall ({0, 0}, {0, 3}, 2.5_m)
      .noise (1_mm)
      .clutter (2_percent);
}

/** \brief What a depth camera at the origin, looking along z, sees of a floor 1 m below
 * it (y down) and a wall 3 m ahead: organized, with pixels that saw nothing as NaN. */
inline pcl::PointCloud<pcl::PointXYZ>::Ptr
roomSeenByCamera (std::uint32_t width, std::uint32_t height)
{
  constexpr float nothing = std::numeric_limits<float>::quiet_NaN();
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>> (width, height);
  cloud->is_dense = false;
  const float focal = 0.8f * static_cast<float> (width);
  for (std::uint32_t row = 0; row < height; ++row)
    for (std::uint32_t column = 0; column < width; ++column) {
      const float x = (static_cast<float> (column) - 0.5f * width) / focal;
      const float y = (static_cast<float> (row) - 0.5f * height) / focal;
      const float depth = y > 0.0f ? std::min (3.0f, 1.0f / y) : 3.0f;
      const bool lost = (row + column) % 10 == 0;
      cloud->at (column, row) = lost ? pcl::PointXYZ (nothing, nothing, nothing)
                                     : pcl::PointXYZ (x * depth, y * depth, depth);
    }
  return cloud;
}

/** \brief Angle between two directions, whatever their signs [rad]. */
inline double
angleBetween (const Eigen::Vector3d& first, const Eigen::Vector3d& second)
{
  return std::atan2 (first.cross (second).norm(), std::abs (first.dot (second)));
}

/** \brief The plane's normal is within \p angle of the truth's, and the plane passes
 * within \p offset of the truth's centre. */
inline void
expectPlaneNear (const pcl_ops::Plane& plane,
                 const Surface& truth,
                 double angle,
                 double offset)
{
  EXPECT_LE (angleBetween (plane.normal, truth.normal()), angle) << "normal [rad]";
  EXPECT_LE (std::abs (plane.distance (truth.centre())), offset) << "offset [m]";
}

/** \brief True if the plane is near enough to the surface to be it. */
inline bool
isNear (const pcl_ops::Plane& plane, const Surface& truth, double angle, double offset)
{
  return angleBetween (plane.normal, truth.normal()) <= angle &&
         std::abs (plane.distance (truth.centre())) <= offset;
}

/** \brief Every surface of the scene is one of the planes, with nine tenths of its
 * points, and there is no plane besides. */
inline void
expectFindsEverySurface (const std::vector<pcl_ops::PlaneSegment>& planes,
                         const LabelledScene& scene)
{
  EXPECT_EQ (planes.size(), scene.surfaces.size());
  for (std::size_t s = 0; s < scene.surfaces.size(); ++s) {
    const auto found =
        std::find_if (planes.begin(), planes.end(), [&] (const auto& plane) {
          return isNear (plane.plane(), scene.surfaces[s], 1_deg, 1_cm);
        });
    ASSERT_NE (found, planes.end()) << "surface " << s << " was not found";
    const auto label = static_cast<int> (s);
    const auto on_it = std::count_if (found->inliers.begin(),
                                      found->inliers.end(),
                                      [&] (int i) { return scene.labels[i] == label; });
    const auto all = std::count (scene.labels.begin(), scene.labels.end(), label);
    EXPECT_GE (on_it, 0.9 * all) << "points of surface " << s;
  }
}
