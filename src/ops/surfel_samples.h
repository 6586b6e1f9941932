// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/float_plane.h"
#include "geometry/points.h"
#include "ops/one_point_ransac.h"
#include "ops/surfels.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::internal {

/** \brief Oriented voxels as arrays the compiler vectorizes. */
struct SurfelSamples {
  Coordinates centroids;
  Coordinates normals;
  /** \brief Largest distance of each to its plane [m]. */
  std::vector<float> bands;
  /** \brief Points in each; integers, whose sum the compiler may reorder. */
  std::vector<std::int32_t> weights;
  /** \brief Which voxel each is. */
  Indices voxels;

  std::size_t
  size () const
  {
    return bands.size();
  }

  void
  add (std::uint32_t voxel, const Moments& moments, const Surfel& normal, double band)
  {
    voxels.push_back (voxel);
    const Eigen::Vector3f c = moments.centroid().cast<float>();
    const Eigen::Vector3f n = normal.plane.normal.cast<float>();
    centroids.add (c.x(), c.y(), c.z());
    normals.add (n.x(), n.y(), n.z());
    bands.push_back (static_cast<float> (band));
    weights.push_back (static_cast<std::int32_t> (moments.count));
  }
};

/** \brief A plane and how much its surfels may lean against it. */
struct SurfelBand {
  FloatPlane plane;
  float smallest_cosine = 0.0f;
};

/** \brief Points and surfels on a plane: the loop RANSAC on surfels spends its time in.
 */
Vote
voteOf (const SurfelSamples& samples, const SurfelBand& band);

/** \brief The voxels whose surfels are on a plane, in the order of the samples. */
Indices
surfelsOn (const SurfelSamples& samples, const SurfelBand& band);

/** \brief Drops samples.
 * \param[in] is_kept per voxel */
void
keepOnly (const std::vector<char>& is_kept, SurfelSamples& samples);

} // namespace pcl_ops::internal
