// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pcl_ops/fast_sampling_plane_filtering.h"
#include "pcl_ops/kernel_hough_transform.h"
#include "presets.h"
#include "scene.h"
#include <pcl_ops/detect_planes.h>

#include <cstddef>
#include <limits>
#include <map>

// What holds for all three detectors by default, and for OPS as in the paper.

namespace {

/** \brief A layout that no point type of PCL has. */
struct TimedPoint {
  double seconds;
  float x, y, z;
};

std::map<std::string, Cloud::Ptr>
cloudsWithoutAPlane ()
{
  RandomGenerator generator (seedOfTest());
  const auto draw = [&] { return static_cast<float> (10.0 * drawNormal (generator)); };
  const auto curve = [] (float i) { return pcl::PointXYZ (i, i * i, 0); };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  return {{"a point", cloudOf (1, curve)},
          {"two points", cloudOf (2, curve)},
          {"three points", cloudOf (3, curve)},
          {"equal points",
           cloudOf (1000, [] (float) { return pcl::PointXYZ (1.1f, 2.2f, 3.3f); })},
          {"nothing finite",
           cloudOf (500, [=] (float i) { return pcl::PointXYZ (nan, i, 2); })},
          {"clutter",
           cloudOf (2000,
                    [&] (float) {
                      const float x = draw(), y = draw(), z = draw();
                      return pcl::PointXYZ (x, y, z);
                    })},
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
    pcl::PCLBase<pcl::PointXYZ>& base = detector;
    base.setInputCloud (cloud);
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
  const LabelledScene scene = denseRoom().build();
  auto detector = this->on (scene.cloud);
  expectHasEverySurface (planesOf (detector), scene);
}

TYPED_TEST (EveryDetector, FindsNothingWhereThereIsNoPlaneAndCallsThatSuccess)
{
  for (const auto& [name, cloud] : cloudsWithoutAPlane()) {
    auto detector = this->on (cloud);
    EXPECT_TRUE (planesOf (detector).empty()) << name;
    pcl::PointIndices inliers;
    pcl::ModelCoefficients coefficients;
    inliers.indices = {1, 2, 3};
    coefficients.values = {1, 2, 3, 4};
    EXPECT_TRUE (detector.segment (inliers, coefficients));
    EXPECT_TRUE (inliers.indices.empty() && coefficients.values.empty()) << name;
  }
}

TYPED_TEST (EveryDetector, FindsTheSameInABufferOfItsUsers)
{
  const Cloud cloud = *room().noise (5_mm).build().cloud;
  std::vector<TimedPoint> points;
  for (const pcl::PointXYZ& point : cloud)
    points.push_back ({0.0, point.x, point.y, point.z});
  auto detector = this->on (cloud.makeShared());
  std::vector<pcl::Indices> inliers;
  for (const auto& plane : detectPlanes (pcl_ops::CloudView (points.data(),
                                                             offsetof (TimedPoint, x),
                                                             sizeof (TimedPoint),
                                                             points.size()),
                                         detector.getParameters()))
    inliers.push_back (plane.inliers);
  EXPECT_EQ (inliers, inliersOf (detector));
}

TYPED_TEST (EveryDetector, UsesTheGivenIndicesAlone)
{
  const LabelledScene scene = denseRoom().build();
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
  LabelledScene scene = denseRoom().build();
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

TYPED_TEST (EveryDetector, IsTheSameForAnyNumberOfThreadsAndForACopy)
{
  // 140,000 points: more than a thread takes at once in any stage.
  const auto cloud = room().spacing (1.45e-2).noise (2_cm).build().cloud;
  (*cloud)[7].x = std::numeric_limits<float>::quiet_NaN();
  auto detector = this->on (cloud);
  const auto planes = inliersOf (detector);
  for (const unsigned threads : {2u, 5u, 0u}) {
    TypeParam copy = detector;
    copy.setNumberOfThreads (threads);
    EXPECT_EQ (inliersOf (copy), planes) << threads << " threads";
  }
}

TYPED_TEST (EveryDetector, TakesTimeForItsStagesAndNoMoreThanTheDetection)
{
  auto detector = this->on (denseRoom().build().cloud);
  planesOf (detector);
  const auto& t = detector.getStageDurations();
  for (const double stage : {t.search, t.extraction, t.assignment, t.merging})
    EXPECT_GT (stage, 0.0);
  EXPECT_EQ (t.normals > 0.0, (std::is_base_of_v<Ops, TypeParam>))
      << "the others need none";
  EXPECT_LE (t.search + t.normals + t.extraction + t.assignment + t.merging,
             t.detection);
}
