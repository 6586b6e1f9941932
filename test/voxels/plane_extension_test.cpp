// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "grid_scene.h"
#include "voxels/plane_extension.h"

using pcl_ops::Labels;
using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief A floor at z = 0 that ends at x = 1.6 m and is plane 0, and rows of points
 * beyond its end, which are along y and on no plane. */
struct FloorAndRows {
  static constexpr int floor_steps = 48;
  static constexpr int points_of_floor = floor_steps * floor_steps;
  static constexpr int points_of_row = 20;
  Coordinates points;

  /** \param[in] width of the floor along y [m] */
  explicit FloorAndRows (double width = 1.6)
  {
    addGrid (points, {{0, 0, 0}, {1.6, 0, 0}, {0, width, 0}}, floor_steps, 1_mm);
  }

  /** \brief Adds a row of points 8 cm apart, at x and above the floor by height [m]. */
  FloorAndRows&
  row (double x, double height)
  {
    for (int i = 0; i < points_of_row; ++i)
      points.add (static_cast<float> (x), 0.08f * i, static_cast<float> (height));
    return *this;
  }

  /** \brief The label of each row after the floor was extended from voxels of 10 cm.
   * Fails the test if the points of a row differ in label.
   * \param[in] doublings how many times the edge of voxels is doubled
   * \param[in] distance_threshold largest distance of a point to the floor [m] */
  Labels
  labelsAfterExtension (int doublings,
                        std::optional<double> distance_threshold = {}) const
  {
    const VoxelGrid grid = connectedGrid (points, 10_cm);
    AssignedPoints assigned{Labels (points.size(), no_plane), {{}}};
    for (int i = 0; i < points_of_floor; ++i) {
      assigned.labels[i] = 0;
      assigned.moments[0].add (points.x[i], points.y[i], points.z[i]);
    }
    extendPlanes (points,
                  grid,
                  openPoints (grid, upTo (grid.size()), assigned.labels),
                  doublings,
                  distance_threshold,
                  assigned);
    EXPECT_EQ (assigned.moments[0].count,
               std::count (assigned.labels.begin(), assigned.labels.end(), 0));
    Labels of_rows;
    for (auto row = assigned.labels.begin() + points_of_floor;
         row != assigned.labels.end();
         row += points_of_row) {
      EXPECT_EQ (std::count (row, row + points_of_row, *row), points_of_row);
      of_rows.push_back (*row);
    }
    return of_rows;
  }
};

} // namespace

TEST (PlaneExtension, TakesPointsOfWidePlanesUpToTheLargestVoxelsAndTheThreshold)
{
  // The floor ends where voxels of 20 and of 40 cm end, too. A row 30 cm beyond it is
  // two voxels of 20 cm away, but in a voxel of 40 cm next to one of the floor.
  const FloorAndRows near = FloorAndRows().row (1.9, 0.0);
  EXPECT_EQ (near.labelsAfterExtension (3), (Labels{0}));
  EXPECT_EQ (near.labelsAfterExtension (1), (Labels{no_plane}));
  EXPECT_EQ (near.labelsAfterExtension (2), (Labels{0}));
  constexpr double half_millimeter = 5e-4; // [m]
  const FloorAndRows narrow = FloorAndRows (0.2).row (1.9, 0.0);
  EXPECT_EQ (narrow.labelsAfterExtension (3), (Labels{no_plane}))
      << "narrower than the voxels";
  const FloorAndRows above = FloorAndRows().row (1.9, 1_mm).row (1.9, 5_cm);
  EXPECT_EQ (above.labelsAfterExtension (3), (Labels{0, no_plane}));
  EXPECT_EQ (above.labelsAfterExtension (3, half_millimeter),
             (Labels{no_plane, no_plane}));
}

TEST (PlaneExtension, GoesOnFromPointsThatItTook)
{
  // The largest voxels have an edge of 80 cm.
  EXPECT_EQ (FloorAndRows().row (2.9, 0.0).labelsAfterExtension (3),
             (Labels{no_plane}));
  EXPECT_EQ (FloorAndRows().row (1.9, 0.0).row (2.9, 0.0).labelsAfterExtension (3),
             (Labels{0, 0}));
}
