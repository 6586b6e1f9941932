// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "depth_camera.h"

namespace pcl_ops::simulation {

enum class NoiseProfile {
  /** \brief Every reading exact. */
  None,
  /** \brief A structured light camera's depth after smoothing: neighbouring pixels err
   * alike. */
  Correlated,
  /** \brief The same camera's raw depth: each pixel errs by itself and the disparity
   * comes in steps of 1/8 px. */
  Raw
};

struct NoiseParameters {
  NoiseProfile profile = NoiseProfile::Correlated;
  /** \brief Factor on all noise; 1 as measured on a Kinect, 0 none at all. */
  double scale = 1.0;
  /** \brief Filter of the correlated profile's noise, see \ref drawSmoothField [px]. */
  double smoothing = 3.0;
  /** \brief Standard deviation of the rays' wandering along each image axis [px]: the
   * edge noise Nguyen et al. measured. */
  double lateral_sigma = 0.8;

  bool
  isNone () const
  {
    return profile == NoiseProfile::None || scale <= 0.0;
  }
};

/** \brief Standard deviation of a Kinect's depth [m] at a depth [m]: Nguyen, Izadi &
 * Lovell, "Modeling Kinect Sensor Noise for Improved 3D Reconstruction and Tracking",
 * 3DIMPVT 2012, for surfaces seen at up to 60 degrees. */
double
axialSigma (double depth);

/** \brief The depths a camera measures: rays wander sideways, depths are noisy, pixels
 * at depth edges fly between the two sides or are lost, as is what is out of range.
 * Flying pixels are on no surface.
 * \param[in] scene what is seen
 * \param[in] camera from where
 * \param[in] noise profile and strength
 * \param[in] seed the same seed gives the same image */
DepthImage
measureDepth (const Scene& scene,
              const DepthCamera& camera,
              const NoiseParameters& noise,
              std::uint32_t seed);

} // namespace pcl_ops::simulation
