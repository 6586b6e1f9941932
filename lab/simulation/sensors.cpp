// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "sensors.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace pcl_ops::simulation {

namespace {

/** A depth camera loses readings outside this range of depth, ends included [m]. */
constexpr double min_depth = 0.5, max_depth = 8.0;
constexpr double no_reading = std::numeric_limits<double>::infinity();

/** Draws standard normal values, one per pixel. Unless the noise is raw, neighbors are
 * correlated: white noise is filtered by a Gaussian and scaled back to variance 1. */
Field
drawField (const DepthCamera& camera, const CameraNoise& noise, Random& random)
{
  // Of the filter [px]; beyond three standard deviations it is cut off.
  const int radius = noise.is_raw ? 0 : int (std::ceil (3.0 * noise.smoothing));
  Field field (camera.height + 2 * radius, camera.width + 2 * radius);
  std::generate_n (field.data(), field.size(), [&] { return random.gaussian(); });
  std::vector<double> kernel;
  double sum_of_squares = 0.0; // variance of white noise of variance 1 after the filter
  for (int i = -radius; i <= radius; ++i) {
    kernel.push_back (std::exp (-0.5 * i * i / (noise.smoothing * noise.smoothing)));
    sum_of_squares += kernel.back() * kernel.back();
  }
  // Two transpositions filter rows and columns, and restore their order.
  for (int axis = 0; axis < 2; ++axis) {
    const Field transposed = field.transpose();
    field = Field::Zero (transposed.rows() - 2 * radius, transposed.cols());
    for (int i = 0; i <= 2 * radius; ++i)
      field += kernel[std::size_t (i)] / std::sqrt (sum_of_squares) *
               transposed.middleRows (i, field.rows());
  }
  return field;
}

/** Returns the first of the four neighboring depths that differs from the depth of the
 * pixel as across an edge; nullopt if none does. */
std::optional<double>
depthBeyondEdge (const Field& depths, Eigen::Index row, Eigen::Index column)
{
  // Neighboring depths that differ by more, relative to the depth, are an edge; chosen
  // by hand.
  constexpr double edge_ratio = 0.05;
  // How far each neighbor is down and to the right.
  constexpr Eigen::Index neighbors[4][2] = {{0, 1}, {0, -1}, {1, 0}, {-1, 0}};
  const double here = depths (row, column);
  for (const auto& [down, right] : neighbors) {
    const Eigen::Index other_row = row + down;
    const Eigen::Index other_column = column + right;
    const bool is_outside = other_column < 0 || other_column >= depths.cols() ||
                            other_row < 0 || other_row >= depths.rows();
    if (is_outside)
      continue;
    const double other = depths (other_row, other_column);
    if (std::abs (other - here) > edge_ratio * std::min (other, here))
      return other;
  }
  return std::nullopt;
}

/** Moves some pixels at depth edges to a depth between the two sides of the edge
 * (flying pixels), and loses others. */
void
disturbEdges (DepthImage& image, const CameraNoise& noise, Random& random)
{
  // Shares of the pixels at depth edges, chosen by hand.
  constexpr double flying_share = 0.3;
  constexpr double lost_share = 0.2;
  const Field exact = image.depth;
  // Less noise than that of a Kinect makes flying and lost pixels rarer.
  const double strength = std::min (1.0, noise.scale);
  for (Eigen::Index row = 0; row < exact.rows(); ++row)
    for (Eigen::Index column = 0; column < exact.cols(); ++column) {
      const std::optional<double> other = depthBeyondEdge (exact, row, column);
      if (!other)
        continue;
      double& depth = image.depth (row, column);
      const double drawn = random.unit() / strength;
      if (drawn < flying_share) {
        depth += random.between (0.1, 0.9) * (*other - depth);
        image.surface[std::size_t (row * exact.cols() + column)] = no_surface;
      }
      else if (drawn < flying_share + lost_share)
        depth = no_reading;
    }
}

/** Adds flying and lost pixels, noise of depths and steps of depth. */
void
disturbDepths (DepthImage& image,
               const DepthCamera& camera,
               const CameraNoise& noise,
               Random& random)
{
  // Distance between a Kinect's projector and camera [m], and steps of disparity per
  // pixel: Khoshelham & Elberink, "Accuracy and Resolution of Kinect Depth Data",
  // Sensors 2012. An image of any size has the steps of the Kinect's own image.
  constexpr double baseline = 0.075;
  constexpr double disparity_steps = 8.0;
  constexpr double steps_times_depth = disparity_steps * kinect_focal_length * baseline;
  const double quantization = noise.is_raw ? steps_times_depth : noise.quantization;
  disturbEdges (image, noise, random);
  const Field field = drawField (camera, noise, random);
  for (Eigen::Index i = 0; i < field.size(); ++i) {
    double& depth = image.depth (i);
    // Nguyen, Izadi & Lovell, "Modeling Kinect Sensor Noise for Improved 3D
    // Reconstruction and Tracking", 3DIMPVT 2012, for surfaces seen at up to 60
    // degrees.
    const double sigma = 0.0012 + 0.0019 * (depth - 0.4) * (depth - 0.4); // [m]
    depth += noise.scale * sigma * field (i);
    if (quantization > 0.0 && depth > 0.0)
      depth = quantization / std::round (quantization / depth);
  }
}

/** Returns the direction of a beam of a rotating lidar.
 * \param[in] step number of the cast, from 0 at the front */
Vector3d
rotatingRay (const Lidar& lidar, int step, int beam)
{
  const double elevation = lidar.elevation (beam) * pi / 180.0;
  const double azimuth = -2.0 * pi * step / lidar.steps;
  return {std::cos (elevation) * std::cos (azimuth),
          std::cos (elevation) * std::sin (azimuth),
          std::sin (elevation)};
}

/** Returns the direction of a beam that passes two counter-rotating prisms. Each prism
 * deflects it by half of the largest deflection.
 * \param[in] ray number of the ray, from 0 on over all scans */
Vector3d
rosetteRay (const Lidar& lidar, std::size_t ray)
{
  // Turns of the prisms of a Livox Mid-40 [1/s], with which the rosette closes after
  // half a minute, and its rays.
  constexpr double turns_of_first = 7294.0 / 60.0;
  constexpr double turns_of_second = -4664.0 / 60.0;
  constexpr double rays_a_second = 1e5;
  const double time = double (ray) / rays_a_second;        // [s]
  const double first = 2.0 * pi * turns_of_first * time;   // angle of the prism [rad]
  const double second = 2.0 * pi * turns_of_second * time; // [rad]
  // The largest deflection is half of the field of view; each prism has half of it.
  const double by_prism = 0.25 * (lidar.highest - lidar.lowest) * pi / 180.0; // [rad]
  const double to_left = by_prism * (std::cos (first) + std::cos (second));   // [rad]
  const double upwards = by_prism * (std::sin (first) + std::sin (second));   // [rad]
  const double deflection = std::hypot (to_left, upwards);
  const double sine_ratio = deflection > 0.0 ? std::sin (deflection) / deflection : 1.0;
  return {std::cos (deflection), sine_ratio * to_left, sine_ratio * upwards};
}

} // namespace

DepthImage
castDepthImage (const Scene& scene,
                const DepthCamera& camera,
                const Isometry3d& pose,
                const Jitter& jitter)
{
  // Largest difference between the depths on the exact and on the jittered ray,
  // relative to the depth, chosen by hand. A larger one means a grazing view.
  constexpr double max_change = 0.1;
  DepthImage image{Field (camera.height, camera.width), {}};
  const std::vector<Plane> planes = surfacePlanes (scene);
  const ShapeTree shapes = treeOf (scene);
  const Vector3d eye = pose.translation();
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      const Vector3d ray = pose.linear() * camera.ray (column, row);
      Vector3d jittered = ray;
      if (jitter[0].size() > 0)
        jittered = pose.linear() * camera.ray (column + jitter[0](row, column),
                                               row + jitter[1](row, column));
      const Hit hit = castRay (shapes, eye, jittered);
      image.surface.push_back (hit.surface);
      double& depth = image.depth (row, column) = hit.distance;
      if (hit.surface == no_surface)
        continue;
      const Plane& plane = planes[hit.surface - 1];
      const double depth_on_exact_ray = -plane.distance (eye) / plane.normal.dot (ray);
      if (std::abs (depth_on_exact_ray - depth) < max_change * depth)
        depth = depth_on_exact_ray;
    }
  return image;
}

Scan
scanByCamera (const View& view, const DepthCamera& camera, const CameraNoise& noise)
{
  // Standard deviation of the ray offsets along each image axis [px] (Nguyen et al.,
  // see disturbDepths).
  constexpr double lateral_sigma = 0.8;
  Random random = randomFor (Purpose::DepthNoise, view.seed);
  const bool is_noisy = noise.scale > 0.0;
  Jitter jitter;
  if (is_noisy)
    for (Field& axis : jitter)
      axis = noise.scale * lateral_sigma * drawField (camera, noise, random);
  DepthImage image = castDepthImage (view.scene, camera, view.pose, jitter);
  if (is_noisy)
    disturbDepths (image, camera, noise, random);
  return toScan (std::move (image), camera);
}

double
drawQuantization (Seed seed)
{
  constexpr double depth = 5.0;          // [m]
  constexpr double finest_step = 0.065;  // at this depth [m]
  constexpr double coarsest_step = 0.08; // [m]
  Random random = randomFor (Purpose::Quantization, seed);
  return depth * depth / random.between (finest_step, coarsest_step);
}

Scan
toScan (DepthImage image, const DepthCamera& camera)
{
  Scan scan{std::size_t (camera.width), std::size_t (camera.height)};
  scan.surfaces = std::move (image.surface);
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      const double depth = image.depth (row, column);
      const bool is_read = depth >= min_depth && depth <= max_depth;
      scan.points.push_back (is_read ? Vector3d (depth * camera.ray (column, row))
                                     : Vector3d::Constant (std::nan ("")));
    }
  return scan;
}

double
Lidar::elevation (int beam) const
{
  // Elevation of a beam by its number, of some beams with equal spacing.
  const auto equallySpaced = [] (double from, double to, int number, int count) {
    const double share = double (number) / (count - 1);
    return from + share * (to - from);
  };
  if (!is_dense_at_level)
    return equallySpaced (highest, lowest, beam, beams);
  // The elevations of a Hesai Pandar64: equal spacing within each of four ranges.
  constexpr struct {
    double highest, lowest; // [degree]
    int beams;
  } ranges[] = {{15.0, 3.0, 2}, {2.0, -6.0, 49}, {-6.5, -13.0, 7}, {-14.0, -25.0, 6}};
  int number_in_range = beam;
  for (const auto& range : ranges) {
    if (number_in_range < range.beams)
      return equallySpaced (range.highest, range.lowest, number_in_range, range.beams);
    number_in_range -= range.beams;
  }
  return lowest;
}

Lidar
lidarOf (const std::string& name)
{
  return *std::find_if (std::begin (known_lidars),
                        std::end (known_lidars) - 1,
                        [&name] (const Lidar& lidar) { return lidar.name == name; });
}

Scan
scanAround (const View& view, const Lidar& lidar, double noise, std::size_t scan_number)
{
  const ShapeTree shapes = treeOf (view.scene);
  const auto cast = [&] (const Vector3d& ray) {
    return castRay (shapes, view.pose.translation(), view.pose.linear() * ray);
  };
  return scanAround (cast, lidar, noise, view.seed, scan_number);
}

Scan
scanAround (const CastRay& cast,
            const Lidar& lidar,
            double noise,
            Seed seed,
            std::size_t scan_number)
{
  Random random = randomFor (Purpose::LidarNoise, seed);
  constexpr bool column_by_column = true;
  Scan scan{std::size_t (lidar.steps), std::size_t (lidar.beams), column_by_column};
  const std::size_t rays = scan.columns * scan.rows;
  scan.points.assign (rays, Vector3d::Constant (std::nan ("")));
  scan.surfaces.assign (rays, no_surface);
  for (std::size_t i = 0; i < rays; ++i) {
    const Vector3d ray =
        lidar.isRosette()
            ? rosetteRay (lidar, scan_number * rays + i)
            : rotatingRay (lidar, int (i / scan.rows), int (i % scan.rows));
    const Hit hit = cast (ray);
    // Drawn also for rays without a hit, so that a hit more or less does not change the
    // errors of the other rays.
    const double error = noise * lidar_sigma * random.gaussian();
    const double distance = hit.distance + error;
    if (!(distance > 0.0 && distance <= lidar.farthest))
      continue;
    scan.points[i] = distance * ray;
    scan.surfaces[i] = hit.surface;
  }
  return scan;
}

} // namespace pcl_ops::simulation
