// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include <numbers/random.h>
#include <pcl_ops/plane.h>

#include <cstdint>
#include <limits>
#include <vector>

namespace pcl_ops::simulation {

using apps::pi;
using apps::Random;

/** \brief What a stream of random numbers is for. Each purpose has its own stream, so
 * that the same seed gives the same scene whatever the camera and the noise. All that
 * takes a seed gives the same again for the same seed. */
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

/** \brief A turn about an axis by an angle [rad]. */
inline Eigen::Isometry3d
turnX (double angle)
{
  return Eigen::Isometry3d (Eigen::AngleAxisd (angle, Eigen::Vector3d::UnitX()));
}

inline Eigen::Isometry3d
turnY (double angle)
{
  return Eigen::Isometry3d (Eigen::AngleAxisd (angle, Eigen::Vector3d::UnitY()));
}

inline Eigen::Isometry3d
turnZ (double angle)
{
  return Eigen::Isometry3d (Eigen::AngleAxisd (angle, Eigen::Vector3d::UnitZ()));
}

/** \brief Identity of a flat surface, from 1. Rectangles that are pieces of the same
 * physical surface share it. */
using SurfaceId = std::uint32_t;

/** \brief Not a plane: round things, and strips too narrow to be called a surface. */
constexpr SurfaceId no_surface = 0;

/** \brief A bounded piece of a plane, seen from both sides. */
struct Rectangle {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis_u = Eigen::Vector3d::UnitX();
  Eigen::Vector3d axis_v = Eigen::Vector3d::UnitY();
  double half_u = 0.5;
  double half_v = 0.5;
  SurfaceId surface = no_surface;

  Eigen::Vector3d
  normal () const
  {
    return axis_u.cross (axis_v);
  }

  double
  area () const
  {
    return 4.0 * half_u * half_v;
  }

  Plane
  plane () const
  {
    return planeThrough (center, normal());
  }
};

/** \brief A rectangle along the axes \p u and \p v of its frame (0: x, 1: y, 2: z). */
inline Rectangle
rectangleAlong (
    int u, int v, const Eigen::Vector3d& center, double half_u, double half_v)
{
  return {center, Eigen::Vector3d::Unit (u), Eigen::Vector3d::Unit (v), half_u, half_v};
}

struct Sphere {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.1;

  double
  area () const
  {
    return 4.0 * pi * radius * radius;
  }
};

/** \brief A closed cylinder. */
struct Cylinder {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();
  double half_length = 0.5;
  double radius = 0.1;

  /** \brief Of its side. */
  double
  area () const
  {
    return 4.0 * pi * radius * half_length;
  }
};

/** \brief A piece of furniture or the shell of a room: shapes that are placed together.
 * Its surfaces are numbered from 1 within the body. */
struct Body {
  std::vector<Rectangle> rectangles;
  std::vector<Sphere> spheres;
  std::vector<Cylinder> cylinders;
  SurfaceId surface_count = 0;
  /** \brief What is narrower is not called a plane [m]: in most scenes the edges of
   * boards, below the distance threshold of the paper. */
  double narrowest_surface = 0.05;
};

/** \brief Calls \p visit with each shape of a body. */
template <typename Visit>
void
forEachShape (const Body& body, const Visit& visit)
{
  for (const Rectangle& rectangle : body.rectangles)
    visit (rectangle);
  for (const Sphere& sphere : body.spheres)
    visit (sphere);
  for (const Cylinder& cylinder : body.cylinders)
    visit (cylinder);
}

/** \brief The surface of a shape, \ref no_surface of what is round. */
inline SurfaceId
surfaceOf (const Rectangle& rectangle)
{
  return rectangle.surface;
}

template <typename Shape>
SurfaceId
surfaceOf (const Shape&)
{
  return no_surface;
}

/** \brief Adds a rectangle with a surface of its own, or \ref no_surface if it is
 * narrower than \ref Body::narrowest_surface. */
void
addSurface (Body& body, const Rectangle& rectangle);

/** \brief The faces of a box that are left out because nothing can see them. */
enum class HiddenFace { None, Bottom, BottomAndTop };

/** \brief Adds the faces of a box.
 * \param[in,out] body takes the faces
 * \param[in] pose from the frame of the box, zero at its center, to that of the body
 * \param[in] size edge lengths [m]
 * \param[in] hidden the faces to leave out */
void
addBox (Body& body,
        const Eigen::Isometry3d& pose,
        const Eigen::Vector3d& size,
        HiddenFace hidden = HiddenFace::None);

/** \brief Gives rectangles of a body that are in one plane the surface of the first of
 * them. */
void
joinCoplanar (Body& body);

/** \brief Adds all shapes of \p part, moved by \p pose, with surfaces of their own. */
void
addPart (Body& body, const Body& part, const Eigen::Isometry3d& pose);

/** \brief Everything a sensor can see. */
struct Scene {
  std::vector<Body> bodies;
  /** \brief A sphere around each body, to skip it quickly. */
  std::vector<Sphere> bounds;
  SurfaceId surface_count = 0;
};

/** \brief Adds a body; its surfaces get the scene's next identities. */
void
addBody (Scene& scene, const Body& body, const Eigen::Isometry3d& pose);

/** \brief The same shapes and surfaces in bodies about as small as cubes of the given
 * edge [m], of which \ref castRay soon skips most. */
Scene
divided (const Scene& scene, double edge);

/** \brief The plane of each surface, surface 1 first. */
std::vector<Plane>
surfacePlanes (const Scene& scene);

/** \brief Where a ray meets a scene. */
struct Hit {
  /** \brief The point is origin + distance * direction; infinite if nothing is met. */
  double distance = std::numeric_limits<double>::infinity();
  SurfaceId surface = no_surface;
};

/** \brief The first point of the scene on a ray.
 * \param[in] origin start of the ray [m]
 * \param[in] direction of any length; the hit's distance is in multiples of it */
Hit
castRay (const Scene& scene,
         const Eigen::Vector3d& origin,
         const Eigen::Vector3d& direction);

} // namespace pcl_ops::simulation
