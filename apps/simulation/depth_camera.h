// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "room.h"

#include <cstdint>
#include <vector>

namespace pcl_ops::simulation {

/** \brief Of a Kinect's depth image of 640 columns [px]. */
constexpr double kinect_focal_length = 525.0;

/** \brief A pinhole depth camera in the room. Its axes: x right, y down, z forward. */
struct DepthCamera {
  int width = 640;
  int height = 480;
  /** \brief Readings outside are lost [m]. */
  double nearest = 0.5;
  double farthest = 8.0;
  /** \brief From the camera's frame to the room's. */
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();

  /** \brief Focal length [px]: the field of view is a Kinect's whatever the width. */
  double
  focalLength () const
  {
    return kinect_focal_length * width / 640.0;
  }

  /** \brief The ray of a pixel in the camera's frame, of length 1 along z. */
  Eigen::Vector3d
  ray (double column, double row) const
  {
    return {(column - 0.5 * (width - 1)) / focalLength(),
            (row - 0.5 * (height - 1)) / focalLength(),
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

/** \brief How far beside its place each pixel looks [px]: this frays the edges, while
 * the depth is that of the surface it sees at the pixel's place. Empty: edges are
 * exact. */
struct PixelOffsets {
  std::vector<double> column, row;
};

/** \brief Casts a ray through every pixel. */
DepthImage
castDepthImage (const Scene& scene,
                const DepthCamera& camera,
                const PixelOffsets& offsets = {});

/** \brief Number of surfaces well in view, none if something stands before the camera.
 */
int
countVisibleSurfaces (const Scene& scene, DepthCamera camera);

/** \brief Draws a pose at a person's height in the room, upright to a few degrees, that
 * sees many surfaces and has nothing just in front of it.
 * \param[in] room the room
 * \param[in] camera its image size and range count
 * \param[in] seed the same seed and room give the same pose whatever the image size */
Eigen::Isometry3d
drawCameraPose (const Room& room, const DepthCamera& camera, std::uint32_t seed);

} // namespace pcl_ops::simulation
