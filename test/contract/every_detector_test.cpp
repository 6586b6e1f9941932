// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcl_ops/fast_sampling_plane_filtering.h"
#include "pcl_ops/kernel_hough_transform.h"
#include "presets.h"
#include "scene.h"

#include <limits>
#include <map>

// What holds for all three detectors by default, and for OPS as in the paper.

namespace {

/** \brief A corner of a room with points as near to each other as a depth camera sees
 * them. */
LabelledScene
denseRoom ()
{
  return room().spacing (2_cm).build();
}

std::map<std::string, Cloud::Ptr>
cloudsWithoutAPlane ()
{
  const auto curve = [] (float i) { return pcl::PointXYZ (i, i * i, 0); };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  return {{"a point", cloudOf (1, curve)},
          {"two points", cloudOf (2, curve)},
          {"three points", cloudOf (3, curve)},
          {"equal points",
           cloudOf (1000, [] (float) { return pcl::PointXYZ (1.1f, 2.2f, 3.3f); })},
          {"nothing finite",
           cloudOf (500, [=] (float i) { return pcl::PointXYZ (nan, i, 2); })},
          {"a line", cloudOf (5000, [] (float i) {
             return pcl::PointXYZ (0.01f * i, 1 - 0.02f * i, 3 + 0.005f * i);
           })}};
}

/** \brief The largest planes are those of the scene; some clutter may be a small one.
 */
void
expectHasEverySurface (std::vector<pcl_ops::PlaneSegment> planes,
                       const LabelledScene& scene)
{
  ASSERT_GE (planes.size(), scene.surfaces.size());
  planes.resize (scene.surfaces.size());
  expectFindsEverySurface (planes, scene);
}

} // namespace

template <typename Detector>
class EveryDetector : public ::testing::Test {
protected:
  static Detector
  on (const Cloud::ConstPtr& cloud)
  {
    Detector detector;
    detector.setInputCloud (cloud);
    return detector;
  }
};

/** \brief With enough samples for a small scene. */
struct PublishedOps : Ops {
  PublishedOps() : Ops (paperOn (nullptr)) {}
};

using Detectors = ::testing::Types<Ops,
                                   PublishedOps,
                                   pcl_ops::FastSamplingPlaneFiltering<pcl::PointXYZ>,
                                   pcl_ops::KernelHoughTransform<pcl::PointXYZ>>;
TYPED_TEST_SUITE (EveryDetector, Detectors);

TYPED_TEST (EveryDetector, FindsEverySurfaceOfARoom)
{
  const LabelledScene scene = denseRoom();
  auto detector = this->on (scene.cloud);
  expectHasEverySurface (planesOf (detector), scene);
}

TYPED_TEST (EveryDetector, FindsNothingWhereThereIsNoPlane)
{
  for (const auto& [name, cloud] : cloudsWithoutAPlane()) {
    auto detector = this->on (cloud);
    EXPECT_TRUE (planesOf (detector).empty()) << name;
  }
}

TYPED_TEST (EveryDetector, TakesAPointThatIsThereTwiceForTwo)
{
  const auto cloud = Scene().floor (1, 1).spacing (1_cm).build().cloud;
  *cloud += Cloud (*cloud);
  auto detector = this->on (cloud);
  const auto planes = inliersOf (detector);
  ASSERT_EQ (planes.size(), 1u);
  EXPECT_EQ (planes[0].size(), cloud->size());
}

TYPED_TEST (EveryDetector, UsesTheGivenIndicesAlone)
{
  const LabelledScene scene = denseRoom();
  const auto floor = pcl::make_shared<pcl::Indices>();
  for (std::size_t i = 0; i < scene.labels.size(); ++i)
    if (scene.labels[i] == 0)
      floor->push_back (static_cast<pcl::index_t> (i));
  auto detector = this->on (scene.cloud);
  detector.setIndices (floor);
  EXPECT_EQ (inliersOf (detector), std::vector<pcl::Indices>{*floor});
}

TYPED_TEST (EveryDetector, DropsPointsThatAreNotFinite)
{
  LabelledScene scene = denseRoom();
  scene.cloud->is_dense = true; // a lie
  for (std::size_t i = 0; i < scene.labels.size(); i += 3) {
    (*scene.cloud)[i].z = i % 2 ? std::numeric_limits<float>::quiet_NaN()
                                : std::numeric_limits<float>::infinity();
    scene.labels[i] = -1;
  }
  auto detector = this->on (scene.cloud);
  const auto planes = planesOf (detector);
  expectHasEverySurface (planes, scene);
  for (const auto& plane : planes)
    for (const pcl::index_t i : plane.inliers)
      ASSERT_NE (i % 3, 0) << "point " << i << " is not finite";
}

TYPED_TEST (EveryDetector, IsTheSameForAnyNumberOfThreads)
{
  // 140,000 points: more than a thread takes at once in any stage.
  auto detector = this->on (room().spacing (1.45e-2).noise (2_cm).build().cloud);
  const auto planes = inliersOf (detector);
  for (const unsigned threads : {2u, 5u, 0u}) {
    detector.setNumberOfThreads (threads);
    EXPECT_EQ (inliersOf (detector), planes) << threads << " threads";
  }
}

TYPED_TEST (EveryDetector, TakesTimeForItsStagesAndNoMoreThanTheDetection)
{
  auto detector = this->on (denseRoom().cloud);
  planesOf (detector);
  const auto& t = detector.getStageDurations();
  for (const double stage : {t.search, t.extraction, t.assignment, t.merging})
    EXPECT_GT (stage, 0.0);
  EXPECT_EQ (t.normals > 0.0, (std::is_base_of_v<Ops, TypeParam>))
      << "the others need none";
  EXPECT_LE (t.search + t.normals + t.extraction + t.assignment + t.merging,
             t.detection);
}
