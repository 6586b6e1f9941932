// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/oriented_cells.h>
#include <pcl_ops/points.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace pcl_ops {

/** \brief Oriented cells as arrays the compiler vectorizes. */
struct CellSamples {
  Coordinates centroids;
  Coordinates normals;
  /** \brief Largest distance of each to its plane [m]. */
  std::vector<float> bands;
  /** \brief Points in each; integers, whose sum the compiler may reorder. */
  std::vector<std::int32_t> weights;
  /** \brief Which cell each is. */
  Positions cells;

  std::size_t
  size () const
  {
    return bands.size();
  }

  void
  add (std::uint32_t cell,
       const Moments& moments,
       const CellNormal& normal,
       double band)
  {
    cells.push_back (cell);
    const Eigen::Vector3f c = moments.centroid().cast<float>();
    const Eigen::Vector3f n = normal.plane.normal.cast<float>();
    centroids.add (c.x(), c.y(), c.z());
    normals.add (n.x(), n.y(), n.z());
    bands.push_back (static_cast<float> (band));
    weights.push_back (static_cast<std::int32_t> (moments.count));
  }
};

struct SinglePlane {
  float nx, ny, nz, offset;
  float smallest_cosine;
};

struct Support {
  std::int32_t weight = 0;
  std::int32_t cells = 0;
};

inline bool
isInlier (const SinglePlane& plane,
          float x,
          float y,
          float z,
          float nx,
          float ny,
          float nz,
          float band)
{
  const float distance = plane.nx * x + plane.ny * y + plane.nz * z + plane.offset;
  const float cosine = plane.nx * nx + plane.ny * ny + plane.nz * nz;
  const int is_near = std::abs (distance) < band;
  const int is_parallel = std::abs (cosine) > plane.smallest_cosine;
  return (is_near & is_parallel) != 0;
}

/** \brief Points and cells on a plane: the loop RANSAC on cells spends its time in. */
Support
supportOf (const CellSamples& samples, const SinglePlane& plane);

/** \brief The cells on a plane, in the order of the samples. */
Positions
cellsOn (const CellSamples& samples, const SinglePlane& plane);

/** \brief Drops samples.
 * \param[in] is_kept per cell */
void
keepOnly (const std::vector<char>& is_kept, CellSamples& samples);

} // namespace pcl_ops
