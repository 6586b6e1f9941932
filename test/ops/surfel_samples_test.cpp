// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "ops/surfel_samples.h"
#include "scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief 200 surfels of ten points each, one above the other, 1 cm apart; those with
 * odd numbers lean by 45 degrees. */
SurfelSamples
tower ()
{
  SurfelSamples samples;
  for (std::uint32_t i = 0; i < 200; ++i) {
    pcl_ops::Moments moments;
    for (int point = 0; point < 10; ++point)
      moments.add (0.0, 0.0, 1_cm * i);
    const double lean = i % 2 == 1 ? 45_deg : 0.0;
    Surfel surfel;
    surfel.plane.normal << std::sin (lean), 0, std::cos (lean);
    samples.add (1000 + i, moments, surfel, 15_mm);
  }
  return samples;
}

/** \brief The ground, which surfels may lean against by up to an angle. */
SurfelBand
ground (double angle)
{
  const pcl_ops::Plane plane{Eigen::Vector3d::UnitZ(), 0.0};
  return {FloatPlane (plane), static_cast<float> (std::cos (angle))};
}

} // namespace

TEST (SurfelSamples, VoteWithTheirPoints)
{
  const Vote vote = voteOf (tower(), ground (50_deg));
  EXPECT_EQ (vote.inliers, 2) << "at 0 and 1 cm, within 15 mm";
  EXPECT_EQ (vote.weight, 20);
  EXPECT_EQ (vote.voters, 200u);
}

TEST (SurfelSamples, DoNotVoteWhereTheyLeanTooMuch)
{
  EXPECT_EQ (voteOf (tower(), ground (40_deg)).inliers, 1);
}

TEST (SurfelSamples, OnAPlaneAreListedByTheirVoxels)
{
  EXPECT_EQ (surfelsOn (tower(), ground (50_deg)), (Indices{1000, 1001}));
  EXPECT_EQ (surfelsOn (tower(), ground (40_deg)), (Indices{1000}));
}

TEST (SurfelSamples, OnAPlaneAreFoundInEveryBatch)
{
  SurfelSamples samples = tower();
  std::fill (samples.bands.begin(), samples.bands.end(), 10.0f);
  EXPECT_EQ (surfelsOn (samples, ground (50_deg)).size(), 200u);
  EXPECT_EQ (voteOf (samples, ground (50_deg)).inliers, 200);
}

TEST (SurfelSamples, AreDroppedWithAllTheyHave)
{
  SurfelSamples samples = tower();
  std::vector<char> is_kept (1200, 1);
  is_kept[1000] = 0;
  keepOnly (is_kept, samples);
  EXPECT_EQ (samples.size(), 199u);
  EXPECT_EQ (samples.voxels.front(), 1001u);
  EXPECT_NEAR (samples.centroids.z.front(), 0.01f, 1e-6f);
  EXPECT_EQ (surfelsOn (samples, ground (50_deg)), (Indices{1001}));
}
