// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "leaves/leaf_cloud.h"
#include "voxel_scene.h"

/** \brief Leaves of 10 cm, and those of up to four times the edge, begin at whole
 * multiples of it from zero. */
constexpr int level_of_10_cm = 2;
constexpr double finest_cell = 10_cm / 4;

/** \brief Wide cells of a noise, as many points in a leaf of 10 cm as given; larger
 * ones hold four times as many a level. */
inline std::vector<pcl_ops::internal::CellScatter>
cellsOfNoise (double noise, double points_of_10_cm, int level, int number = 100)
{
  pcl_ops::internal::CellScatter cell;
  cell.level = level;
  cell.is_wide = true;
  cell.count = static_cast<std::uint32_t> (points_of_10_cm *
                                           std::pow (4.0, level - level_of_10_cm));
  cell.noise = static_cast<float> (noise);
  return std::vector<pcl_ops::internal::CellScatter> (number, cell);
}

/** \brief The same noise expected of planes of any size and density. */
inline pcl_ops::internal::ExpectedNoise
expectEverywhere (double noise)
{
  std::vector<pcl_ops::internal::CellScatter> cells;
  for (int level = level_of_10_cm; level < level_of_10_cm + 10; ++level) {
    const auto of_level = cellsOfNoise (noise, 36, level);
    cells.insert (cells.end(), of_level.begin(), of_level.end());
  }
  return {cells, finest_cell};
}

/** \brief Points in leaves, of 10 cm unless a test divides them otherwise, with planes.
 * Nothing is known of steps of their coordinates, though they are on grids. */
struct LeafScene {
  explicit LeafScene (const pcl_ops::internal::Coordinates& positions,
                      double expected_noise = 1_mm,
                      pcl_ops::internal::LeafSizes sizes = {2, 2, 0.0})
  : points (pcl_ops::internal::sortAlongCurve (positions, finest_cell, 1))
  , expected (expectEverywhere (expected_noise))
  , cloud (measured (pcl_ops::internal::divideIntoLeaves (
        points, sizes, {points, {}, level_of_10_cm})))
  {
    planes.plane_of_leaf.assign (cloud.size(), pcl_ops::no_plane);
    planes.noise.assign (cloud.size(), 0.0);
    planes.is_curved.assign (cloud.size(), 0);
  }
  LeafScene (const LeafScene&) = delete;
  LeafScene&
  operator= (const LeafScene&) = delete;

  /** \brief 120 x 120 points of each surface, moved along its normal by up to a noise
   * [m]: 36 in a leaf of a surface of 2 m x 2 m. */
  explicit LeafScene (const std::vector<Surface>& surfaces,
                      double noise = 0.0,
                      double expected_noise = 1_mm)
  : LeafScene (gridsOf (surfaces, 120, noise), expected_noise)
  {}

  pcl_ops::internal::LeafCloud
  measured (std::vector<pcl_ops::internal::Leaf> leaves) const
  {
    return pcl_ops::internal::measureLeaves (
        points,
        expected,
        pcl_ops::internal::CoordinateSteps (pcl_ops::internal::CurvePoints()),
        std::move (leaves),
        1);
  }

  /** \brief Adds a plane and puts all leaves on it whose centroids are such, each with
   * a noise. */
  template <typename IsSuch>
  void
  addPlane (const pcl_ops::Plane& plane, double noise, IsSuch&& isSuch)
  {
    planes.planes.push_back (plane);
    label (static_cast<std::int32_t> (planes.planes.size() - 1), noise, isSuch);
  }
  template <typename IsSuch>
  void
  addPlane (const Surface& surface, double noise, IsSuch&& isSuch)
  {
    addPlane (
        pcl_ops::planeThrough (surface.center(), surface.normal()), noise, isSuch);
  }

  /** \brief Puts leaves with such a centroid on a plane, or on no_plane. */
  template <typename IsSuch>
  void
  label (std::int32_t plane, double noise, IsSuch&& isSuch)
  {
    for (std::size_t leaf = 0; leaf < cloud.size(); ++leaf)
      if (isSuch (centroid (leaf))) {
        planes.plane_of_leaf[leaf] = plane;
        planes.noise[leaf] = plane == pcl_ops::no_plane ? 0.0 : noise;
      }
  }

  Eigen::Vector3d
  centroid (std::size_t leaf) const
  {
    return cloud.moments[leaf].centroid();
  }

  /** \brief The leaf with the centroid nearest to a place. */
  std::uint32_t
  leafAt (const Eigen::Vector3d& place) const
  {
    std::uint32_t nearest = 0;
    for (std::uint32_t leaf = 1; leaf < cloud.size(); ++leaf)
      if ((centroid (leaf) - place).norm() < (centroid (nearest) - place).norm())
        nearest = leaf;
    return nearest;
  }

  std::size_t
  leavesOn (std::int32_t plane) const
  {
    return static_cast<std::size_t> (
        std::count (planes.plane_of_leaf.begin(), planes.plane_of_leaf.end(), plane));
  }

  /** \brief Planes that have leaves. */
  std::size_t
  planesWithLeaves () const
  {
    std::size_t number = 0;
    for (std::size_t p = 0; p < planes.planes.size(); ++p)
      number += leavesOn (static_cast<std::int32_t> (p)) > 0;
    return number;
  }

  pcl_ops::internal::CurvePoints points;
  pcl_ops::internal::ExpectedNoise expected;
  pcl_ops::internal::LeafCloud cloud;
  pcl_ops::internal::LeafPlanes planes;
};

/** \brief For all leaves. */
inline bool
anywhere (const Eigen::Vector3d&)
{
  return true;
}

/** \brief Leaves before and behind a place along x. */
inline auto
before (double x)
{
  return [x] (const Eigen::Vector3d& at) { return at.x() < x; };
}
inline auto
behind (double x)
{
  return [x] (const Eigen::Vector3d& at) { return at.x() >= x; };
}

/** \brief 200 x 200 points above a square about zero.
 * \param[in] heightAt x and y, both from -half_edge to half_edge [m]
 * \param[in] noise each point is moved up or down by up to this much [m] */
template <typename Height>
pcl_ops::internal::Coordinates
pointsOver (double half_edge, double noise, Height&& heightAt)
{
  const Surface square{
      {-half_edge, -half_edge, 0}, {2 * half_edge, 0, 0}, {0, 2 * half_edge, 0}};
  pcl_ops::internal::Coordinates points = gridsOf ({square}, 200, noise);
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] += static_cast<float> (heightAt (points.x[i], points.y[i]));
  return points;
}

/** \brief A ground of 2 m x 2 m with 120 x 120 points whose leaves of 10 cm lie higher
 * and lower in turn by a height, where they are such. */
template <typename IsSuch>
pcl_ops::internal::Coordinates
checkerboard (double height, IsSuch&& isSuch)
{
  pcl_ops::internal::Coordinates points = gridsOf ({ground}, 120);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (isSuch (points[i])) {
      const int row = static_cast<int> (10.0f * points.x[i]);
      const int column = static_cast<int> (10.0f * points.y[i]);
      points.z[i] += static_cast<float> ((row + column) % 2 == 0 ? height : -height);
    }
  return points;
}
