// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"

using namespace pcl_ops::internal;

namespace {

/** \brief 5000 points anywhere on 5 m x 5 m, at one of 50 depths each. */
template <typename Depth>
CurvePoints
pointsOfDepths (Depth&& depthOf)
{
  Coordinates points = pointsInACube (5000, 5.0);
  for (std::size_t i = 0; i < points.size(); ++i)
    points.z[i] = depthOf (static_cast<int> (i % 50));
  return sortAlongCurve (points, finest_cell, 1);
}

float
everyCentimeter (int i)
{
  return 0.01f * static_cast<float> (i);
}

} // namespace

TEST (CoordinateSteps, AreAsWideAsThoseOfAQuantizedDepth)
{
  const CoordinateSteps steps (pointsOfDepths (everyCentimeter));
  EXPECT_NEAR (steps.at ({0, 0, 0.255}, 10_cm), 1_cm, 1e-6);
  EXPECT_NEAR (steps.at ({2, -1, 0.38}, 10_cm), 1_cm, 1e-6) << "on a value";
}

TEST (CoordinateSteps, MayGrowWithTheDepth)
{
  const CoordinateSteps steps (
      pointsOfDepths ([] (int i) { return 0.001f * static_cast<float> (i * i); }));
  EXPECT_NEAR (steps.at ({0, 0, 0.105}, 10_cm), 2.1e-2, 1e-6) << "10^2 to 11^2";
  EXPECT_NEAR (steps.at ({0, 0, 0.92}, 10_cm), 6.1e-2, 1e-6) << "30^2 to 31^2";
}

TEST (CoordinateSteps, AreNoneOfContinuousCoordinates)
{
  const CoordinateSteps steps (
      sortAlongCurve (pointsInACube (5000, 5.0), finest_cell, 1));
  EXPECT_EQ (steps.at ({0, 0, 0.255}, 10_cm), 0.0);
}

TEST (CoordinateSteps, AreNoneOfAFewFlatSurfaces)
{
  const CoordinateSteps steps (
      pointsOfDepths ([] (int i) { return 0.5f * static_cast<float> (i % 5); }));
  EXPECT_EQ (steps.at ({0, 0, 0.75}, 10_m), 0.0);
}

TEST (CoordinateSteps, AreNarrowerThanTheEdge)
{
  const CoordinateSteps steps (pointsOfDepths (everyCentimeter));
  EXPECT_EQ (steps.at ({0, 0, 0.255}, 5_mm), 0.0);
}

TEST (CoordinateSteps, EndWhereTheValuesEnd)
{
  const CoordinateSteps steps (pointsOfDepths (everyCentimeter));
  for (const double beyond : {-1.0, 7.0})
    EXPECT_EQ (steps.at ({0, 0, beyond}, 10_cm), 0.0);
  EXPECT_EQ (CoordinateSteps (CurvePoints()).at ({0, 0, 0}, 10_cm), 0.0);
}
