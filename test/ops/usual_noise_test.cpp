// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "ops/usual_noise.h"

using namespace pcl_ops::internal;

namespace {

pcl_ops::CloudNoise
usualOf (const std::vector<float>& density, const std::vector<float>& noise)
{
  pcl_ops::CloudNoise cloud;
  setUsualNoise (density, noise, cloud);
  return cloud;
}

} // namespace

TEST (QuantileOf, IsTheValueBelowWhichAShareLies)
{
  std::vector<float> values{5, 1, 4, 2, 3};
  EXPECT_EQ (quantileOf (values, 0.0), 1.0f);
  EXPECT_EQ (quantileOf (values, 0.5), 3.0f);
  EXPECT_EQ (quantileOf (values, 1.0), 5.0f);
  values.clear();
  EXPECT_EQ (quantileOf (values, 0.5), 0.0f);
}

TEST (UsualNoise, IsTheMedianWherePointsAreAsDense)
{
  // In the middle of octaves that are far apart.
  const pcl_ops::CloudNoise usual =
      usualOf ({1.4f, 1.4f, 1.4f, 1000.0f}, {1.0f, 2.0f, 3.0f, 1.0f});
  EXPECT_NEAR (usualNoise (usual, 1.4), 2.0, 1e-6);
  EXPECT_NEAR (usualNoise (usual, 1000.0), 1.0, 1e-6);
}

TEST (UsualNoise, ChangesLittleWithTheDensity)
{
  std::vector<float> density;
  std::vector<float> noise;
  for (int octave = 0; octave < 8; ++octave) {
    density.push_back (1.4f * static_cast<float> (1 << octave));
    noise.push_back (octave < 4 ? 1.0f : 2.0f);
  }
  const pcl_ops::CloudNoise usual = usualOf (density, noise);
  for (double at = 1.0; at < 300.0; at *= 1.01)
    EXPECT_NEAR (usualNoise (usual, 1.01 * at),
                 usualNoise (usual, at),
                 0.03 * usualNoise (usual, at))
        << at;
  EXPECT_LT (usualNoise (usual, 4.0), usualNoise (usual, 100.0));
}

TEST (UsualNoise, IsAtMostThreeTimesThatOfTheCloud)
{
  std::vector<float> density (10, 1.4f);
  std::vector<float> noise (10, 1.0f);
  density.push_back (1000.0f);
  noise.push_back (50.0f);
  EXPECT_NEAR (usualNoise (usualOf (density, noise), 1000.0), 3.0, 1e-6);
}

TEST (UsualNoise, IsNoneOfNoPlaces)
{
  EXPECT_EQ (usualNoise (usualOf ({}, {}), 1.0), 0.0);
}

TEST (UsualNoise, IsKnownAtAnyDensity)
{
  const pcl_ops::CloudNoise usual = usualOf ({0.0f, 1.4f}, {1.0f, 1.0f});
  EXPECT_NEAR (usualNoise (usual, 0.0), 1.0, 1e-6);
  EXPECT_NEAR (usualNoise (usual, 1e308), 1.0, 1e-6);
}
