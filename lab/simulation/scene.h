// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

#include <numbers/random.h>
#include <pcl_ops/plane.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops::simulation {

using apps::pi;
using apps::Random;
using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

using Seed = std::uint32_t;

/** Each has random numbers of its own, so that a seed gives the same scene whatever the
 * camera and the noise. */
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
  Drive,
  Quantization,
  Missing,
  Airborne,
  AirborneScan,
  HillyStreet,
  Bushes,
  Table,
  TableNoise,
  Plaster,
  PlasterScan,
  Slabs,
  PointsOfSlabs,
  SlabsScan,
  Story
};

inline Random
randomFor (Purpose purpose, Seed seed)
{
  return Random (std::seed_seq{seed, std::uint32_t (purpose)});
}

/** Of equal chance for each octave. */
inline double
drawLogUniform (double lowest, double highest, Random& random)
{
  return lowest * std::pow (highest / lowest, random.unit());
}

inline Isometry3d
at (const Vector3d& place)
{
  return Isometry3d (Eigen::Translation3d (place));
}

/** A turn about the axis x (0), y (1) or z (2) by an angle [rad]. */
template <int axis>
Isometry3d
turn (double angle)
{
  return Isometry3d (Eigen::AngleAxisd (angle, Vector3d::Unit (axis)));
}

constexpr auto turnX = turn<0>, turnY = turn<1>, turnZ = turn<2>;

/** From the sensor's frame to that of the scene. */
using Poses = std::vector<Isometry3d>;

/** From 1; rectangles that are pieces of one flat surface share it. */
using SurfaceId = std::uint32_t;

/** Not a plane: round things, and strips too narrow to be called a surface. */
constexpr SurfaceId no_surface = 0;

/** A rectangle seen from both sides, a sphere, or a cylinder along u. Rays meet no
 * other shapes: a dome, the top of a sphere; a cone about an upright axis, without its
 * base; a torus about one. */
struct Shape {
  enum class Kind { Rectangle, Sphere, Cylinder, Dome, Cone, Torus };
  Kind kind = Kind::Rectangle;
  /** Of a dome its sphere's, of a cone its apex. */
  Vector3d center = Vector3d::Zero();
  Vector3d u = Vector3d::UnitX(), v = Vector3d::UnitY();
  /** Half the edges [m]. Of what is round half_v is the radius (of a cone of its base,
   * of a torus of its ring), half_u the height of a dome or a cone, and half that of a
   * cylinder or a torus. */
  double half_u = 0.5, half_v = 0.5;
  SurfaceId surface = no_surface;
  /** Part of a turn that there is of a cylinder, cone or torus about an upright axis,
   * around +y from there. */
  double share = 1.0;

  Vector3d
  normal () const
  {
    return u.cross (v);
  }

  Plane
  plane () const
  {
    return planeThrough (center, normal());
  }

  /** Without the ends of a cylinder. */
  double
  area () const
  {
    return share * (kind == Kind::Rectangle  ? 4.0 * half_u * half_v
                    : kind == Kind::Sphere   ? 4.0 * pi * half_v * half_v
                    : kind == Kind::Cylinder ? 4.0 * pi * half_v * half_u
                    : kind == Kind::Dome     ? 2.0 * pi * half_v * half_u
                    : kind == Kind::Cone     ? pi * half_v * std::hypot (half_v, half_u)
                                             : 4.0 * pi * pi * half_v * half_u);
  }
};

using Shapes = std::vector<Shape>;

/** Eigen's tree asks for this name. */
Eigen::AlignedBox3d
bounding_box (const Shape& shape);

/** With edges at right angles. */
Shape
makeRectangle (const Vector3d& center, const Vector3d& edge_u, const Vector3d& edge_v);

/** A rectangle in a wall's frame: x along it, z up, y < 0 behind it [m]. */
struct WallRange {
  double left, right, bottom, top;

  Shape
  at (double y) const
  {
    return makeRectangle ({0.5 * (left + right), y, 0.5 * (bottom + top)},
                          (right - left) * Vector3d::UnitX(),
                          (top - bottom) * Vector3d::UnitZ());
  }
};

/** The faces of a box that are left out because nothing can see them. */
enum class HiddenFace { None, Bottom, BottomAndTop };

/** A piece of furniture or the shell of a room, with its surfaces numbered from 1. */
struct Body {
  /** Extent of furniture on the floor along x and y [m]. */
  Vector2d footprint = Vector2d::Zero();
  Shapes shapes = {};
  SurfaceId surface_count = 0;
  /** What is narrower is called no plane [m]: usually the edges of boards. */
  double narrowest_surface = 0.05;

  /** Adds a rectangle with a surface of its own, unless it is too narrow. */
  void
  addSurface (const Shape& rectangle);

  /** From the middle of one edge to that of the opposite one. */
  void
  addFace (const Vector3d& from, const Vector3d& to, const Vector3d& edge)
  {
    addSurface (makeRectangle (0.5 * (from + to), edge, to - from));
  }

  void
  addSphere (const Vector3d& center, double radius)
  {
    shapes.push_back ({Shape::Kind::Sphere, center});
    shapes.back().half_v = radius;
  }

  /** \param[in] axis of length 1 */
  void
  addCylinder (const Vector3d& center, const Vector3d& axis, double half, double radius)
  {
    shapes.push_back (
        {Shape::Kind::Cylinder, center, axis, Vector3d::Zero(), half, radius});
  }

  /** An upright cylinder on \p foot. */
  void
  addPole (const Vector3d& foot, double height, double radius)
  {
    const Vector3d up = Vector3d::UnitZ();
    addCylinder (foot + 0.5 * height * up, up, 0.5 * height, radius);
  }

  /** Around the origin of the pose. */
  void
  addBox (const Isometry3d& pose,
          const Vector3d& size,
          HiddenFace hidden = HiddenFace::None);

  /** Adds a wall around a hole, one surface, with the hole's back and sides. */
  void
  addWallAround (const WallRange& wall, const WallRange& hole, double depth);

  /** With surfaces of their own. */
  void
  addPart (const Body& part, const Isometry3d& pose);

  /** Gives rectangles in one plane the surface of the first of them. */
  void
  joinCoplanar ();
};

struct Scene {
  std::vector<Body> bodies;
  SurfaceId surface_count = 0;

  void
  add (const Body& body, const Isometry3d& pose)
  {
    Body& placed = bodies.emplace_back();
    placed.surface_count = surface_count;
    placed.addPart (body, pose);
    surface_count = placed.surface_count;
  }
};

/** That of surface 1 first. */
std::vector<Plane>
surfacePlanes (const Scene& scene);

/** At origin + distance * direction. */
struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  SurfaceId surface = no_surface;
};

using ShapeTree = Eigen::KdBVH<double, 3, Shape>;

ShapeTree
treeOf (const Scene& scene);

Hit
castRay (const ShapeTree& shapes, const Vector3d& origin, const Vector3d& direction);

} // namespace pcl_ops::simulation
