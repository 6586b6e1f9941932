// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "leaf_scene.h"
#include "leaves/plane_contacts.h"

#include <map>

using pcl_ops::no_plane;
using namespace pcl_ops::internal;

namespace {

/** \brief A noisy ground of three planes that meet at (1, 1), with noises of their own.
 * A strip of it is on no plane. */
void
makeThreePlanes (LeafScene& scene)
{
  scene.addPlane (ground, 1_cm, before (1.0));
  scene.addPlane ({Eigen::Vector3d::UnitZ(), -0.06}, 2_cm, [] (const auto& at) {
    return at.x() >= 1.0 && at.y() < 1.0;
  });
  scene.addPlane ({Eigen::Vector3d::UnitZ(), -0.03}, 3_cm, [] (const auto& at) {
    return at.x() >= 1.0 && at.y() >= 1.0;
  });
  scene.label (no_plane, 0.0, behind (1.8));
}

using Pair = std::pair<std::int32_t, std::int32_t>;

/** \brief The sums of each pair of planes, over all pairs of leaves. */
std::map<Pair, PlaneContact>
summedOneByOne (const LeafScene& scene)
{
  const LeafPlanes& planes = scene.planes;
  std::map<Pair, PlaneContact> sums;
  for (std::uint32_t leaf = 0; leaf < scene.cloud.size(); ++leaf)
    for (const std::uint32_t k : scene.cloud.neighbors[leaf]) {
      const Pair pair (planes.plane_of_leaf[leaf], planes.plane_of_leaf[k]);
      if (pair.first == pair.second || std::min (pair.first, pair.second) == no_plane)
        continue;
      PlaneContact& sum = sums[pair];
      sum.links += 1.0;
      sum.squared_noise += planes.noise[k] * planes.noise[k];
      sum.squared_distance += 0.5 * meanSquaredDistance (scene.cloud.moments[k],
                                                         planes.planes[pair.first]) +
                              0.5 * meanSquaredDistance (scene.cloud.moments[leaf],
                                                         planes.planes[pair.second]);
    }
  return sums;
}

void
expectTheSame (const PlaneContacts& one, const PlaneContacts& other, std::size_t planes)
{
  for (std::size_t p = 0; p < planes; ++p) {
    EXPECT_EQ (one.border (p), other.border (p));
    ASSERT_EQ (one.end (p) - one.begin (p), other.end (p) - other.begin (p));
    const PlaneContact* b = other.begin (p);
    for (const PlaneContact* a = one.begin (p); a != one.end (p); ++a, ++b) {
      EXPECT_EQ (a->to, b->to);
      EXPECT_EQ (a->links, b->links);
      EXPECT_DOUBLE_EQ (a->squared_noise, b->squared_noise);
      EXPECT_DOUBLE_EQ (a->squared_distance, b->squared_distance);
      EXPECT_DOUBLE_EQ (a->squared_grain, b->squared_grain);
    }
  }
}

} // namespace

TEST (PlaneContacts, AreSumsOverThePairsOfTouchingLeaves)
{
  LeafScene scene ({ground}, 1_cm);
  makeThreePlanes (scene);
  const PlaneContacts contacts (scene.cloud, scene.planes, 2);
  const std::map<Pair, PlaneContact> expected = summedOneByOne (scene);
  EXPECT_EQ (expected.size(), 6u);
  std::size_t found = 0;
  for (std::int32_t p = 0; p < 3; ++p)
    for (const PlaneContact* contact = contacts.begin (p); contact != contacts.end (p);
         ++contact, ++found) {
      ASSERT_EQ (contact->from, p);
      const PlaneContact& sum = expected.at ({p, contact->to});
      EXPECT_EQ (contact->links, sum.links);
      EXPECT_NEAR (contact->squared_noise, sum.squared_noise, 1e-12);
      EXPECT_NEAR (contact->squared_distance, sum.squared_distance, 1e-12);
    }
  EXPECT_EQ (found, 6u);
}

TEST (PlaneContacts, KnowTheBorderAndThatOpenLeavesAreHalfOfIt)
{
  // Rows of 20 leaves touch in 20 + 2 19 pairs.
  LeafScene scene ({ground});
  scene.addPlane (ground, 1_cm, before (0.5));
  scene.addPlane (
      ground, 1_cm, [] (const auto& at) { return at.x() > 0.5 && at.x() < 1.0; });
  const PlaneContacts contacts (scene.cloud, scene.planes, 2);
  EXPECT_EQ (contacts.border (0), 58.0);
  EXPECT_EQ (contacts.border (1), 58.0 + 0.5 * 58.0);
}

TEST (PlaneContacts, HaveTheGrainOfTheLeavesBesideThemWithoutTheStep)
{
  const Surface higher = {{1, 0, 0.08}, {1, 0, 0}, {0, 2, 0}};
  Coordinates points = gridsOf ({ground}, 120);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (points.x[i] > 1.0f)
      points.z[i] += 0.03f;
  LeafScene scene (points);
  scene.addPlane (ground, 1_cm, before (1.0));
  scene.addPlane (higher, 1_cm, behind (1.0));
  const PlaneContacts contacts (scene.cloud, scene.planes, 2);
  const PlaneContact& contact = *contacts.begin (0);
  EXPECT_NEAR (std::sqrt (contact.squared_distance / contact.links), 3_cm, 1e-6);
  EXPECT_NEAR (std::sqrt (contact.squared_grain / contact.links),
               scene.cloud.min_noise[0],
               1e-6);
}

TEST (PlaneContacts, AfterPlanesChangedAreThoseOfANewCount)
{
  LeafScene scene ({ground}, 1_cm);
  makeThreePlanes (scene);
  PlaneContacts contacts (scene.cloud, scene.planes, 2);
  for (std::int32_t& plane : scene.planes.plane_of_leaf)
    plane = plane == 2 ? 0 : plane;
  refitPlanes (scene.cloud, scene.planes);
  contacts.update (scene.cloud, scene.planes, {1, 0, 1});
  // The third plane changed and has no leaves; the second was fitted as well.
  contacts.update (scene.cloud, scene.planes, {0, 1, 0});
  expectTheSame (contacts, PlaneContacts (scene.cloud, scene.planes, 1), 3);
}

TEST (PlaneContacts, OfAnotherPlaneAreLeftWhenPlanesChange)
{
  LeafScene scene ({ground}, 1_cm);
  makeThreePlanes (scene);
  PlaneContacts contacts (scene.cloud, scene.planes, 2);
  const PlaneContact before_change = *contacts.begin (1);
  scene.planes.planes[2].offset = 7.0;
  contacts.update (scene.cloud, scene.planes, {0, 0, 1});
  EXPECT_EQ (contacts.begin (1)->to, 0);
  EXPECT_EQ (contacts.begin (1)->squared_distance, before_change.squared_distance);
  EXPECT_GT ((contacts.begin (1) + 1)->squared_distance, 1.0);
}
