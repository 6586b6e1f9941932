// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "ops/usual_noise.h"

using namespace pcl_ops::internal;

namespace {

/** \brief Near sqrt (2): the middle of the octave of densities from 1 to 2 [1/m^2]. */
constexpr float mid_octave = 1.4f;

/** \brief The statistics of the noise of places with these densities [1/m^2] and noises
 * [m]. */
pcl_ops::CloudNoise
statisticsOf (const std::vector<float>& density, const std::vector<float>& noise)
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

TEST (UsualNoise, IsTheMedianOverPlacesOfTheSameDensity)
{
  // Densities in two octaves that are far apart.
  const pcl_ops::CloudNoise usual = statisticsOf (
      {mid_octave, mid_octave, mid_octave, 1000.0f}, {1.0f, 2.0f, 3.0f, 1.0f});
  EXPECT_NEAR (usualNoise (usual, mid_octave), 2.0, 1e-6);
  EXPECT_NEAR (usualNoise (usual, 1000.0), 1.0, 1e-6);
}

TEST (UsualNoise, ChangesLittleWithTheDensity)
{
  // Densities from 1 to 256; the noise is 1 m below 16 and 2 m above.
  std::vector<float> density;
  std::vector<float> noise;
  for (int octave = 0; octave < 8; ++octave) {
    density.push_back (mid_octave * static_cast<float> (1 << octave));
    noise.push_back (octave < 4 ? 1.0f : 2.0f);
  }
  const pcl_ops::CloudNoise usual = statisticsOf (density, noise);
  for (double other_density = 1.0; other_density < 300.0; other_density *= 1.01)
    EXPECT_NEAR (usualNoise (usual, 1.01 * other_density),
                 usualNoise (usual, other_density),
                 0.03 * usualNoise (usual, other_density))
        << other_density;
  EXPECT_LT (usualNoise (usual, 4.0), usualNoise (usual, 100.0));
}

TEST (UsualNoise, IsAtMostThreeTimesThatOfTheCloud)
{
  std::vector<float> density (10, mid_octave);
  std::vector<float> noise (10, 1.0f);
  density.push_back (1000.0f);
  noise.push_back (50.0f);
  EXPECT_NEAR (usualNoise (statisticsOf (density, noise), 1000.0), 3.0, 1e-6);
}

TEST (UsualNoise, IsNoneOfNoPlaces)
{
  EXPECT_EQ (usualNoise (statisticsOf ({}, {}), 1.0), 0.0);
}

TEST (UsualNoise, IsThatOfTheCloudAtADensityWithoutPlaces)
{
  const pcl_ops::CloudNoise usual = statisticsOf ({0.0f, mid_octave}, {1.0f, 1.0f});
  EXPECT_NEAR (usualNoise (usual, 0.0), 1.0, 1e-6);
  EXPECT_NEAR (usualNoise (usual, 1e308), 1.0, 1e-6);
}
