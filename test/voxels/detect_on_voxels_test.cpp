// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "voxel_scene.h"
#include "voxels/detect_on_voxels.h"

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief A narrow board in 15 voxels of 10 cm, fewer than the 20 that a plane needs,
 * but in 60 voxels of 5 cm. */
const Surface board = {{0, 0, 1.01}, {1.5, 0, 0}, {0, 0.1, 0}};

/** \brief points_of_surface points on each surface.
 * \param[in] max_offset of points along the normal, as in \ref addGrid [m] */
Points
pointsOf (const std::vector<Surface>& surfaces, double max_offset = 0.0)
{
  return gridsOf (surfaces, grid_steps, max_offset);
}

using Parameters = pcl_ops::OrientedPointSamplingParameters;

/** \brief Normals come from voxels of the given size alone. */
constexpr int one_resolution = 1;

/** \brief Parameters with voxels of 10 cm. */
Parameters
parametersOf10cm (int resolutions = Parameters().surfels.resolutions)
{
  Parameters parameters;
  parameters.surfels.voxel_size = 10_cm;
  parameters.surfels.resolutions = resolutions;
  return parameters;
}

LabeledPlanes
detect (const Points& points, const Parameters& parameters = parametersOf10cm())
{
  pcl_ops::StageDurations durations;
  return detectOnVoxels (points, parameters, durations);
}

std::size_t
pointCountOn (std::int32_t plane, const LabeledPlanes& found)
{
  return static_cast<std::size_t> (
      std::count (found.labels.begin(), found.labels.end(), plane));
}

} // namespace

TEST (DetectOnVoxels, MakesOnePlaneOfTwoThatAGapDividesAndFindsANarrowBoard)
{
  const Surface beyond_gap = {{3, 0, 0.05}, {2, 0, 0}, {0, 2, 0}};
  const LabeledPlanes found = detect (pointsOf ({ground, beyond_gap, board}));
  EXPECT_EQ (found.planes_before_merging, 3u);
  EXPECT_EQ (found.planes.fits.size(), 2u);
  EXPECT_EQ (pointCountOn (0, found), 2 * points_of_surface)
      << "on both sides of the gap";
  EXPECT_EQ (pointCountOn (1, found), points_of_surface)
      << "the board, found in voxels of half the edge";
}

TEST (DetectOnVoxels, SaysTheVoxelSizeAndTheDistanceThatItUsed)
{
  // Offsets drawn uniformly up to 2 cm have an rms of 2 cm / sqrt (3) = 1.15 cm. By
  // default a point may be five times that from its plane (assignment_noise_factor).
  const LabeledPlanes noisy = detect (pointsOf ({ground}, 2_cm));
  EXPECT_EQ (noisy.used.voxel_size, parametersOf10cm().surfels.voxel_size);
  ASSERT_TRUE (noisy.used.distance_threshold);
  EXPECT_NEAR (*noisy.used.distance_threshold, 5 * 0.0115, 1_cm);
  Parameters threshold_alone = parametersOf10cm();
  threshold_alone.surfels.voxel_size.reset();
  threshold_alone.distance_threshold = 1_cm;
  const LabeledPlanes limited = detect (pointsOf ({ground}, 2_cm), threshold_alone);
  EXPECT_GT (limited.used.voxel_size.value_or (0), 1_cm) << "chosen by the detector";
  EXPECT_NEAR (limited.used.distance_threshold.value_or (0), 1_cm, 1e-6);
  EXPECT_EQ (detect (Points()).used.distance_threshold, std::nullopt);
}

TEST (DetectOnVoxels, KeepsApartWhatNoiseDoesNotExplain)
{
  // A second ground beside the first, 3 cm higher, which is less than theta_h of the
  // paper, 5 cm. Offsets of up to 6 cm explain the step.
  for (const double max_offset : {0.0, 6_cm}) {
    const Points points =
        pointsOf ({ground, {{3, 0, 0.08}, {2, 0, 0}, {0, 2, 0}}}, max_offset);
    EXPECT_EQ (detect (points).planes.fits.size(), max_offset == 0.0 ? 2u : 1u);
  }
}

TEST (DetectOnVoxels, CountsEachPointOnce)
{
  // The board stands on the ground. Around it planes are searched in voxels of 10 cm
  // and of 5 cm.
  const Surface upright_board = {{0, 1.05, 0.1}, {1.5, 0, 0}, {0, 0, 0.1}};
  const LabeledPlanes found = detect (pointsOf ({ground, upright_board}));
  ASSERT_EQ (found.planes.fits.size(), 2u);
  for (const std::int32_t plane : {0, 1})
    EXPECT_EQ (found.planes.moments[static_cast<std::size_t> (plane)].count,
               static_cast<double> (pointCountOn (plane, found)));
}

TEST (DetectOnVoxels, TakesSurfelsUpToAThicknessOfEachSizeOfVoxels)
{
  // Points up to 4 cm off: thick in voxels of 10 cm, which sure_thickness is for, and
  // in those of half the edge, which max_thickness is for. No surfel is thicker than 1.
  const Points points = pointsOf ({ground}, 4_cm);
  Parameters parameters = parametersOf10cm (one_resolution);
  const struct {
    double sure_thickness, max_thickness;
    bool has_planes;
  } rows[] = {{0.0, 0.0, false}, {1.0, 0.0, true}, {0.0, 1.0, true}};
  for (const auto& row : rows) {
    parameters.surfels.sure_thickness = row.sure_thickness;
    parameters.surfels.max_thickness = row.max_thickness;
    EXPECT_EQ (!detect (points, parameters).planes.fits.empty(), row.has_planes);
  }
}

TEST (DetectOnVoxels, AsksForPointsEnoughForANormal)
{
  // 36 points in each voxel, 9 voxels in a neighborhood: 324 points. A surfel needs k /
  // 2 points, so the largest k is 2 * 324 = 648.
  const Points points = pointsOf ({ground});
  Parameters parameters = parametersOf10cm (one_resolution);
  for (const int k : {30, 640, 650}) {
    parameters.k = k;
    EXPECT_EQ (detect (points, parameters).planes.fits.size(), k < 648 ? 1u : 0u) << k;
  }
  parameters.k = 30;
  parameters.surfels.min_average_voxels = 9.1;
  EXPECT_EQ (detect (points, parameters).planes.fits.size(), 0u)
      << "a neighborhood of nine voxels has fewer points than 9.1 average voxels";
}

TEST (DetectOnVoxels, GrowsOverPointsTooFewForANormal)
{
  // Two parts of a ground, and in the gap of 1 m between them one point in each voxel.
  Points points = pointsOf ({{{0, 0, 0.05}, {1.5, 0, 0}, {0, 2, 0}},
                             {{2.5, 0, 0.05}, {1.5, 0, 0}, {0, 2, 0}}},
                            5_mm);
  for (int x = 0; x < 10; ++x)
    for (int y = 0; y < 20; ++y)
      points.add (1.55f + 0.1f * static_cast<float> (x),
                  0.05f + 0.1f * static_cast<float> (y),
                  0.05f);
  const LabeledPlanes found = detect (points, parametersOf10cm (one_resolution));
  EXPECT_EQ (found.planes_before_merging, 2u);
  EXPECT_EQ (found.planes.fits.size(), 1u);
  EXPECT_EQ (pointCountOn (0, found), points.size());
}
