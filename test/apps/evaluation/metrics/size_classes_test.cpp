// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <evaluation/metrics/size_classes.h>

namespace {

using namespace pcl_ops::evaluation;

/** True planes of so many points, of each of which the result has the first share. */
std::vector<SizeClass>
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

std::vector<std::size_t>
planesOf (const std::vector<SizeClass>& classes)
{
  std::vector<std::size_t> planes;
  for (const SizeClass& size : classes)
    planes.push_back (size.planes);
  return planes;
}

TEST (SizeClasses, EachBeginsWhereTheOneBelowEnds)
{
  const std::vector<SizeClass> classes = classesOf ({});
  ASSERT_EQ (classes.size(), 6u);
  EXPECT_EQ (classes.front().fewest_points, 0u);
  for (std::size_t i = 1; i < classes.size(); ++i)
    EXPECT_EQ (classes[i].fewest_points, classes[i - 1].below);
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
  const SizeClass of_six_tenths = classesOf ({100, 150}, 0.6).front();
  EXPECT_EQ (of_six_tenths.found_50, 2u);
  EXPECT_EQ (of_six_tenths.found_75, 0u);
  const SizeClass whole = classesOf ({100, 150}).front();
  EXPECT_EQ (whole.found_50, 2u);
  EXPECT_EQ (whole.found_75, 2u);
}

TEST (SizeClasses, WhatIsNotFoundIsCountedAmongThePlanes)
{
  const SizeClass missed = classesOf ({300}, 0.0)[1];
  EXPECT_EQ (missed.planes, 1u);
  EXPECT_EQ (missed.found_50, 0u);
}

TEST (SizeClasses, AFoundPlaneOnNoTrueOneIsInNone)
{
  const auto classes =
      sizeClasses (confusionOf (PlaneLabels (300, 0), PlaneLabels (300, 1)));
  EXPECT_EQ (planesOf (classes), std::vector<std::size_t> (6, 0));
}

} // namespace
