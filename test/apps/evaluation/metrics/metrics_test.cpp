// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/metrics/metrics.h>

#include <limits>

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

/** {{10, 1}, {10, 2}}: ten points labelled 1, then ten labelled 2. */
PlaneLabels
runs (std::initializer_list<std::pair<std::size_t, std::uint32_t>> counts)
{
  PlaneLabels labels;
  for (const auto& [count, label] : counts)
    labels.insert (labels.end(), count, label);
  return labels;
}

const PlaneLabels floor_and_wall = runs ({{10, 1}, {10, 2}});

TEST (Metrics, TheTruthItselfIsPerfect)
{
  const Metrics metrics =
      compareLabels (floorAndWall(), floor_and_wall, floor_and_wall);
  for (const auto& [name, value] : namedMetrics (metrics)) {
    const bool is_error = name.find ("segmentation") != std::string::npos &&
                          name.find ("accuracy") == std::string::npos;
    const bool is_bad =
        is_error || name.rfind ("noise", 0) == 0 || name.rfind ("missed", 0) == 0;
    EXPECT_EQ (value, is_bad ? 0.0 : 1.0) << name;
  }
}

TEST (Metrics, NamesOfPlanesDoNotMatter)
{
  const PlaneLabels renamed = runs ({{10, 900}, {10, 7}});
  const Metrics metrics = compareLabels (floorAndWall(), floor_and_wall, renamed);
  EXPECT_EQ (metrics.segmentation_accuracy, 1.0);
  EXPECT_EQ (metrics.at_75.f_score, 1.0);
}

TEST (Metrics, NothingFoundLeavesOnlyNothingRight)
{
  const PlaneLabels truth = runs ({{10, 1}, {10, 0}});
  const Metrics metrics = compareLabels (floorAndWall(), truth, PlaneLabels (20, 0));
  EXPECT_EQ (metrics.classification_accuracy,
             0.5); // the ten of no plane are "other"
  EXPECT_EQ (metrics.segmentation_accuracy, 0.0);
  EXPECT_EQ (metrics.segmentation_accuracy_all, 0.5);
  EXPECT_EQ (metrics.at_50.precision, 0.0);
  EXPECT_EQ (metrics.at_50.recall, 0.0);
  EXPECT_EQ (metrics.at_50.missed, 1.0);
}

TEST (Metrics, APlaneWhereThereIsNoneIsNoise)
{
  const Metrics metrics =
      compareLabels (floorAndWall(), PlaneLabels (20, 0), runs ({{10, 1}, {10, 0}}));
  EXPECT_EQ (metrics.segmentation_accuracy, 0.0);
  EXPECT_EQ (metrics.segmentation_accuracy_all, 0.5);
  EXPECT_EQ (metrics.at_50.precision, 0.0);
  EXPECT_EQ (metrics.at_50.noise, 1.0);
}

TEST (Metrics, NothingToFindAndNothingFoundIsPerfect)
{
  const Metrics metrics =
      compareLabels (floorAndWall(), PlaneLabels (20, 0), PlaneLabels (20, 0));
  EXPECT_EQ (metrics.segmentation_accuracy, 1.0);
  EXPECT_EQ (metrics.at_50.f_score, 1.0);
}

TEST (Metrics, AOnePlaneTruthIsComparedAsAnyOther)
{
  const Metrics metrics =
      compareLabels (floorAndWall(), runs ({{20, 1}}), floor_and_wall);
  EXPECT_EQ (metrics.segmentation_accuracy, 0.5);
  EXPECT_EQ (metrics.truth_planes, 1u);
}

TEST (SegmentationAccuracy, CountsThePointsOfTheAssignedPlanes)
{
  const PlaneLabels result = runs ({{8, 1}, {2, 2}, {9, 2}, {1, 0}});
  const Metrics metrics = compareLabels (floorAndWall(), floor_and_wall, result);
  EXPECT_DOUBLE_EQ (metrics.segmentation_accuracy, 17.0 / 20.0);
}

TEST (SegmentationAccuracy, AssignsAFoundPlaneOnlyOnce)
{
  const Metrics metrics =
      compareLabels (floorAndWall(), floor_and_wall, PlaneLabels (20, 1));
  EXPECT_EQ (metrics.segmentation_accuracy, 0.5);
}

TEST (SegmentationAccuracy, OverAllPointsCountsCorrectlyUnassignedOnes)
{
  const PlaneLabels truth = runs ({{10, 1}, {10, 0}});
  const PlaneLabels result = runs ({{8, 1}, {8, 0}, {4, 2}});
  const Metrics metrics = compareLabels (floorAndWall(), truth, result);
  EXPECT_DOUBLE_EQ (metrics.segmentation_accuracy, 8.0 / 10.0);
  EXPECT_DOUBLE_EQ (metrics.segmentation_accuracy_all, (8.0 + 6.0) / 20.0);
}

TEST (PointsOffPlanes, AreTheShareThatTheResultCallsPlanes)
{
  const PlaneLabels found = runs ({{6, 1}, {4, 2}, {10, 0}});
  const Metrics metrics = compareLabels (floorAndWall(), PlaneLabels (20, 0), found);
  EXPECT_EQ (metrics.points_off_planes_called_planes, 0.5);
}

TEST (PointsOffPlanes, ArePointsOnNoTruePlaneOnly)
{
  const PlaneLabels truth = runs ({{10, 1}, {10, 0}});
  const PlaneLabels found = runs ({{14, 1}, {6, 0}});
  const Metrics metrics = compareLabels (floorAndWall(), truth, found);
  EXPECT_EQ (metrics.points_off_planes_called_planes, 0.4);
}

TEST (PointsOffPlanes, WhereThereAreNoneNoneIsCalledAPlane)
{
  const Metrics metrics =
      compareLabels (floorAndWall(), PlaneLabels (20, 1), PlaneLabels (20, 1));
  EXPECT_EQ (metrics.points_off_planes_called_planes, 0.0);
}

TEST (ClassificationAccuracy, IsThatOfThePlanesNotOfTheirNames)
{
  const PlaneLabels one_of_four_strips = runs ({{5, 1}, {5, 3}, {10, 0}});
  const Metrics metrics =
      compareLabels (floorAndWall(), floor_and_wall, one_of_four_strips);
  // Five collinear points span no plane: "other", as are the ten wall points.
  EXPECT_EQ (metrics.classification_accuracy, 0.0);
}

TEST (ClassificationAccuracy, FollowsTheUpAxis)
{
  const XyzCloud cloud = floorAndWall();
  const auto first = [&] (const Eigen::Vector3d& up) {
    ClassParameters parameters;
    parameters.up = up;
    return pointClasses (cloud, floor_and_wall, parameters).front();
  };
  EXPECT_EQ (first (Eigen::Vector3d::UnitZ()), pcl_ops::Orientation::Horizontal);
  EXPECT_EQ (first (Eigen::Vector3d::UnitX()), pcl_ops::Orientation::Vertical);
  EXPECT_EQ (first (Eigen::Vector3d (1, 0, 1).normalized()),
             pcl_ops::Orientation::Other);
}

TEST (InstanceMetrics, ThresholdDecidesWhatMatches)
{
  // Floor 6 of 10 points: IoU 0.6. Wall 9 of 10: IoU 0.9.
  const PlaneLabels result = runs ({{6, 1}, {4, 0}, {9, 2}, {1, 0}});
  const Confusion confusion = confusionOf (floor_and_wall, result);
  const InstanceMetrics at_50 = instanceMetrics (confusion, 0.5);
  EXPECT_EQ (at_50.recall, 1.0);
  EXPECT_DOUBLE_EQ (at_50.mean_iou, 0.75);
  EXPECT_DOUBLE_EQ (at_50.panoptic_quality, 0.75);
  const InstanceMetrics at_75 = instanceMetrics (confusion, 0.75);
  EXPECT_EQ (at_75.precision, 0.5);
  EXPECT_EQ (at_75.recall, 0.5);
  EXPECT_DOUBLE_EQ (at_75.panoptic_quality, 0.9 * 0.5);
  EXPECT_EQ (at_75.missed, 0.5);
  EXPECT_EQ (at_75.noise, 0.5);
}

TEST (InstanceMetrics, PrecisionAndRecallHaveTheirOwnDenominators)
{
  const PlaneLabels truth = runs ({{10, 1}, {10, 2}, {10, 3}, {10, 0}});
  const PlaneLabels result = runs ({{10, 1}, {10, 2}, {10, 0}, {5, 4}, {5, 5}});
  const InstanceMetrics metrics = instanceMetrics (confusionOf (truth, result), 0.5);
  EXPECT_DOUBLE_EQ (metrics.precision, 2.0 / 4.0);
  EXPECT_DOUBLE_EQ (metrics.recall, 2.0 / 3.0);
  EXPECT_DOUBLE_EQ (metrics.f_score, 2.0 * 2.0 / (4.0 + 3.0));
  EXPECT_DOUBLE_EQ (metrics.noise, 2.0 / 4.0);
  EXPECT_DOUBLE_EQ (metrics.missed, 1.0 / 3.0);
}

TEST (InstanceMetrics, ATruePlaneInThreePiecesIsOverSegmented)
{
  const PlaneLabels result = runs ({{4, 1}, {3, 2}, {3, 3}, {10, 4}});
  const InstanceMetrics metrics =
      instanceMetrics (confusionOf (floor_and_wall, result), 0.5);
  EXPECT_EQ (metrics.over_segmentation, 0.5); // one of two true planes
  EXPECT_EQ (metrics.under_segmentation, 0.0);
  EXPECT_EQ (metrics.missed, 0.0);
  EXPECT_EQ (metrics.noise, 0.0); // the pieces are explained
}

TEST (InstanceMetrics, AFoundPlaneOverTwoTrueOnesIsUnderSegmented)
{
  const InstanceMetrics metrics =
      instanceMetrics (confusionOf (floor_and_wall, PlaneLabels (20, 1)), 0.75);
  EXPECT_EQ (metrics.under_segmentation, 1.0);
  EXPECT_EQ (metrics.over_segmentation, 0.0);
  EXPECT_EQ (metrics.missed, 0.0);
  EXPECT_EQ (metrics.noise, 0.0);
}

TEST (InstanceMetrics, PiecesThatLeaveMostOfThePlaneOpenAreNoise)
{
  const PlaneLabels truth (20, 1);
  const PlaneLabels result = runs ({{4, 1}, {4, 2}, {12, 0}});
  const InstanceMetrics metrics = instanceMetrics (confusionOf (truth, result), 0.5);
  EXPECT_EQ (metrics.over_segmentation, 0.0);
  EXPECT_EQ (metrics.noise, 1.0);
  EXPECT_EQ (metrics.missed, 1.0);
}

TEST (InstanceMetrics, HalvesOfOnePlaneMatchItOnlyOnce)
{
  const InstanceMetrics metrics =
      instanceMetrics (confusionOf (PlaneLabels (20, 1), floor_and_wall), 0.5);
  EXPECT_EQ (metrics.recall, 1.0);
  EXPECT_EQ (metrics.precision, 0.5);
}

TEST (Confusion, CountsEveryPairThatMeets)
{
  const Confusion confusion =
      confusionOf (runs ({{3, 5}, {2, 9}, {1, 0}}), runs ({{1, 2}, {3, 4}, {2, 0}}));
  ASSERT_EQ (confusion.overlaps.size(), 3u);
  EXPECT_EQ (confusion.overlaps[0].points, 1u); // 5 with 2
  EXPECT_EQ (confusion.overlaps[1].points, 2u); // 5 with 4
  EXPECT_EQ (confusion.overlaps[2].points, 1u); // 9 with 4
  EXPECT_EQ (confusion.points_on_no_plane_in_both, 1u);
}

TEST (Metrics, PointsWithoutCoordinatesDoNotCount)
{
  XyzCloud cloud = floorAndWall();
  for (std::size_t i = 0; i < 5; ++i)
    cloud[i].x = std::numeric_limits<float>::quiet_NaN();
  const PlaneLabels result = runs ({{5, 0}, {5, 1}, {10, 2}});
  const Metrics metrics = compareLabels (cloud, floor_and_wall, result);
  EXPECT_EQ (metrics.points, 15u);
  EXPECT_EQ (metrics.segmentation_accuracy, 1.0);
}

TEST (Metrics, LabelsOfAnotherSizeAreRefused)
{
  EXPECT_THROW (
      compareLabels (floorAndWall(), PlaneLabels (20, 1), PlaneLabels (19, 1)),
      std::invalid_argument);
}

TEST (Metrics, ALabelForEveryPointIsRefusedBeforeMemoryIs)
{
  PlaneLabels labels (20'000);
  for (std::size_t i = 0; i < labels.size(); ++i)
    labels[i] = static_cast<std::uint32_t> (i + 1);
  EXPECT_THROW (assignPlanes (confusionOf (labels, labels)), std::length_error);
}

TEST (DropSmallPlanes, LeavesPlanesOfTheSizeAsked)
{
  PlaneLabels labels = runs ({{50, 1}, {49, 2}, {3, 0}});
  dropSmallPlanes (labels, 50);
  EXPECT_EQ (labels, runs ({{50, 1}, {52, 0}}));
}

} // namespace
