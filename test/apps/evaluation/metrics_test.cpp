// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/metrics/metrics.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <sstream>
#include <tuple>

namespace {

using namespace pcl_ops::evaluation;

/** A floor of ten points (the first five near x = 0) and a wall of ten. */
XyzCloud
floorAndWall ()
{
  XyzCloud cloud;
  for (int i = 0; i < 20; ++i)
    cloud.push_back (i < 10 ? pcl::PointXYZ (i / 5, i % 5, 0)
                            : pcl::PointXYZ (2, i % 5, i / 5 - 1));
  return cloud;
}

/** "10x1 5x2": ten points labeled 1, then five labeled 2. */
PlaneLabels
runs (const std::string& text)
{
  PlaneLabels labels;
  std::istringstream stream (text);
  std::size_t count = 0;
  std::uint32_t label = 0;
  for (char times = ' '; stream >> count >> times >> label;)
    labels.insert (labels.end(), count, label);
  return labels;
}

const PlaneLabels floor_and_wall = runs ("10x1 10x2"), floor_only = runs ("10x1 10x0");

/** By published name. */
std::map<std::string, double>
metricsOf (const PlaneLabels& truth, const PlaneLabels& result)
{
  const Metrics metrics = compareLabels (floorAndWall(), truth, result);
  std::map<std::string, double> named (metrics.named.begin(), metrics.named.end());
  named[off_planes_name] = metrics.points_off_planes_called_planes;
  return named;
}

TEST (Metrics, TheTruthItselfIsPerfectWhateverThePlanesAreCalled)
{
  for (const auto& [name, value] : metricsOf (floor_and_wall, runs ("10x900 10x7"))) {
    const std::string error = name.substr (0, name.find ("_75"));
    const bool is_error = error == "over_segmentation" ||
                          error == "under_segmentation" || error == "noise" ||
                          error == "missed" || error == off_planes_name;
    EXPECT_EQ (value, is_error ? 0.0 : 1.0) << name;
  }
}

/** What, the truth, the result, and some metrics they have. */
constexpr const char* comparisons = R"(
nothing found leaves only the ten of no plane right | 10x1 10x0 | 20x0 |
  classification_accuracy .5 segmentation_accuracy 0 segmentation_accuracy_all .5
  precision 0 recall 0 missed 1;
a plane where there is none is noise | 20x0 | 10x1 10x0 |
  segmentation_accuracy 0 segmentation_accuracy_all .5 precision 0 noise 1;
nothing to find and nothing found is perfect | 20x0 | 20x0 | segmentation_accuracy 1 f_score 1;
the points of the assigned planes count | 10x1 10x2 | 8x1 2x2 9x2 1x0 | segmentation_accuracy .85;
a found plane is assigned only once | 10x1 10x2 | 20x1 |
  segmentation_accuracy .5 recall .5 precision 1;
points rightly on no plane count in one of the accuracies | 10x1 10x0 | 8x1 8x0 4x2 |
  segmentation_accuracy .8 segmentation_accuracy_all .7;
half of the points off planes are called planes | 20x0 | 6x1 4x2 10x0 |
  points_off_planes_called_planes .5;
points on a true plane are not off planes | 10x1 10x0 | 14x1 6x0 |
  points_off_planes_called_planes .4;
no point is off planes | 20x1 | 20x1 | points_off_planes_called_planes 0;
classes are those of the planes: five points on a line span none |
  10x1 10x2 | 5x1 5x3 10x0 | classification_accuracy 0;
floor with an IoU of 0.6, wall with one of 0.9 | 10x1 10x2 | 6x1 4x0 9x2 1x0 |
  recall 1 mean_iou .75 panoptic_quality .75 precision_75 .5 recall_75 .5
  panoptic_quality_75 .45 missed_75 .5 noise_75 .5;
precision and recall have their own denominators |
  5x1 5x2 5x3 5x0 | 5x1 5x2 5x0 3x4 2x5 |
  precision .5 recall .6666666666666666 f_score .5714285714285714 noise .5
  missed .3333333333333333;
a true plane in three parts is over-segmented, the parts are explained |
  10x1 10x2 | 4x1 3x2 3x3 10x4 | over_segmentation .5 under_segmentation 0 missed 0 noise 0;
a found plane over two true ones is under-segmented | 10x1 10x2 | 20x1 |
  under_segmentation_75 1 over_segmentation_75 0 missed_75 0 noise_75 0;
parts that leave most of the plane open are noise | 20x1 | 4x1 4x2 12x0 |
  over_segmentation 0 noise 1 missed 1;
halves of one plane match it only once | 20x1 | 10x1 10x2 |
  segmentation_accuracy .5 recall 1 precision .5 mean_iou .5;)";

TEST (Metrics, AreWhatTheirDefinitionSays)
{
  std::istringstream rows (comparisons);
  for (std::string what, truth, result, expected; std::getline (rows, what, '|');) {
    std::getline (rows, truth, '|');
    std::getline (rows, result, '|');
    std::getline (rows, expected, ';');
    SCOPED_TRACE (what);
    const auto metrics = metricsOf (runs (truth), runs (result));
    std::istringstream stream (expected);
    std::string name;
    for (double value = -1.0; stream >> name >> value;)
      EXPECT_DOUBLE_EQ (metrics.at (name), value) << name;
    EXPECT_TRUE (stream.eof());
  }
}

TEST (Metrics, ClassesFollowTheUpAxis)
{
  // Found is the floor alone: right are its points, and those of the wall where it is
  // neither horizontal nor vertical, like points on no plane.
  for (const auto& [up, right] : {std::pair (Eigen::Vector3d (0, 0, 1), 0.5),
                                  {Eigen::Vector3d (1, 0, 1).normalized(), 1.0}}) {
    const auto metrics =
        compareLabels (floorAndWall(), floor_and_wall, floor_only, {up});
    EXPECT_EQ (metrics.named[0].second, right);
  }
}

TEST (Metrics, PointsWithoutCoordinatesDoNotCount)
{
  XyzCloud cloud = floorAndWall();
  for (std::size_t i = 0; i < 5; ++i)
    cloud[i].x = std::numeric_limits<float>::quiet_NaN();
  const Metrics metrics = compareLabels (cloud, floor_and_wall, runs ("5x0 5x1 10x2"));
  EXPECT_EQ (metrics.points, 15u);
  EXPECT_EQ (metrics.named[1].second, 1.0);
}

TEST (Metrics, LabelsThatAreNoneOfPlanesAreRefused)
{
  EXPECT_THROW (compareLabels (floorAndWall(), floor_only, PlaneLabels (19, 1)),
                std::invalid_argument);
  PlaneLabels one_a_point (20'000); // refused before memory is
  std::iota (one_a_point.begin(), one_a_point.end(), 1u);
  EXPECT_THROW (compareLabels (XyzCloud (20'000, 1), one_a_point, one_a_point),
                std::length_error);
}

TEST (DropSmallPlanes, LeavesPlanesOfTheSizeAsked)
{
  PlaneLabels labels = runs ("50x1 49x2 3x0");
  dropSmallPlanes (labels, 50);
  EXPECT_EQ (labels, runs ("50x1 52x0"));
}

/** \brief How many planes there are in each class. */
std::vector<std::size_t>
planesIn (const SizeClasses& classes)
{
  std::vector<std::size_t> planes;
  for (const SizeClass& size : classes)
    planes.push_back (size.planes);
  return planes;
}

/** True planes of so many points, of each of which the result has the first share. */
Metrics
metricsOfSizes (const std::vector<std::size_t>& sizes, double share_found)
{
  PlaneLabels truth, result;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    truth.resize (truth.size() + sizes[i], std::uint32_t (i + 1));
    result.resize (result.size() + std::size_t (share_found * double (sizes[i])),
                   std::uint32_t (i + 1));
    result.resize (truth.size(), 0);
  }
  return compareLabels (XyzCloud (std::uint32_t (truth.size()), 1), truth, result);
}

TEST (SizeClasses, ATruePlaneBelongsToTheClassOfItsPoints)
{
  const Metrics metrics = metricsOfSizes (
      {1, 199, 200, 499, 500, 999, 1000, 2999, 3000, 9999, 10000, 30000}, 1.0);
  EXPECT_EQ (planesIn (metrics.by_size), (std::vector<std::size_t> (6, 2)));
}

TEST (SizeClasses, CountThePlanesFoundAtBothOverlaps)
{
  for (const auto& [share, at_50, at_75] :
       {std::tuple (0.0, 0.0, 0.0), {0.6, 2.0, 0.0}, {1.0, 2.0, 2.0}}) {
    const NamedValues counts = namedCounts (metricsOfSizes ({100, 150}, share));
    EXPECT_EQ (counts[0], std::pair (std::string ("planes_by_points_below_200"), 2.0));
    EXPECT_EQ (counts[1].second, at_50) << share;
    EXPECT_EQ (counts[2].second, at_75) << share;
    EXPECT_EQ (counts.back().first, "found_75_by_width_from_1");
  }
}

TEST (Widths, DivideTruePlanesIntoClasses)
{
  // Slanted boards 2 m long, of 40 x 40 points each.
  const Eigen::Vector3d across (1.0 / 3, 2.0 / 3, 2.0 / 3),
      along (2.0 / 3, 1.0 / 3, -2.0 / 3);
  XyzCloud cloud;
  PlaneLabels labels;
  for (const double width : {0.02, 0.04, 0.05, 0.2, 0.5, 1.5}) {
    const std::uint32_t label = labels.empty() ? 1 : labels.back() + 1;
    for (int i = 0; i < 1600; ++i) {
      const Eigen::Vector3d point = width * (i / 40 + 0.5) / 40 * across +
                                    2.0 * (i % 40 + 0.5) / 40 * along +
                                    label * Eigen::Vector3d::UnitZ();
      cloud.emplace_back (float (point.x()), float (point.y()), float (point.z()));
      labels.push_back (label);
    }
  }
  cloud[0].x = std::numeric_limits<float>::quiet_NaN();
  PlaneLabels all_but_first = labels;
  std::replace (all_but_first.begin(), all_but_first.end(), 1u, 0u);
  const SizeClasses classes = compareLabels (cloud, labels, all_but_first).by_width;
  EXPECT_EQ (planesIn (classes), (std::vector<std::size_t>{1, 2, 0, 1, 1, 1}));
  EXPECT_EQ (classes[0].found_50, 0u);
  EXPECT_EQ (classes[1].found_75, 2u);
}

TEST (Hungarian, IsTheBestOfAllPermutationsOfTheColumns)
{
  std::mt19937 generator (1);
  for (const auto& [rows, columns] : {std::pair (5, 5), {3, 6}, {0, 4}, {0, 0}})
    for (int i = 0; i < 50; ++i) {
      const Eigen::MatrixXd benefit = Eigen::MatrixXd::NullaryExpr (
          rows, columns, [&] { return double (generator() % 20) - 5.0; });
      std::vector<int> column_of (columns);
      std::iota (column_of.begin(), column_of.end(), 0);
      double best = -1e9;
      do {
        double sum = 0.0;
        for (int row = 0; row < rows; ++row)
          sum += benefit (row, column_of[row]);
        best = std::max (best, sum);
      }
      while (std::next_permutation (column_of.begin(), column_of.end()));
      EXPECT_EQ (maximumAssignment (benefit), best);
    }
}

} // namespace
