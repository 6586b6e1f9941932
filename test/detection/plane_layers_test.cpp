// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detection/plane_layers.h"
#include "scene.h"

using pcl_ops::Labels;
using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief Two level squares of points, one above the other, labeled as one plane
 * between them, and the result of splitLayers on that plane. */
struct Split {
  /** \param[in] apart distance of the squares [m]
   * \param[in] noise standard deviation of the points along the normal [m]
   * \param[in] points_of_each number of points of each square
   * \param[in] min_apart least distance of two layers [m] */
  Split (double apart,
         double noise,
         std::size_t points_of_each,
         double min_apart = 5_mm)
  : labels (2 * points_of_each, 0), is_kept (1, 1)
  {
    RandomGenerator generator (seedOfTest());
    for (std::size_t i = 0; i < 2 * points_of_each; ++i) {
      const double height = i < points_of_each ? 0.0 : apart;
      const Surface ground = {{0, 0, height}, {2, 0, 0}, {0, 2, 0}};
      const pcl::PointXYZ p = toPoint (drawPointOf (ground, noise, generator));
      points.add (p.x, p.y, p.z);
    }
    const pcl_ops::Plane middle = {Eigen::Vector3d::UnitZ(), -0.5 * apart};
    splitLayers (points, {middle}, {min_apart}, labels, is_kept);
  }

  /** \brief Number of planes after the split: 1 if there was none. */
  std::size_t
  planes () const
  {
    return is_kept.size();
  }

  Coordinates points;
  Labels labels;
  /** \brief A 1 for each plane: for the given one, and for a new one if it was split.
   */
  std::vector<char> is_kept;
};

} // namespace

TEST (PlaneLayers, AreTheTwoSidesOfAThinWall)
{
  const Split split (4_cm, 3_mm, 500);
  ASSERT_EQ (split.is_kept, (std::vector<char>{1, 1}));
  for (std::size_t i = 0; i < split.labels.size(); ++i)
    ASSERT_EQ (split.labels[i], i < 500 ? 0 : 1);
}

TEST (PlaneLayers, AreNoneOfOneNoisyPlane)
{
  EXPECT_EQ (Split (0.0, 1_cm, 2000).planes(), 1u);
}

TEST (PlaneLayers, AreNoneIfTheyAreOnlyTheirNoiseApart)
{
  EXPECT_EQ (Split (1_cm, 1_cm, 2000).planes(), 1u);
}

TEST (PlaneLayers, AreAtLeastAsFarApartAsIsAsked)
{
  EXPECT_EQ (Split (4_cm, 3_mm, 500, 3_cm).planes(), 2u);
  EXPECT_EQ (Split (4_cm, 3_mm, 500, 5_cm).planes(), 1u);
}

TEST (PlaneLayers, NeedFiftyPointsTogether)
{
  // Two squares have 40 points together, or 60.
  EXPECT_EQ (Split (4_cm, 3_mm, 20).planes(), 1u);
  EXPECT_EQ (Split (4_cm, 3_mm, 30).planes(), 2u);
}
