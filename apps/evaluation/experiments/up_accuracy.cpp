// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "up_accuracy.h"

#include <pcl/common/transforms.h>

#include <numbers/angles.h>
#include <numbers/fraction.h>
#include <numbers/quantile.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/visibility.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace pcl_ops::evaluation {

namespace {

constexpr double largest_right_error = 10.0; // [degree]

/** Even among all rotations (Shoemake 1992). */
Eigen::Quaterniond
drawRotation (apps::Random& random)
{
  constexpr double two_pi = 2.0 * M_PI;
  const double share = random.unit();
  const double first = two_pi * random.unit();
  const double second = two_pi * random.unit();
  const double a = std::sqrt (1.0 - share), b = std::sqrt (share);
  return {b * std::cos (second),
          a * std::sin (first),
          a * std::cos (first),
          b * std::sin (second)};
}

XyzCloud::Ptr
turned (const XyzCloud& cloud, const Eigen::Quaterniond& rotation)
{
  const Eigen::Affine3f turn (rotation.cast<float>());
  XyzCloud::Ptr result (new XyzCloud);
  pcl::transformPointCloud (cloud, *result, turn);
  const Eigen::Vector3f origin = cloud.sensor_origin_.head<3>();
  result->sensor_origin_.head<3>() = turn * origin;
  return result;
}

bool
isRight (const UpGuess& guess)
{
  return guess.error <= largest_right_error;
}

} // namespace

std::optional<UpGuess>
guessUp (const EvaluationCloud& cloud, apps::Random& random)
{
  const Eigen::Quaterniond rotation = drawRotation (random);
  const XyzCloud::Ptr turned_cloud = turned (*cloud.cloud, rotation);
  if (!isSeenFromItsOrigin (*turned_cloud))
    return std::nullopt;
  OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (turned_cloud);
  std::vector<PlaneSegment> planes;
  ops.segment (planes);
  UpAxisParameters parameters;
  parameters.least_confidence = 0.0;
  const Eigen::Vector3d viewpoint =
      turned_cloud->sensor_origin_.head<3>().cast<double>();
  const std::optional<UpAxis> found = estimateUpAxis (planes, viewpoint, parameters);
  if (!found)
    return std::nullopt;
  const Eigen::Vector3d truth = rotation * cloud.up;
  const double angle =
      std::atan2 (found->direction.cross (truth).norm(), found->direction.dot (truth));
  return UpGuess{found->confidence, apps::toDegrees (angle)};
}

TextTable
errorTable (const std::vector<UpGuesses>& data_sets, double least_confidence)
{
  TextTable table{
      "Up axis of clouds turned at random",
      {"data set", "clouds", "answered %", "wrong %", "median [deg]", "95 % [deg]"},
      {}};
  for (const UpGuesses& set : data_sets) {
    std::vector<double> errors;
    std::size_t wrong = 0;
    for (const UpGuess& guess : set.guesses)
      if (guess.confidence >= least_confidence) {
        errors.push_back (guess.error);
        wrong += isRight (guess) ? 0 : 1;
      }
    table.rows.push_back ({set.data_set,
                           std::to_string (set.tries),
                           percent (apps::fraction (errors.size(), set.tries, NAN)),
                           percent (apps::fraction (wrong, set.tries, NAN)),
                           decimal (apps::quantile (errors, 0.5), 2),
                           decimal (apps::quantile (errors, 0.95), 2)});
  }
  return table;
}

TextTable
reliabilityTable (const std::vector<UpGuesses>& data_sets)
{
  constexpr std::array<double, 6> bounds{0.0, 0.5, 0.7, 0.8, 0.9, 1.0};
  TextTable table{"Right by confidence, within " + decimal (largest_right_error, 0) +
                      " degrees",
                  {"confidence", "guesses", "mean confidence %", "right %"},
                  {}};
  for (std::size_t i = 0; i + 1 < bounds.size(); ++i) {
    const bool is_last = i + 2 == bounds.size();
    std::size_t guesses = 0, right = 0;
    double confidence = 0.0;
    for (const UpGuesses& set : data_sets)
      for (const UpGuess& guess : set.guesses)
        if (guess.confidence >= bounds[i] &&
            (is_last || guess.confidence < bounds[i + 1])) {
          ++guesses;
          right += isRight (guess) ? 1 : 0;
          confidence += guess.confidence;
        }
    table.rows.push_back (
        {decimal (bounds[i], 1) + " to " + decimal (bounds[i + 1], 1),
         std::to_string (guesses),
         percent (guesses == 0 ? NAN : confidence / static_cast<double> (guesses)),
         percent (apps::fraction (right, guesses, NAN))});
  }
  return table;
}

} // namespace pcl_ops::evaluation
