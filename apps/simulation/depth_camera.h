// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <vector>

namespace pcl_ops::simulation {

/** \brief Of a Kinect's depth image of 640 columns [px]. */
constexpr double kinect_focal_length = 525.0;

/** \brief A pinhole depth camera in the room. Its axes: x right, y down, z forward. */
struct DepthCamera {
  int width = 640;
  int height = 480;

  /** \brief The ray of a pixel in the camera's frame, of length 1 along z. */
  Eigen::Vector3d
  ray (double column, double row) const
  {
    // [px]: the field of view is a Kinect's whatever the width.
    const double focal_length = kinect_focal_length * width / 640.0;
    return {(column - 0.5 * (width - 1)) / focal_length,
            (row - 0.5 * (height - 1)) / focal_length,
            1.0};
  }
};

/** \brief What the camera reads, row by row. */
struct DepthImage {
  int width = 0;
  int height = 0;
  /** \brief Distance along the camera's z axis [m]; infinite: no reading. */
  std::vector<double> depth;
  std::vector<SurfaceId> surface;
};

/** \brief Casts a ray through every pixel.
 * \param[in] offsets how far beside its place each pixel looks along the row and the
 * column [px]: this frays the edges, while the depth is that of the surface it sees at
 * the pixel's place; empty: edges are exact */
DepthImage
castDepthImage (const Scene& scene,
                const DepthCamera& camera,
                const Eigen::Isometry3d& pose,
                const std::vector<Eigen::Vector2d>& offsets = {});

struct CameraNoise {
  /** \brief Factor on all noise; 1 as measured on a Kinect, 0 none at all. */
  double scale = 1.0;
  /** \brief Each pixel errs by itself and the disparity comes in steps of 1/8 px; else
   * the depth is smoothed: neighboring pixels err alike. */
  bool is_raw = false;
  /** \brief Standard deviation s of the Gaussian filter of smoothed depth [px]: at a
   * distance d the correlation is exp (-d^2 / (4 s^2)). */
  double smoothing = 3.0;
};

/** \brief The depths a camera measures: rays wander sideways, depths are noisy, pixels
 * at depth edges fly between the two sides, on no surface, or are lost, as is what is
 * out of range. */
DepthImage
measureDepth (const Scene& scene,
              const DepthCamera& camera,
              const Eigen::Isometry3d& pose,
              const CameraNoise& noise,
              std::uint32_t seed);

/** \brief What \ref measureDepth gives as points in the camera's frame. */
Scan
scanByCamera (const Scene& scene,
              const DepthCamera& camera,
              const Eigen::Isometry3d& pose,
              const CameraNoise& noise,
              std::uint32_t seed);

} // namespace pcl_ops::simulation
