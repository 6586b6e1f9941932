// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <array>
#include <functional>
#include <string>

namespace pcl_ops::simulation {

/** Of a Kinect's depth image of 640 columns [px]. */
constexpr double kinect_focal_length = 525.0;

/** Its axes: x right, y down, z forward. */
struct DepthCamera {
  int width = 640, height = 480;

  /** Of length 1 along z. */
  Vector3d
  ray (double column, double row) const
  {
    // [px]: the field of view is a Kinect's whatever the width.
    const double focal_length = kinect_focal_length * width / 640.0;
    return {(column - 0.5 * (width - 1)) / focal_length,
            (row - 0.5 * (height - 1)) / focal_length,
            1.0};
  }
};

/** A number for each pixel. */
using Field = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct DepthImage {
  Field depth; // along the camera's z axis [m]; infinite: nothing
  std::vector<SurfaceId> surface;
};

/** How many columns and rows beside its place each pixel looks: this frays the edges,
 * while the depth is that of the surface it sees at the pixel's place. */
using Jitter = std::array<Field, 2>;

DepthImage
castDepthImage (const Scene& scene,
                const DepthCamera& camera,
                const Isometry3d& pose,
                const Jitter& jitter = {});

/** A scene from the pose of a sensor. */
struct View {
  const Scene& scene;
  Isometry3d pose;
  Seed seed; // of the noise
};

struct CameraNoise {
  /** Factor on all noise; 1 as measured on a Kinect, 0 none at all. */
  double scale = 1.0;
  /** Each pixel errs by itself and the disparity comes in steps of 1/8 px; else the
   * depth is smoothed: neighboring pixels err alike. */
  bool is_raw = false;
  /** Standard deviation s of the Gaussian filter of smoothed depth [px]: at a distance
   * d the correlation is exp (-d^2 / (4 s^2)). */
  double smoothing = 3.0;
  /** q if a smoothed depth is q / n with a whole number n, so that at a depth z it
   * comes in steps of z^2 / q; 0: as it is [m]. */
  double quantization = 0.0;
};

/** Of a Kinect, by the seed: steps of 6.5 to 8 cm at 5 m. */
double
drawQuantization (Seed seed);

/** One point for each pixel; none where its depth is out of range. */
Scan
toScan (DepthImage image, const DepthCamera& camera);

/** Rays wander sideways, depths are noisy, pixels at depth edges fly between the two
 * sides, on no surface, or are lost, as is what is out of range. */
Scan
scanByCamera (const View& view, const DepthCamera& camera, const CameraNoise& noise);

/** Standard deviation of a lidar's distances [m]. */
constexpr double lidar_sigma = 0.02;

/** A lidar in its axes: x forward, y left, z up. It sends some beams at once, one above
 * the other, highest first, and so around clockwise; or with \ref beams 1 a single one
 * along a rosette whose gaps the next scans fill. */
struct Lidar {
  const char* name;
  int beams, steps;       // how many at once, and how often in a scan
  double highest, lowest; // elevations of the outer beams or the edge [degree]
  double farthest;        // readings beyond are lost [m]
  /** Most beams are within 6 degrees of the level; else they are equally far apart. */
  bool is_dense_at_level = false;

  bool
  isRosette () const
  {
    return beams == 1;
  }

  /** Of a rotating lidar's beam, the highest first [degree]. */
  double
  elevation (int beam) const;
};

/** Like a Velodyne HDL-64E, HDL-32E, VLP-16, a Hesai Pandar64 and a Livox Avia. */
constexpr Lidar known_lidars[] = {
    {"lidar-64", 64, 1900, 2.0, -24.8, 120.0},
    {"lidar-32", 32, 1080, 10.0, -30.0, 100.0},
    {"lidar-16", 16, 1800, 15.0, -15.0, 100.0},
    {"lidar-64-level", 64, 1800, 15.0, -25.0, 130.0, true},
    {"livox", 1, 100'000, 35.0, -35.0, 120.0}};

/** That of a name; of another one the last. */
Lidar
lidarOf (const std::string& name);

/** What a ray in the sensor's frame meets. */
using CastRay = std::function<Hit (const Vector3d& ray)>;

/** \param[in] seed of the noise
 * \param[in] number of the scan: a rosette goes on where the last scan ended */
Scan
scanAround (const CastRay& cast,
            const Lidar& lidar,
            double noise,
            Seed seed,
            std::size_t number = 0);

Scan
scanAround (const View& view, const Lidar& lidar, double noise, std::size_t number = 0);

} // namespace pcl_ops::simulation
