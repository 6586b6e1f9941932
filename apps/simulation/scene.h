// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include <numbers/random.h>
#include <pcl_ops/plane.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops::simulation {

using apps::pi;
using apps::Random;

/** \brief What random numbers are for. Each purpose has its own stream, so that a seed
 * gives the same scene whatever the camera and the noise. */
enum class Purpose : std::uint32_t {
  Room = 1,
  CameraPose,
  DepthNoise,
  DenseScan,
  Survey,
  SurveyScan,
  Shapes,
  ShapesScan,
  Corner,
  Town,
  Walk,
  PoseError,
  Street,
  SensorPose,
  LidarNoise,
  Drive
};

inline Random
randomFor (Purpose purpose, std::uint32_t seed)
{
  return Random (std::seed_seq{seed, std::uint32_t (purpose)});
}

inline Eigen::Isometry3d
at (double x, double y, double z)
{
  return Eigen::Isometry3d (Eigen::Translation3d (x, y, z));
}

/** \brief A turn about the axis x (0), y (1) or z (2) by an angle [rad]. */
template <int axis>
Eigen::Isometry3d
turn (double angle)
{
  return Eigen::Isometry3d (Eigen::AngleAxisd (angle, Eigen::Vector3d::Unit (axis)));
}

constexpr auto turnX = turn<0>, turnY = turn<1>, turnZ = turn<2>;

/** \brief Identity of a flat surface, from 1; rectangles that are pieces of the same
 * surface share it. */
using SurfaceId = std::uint32_t;

/** \brief Not a plane: round things, and strips too narrow to be called a surface. */
constexpr SurfaceId no_surface = 0;

/** \brief A rectangle seen from both sides, a sphere, or a closed cylinder along u. */
struct Shape {
  enum class Kind { Rectangle, Sphere, Cylinder };
  Kind kind = Kind::Rectangle;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d u = Eigen::Vector3d::UnitX(), v = Eigen::Vector3d::UnitY();
  /** \brief Half the edges; half_v is the radius of what is round. */
  double half_u = 0.5, half_v = 0.5;
  SurfaceId surface = no_surface;

  Eigen::Vector3d
  normal () const
  {
    return u.cross (v);
  }

  Plane
  plane () const
  {
    return planeThrough (center, normal());
  }

  /** \brief Without the ends of a cylinder. */
  double
  area () const;
};

/** \brief Around a shape; of that name because Eigen's tree asks for it. */
Eigen::AlignedBox3d
bounding_box (const Shape& shape);

/** \brief A rectangle along the axes \p u and \p v of its frame (0: x, 1: y, 2: z). */
Shape
rectangleAlong (
    int u, int v, const Eigen::Vector3d& center, double half_u, double half_v);

/** \brief A piece of furniture or the shell of a room; its surfaces are numbered from 1
 * within the body. */
struct Body {
  std::vector<Shape> shapes;
  SurfaceId surface_count = 0;
  /** \brief What is narrower is not called a plane [m]: in most scenes the edges of
   * boards, below the distance threshold of the paper. */
  double narrowest_surface = 0.05;
};

/** \brief Adds a rectangle with a surface of its own, or \ref no_surface if it is
 * narrower than \ref Body::narrowest_surface. */
void
addSurface (Body& body, const Shape& rectangle);

void
addSphere (Body& body, const Eigen::Vector3d& center, double radius);

void
addCylinder (Body& body,
             const Eigen::Vector3d& center,
             const Eigen::Vector3d& axis,
             double half_length,
             double radius);

/** \brief An upright cylinder on \p foot. */
void
addPole (Body& body, const Eigen::Vector3d& foot, double height, double radius);

/** \brief The faces of a box that are left out because nothing can see them. */
enum class HiddenFace { None, Bottom, BottomAndTop };

/** \brief Adds the faces of a box.
 * \param[in] pose from the frame of the box, zero at its center, to that of the body */
void
addBox (Body& body,
        const Eigen::Isometry3d& pose,
        const Eigen::Vector3d& size,
        HiddenFace hidden = HiddenFace::None);

/** \brief A rectangle in a wall's frame: x along it, z up, y < 0 behind it [m]. */
struct WallRange {
  double left, right, bottom, top;

  Shape
  at (double y) const
  {
    return rectangleAlong (0,
                           2,
                           {0.5 * (left + right), y, 0.5 * (bottom + top)},
                           0.5 * (right - left),
                           0.5 * (top - bottom));
  }
};

/** \brief Adds a wall around a hole, one surface, with the hole's back and sides. */
void
addWallAround (Body& body, const WallRange& wall, const WallRange& hole, double depth);

/** \brief Gives rectangles in one plane the surface of the first of them. */
void
joinCoplanar (Body& body);

/** \brief Adds all shapes of \p part, moved by \p pose, with surfaces of their own. */
void
addPart (Body& body, const Body& part, const Eigen::Isometry3d& pose);

/** \brief Everything a sensor can see. */
struct Scene {
  std::vector<Body> bodies;
  SurfaceId surface_count = 0;
};

/** \brief Adds a body; its surfaces get the scene's next identities. */
void
addBody (Scene& scene, const Body& body, const Eigen::Isometry3d& pose);

/** \brief The plane of each surface, surface 1 first. */
std::vector<Plane>
surfacePlanes (const Scene& scene);

/** \brief Where a ray meets a scene: at origin + distance * direction, if anywhere. */
struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  SurfaceId surface = no_surface;
};

/** \brief All shapes of a scene in Eigen's hierarchy of bounding volumes. */
using ShapeTree = Eigen::KdBVH<double, 3, Shape>;

ShapeTree
treeOf (const Scene& scene);

Hit
castRay (const ShapeTree& shapes,
         const Eigen::Vector3d& origin,
         const Eigen::Vector3d& direction);

} // namespace pcl_ops::simulation
