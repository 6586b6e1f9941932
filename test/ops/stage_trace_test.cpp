// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "presets.h"
#include "scene.h"
#include <pcl_ops/detect_planes.h>

#include <limits>
#include <string>

using pcl_ops::no_plane;
using pcl_ops::PlaneSegment;
using pcl_ops::Stage;
using pcl_ops::StageResult;

namespace {

using TracedParameters = pcl_ops::OrientedPointSamplingParameters;

/** \brief The y coordinate of a point whose reading is missing. */
constexpr float not_read = std::numeric_limits<float>::quiet_NaN();

/** \brief The points of a floor and of a wall, and then a copy of every second of them,
 * so that the last third of the cloud are copies. The reading of every tenth original,
 * and so of every fifth copy, is missing. */
Cloud
floorAndWallWithCopies ()
{
  Cloud cloud = *Scene()
                     .floor (3, 3)
                     .wall ({0, 0}, {0, 3}, 2)
                     .spacing (4_cm)
                     .noise (3_mm)
                     .build()
                     .cloud;
  for (std::size_t i = 0; i < cloud.size(); i += 10)
    cloud[i].y = not_read;
  const std::size_t size = cloud.size();
  for (std::size_t i = 0; i < size; i += 2)
    cloud.push_back (cloud[i]);
  return cloud;
}

/** \brief The planes of a detection, and what it reported after each stage. */
struct Trace {
  std::vector<PlaneSegment> planes;
  std::vector<StageResult> stages;
};

/** \brief Detects planes and keeps what is reported after each stage. */
Trace
traceOf (const Cloud& cloud, TracedParameters parameters = {})
{
  Trace trace;
  parameters.on_stage = [&] (const auto& stage) { trace.stages.push_back (stage); };
  trace.planes = detectPlanes (cloud, parameters);
  return trace;
}

/** \brief The result of a stage in a trace that has all stages. */
const StageResult&
resultOf (Stage stage, const Trace& trace)
{
  return trace.stages.at (static_cast<std::size_t> (stage));
}

/** \brief Whether the reading of a point is not missing. */
bool
isRead (const pcl::PointXYZ& point)
{
  return !std::isnan (point.y);
}

} // namespace

TEST (StageTrace, ReportsEachStageOnceInOrder)
{
  const Trace trace = traceOf (floorAndWallWithCopies());
  ASSERT_EQ (trace.stages.size(), std::size (pcl_ops::all_stages));
  std::string names;
  for (std::size_t i = 0; i < trace.stages.size(); ++i) {
    EXPECT_EQ (trace.stages[i].stage, pcl_ops::all_stages[i]);
    names += toString (trace.stages[i].stage) + std::string (" ");
  }
  EXPECT_EQ (names, "density noise supports regions joined planes labels ");
}

TEST (StageTrace, HasAValueOrALabelForEachPointThatWasRead)
{
  const Cloud cloud = floorAndWallWithCopies();
  const Trace trace = traceOf (cloud);
  ASSERT_EQ (trace.stages.size(), std::size (pcl_ops::all_stages));
  for (const StageResult& result : trace.stages) {
    SCOPED_TRACE (toString (result.stage));
    const bool has_values = result.stage <= Stage::Supports;
    EXPECT_EQ (result.values.size(), has_values ? cloud.size() : 0);
    EXPECT_EQ (result.labels.size(),
               result.stage >= Stage::Supports ? cloud.size() : 0);
    for (std::size_t i = 0; i < result.values.size(); ++i)
      ASSERT_EQ (result.values[i] > 0.0f, isRead (cloud[i])) << i;
    for (std::size_t i = 0; i < result.labels.size(); ++i)
      if (!isRead (cloud[i])) {
        ASSERT_EQ (result.labels[i], no_plane) << i;
      }
  }
}

TEST (StageTrace, SaysTheSameOfEqualPoints)
{
  const Cloud cloud = floorAndWallWithCopies();
  const std::size_t first_copy = 2 * cloud.size() / 3;
  ASSERT_EQ (cloud[first_copy + 1].x, cloud[2].x);
  const Trace trace = traceOf (cloud);
  ASSERT_EQ (trace.stages.size(), std::size (pcl_ops::all_stages));
  for (const StageResult& result : trace.stages)
    for (std::size_t i = first_copy; i < cloud.size(); ++i) {
      const std::size_t original = 2 * (i - first_copy); // of copy i
      if (!result.labels.empty()) {
        ASSERT_EQ (result.labels[i], result.labels[original]) << i;
      }
      if (!result.values.empty() && isRead (cloud[i])) {
        ASSERT_EQ (result.values[i], result.values[original]) << i;
      }
    }
}

TEST (StageTrace, EndsWithTheLabelsOfTheResult)
{
  // The wall has fewer than 6000 points, the floor more.
  TracedParameters parameters;
  for (const std::size_t min_points : {0, 6000}) {
    parameters.min_points = min_points;
    const Cloud cloud = floorAndWallWithCopies();
    const Trace trace = traceOf (cloud, parameters);
    ASSERT_EQ (trace.planes.size(), min_points == 0 ? 2u : 1u);
    pcl_ops::Labels labels (cloud.size(), no_plane);
    for (std::size_t p = 0; p < trace.planes.size(); ++p)
      for (const pcl::index_t i : trace.planes[p].inliers)
        labels[i] = static_cast<std::int32_t> (p);
    EXPECT_EQ (resultOf (Stage::Labels, trace).labels, labels);
  }
}

TEST (StageTrace, HasDensitiesAndNoisesOfTheCloud)
{
  // The median of the values after a stage, for a floor of this spacing and noise [m].
  const auto medianAfter = [] (Stage stage, double spacing, double noise) {
    const auto cloud =
        Scene().floor (2, 2).spacing (spacing).noise (noise).build().cloud;
    std::vector<float> values = resultOf (stage, traceOf (*cloud)).values;
    std::nth_element (values.begin(), values.begin() + values.size() / 2, values.end());
    return static_cast<double> (values[values.size() / 2]);
  };
  // Half the spacing is four times the density, roughly: neighborhoods have no sharp
  // rim.
  EXPECT_NEAR (medianAfter (Stage::Density, 0.02, 0.003) /
                   medianAfter (Stage::Density, 0.04, 0.003),
               4.0,
               0.7);
  EXPECT_NEAR (medianAfter (Stage::Noise, 0.03, 0.003), 0.003, 0.0005);
  EXPECT_NEAR (medianAfter (Stage::Noise, 0.03, 0.006), 0.006, 0.001);
}

TEST (StageTrace, KeepsOfTheJoinedRegionsThoseThatArePlanes)
{
  const Trace trace = traceOf (floorAndWallWithCopies());
  const pcl_ops::Labels& grown = resultOf (Stage::Regions, trace).labels;
  const pcl_ops::Labels& joined = resultOf (Stage::Joined, trace).labels;
  const pcl_ops::Labels& planes = resultOf (Stage::Planes, trace).labels;
  ASSERT_FALSE (planes.empty());
  ASSERT_EQ (planes.size(), joined.size());
  ASSERT_EQ (grown.size(), joined.size());
  EXPECT_LT (2 * std::count (planes.begin(), planes.end(), no_plane),
             static_cast<std::ptrdiff_t> (planes.size()));
  for (std::size_t i = 0; i < joined.size(); ++i) {
    ASSERT_EQ (grown[i] == no_plane, joined[i] == no_plane);
    if (planes[i] != no_plane) {
      ASSERT_EQ (planes[i], joined[i]);
    }
  }
}

TEST (StageTrace, ChangesNothingOfTheResult)
{
  const Cloud cloud = floorAndWallWithCopies();
  const std::vector<PlaneSegment> planes = detectPlanes (cloud, TracedParameters());
  ASSERT_GE (planes.size(), 2u);
  const Trace trace = traceOf (cloud);
  ASSERT_EQ (trace.planes.size(), planes.size());
  for (std::size_t p = 0; p < planes.size(); ++p)
    EXPECT_EQ (trace.planes[p].inliers, planes[p].inliers);
}

TEST (StageTrace, HasTheLabelsAloneOfTooFewPoints)
{
  const Cloud cloud = floorAndWallWithCopies();
  Cloud few;
  for (int i = 1; i < 5; ++i)
    few.push_back (cloud[i]);
  const Trace trace = traceOf (few);
  ASSERT_EQ (trace.stages.size(), 1u);
  EXPECT_EQ (trace.stages[0].stage, Stage::Labels);
  EXPECT_EQ (trace.stages[0].labels, pcl_ops::Labels (few.size(), no_plane));
}

TEST (StageTrace, IsOfNeighborhoodsAlone)
{
  TracedParameters on_voxels;
  on_voxels.surfels.voxel_size = 0.1;
  for (const TracedParameters& parameters : {on_voxels, TracedParameters::paper()})
    EXPECT_TRUE (traceOf (floorAndWallWithCopies(), parameters).stages.empty());
}
