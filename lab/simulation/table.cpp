// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "table.h"

#include <utility>

namespace pcl_ops::simulation {

namespace {

/** Returns the smooth depth error at a pixel as a multiple of \ref Table::bend: a
 * parabola in both directions. */
double
smoothErrorAt (const DepthCamera& camera, int column, int row)
{
  // Chosen by hand, so that the error is about 0 over the image: from -0.5 to 0.9.
  constexpr double error_in_the_middle = -0.5;
  constexpr double vertical_share = 0.4; // of the horizontal parabola
  // From -1 at the first to 1 at the last column or row.
  const double right = 2.0 * column / (camera.width - 1) - 1.0;
  const double down = 2.0 * row / (camera.height - 1) - 1.0;
  return error_in_the_middle + right * right + vertical_share * down * down;
}

/** Returns the depth with noise and smooth error, in steps that are blurred a little.
 * \param[in] error smooth error at the distance of the table [m] */
double
disturbed (double depth, double error, const Table& table, double noise, Random& random)
{
  if (!(noise > 0.0))
    return depth;
  constexpr double blur = 0.35; // width of its distribution, chosen by hand [steps]
  // Errors grow with the depth: these are relative to it.
  const double sigma = noise * table_sigma / table.distance;
  const double measured =
      depth * (1.0 + noise * error / table.distance + sigma * random.gaussian());
  const double blur_of_step = blur * random.between (-0.5, 0.5); // [steps]
  return table.quantization /
         (std::round (table.quantization / measured) + blur_of_step);
}

} // namespace

Shape
Table::top() const
{
  constexpr double edge = 20.0; // more than any view [m]
  const Isometry3d pose = at ({0, 0, distance}) * turnX (-tilt);
  const Eigen::Matrix3d axes = edge * pose.linear();
  Shape top = makeRectangle (pose.translation(), axes.col (0), axes.col (1));
  top.surface = 1;
  return top;
}

Table
drawTableView (Seed seed)
{
  Random random = randomFor (Purpose::Table, seed);
  Table table;
  table.bend = random.between (0.001, 0.006);
  table.distance = random.between (0.8, 1.2);
  table.tilt = random.angle (25, 50);
  table.quantization = drawQuantization (seed);
  return table;
}

SimulatedCloud
scanTable (const Table& table,
           const DepthCamera& camera,
           double noise,
           Seed seed,
           bool organized)
{
  const Isometry3d pose = Isometry3d::Identity();
  Body body;
  body.addSurface (table.top());
  Scene scene;
  scene.add (body, pose);
  DepthImage image = castDepthImage (scene, camera, pose);
  Random random = randomFor (Purpose::TableNoise, seed);
  for (int row = 0; row < camera.height; ++row)
    for (int column = 0; column < camera.width; ++column) {
      double& depth = image.depth (row, column);
      const double error = table.bend * smoothErrorAt (camera, column, row);
      depth = disturbed (depth, error, table, noise, random);
    }
  SimulatedCloud result = labeledBySize (
      toSurfaceCloud (toScan (std::move (image), camera), pose, organized),
      surfacePlanes (scene));
  result.up = -table.top().normal(); // towards the camera
  return result;
}

} // namespace pcl_ops::simulation
