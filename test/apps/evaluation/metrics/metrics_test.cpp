// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/metrics/metrics.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <random>
#include <tuple>

namespace {

using namespace pcl_ops::evaluation;

/** A floor of ten points (the first five near x = 0) and a wall of ten. */
XyzCloud
floorAndWall ()
{
  XyzCloud cloud;
  for (int i = 0; i < 10; ++i)
    cloud.push_back (pcl::PointXYZ (i / 5, i % 5, 0));
  for (int i = 0; i < 10; ++i)
    cloud.push_back (pcl::PointXYZ (2, i % 5, 1 + i / 5));
  return cloud;
}

/** {{10, 1}, {10, 2}}: ten points labeled 1, then ten labeled 2. */
PlaneLabels
runs (std::initializer_list<std::pair<std::size_t, std::uint32_t>> counts)
{
  PlaneLabels labels;
  for (const auto& [count, label] : counts)
    labels.insert (labels.end(), count, label);
  return labels;
}

const PlaneLabels floor_and_wall = runs ({{10, 1}, {10, 2}}), one = PlaneLabels (20, 1),
                  none = PlaneLabels (20, 0), floor_only = runs ({{10, 1}, {10, 0}});

/** By published name. */
std::map<std::string, double>
metricsOf (const PlaneLabels& truth, const PlaneLabels& result)
{
  const Metrics metrics = compareLabels (floorAndWall(), truth, result);
  std::map<std::string, double> named;
  for (const auto& [name, value] : metrics.named)
    named[name] = value;
  named[off_planes_name] = metrics.points_off_planes_called_planes;
  return named;
}

TEST (Metrics, TheTruthItselfIsPerfectWhateverThePlanesAreCalled)
{
  const PlaneLabels renamed = runs ({{10, 900}, {10, 7}});
  for (const auto& [name, value] : metricsOf (floor_and_wall, renamed)) {
    const bool is_error = (name.find ("segmentation") != std::string::npos &&
                           name.find ("accuracy") == std::string::npos) ||
                          name.rfind ("noise", 0) == 0 ||
                          name.rfind ("missed", 0) == 0 || name == off_planes_name;
    EXPECT_EQ (value, is_error ? 0.0 : 1.0) << name;
  }
}

/** A truth, a result, and some metrics they have. */
struct Comparison {
  const char* what;
  PlaneLabels truth, result;
  std::map<std::string, double> metrics;
};

TEST (Metrics, AreWhatTheirDefinitionSays)
{
  const Comparison comparisons[] = {
      {"nothing found leaves only nothing right", // the ten of no plane are "other"
       floor_only,
       none,
       {{"classification_accuracy", 0.5},
        {"segmentation_accuracy", 0.0},
        {"segmentation_accuracy_all", 0.5},
        {"precision", 0.0},
        {"recall", 0.0},
        {"missed", 1.0}}},
      {"a plane where there is none is noise",
       none,
       floor_only,
       {{"segmentation_accuracy", 0.0},
        {"segmentation_accuracy_all", 0.5},
        {"precision", 0.0},
        {"noise", 1.0}}},
      {"nothing to find and nothing found is perfect",
       none,
       none,
       {{"segmentation_accuracy", 1.0}, {"f_score", 1.0}}},
      {"one true plane", one, floor_and_wall, {{"segmentation_accuracy", 0.5}}},
      {"the points of the assigned planes count",
       floor_and_wall,
       runs ({{8, 1}, {2, 2}, {9, 2}, {1, 0}}),
       {{"segmentation_accuracy", 17.0 / 20.0}}},
      {"a found plane is assigned only once",
       floor_and_wall,
       one,
       {{"segmentation_accuracy", 0.5}}},
      {"points rightly on no plane count in one of the accuracies",
       floor_only,
       runs ({{8, 1}, {8, 0}, {4, 2}}),
       {{"segmentation_accuracy", 8.0 / 10.0},
        {"segmentation_accuracy_all", (8.0 + 6.0) / 20.0}}},
      {"half of the points off planes are called planes",
       none,
       runs ({{6, 1}, {4, 2}, {10, 0}}),
       {{off_planes_name, 0.5}}},
      {"points on a true plane are not off planes",
       floor_only,
       runs ({{14, 1}, {6, 0}}),
       {{off_planes_name, 0.4}}},
      {"no point is off planes", one, one, {{off_planes_name, 0.0}}},
      {"classes are those of the planes: five points on a line span none",
       floor_and_wall,
       runs ({{5, 1}, {5, 3}, {10, 0}}),
       {{"classification_accuracy", 0.0}}},
      {"floor with an IoU of 0.6, wall with one of 0.9",
       floor_and_wall,
       runs ({{6, 1}, {4, 0}, {9, 2}, {1, 0}}),
       {{"recall", 1.0},
        {"mean_iou", 0.75},
        {"panoptic_quality", 0.75},
        {"precision_75", 0.5},
        {"recall_75", 0.5},
        {"panoptic_quality_75", 0.9 * 0.5},
        {"missed_75", 0.5},
        {"noise_75", 0.5}}},
      {"precision and recall have their own denominators",
       runs ({{5, 1}, {5, 2}, {5, 3}, {5, 0}}),
       runs ({{5, 1}, {5, 2}, {5, 0}, {3, 4}, {2, 5}}),
       {{"precision", 2.0 / 4.0},
        {"recall", 2.0 / 3.0},
        {"f_score", 2.0 * 2.0 / (4.0 + 3.0)},
        {"noise", 2.0 / 4.0},
        {"missed", 1.0 / 3.0}}},
      {"a true plane in three parts is over-segmented, the parts are explained",
       floor_and_wall,
       runs ({{4, 1}, {3, 2}, {3, 3}, {10, 4}}),
       {{"over_segmentation", 0.5},
        {"under_segmentation", 0.0},
        {"missed", 0.0},
        {"noise", 0.0}}},
      {"a found plane over two true ones is under-segmented",
       floor_and_wall,
       one,
       {{"under_segmentation_75", 1.0},
        {"over_segmentation_75", 0.0},
        {"missed_75", 0.0},
        {"noise_75", 0.0}}},
      {"parts that leave most of the plane open are noise",
       one,
       runs ({{4, 1}, {4, 2}, {12, 0}}),
       {{"over_segmentation", 0.0}, {"noise", 1.0}, {"missed", 1.0}}},
      {"halves of one plane match it only once",
       one,
       floor_and_wall,
       {{"recall", 1.0}, {"precision", 0.5}}}};
  for (const Comparison& comparison : comparisons) {
    const auto metrics = metricsOf (comparison.truth, comparison.result);
    for (const auto& [name, value] : comparison.metrics)
      EXPECT_DOUBLE_EQ (metrics.at (name), value) << comparison.what << ": " << name;
  }
}

TEST (Metrics, ClassesFollowTheUpAxis)
{
  // Found is the floor alone: right are its points, and those of the wall where it is
  // neither horizontal nor vertical, like points on no plane.
  for (const auto& [up, right] : {std::pair (Eigen::Vector3d (0, 0, 1), 0.5),
                                  {Eigen::Vector3d (1, 0, 1).normalized(), 1.0}})
    EXPECT_EQ (compareLabels (floorAndWall(), floor_and_wall, floor_only, {up})
                   .named[0]
                   .second,
               right);
}

TEST (Metrics, PointsWithoutCoordinatesDoNotCount)
{
  XyzCloud cloud = floorAndWall();
  for (std::size_t i = 0; i < 5; ++i)
    cloud[i].x = std::numeric_limits<float>::quiet_NaN();
  const PlaneLabels result = runs ({{5, 0}, {5, 1}, {10, 2}});
  const Metrics metrics = compareLabels (cloud, floor_and_wall, result);
  EXPECT_EQ (metrics.points, 15u);
  EXPECT_EQ (metrics.named[1].second, 1.0);
}

TEST (Metrics, LabelsThatAreNoneOfPlanesAreRefused)
{
  EXPECT_THROW (compareLabels (floorAndWall(), one, PlaneLabels (19, 1)),
                std::invalid_argument);
  PlaneLabels one_a_point (20'000); // refused before memory is
  for (std::size_t i = 0; i < one_a_point.size(); ++i)
    one_a_point[i] = static_cast<std::uint32_t> (i + 1);
  EXPECT_THROW (compareLabels (XyzCloud (20'000, 1), one_a_point, one_a_point),
                std::length_error);
}

TEST (DropSmallPlanes, LeavesPlanesOfTheSizeAsked)
{
  PlaneLabels labels = runs ({{50, 1}, {49, 2}, {3, 0}});
  dropSmallPlanes (labels, 50);
  EXPECT_EQ (labels, runs ({{50, 1}, {52, 0}}));
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
metricsOfSizes (std::initializer_list<std::size_t> sizes, double share_found = 1.0)
{
  PlaneLabels truth, result;
  std::uint32_t label = 0;
  for (const std::size_t size : sizes) {
    truth.insert (truth.end(), size, ++label);
    result.insert (
        result.end(), static_cast<std::size_t> (share_found * double (size)), label);
    result.resize (truth.size(), 0);
  }
  return compareLabels (XyzCloud (std::uint32_t (truth.size()), 1), truth, result);
}

TEST (SizeClasses, ATruePlaneBelongsToTheClassOfItsPoints)
{
  EXPECT_EQ (planesIn (metricsOfSizes ({1, 199, 200, 499, 500, 999}).by_size),
             (std::vector<std::size_t>{2, 2, 2, 0, 0, 0}));
  EXPECT_EQ (planesIn (metricsOfSizes ({1000, 2999, 3000, 9999, 10000, 30000}).by_size),
             (std::vector<std::size_t>{0, 0, 0, 2, 2, 2}));
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

/** Adds a board of 40 x 40 points to a cloud and gives them the next label. */
void
addBoard (XyzCloud& cloud, PlaneLabels& labels, double width, double length)
{
  constexpr int side = 40;
  const Eigen::Vector3d across (1.0 / 3, 2.0 / 3, 2.0 / 3),
      along (2.0 / 3, 1.0 / 3, -2.0 / 3);
  const std::uint32_t label = labels.empty() ? 1 : labels.back() + 1;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const Eigen::Vector3f point =
          ((width * (i + 0.5) * across + length * (j + 0.5) * along) / side)
              .cast<float>();
      cloud.push_back ({point.x(), point.y(), point.z() + float (label)});
      labels.push_back (label);
    }
}

TEST (Widths, DivideTruePlanesIntoClasses)
{
  XyzCloud cloud;
  PlaneLabels labels;
  for (const double width : {0.02, 0.04, 0.05, 0.2, 0.5, 1.5})
    addBoard (cloud, labels, width, 2.0);
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
