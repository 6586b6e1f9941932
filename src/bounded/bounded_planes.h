// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cell_grid.h>
#include <pcl_ops/oriented_cells.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_assignment.h>
#include <pcl_ops/plane_merging.h>
#include <pcl_ops/random.h>

#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief What a cell may lie off a plane and still be on it. */
struct CellInlierParameters {
  /** \brief theta_h: largest distance to a plane [m]; 0: two cells. */
  double distance_threshold = 0.0;
  /** \brief Distance in units of the noise measured around the cell. */
  double noise_factor = 3.0;
  /** \brief Largest angle between a cell's normal and the plane's [rad]; 30 degrees. */
  double angle_threshold = 0.52359877559829882;
  /** \brief Largest rms angle between the normals of a plane's cells and its own [rad];
   * more, and the surface is curved. */
  double largest_normal_spread = 0.13;
  /** \brief What noise may add to it, in units of the cells' mean thickness [rad]. */
  double spread_of_thickness = 0.6;
  /** \brief Cells thicker than this (see CellNormal::thickness) support no plane. */
  double largest_thickness = 0.3;
};

/** \brief One-point RANSAC on the oriented samples of a grid. */
struct CellRansacParameters {
  CellInlierParameters inlier;
  /** \brief theta_N: a plane needs at least this many connected cells. */
  std::size_t min_inliers = 20;
  /** \brief p: probability that one of the draws is an inlier of the largest plane. */
  double probability = 0.99;
};

/** \brief Planes with the cells that support them: what bounds each to its surface. */
struct CellPlanes {
  std::vector<Plane> planes;
  /** \brief Plane of each cell, or no_plane. */
  Labels plane_of_cell;
  /** \brief Noise around each cell of a plane [m]. */
  std::vector<double> noise;
};

/** \brief Finds planes among the cells of a grid that have none by one-point RANSAC on
 * its oriented cells: largest planes first, cells weigh as much as their points,
 * normals are compared too; refits the winner while its support grows, and keeps the
 * connected parts of its support that are large enough.
 * \param[in] grid the cells
 * \param[in] normals the oriented sample of each cell, or nothing
 * \param[in] parameters thresholds and the probability of success
 * \param[in,out] generator draws the hypotheses
 * \param[in,out] planes those found before, empty at first; new ones are added */
void
extractCellPlanes (const CellGrid& grid,
                   const std::vector<std::optional<CellNormal>>& normals,
                   const CellRansacParameters& parameters,
                   RandomGenerator& generator,
                   CellPlanes& planes);

/** \brief Measures the noise around each cell of a plane: the rms distance to the plane
 * of the points of the cells around that are on it.
 * \param[in] grid the cells
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \param[in,out] planes whose noise is set */
void
measureNoise (const CellGrid& grid, unsigned threads, CellPlanes& planes);

/** \brief Lets planes grow into cells without a plane that touch their support, as long
 * as the rms distance of the cell's points is below a multiple of the noise next to it.
 */
struct GrowingParameters {
  /** \brief The multiple of the noise. */
  double noise_factor = 2.0;
  /** \brief theta_h: largest rms distance [m]; 0: two cells. */
  double distance_threshold = 0.0;
  /** \brief Cells a plane may grow by. */
  int rounds = 10;
};

void
growPlanes (const CellGrid& grid,
            const GrowingParameters& parameters,
            unsigned threads,
            CellPlanes& planes);

/** \brief Gives planes to a larger neighbour that explains them: whose plane their
 * points are no farther from than a multiple of the noise on its side of the border. */
void
absorbPlanes (const CellGrid& grid, double noise_factor, CellPlanes& planes);

/** \brief Hands every cell to the nearest of its own plane and those of its neighbours,
 * and refits all planes. */
void
reassignCells (const CellGrid& grid, unsigned threads, CellPlanes& planes);

/** \brief Keeps coplanar surfaces apart: connected parts of a plane become planes of
 * their own where the sensor looked through between them; where something stood in
 * front they stay one.
 * \param[in] grid the cells
 * \param[in] viewpoint of the sensor in the frame of the grid
 * \param[in] least_cells parts of fewer cells stay with their plane
 * \param[in,out] planes each gives its parts away; new ones are added */
void
separateSurfaces (const CellGrid& grid,
                  const Eigen::Vector3d& viewpoint,
                  std::size_t least_cells,
                  CellPlanes& planes);

/** \brief Moments of each plane's cells. */
std::vector<Moments>
momentsOfPlanes (const CellGrid& grid, const CellPlanes& planes);

/** \brief Replaces planes by those they were merged into. */
void
renumberPlanes (const MergedPlanes& merged, CellPlanes& planes);

/** \brief How points are assigned to bounded planes. */
struct BoundedAssignmentParameters {
  /** \brief Largest distance in units of the noise measured there. */
  double noise_factor = 4.0;
  /** \brief theta_h: largest distance [m]; 0: two cells. */
  double distance_threshold = 0.0;
};

/** \brief Points with their planes, and the planes' moments. */
struct AssignedPoints {
  /** \brief Plane of each point, or no_plane. */
  Labels labels;
  /** \brief Moments of the points of each plane about the zero of their frame. */
  std::vector<Moments> moments;
};

/** \brief Assigns points to bounded planes: to the nearest, in units of the noise
 * measured there, of the planes whose support has a cell within one cell of the point.
 */
AssignedPoints
assignToBoundedPlanes (const Coordinates& positions,
                       const GriddedPoints& gridded,
                       const CellPlanes& planes,
                       const BoundedAssignmentParameters& parameters,
                       unsigned threads);

} // namespace pcl_ops
