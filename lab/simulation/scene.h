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

/** Each purpose has its own stream of random numbers, so that a seed gives the same
 * scene with any camera and any noise. The values seed the streams: append new purposes
 * at the end, and never move or remove one, or all scenes after it change. */
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

/** Draws a number whose logarithm is uniform: each octave has equal probability. */
inline double
drawLogUniform (double lowest, double highest, Random& random)
{
  return lowest * std::pow (highest / lowest, random.unit());
}

/** Returns a shift of the origin to a position [m]. */
inline Isometry3d
at (const Vector3d& position)
{
  return Isometry3d (Eigen::Translation3d (position));
}

/** Returns a rotation about the axis x (0), y (1) or z (2) by an angle [rad]. */
template <int axis>
Isometry3d
turn (double angle)
{
  return Isometry3d (Eigen::AngleAxisd (angle, Vector3d::Unit (axis)));
}

constexpr auto turnX = turn<0>, turnY = turn<1>, turnZ = turn<2>;

/** Transforms from the frame of a sensor to that of the scene, one for each scan. */
using Poses = std::vector<Isometry3d>;

/** Number of a flat surface, from 1 on; all rectangles of a surface have its number. */
using SurfaceId = std::uint32_t;

/** The \ref SurfaceId of shapes that are on no true plane: round shapes and too narrow
 * rectangles. */
constexpr SurfaceId no_surface = 0;

/** A rectangle that is seen from both sides, or a round shape. A dome is the top of a
 * sphere; a cone has no base. Domes, cones and tori have an upright axis.
 * \ref castRay and \ref scanDensely support only the first three kinds. */
struct Shape {
  enum class Kind { Rectangle, Sphere, Cylinder, Dome, Cone, Torus };
  Kind kind = Kind::Rectangle;
  /** Center; of a dome the center of its sphere, of a cone the apex [m]. */
  Vector3d center = Vector3d::Zero();
  /** Unit vectors along the edges of a rectangle; u is the axis of a cylinder. */
  Vector3d u = Vector3d::UnitX(), v = Vector3d::UnitY();
  /** Lengths [m]:
   * - rectangle: half_u and half_v are half the edges
   * - sphere: half_v is the radius
   * - cylinder: half_u is half the length, half_v the radius
   * - dome: half_u is the height, half_v the radius of the sphere
   * - cone: half_u is the height, half_v the radius of the base
   * - torus: half_u is the radius of the tube, half_v the radius of the ring */
  double half_u = 0.5, half_v = 0.5;
  SurfaceId surface = no_surface;
  /** A cylinder, cone or torus about an upright axis may exist only in part: over this
   * share of a whole turn, centered on the direction +y of the scene from its axis;
   * Body::addPart does not turn it. \ref castRay takes it for whole. */
  double share = 1.0;

  /** Only rectangles have one. */
  Vector3d
  normal () const
  {
    return u.cross (v);
  }

  /** Only rectangles have one. */
  Plane
  plane () const
  {
    return planeThrough (center, normal());
  }

  /** \return [m^2]; of a cylinder without its ends */
  double
  area () const
  {
    return share * areaOfWholeTurn();
  }

private:
  double
  areaOfWholeTurn () const
  {
    switch (kind) {
    case Kind::Rectangle:
      return 4.0 * half_u * half_v;
    case Kind::Sphere:
      return 4.0 * pi * half_v * half_v;
    case Kind::Cylinder:
      return 4.0 * pi * half_v * half_u;
    case Kind::Dome:
      return 2.0 * pi * half_v * half_u;
    case Kind::Cone:
      return pi * half_v * std::hypot (half_v, half_u);
    case Kind::Torus:
      break;
    }
    return 4.0 * pi * pi * half_v * half_u;
  }
};

using Shapes = std::vector<Shape>;

/** A box around a rectangle, a sphere or a cylinder. Eigen::KdBVH looks for a function
 * of this name. */
Eigen::AlignedBox3d
bounding_box (const Shape& shape);

/** \param[in] edge_u, edge_v full edges, at right angles to each other [m] */
Shape
makeRectangle (const Vector3d& center, const Vector3d& edge_u, const Vector3d& edge_v);

/** A rectangle in a wall's frame, in which x is along the wall, z is up, and y < 0 is
 * behind the front of the wall: from x = left to x = right, and from z = bottom to
 * z = top [m]. */
struct WallRange {
  double left, right, bottom, top;

  /** \param[in] y of the rectangle [m] */
  Shape
  rectangleAt (double y) const
  {
    return makeRectangle ({0.5 * (left + right), y, 0.5 * (bottom + top)},
                          (right - left) * Vector3d::UnitX(),
                          (top - bottom) * Vector3d::UnitZ());
  }
};

/** Faces of a box that are left out because no sensor can see them. */
enum class HiddenFace { None, Bottom, BottomAndTop };

/** Shapes that are placed together in a scene, such as a piece of furniture, a house or
 * the shell of a room. Surfaces are numbered from 1; in a \ref Scene the numbers go on
 * from body to body. */
struct Body {
  /** Extent on the floor along x and y, for furniture [m]. */
  Vector2d footprint = Vector2d::Zero();
  Shapes shapes = {};
  SurfaceId surface_count = 0; // the largest number of a surface
  /** \ref addSurface gives a narrower rectangle no_surface [m]. By default the narrow
   * faces of boards are no surfaces. */
  double narrowest_surface = 0.05;

  /** Adds a rectangle as a new surface, or with no_surface if it is too narrow. */
  void
  addSurface (const Shape& rectangle);

  /** Adds a rectangle by \ref addSurface, given by two opposite edges.
   * \param[in] from, to middles of these edges
   * \param[in] edge vector from one end of each of these edges to its other end [m] */
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
  addCylinder (const Vector3d& center,
               const Vector3d& axis,
               double half_length,
               double radius)
  {
    shapes.push_back (
        {Shape::Kind::Cylinder, center, axis, Vector3d::Zero(), half_length, radius});
  }

  /** Adds an upright cylinder whose lower end has the center \p foot. */
  void
  addPole (const Vector3d& foot, double height, double radius)
  {
    const Vector3d up = Vector3d::UnitZ();
    addCylinder (foot + 0.5 * height * up, up, 0.5 * height, radius);
  }

  /** Adds the faces of a box, whose center is the origin of the pose and whose edges
   * are along its axes.
   * \param[in] size lengths of the edges [m] */
  void
  addBox (const Isometry3d& pose,
          const Vector3d& size,
          HiddenFace hidden = HiddenFace::None);

  /** Adds the wall around a hole as one surface, and the back and the four sides of the
   * hole as five more. The body's frame is that of the wall (\ref WallRange).
   * \param[in] depth from the front of the wall to the back of the hole [m] */
  void
  addWallAround (const WallRange& wall, const WallRange& hole, double depth);

  /** Adds the shapes of another body; its surfaces get new numbers.
   * \param[in] pose from the frame of the part to that of this body */
  void
  addPart (const Body& part, const Isometry3d& pose);

  /** Gives coplanar rectangles the surface number of the first one. The numbers of the
   * others are then unused; surface_count still counts them. */
  void
  joinCoplanar ();
};

struct Scene {
  std::vector<Body> bodies;
  SurfaceId surface_count = 0; // of all bodies

  /** \param[in] pose from the frame of the body to that of the scene */
  void
  add (const Body& body, const Isometry3d& pose)
  {
    Body& placed = bodies.emplace_back();
    // addPart() gives surfaces the numbers after this count.
    placed.surface_count = surface_count;
    placed.addPart (body, pose);
    surface_count = placed.surface_count;
  }
};

/** Returns the plane of surface i at index i - 1; a default plane for an unused number.
 */
std::vector<Plane>
surfacePlanes (const Scene& scene);

/** Where a ray hits a shape first: at origin + distance * direction. The direction may
 * have any length, so the distance is in units of this length. An infinite distance is
 * no hit. */
struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  SurfaceId surface = no_surface;
};

using ShapeTree = Eigen::KdBVH<double, 3, Shape>;

/** Returns a search tree of all shapes, for \ref castRay. */
ShapeTree
treeOf (const Scene& scene);

/** Returns the nearest hit of a ray.
 * \param[in] shapes rectangles, spheres and cylinders alone */
Hit
castRay (const ShapeTree& shapes, const Vector3d& origin, const Vector3d& direction);

} // namespace pcl_ops::simulation
