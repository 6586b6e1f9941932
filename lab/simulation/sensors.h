// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simulated_cloud.h"

#include <array>
#include <functional>
#include <string>

namespace pcl_ops::simulation {

/** Number of columns of a Kinect's depth image. */
constexpr double kinect_columns = 640.0;
/** Focal length of a Kinect's depth camera [px]. */
constexpr double kinect_focal_length = 525.0;

/** A pinhole camera with the axes x right, y down, z forward. */
struct DepthCamera {
  int width = 640, height = 480; // of the image [px]

  /** Returns the direction of a pixel's ray in the camera's frame, scaled to z = 1, so
   * that Hit::distance is a depth.
   * \param[in] column, row of the pixel; they may lie between pixels */
  Vector3d
  ray (double column, double row) const
  {
    // In pixels of this image: an image of any width spans a Kinect's field of view.
    const double focal_length = kinect_focal_length * width / kinect_columns;
    return {(column - 0.5 * (width - 1)) / focal_length,
            (row - 0.5 * (height - 1)) / focal_length,
            1.0};
  }
};

/** A number for each pixel, by row and column. */
using Field = Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct DepthImage {
  Field depth;                    // along the camera's z axis [m]; infinite: no hit
  std::vector<SurfaceId> surface; // of each pixel, row by row
};

/** For each pixel, how far the ray that is cast for it is off in columns (index 0) and
 * in rows (index 1) [px]; empty fields: rays are exact. */
using Jitter = std::array<Field, 2>;

/** Casts a ray for each pixel. With jitter, the ray finds the surface of the pixel, so
 * that depth edges are ragged; the depth is that of the plane of this surface on the
 * exact ray. For \ref no_surface, and where the surface is seen at a grazing angle, it
 * is the depth on the ray that was cast.
 * \param[in] pose of the camera in the scene */
DepthImage
castDepthImage (const Scene& scene,
                const DepthCamera& camera,
                const Isometry3d& pose,
                const Jitter& jitter = {});

/** A scene and the pose of a sensor in it. */
struct View {
  const Scene& scene;
  Isometry3d pose;
  Seed seed; // of the noise
};

/** The errors of a depth camera. */
struct CameraNoise {
  /** Factor on all noise; 1: as measured on a Kinect, 0: no noise. */
  double scale = 1.0;
  /** True: errors of pixels are independent, and disparity has steps of 1/8 px. False:
   * depth is smoothed, and errors of neighboring pixels are correlated. */
  bool is_raw = false;
  /** Standard deviation s of the Gaussian filter of smoothed depth [px]: at a distance
   * d the correlation is exp (-d^2 / (4 s^2)). */
  double smoothing = 3.0;
  /** Above 0: each smoothed depth z is rounded to the nearest quantization / n, where n
   * is an integer; so the steps of depth are z^2 / quantization [m]. 0: no steps. */
  double quantization = 0.0;
};

/** Draws \ref CameraNoise::quantization of a Kinect [m]: its depth has steps of 6.5 to
 * 8 cm at 5 m. */
double
drawQuantization (Seed seed);

/** Returns one point per pixel; NaN where the depth is outside 0.5 to 8 m. */
Scan
toScan (DepthImage image, const DepthCamera& camera);

/** Simulates a depth image with noise of ray directions and of depths. Some pixels at
 * depth edges get a depth between the two sides and no surface (flying pixels), others
 * are lost. Depths out of range are lost as well. */
Scan
scanByCamera (const View& view, const DepthCamera& camera, const CameraNoise& noise);

/** Standard deviation of a lidar's distances [m]. */
constexpr double lidar_sigma = 0.02;

/** A lidar with the axes x forward, y left, z up. A rotating lidar casts a column of
 * beams at once, the highest first, and turns clockwise. With \ref beams 1, a single
 * beam follows a rosette, whose gaps the next scans fill. */
struct Lidar {
  const char* name;
  int beams;       // number of rays that are cast at once; 1: a rosette
  int steps;       // number of times that they are cast in a scan
  double highest;  // elevation of the highest beam, or of the rosette's top [degree]
  double lowest;   // elevation of the lowest beam, or of the rosette's bottom [degree]
  double farthest; // readings at larger distances are lost [m]
  /** True: the 64 elevations of a Hesai Pandar64, most of them within 6 degrees of
   * horizontal. False: equal spacing from \ref highest to \ref lowest. */
  bool is_dense_at_level = false;

  bool
  isRosette () const
  {
    return beams == 1;
  }

  /** Returns the elevation of a beam of a rotating lidar [degree].
   * \param[in] beam 0 is the highest */
  double
  elevation (int beam) const;
};

/** In this order, like a Velodyne HDL-64E, HDL-32E, VLP-16, a Hesai Pandar64 and a
 * Livox Avia. */
constexpr Lidar known_lidars[] = {
    {"lidar-64", 64, 1900, 2.0, -24.8, 120.0},
    {"lidar-32", 32, 1080, 10.0, -30.0, 100.0},
    {"lidar-16", 16, 1800, 15.0, -15.0, 100.0},
    {"lidar-64-level", 64, 1800, 15.0, -25.0, 130.0, true},
    {"livox", 1, 100'000, 35.0, -35.0, 120.0}};

/** Returns the known lidar of a name; the last one if the name is unknown. */
Lidar
lidarOf (const std::string& name);

/** A function that returns the nearest hit of a ray from the sensor.
 * \param[in] ray of length 1, in the sensor's frame */
using CastRay = std::function<Hit (const Vector3d& ray)>;

/** Simulates a scan; rays without a hit in range have NaN points.
 * \param[in] noise factor on \ref lidar_sigma
 * \param[in] seed of the noise
 * \param[in] scan_number from 0 on: the rosette of a scan continues where that of the
 * scan before ended */
Scan
scanAround (const CastRay& cast,
            const Lidar& lidar,
            double noise,
            Seed seed,
            std::size_t scan_number = 0);

/** Simulates a scan of a scene, as the function above. */
Scan
scanAround (const View& view,
            const Lidar& lidar,
            double noise,
            std::size_t scan_number = 0);

} // namespace pcl_ops::simulation
