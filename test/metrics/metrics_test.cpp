// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <metrics/metrics.h>
#include <support/text.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>

namespace {

using namespace pcl_ops::evaluation;

/** A floor of ten points, five at x = 0 and then five at x = 1, and a wall of ten at
 * x = 2. */
XyzCloud
floorAndWall ()
{
  XyzCloud cloud;
  for (int i = 0; i < 20; ++i)
    cloud.push_back (i < 10 ? pcl::PointXYZ (i / 5, i % 5, 0)
                            : pcl::PointXYZ (2, i % 5, i / 5 - 1));
  return cloud;
}

/** The labels that a text such as "10x1 5x2" describes: ten points labeled 1, then five
 * labeled 2. Label 0 is no plane. */
PlaneLabels
labelsFrom (const std::string& text)
{
  PlaneLabels labels;
  std::istringstream stream (text);
  std::size_t count = 0;
  std::uint32_t label = 0;
  for (char times = ' '; stream >> count >> times >> label;)
    labels.insert (labels.end(), count, label);
  return labels;
}

TEST (Metrics, AreWhatTheirDefinitionSays)
{
  // Each row has a name, the true labels, the found labels and the expected metrics.
  const auto rows = tableIn (PCL_OPS_METRICS); // test/metrics/metrics.tsv
  ASSERT_FALSE (rows.empty());
  for (const auto& row : rows) {
    SCOPED_TRACE (row.at (0));
    const Metrics metrics = compareLabels (
        floorAndWall(), labelsFrom (row.at (1)), labelsFrom (row.at (2)));
    std::map<std::string, double> named;
    for (const NamedValues& values : {metrics.named, namedCounts (metrics)})
      named.insert (values.begin(), values.end());
    std::istringstream expected (row.at (3));
    std::size_t compared = 0;
    for (std::string name; expected >> name; ++compared) {
      double value = -1.0;
      ASSERT_FALSE ((expected >> value).fail()) << name << " has no value";
      EXPECT_DOUBLE_EQ (named.at (name), value) << name;
    }
    EXPECT_GT (compared, 0u);
  }
}

/** For each point 1 if its truth is unknown, else 0.
 * \param[in] text as for \ref labelsFrom */
std::vector<char>
unknownFrom (const std::string& text)
{
  const PlaneLabels is_unknown = labelsFrom (text);
  return {is_unknown.begin(), is_unknown.end()};
}

/** The metric of that name; -1 if there is none. */
double
valueOf (const Metrics& metrics, const std::string& name)
{
  for (const auto& [metric, value] : metrics.named)
    if (metric == name)
      return value;
  return -1.0;
}

TEST (Metrics, PointsWhoseTruthIsUnknownAreLeftOut)
{
  // The truth of the wall is unknown; half of the floor's plane is not found.
  const Metrics metrics = compareLabels (floorAndWall(),
                                         labelsFrom ("10x1 10x0"),
                                         labelsFrom ("5x1 15x0"),
                                         {},
                                         unknownFrom ("10x0 10x1"));
  EXPECT_EQ (metrics.points, 10u);
  EXPECT_DOUBLE_EQ (valueOf (metrics, "segmentation_accuracy_all"), 0.5);
  EXPECT_DOUBLE_EQ (valueOf (metrics, "mean_iou"), 0.5);
}

TEST (Metrics, AFoundPlaneCountsIfAtLeastHalfOfItIsKnown)
{
  // The floor is found. On the wall a second plane is found, which is no true plane;
  // the truth of only four or five of its ten points is known.
  const PlaneLabels truth = labelsFrom ("10x1 10x0");
  const PlaneLabels found = labelsFrom ("10x1 10x2");
  for (const auto& [is_unknown, precision] :
       {std::pair ("10x0 4x0 6x1", 1.0), {"10x0 5x0 5x1", 0.5}})
    EXPECT_DOUBLE_EQ (
        valueOf (
            compareLabels (floorAndWall(), truth, found, {}, unknownFrom (is_unknown)),
            "precision"),
        precision)
        << is_unknown;
}

TEST (PlaneLabels, NumberPlanesFromOneAndAreZeroElsewhere)
{
  pcl::PointIndices floor;
  floor.indices = {4, 0};
  pcl::PointIndices wall;
  wall.indices = {1};
  EXPECT_EQ (labelsOf ({floor, wall}, 5), (PlaneLabels{1, 2, 0, 0, 1}));
}

TEST (PlaneLabels, OfPlanesWithFewerPointsThanWantedAreDropped)
{
  PlaneLabels labels = labelsFrom ("3x7 2x9 1x0");
  dropSmallPlanes (labels, 3);
  EXPECT_EQ (labels, labelsFrom ("3x7 3x0"));
}

TEST (Metrics, LabelsOfOtherPointsOrOfTooManyPlanesAreRefused)
{
  EXPECT_THROW (
      compareLabels (floorAndWall(), PlaneLabels (20, 1), PlaneLabels (19, 1)),
      std::invalid_argument);
  // As many planes as points would need a table of 20,000 x 20,000 overlaps.
  PlaneLabels all_different (20'000);
  std::iota (all_different.begin(), all_different.end(), 1u);
  EXPECT_THROW (compareLabels (XyzCloud (20'000, 1), all_different, all_different),
                std::length_error);
}

/** Number of planes in each size class. */
std::vector<std::size_t>
planesIn (const SizeClasses& classes)
{
  std::vector<std::size_t> planes;
  for (const SizeClass& size : classes)
    planes.push_back (size.planes);
  return planes;
}

TEST (SizeClasses, ATruePlaneBelongsToTheClassOfItsPoints)
{
  // The classes end before 200, 500, 1000, 3000 and 10,000 points.
  PlaneLabels labels;
  for (const std::size_t size :
       {1, 199, 200, 499, 500, 999, 1000, 2999, 3000, 9999, 10000, 30000})
    labels.insert (labels.end(), size, std::uint32_t (labels.size() + 1));
  const XyzCloud cloud (std::uint32_t (labels.size()), 1);
  EXPECT_EQ (planesIn (compareLabels (cloud, labels, labels).by_size),
             (std::vector<std::size_t> (6, 2)));
}

TEST (WidthClasses, ATruePlaneBelongsToTheClassOfItsWidth)
{
  // The classes end at 3 cm, 6 cm, 12 cm, 25 cm and 1 m. Slanted boards 2 m long, one
  // above the other, have steps x steps points each.
  constexpr int steps = 40;
  const Eigen::Vector3d across (1.0 / 3, 2.0 / 3, 2.0 / 3);
  const Eigen::Vector3d along (2.0 / 3, 1.0 / 3, -2.0 / 3);
  XyzCloud cloud;
  PlaneLabels labels;
  for (const double width : {0.02, 0.04, 0.05, 0.2, 0.5, 1.5}) {
    const std::uint32_t label = labels.empty() ? 1 : labels.back() + 1;
    for (int i = 0; i < steps * steps; ++i) {
      const Eigen::Vector3d point = width * (i / steps + 0.5) / steps * across +
                                    2.0 * (i % steps + 0.5) / steps * along +
                                    label * Eigen::Vector3d::UnitZ();
      cloud.emplace_back (float (point.x()), float (point.y()), float (point.z()));
      labels.push_back (label);
    }
  }
  cloud[0].x = std::numeric_limits<float>::quiet_NaN(); // which changes no width
  PlaneLabels all_but_first = labels;
  std::replace (all_but_first.begin(), all_but_first.end(), 1u, 0u);
  const SizeClasses classes = compareLabels (cloud, labels, all_but_first).by_width;
  EXPECT_EQ (planesIn (classes), (std::vector<std::size_t>{1, 2, 0, 1, 1, 1}));
  EXPECT_EQ (classes[0].found_50, 0u);
  EXPECT_EQ (classes[1].found_75, 2u);
}

} // namespace
