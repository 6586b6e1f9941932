// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/planes_of_regions.h"
#include "place_scene.h"

#include <cmath>

using namespace pcl_ops::internal;

namespace {

/** \brief How many planes are left of one region, a ground of 20 m x 20 m that rises
 * and falls by an amplitude, where points have 4 mm of noise. */
std::size_t
planesOfWaves (double amplitude)
{
  constexpr double wave = 5_m;
  Points points;
  for (double x = 0.0; x < 20_m; x += 25_cm)
    for (double y = 0.0; y < 20_m; y += 25_cm)
      points.add (static_cast<float> (x),
                  static_cast<float> (y),
                  static_cast<float> (amplitude * std::sin (2.0 * M_PI * x / wave)));
  PlaceScene scene (points);
  std::fill (scene.noise.of_place.begin(), scene.noise.of_place.end(), 4e-3F);
  Region all;
  for (const Eigen::Vector3d& place : scene.places.position)
    all.moments.add (place.x(), place.y(), place.z());
  all.scatter = all.noise = 4_mm;
  all.is_joined = true;
  all.refit();
  scene.regions = {{all}, pcl_ops::Labels (scene.places.size(), 0)};
  return planesOfRegions (points,
                          scene.distinct,
                          scene.places,
                          scene.noise,
                          scene.regions,
                          {1},
                          pcl_ops::OrientedPointSamplingParameters())
      .planes.fits.size();
}

} // namespace

TEST (PlanesOfRegions, AreNotThickerThanTwelveNoises)
{
  EXPECT_EQ (planesOfWaves (60_mm), 1u); // an rms of 4.2 cm
  EXPECT_EQ (planesOfWaves (78_mm), 0u); // of 5.5 cm
}
