// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/metrics/metrics.h>

#include <limits>

namespace {

using namespace pcl_ops::evaluation;

/** True planes of so many points, of each of which the result has the first share. */
std::vector<PointsClass>
classesOf (std::initializer_list<std::size_t> sizes, double share_found = 1.0)
{
  PlaneLabels truth, result;
  std::uint32_t label = 0;
  for (const std::size_t size : sizes) {
    truth.insert (truth.end(), size, ++label);
    result.insert (
        result.end(), static_cast<std::size_t> (share_found * double (size)), label);
    result.resize (truth.size(), 0);
  }
  return sizeClasses (confusionOf (truth, result));
}

template <typename Size>
std::vector<std::size_t>
planesOf (const std::vector<SizeClass<Size>>& classes)
{
  std::vector<std::size_t> planes;
  for (const SizeClass<Size>& size : classes)
    planes.push_back (size.planes);
  return planes;
}

TEST (SizeClasses, EachBeginsWhereTheOneBelowEnds)
{
  const std::vector<PointsClass> classes = classesOf ({});
  ASSERT_EQ (classes.size(), 6u);
  EXPECT_EQ (classes.front().from, 0u);
  for (std::size_t i = 1; i < classes.size(); ++i)
    EXPECT_EQ (classes[i].from, classes[i - 1].below);
  EXPECT_FALSE (classes.back().below);
}

TEST (SizeClasses, ATruePlaneBelongsToTheClassOfItsPoints)
{
  EXPECT_EQ (planesOf (classesOf ({1, 199, 200, 499, 500, 999})),
             (std::vector<std::size_t>{2, 2, 2, 0, 0, 0}));
  EXPECT_EQ (planesOf (classesOf ({1000, 2999, 3000, 9999, 10000, 30000})),
             (std::vector<std::size_t>{0, 0, 0, 2, 2, 2}));
}

TEST (SizeClasses, CountThePlanesFoundAtBothOverlaps)
{
  const PointsClass of_six_tenths = classesOf ({100, 150}, 0.6).front();
  EXPECT_EQ (of_six_tenths.found_50, 2u);
  EXPECT_EQ (of_six_tenths.found_75, 0u);
  const PointsClass whole = classesOf ({100, 150}).front();
  EXPECT_EQ (whole.found_50, 2u);
  EXPECT_EQ (whole.found_75, 2u);
}

TEST (SizeClasses, WhatIsNotFoundIsCountedAmongThePlanes)
{
  const PointsClass missed = classesOf ({300}, 0.0)[1];
  EXPECT_EQ (missed.planes, 1u);
  EXPECT_EQ (missed.found_50, 0u);
}

TEST (SizeClasses, AFoundPlaneOnNoTrueOneIsInNone)
{
  const auto classes =
      sizeClasses (confusionOf (PlaneLabels (300, 0), PlaneLabels (300, 1)));
  EXPECT_EQ (planesOf (classes), std::vector<std::size_t> (6, 0));
}

/** Boards beside each other, labelled 1, 2 and so on. */
struct Boards {
  XyzCloud cloud;
  PlaneLabels labels;

  void
  add (double width,
       double length,
       const Eigen::Vector3d& across = Eigen::Vector3d::UnitX(),
       const Eigen::Vector3d& along = Eigen::Vector3d::UnitY())
  {
    constexpr int points_of_side = 40;
    const std::uint32_t label = labels.empty() ? 1 : labels.back() + 1;
    for (int i = 0; i < points_of_side; ++i)
      for (int j = 0; j < points_of_side; ++j) {
        const Eigen::Vector3f point = (width * (i + 0.5) / points_of_side * across +
                                       length * (j + 0.5) / points_of_side * along)
                                          .cast<float>();
        cloud.push_back (
            pcl::PointXYZ (point.x(), point.y(), point.z() + float (label)));
        labels.push_back (label);
      }
  }

  std::vector<double>
  widths () const
  {
    return widthsOf (cloud, planeIds (labels));
  }
};

TEST (Width, IsTheSmallerSideOfARectangle)
{
  Boards boards;
  boards.add (0.04, 1.2);
  boards.add (0.8, 0.5);
  const std::vector<double> widths = boards.widths();
  ASSERT_EQ (widths.size(), 2u);
  EXPECT_NEAR (widths[0], 0.04, 0.001);
  EXPECT_NEAR (widths[1], 0.5, 0.005);
}

TEST (Width, IsTheSameWhicheverWayTheRectangleIsTurned)
{
  Boards boards;
  const Eigen::Vector3d across = Eigen::Vector3d (1, 2, 2) / 3,
                        along = Eigen::Vector3d (2, 1, -2) / 3;
  boards.add (0.04, 1.2, across, along);
  EXPECT_NEAR (boards.widths().at (0), 0.04, 0.001);
}

TEST (Width, IsNoneOfPointsOnALine)
{
  Boards boards;
  boards.add (0.0, 1.0);
  EXPECT_EQ (boards.widths(), std::vector<double>{0.0});
}

TEST (WidthClasses, ATruePlaneBelongsToTheClassOfItsWidth)
{
  Boards boards;
  for (const double width : {0.02, 0.04, 0.05, 0.2, 0.5, 1.5})
    boards.add (width, 2.0);
  const Confusion confusion = confusionOf (boards.labels, boards.labels);
  EXPECT_EQ (planesOf (widthClasses (confusion, boards.widths())),
             (std::vector<std::size_t>{1, 2, 0, 1, 1, 1}));
}

TEST (WidthClasses, CountThoseOfTheirWidthThatAreFound)
{
  Boards boards;
  boards.add (0.02, 1.0);
  boards.add (0.5, 1.0);
  PlaneLabels wide_one_found = boards.labels;
  for (std::uint32_t& label : wide_one_found)
    label = label == 2 ? 2 : 0;
  const auto classes =
      widthClasses (confusionOf (boards.labels, wide_one_found), boards.widths());
  EXPECT_EQ (classes[0].found_50, 0u);
  EXPECT_EQ (classes[4].found_50, 1u);
  EXPECT_EQ (classes[4].found_75, 1u);
}

TEST (WidthClasses, OfACloudAreThoseOfItsFinitePoints)
{
  Boards boards;
  boards.add (0.04, 1.0);
  boards.cloud[0].x = std::numeric_limits<float>::quiet_NaN();
  const Metrics metrics = compareLabels (boards.cloud, boards.labels, boards.labels);
  EXPECT_EQ (metrics.by_width[1].planes, 1u);
}

TEST (RangeName, SaysWhereAClassEnds)
{
  const std::vector<WidthClass> classes = widthClasses ({}, {});
  EXPECT_EQ (rangeName (classes.front()), "below 0.03");
  EXPECT_EQ (rangeName (classes.back()), "from 1");
  EXPECT_EQ (countNames ("width", classes.back()).found_75, "found_75_by_width_from_1");
}

} // namespace
