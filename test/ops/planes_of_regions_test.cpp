// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops/planes_of_regions.h"
#include "place_scene.h"

#include <cmath>

using namespace pcl_ops::internal;

namespace {

constexpr double noise_of_waves = 4_mm; // of each place and of the region

/** \brief Number of planes that planesOfRegions makes of one region: a ground of 20 m x
 * 20 m in waves of this amplitude [m]. */
std::size_t
planesOfWaves (double amplitude)
{
  constexpr double wavelength = 5_m;
  Points points;
  for (double x = 0.0; x < 20_m; x += 25_cm)
    for (double y = 0.0; y < 20_m; y += 25_cm)
      points.add (
          static_cast<float> (x),
          static_cast<float> (y),
          static_cast<float> (amplitude * std::sin (2.0 * M_PI * x / wavelength)));
  PlaceScene scene (points);
  std::fill (scene.noise.of_place.begin(),
             scene.noise.of_place.end(),
             static_cast<float> (noise_of_waves));
  Region whole_ground;
  for (const Eigen::Vector3d& position : scene.places.position)
    whole_ground.moments.add (position.x(), position.y(), position.z());
  whole_ground.scatter = noise_of_waves;
  whole_ground.noise = noise_of_waves;
  whole_ground.has_parts = true;
  whole_ground.refit();
  scene.regions = {{whole_ground}, pcl_ops::Labels (scene.places.size(), 0)};
  const std::vector<char> is_plane = {1};
  return planesOfRegions (points,
                          scene.distinct,
                          scene.places,
                          scene.noise,
                          scene.regions,
                          is_plane,
                          pcl_ops::OrientedPointSamplingParameters())
      .planes.fits.size();
}

} // namespace

TEST (PlanesOfRegions, AreNotThickerThanTwelveNoises)
{
  // The rms of a wave is its amplitude over sqrt (2); twelve noises are 48 mm.
  EXPECT_EQ (planesOfWaves (60_mm), 1u); // an rms of 42 mm
  EXPECT_EQ (planesOfWaves (78_mm), 0u); // an rms of 55 mm
}
