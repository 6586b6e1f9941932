// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "ops/thin_planes.h"

using namespace pcl_ops;
using namespace pcl_ops::internal;

namespace {

ThinPlaneLimits
eightNoises ()
{
  ThinPlaneLimits limits;
  limits.noises = 8.0;
  return limits;
}

/** \brief A flat ground of 400 points and a smaller wall, each on its plane; every so
 * many points one of the ground is half a meter above it. */
LabelledPlanes
groundAndWall (std::size_t step, Points& points)
{
  for (std::size_t i = 0; i < 400; ++i)
    points.add (0.1f * static_cast<float> (i % 20),
                0.1f * static_cast<float> (i / 20),
                i % step == 0 ? 0.5f : 0.0f);
  for (int i = 0; i < 100; ++i)
    points.add (
        0.1f * static_cast<float> (i % 10), 4.0f, 0.1f * static_cast<float> (i / 10));
  Labels labels (500, 0);
  std::fill (labels.begin() + 400, labels.end(), 1);
  MergingParameters none;
  none.enabled = false;
  LabelledPlanes found =
      mergeAssigned ({labels, momentsOfLabels (points, labels, 2, 1)}, none, 1);
  found.noises = {1.5e-2, 2_cm};
  return found;
}

} // namespace

TEST (KeepThin, LeavesPlanesWithinTheLimitAsTheyAre)
{
  Points points;
  const LabelledPlanes found = groundAndWall (80, points); // an rms of 6 cm
  const LabelledPlanes kept = keepThin (points, eightNoises(), 1, found);
  EXPECT_EQ (kept.labels, found.labels);
  EXPECT_EQ (kept.noises, found.noises);
}

TEST (KeepThin, TakesWhatIsBeyondTheLimitFromThickPlanesAlone)
{
  Points points;
  const LabelledPlanes found = groundAndWall (8, points); // an rms of 17 cm
  const LabelledPlanes kept = keepThin (points, eightNoises(), 1, found);
  ASSERT_EQ (kept.planes.fits.size(), 2u);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ (kept.labels[i], i >= 400 ? 1 : points.z[i] > 0.0f ? no_plane : 0);
  EXPECT_NEAR (kept.planes.fits[0].variances[0], 0.0, 1e-9);
  EXPECT_EQ (kept.noises, found.noises);
}

TEST (KeepThin, HasNoLimitWhereTheNoiseIsNotKnown)
{
  Points points;
  LabelledPlanes found = groundAndWall (8, points);
  found.noises[0].reset();
  EXPECT_EQ (keepThin (points, eightNoises(), 1, found).labels, found.labels);
}

TEST (KeepThin, DropsPlanesThatHaveNoPointWithinTheLimit)
{
  // The plane lies between both layers of the ground.
  Points points;
  const LabelledPlanes found = groundAndWall (3, points);
  const LabelledPlanes kept = keepThin (points, eightNoises(), 1, found);
  ASSERT_EQ (kept.planes.fits.size(), 1u);
  EXPECT_GT (std::abs (kept.planes.fits[0].plane.normal.y()), 0.9);
  EXPECT_EQ (kept.noises, (std::vector<std::optional<double>>{2_cm}));
}

TEST (KeepThin, DropsPlanesThatHaveFewPointsLeft)
{
  // The plane lies in the middle of two layers, where there are four points.
  Points points;
  for (int i = 0; i < 100; ++i)
    for (const float z : {-0.5f, 0.5f})
      points.add (static_cast<float> (i % 10), static_cast<float> (i / 10), z);
  for (int i = 0; i < 4; ++i)
    points.add (
        4.0f * static_cast<float> (i % 2), 4.0f * static_cast<float> (i / 2), 0);
  const Labels labels (points.size(), 0);
  MergingParameters none;
  none.enabled = false;
  LabelledPlanes found =
      mergeAssigned ({labels, momentsOfLabels (points, labels, 1, 1)}, none, 1);
  found.noises = {1_cm};
  EXPECT_TRUE (keepThin (points, eightNoises(), 1, found).planes.fits.empty());
}

TEST (KeepThin, TakesPointsBeyondADistanceFromAllPlanes)
{
  Points points;
  const LabelledPlanes found = groundAndWall (80, points);
  ThinPlaneLimits limits;
  limits.distance = 10_cm;
  const LabelledPlanes kept = keepThin (points, limits, 1, found);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ (kept.labels[i], i >= 400 ? 1 : points.z[i] > 0.0f ? no_plane : 0);
}
