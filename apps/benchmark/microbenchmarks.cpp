// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause

// Each stage on simulated scans of growing size, with what the stages before it give.
// --benchmark_filter=REGEX chooses among them.
#include <pcl/common/io.h>
#include <pcl/search/kdtree.h>

#include <benchmark/benchmark.h>
#include <bounded/bounded_assignment.h>
#include <bounded/bounded_planes.h>
#include <bounded/noise_measurement.h>
#include <bounded/plane_growing.h>
#include <bounded/refinement.h>
#include <kht/octree_clusters.h>
#include <ops/oriented_points.h>
#include <ops/surfel_extraction.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <search/fixed_radius_search.h>
#include <simulation/dense_scan.h>

#include <map>
#include <numeric>

namespace {

using namespace pcl_ops;
using namespace pcl_ops::internal;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using benchmark::State;

constexpr unsigned threads = 1;
constexpr std::uint32_t seed = 1;
/** About 12,000 voxels at 300,000 points, as by default [m]. */
constexpr double voxel_size = 0.1;

constexpr int resolutions = 3;
constexpr double least_points = 200.0;

SurfelExtractionParameters
extractionParameters ()
{
  const SurfelParameters usual;
  SurfelExtractionParameters extraction;
  extraction.noise_factor = usual.noise_factor;
  extraction.angle_threshold = usual.angle_threshold;
  extraction.largest_thickness = usual.sure_thickness;
  return extraction;
}

/** \brief What the stages make of a scan, in their order. */
struct Scan {
  Cloud::Ptr cloud;
  pcl::Indices all;
  Points points;
  VoxelizedPoints voxelized;
  std::vector<std::optional<Surfel>> surfels;
  BoundedPlanes planes;
};

BoundedPlanes
extractedFrom (const Scan& scan)
{
  BoundedPlanes planes;
  extractSurfelPlanes (
      scan.voxelized.grid, scan.surfels, extractionParameters(), planes);
  return planes;
}

Scan
makeScan (std::size_t size)
{
  Scan scan;
  scan.cloud.reset (new Cloud);
  pcl::copyPointCloud (
      simulation::scanDensely (simulation::makeRoom (seed).scene, size, 1.0, seed)
          .cloud,
      *scan.cloud);
  scan.all.resize (size);
  std::iota (scan.all.begin(), scan.all.end(), 0);
  scan.points = finitePoints (CloudView (*scan.cloud), scan.all, threads);
  scan.voxelized = voxelize (scan.points, voxel_size, threads);
  scan.surfels = findSurfels (scan.voxelized.grid, resolutions, least_points, threads);
  scan.planes = extractedFrom (scan);
  measureNoise (scan.voxelized.grid, threads, scan.planes);
  return scan;
}

const Scan&
scanFor (State& state)
{
  static std::map<std::int64_t, Scan> scans;
  const std::int64_t size = state.range (0);
  if (scans.count (size) == 0)
    scans[size] = makeScan (static_cast<std::size_t> (size));
  return scans[size];
}

/** Times a stage and says what it takes per point. */
template <typename Stage>
void
measure (State& state, Stage&& stage)
{
  for (auto _ : state)
    benchmark::DoNotOptimize (stage());
  state.SetItemsProcessed (state.iterations() * state.range (0));
}

void
finitePointsOfACloud (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state,
           [&] { return finitePoints (CloudView (*scan.cloud), scan.all, threads); });
}

void
voxelSizeOfACloud (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] { return voxelSizeFor (scan.points, 12000.0); });
}

void
voxelizing (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] { return voxelize (scan.points, voxel_size, threads); });
}

void
findingSurfels (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] {
    return findSurfels (scan.voxelized.grid, resolutions, least_points, threads);
  });
}

void
extractingPlanesOfSurfels (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] { return extractedFrom (scan); });
}

void
measuringNoise (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] {
    BoundedPlanes planes = scan.planes;
    measureNoise (scan.voxelized.grid, threads, planes);
    return planes;
  });
}

void
refining (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state,
           [&] { return refine (scan.points, scan.voxelized, scan.planes, threads); });
}

void
growingPlanes (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] {
    BoundedPlanes planes = scan.planes;
    growPlanes (scan.voxelized.grid, std::nullopt, threads, planes);
    return planes;
  });
}

void
reassigningVoxels (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] {
    BoundedPlanes planes = scan.planes;
    reassignVoxels (scan.voxelized.grid, 1, planes);
    return planes;
  });
}

void
mergingPlanes (State& state)
{
  const Scan& scan = scanFor (state);
  MergingParameters parameters;
  parameters.distance_threshold = 0.05;
  const auto moments = momentsOfPlanes (scan.voxelized.grid, scan.planes);
  measure (state, [&] { return mergePlanes (moments, parameters); });
}

void
assigningToBoundedPlanes (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] {
    return assignToBoundedPlanes (
        scan.points, scan.voxelized, scan.planes, std::nullopt, 4.0, threads);
  });
}

void
assigningToUnboundedPlanes (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] {
    return assignPoints (
        scan.points, scan.planes.planes, 0.05, AssignmentRule::First, threads);
  });
}

/** The paper's samples: 3 % of the points, 30 neighbours, over a tree built before. */
void
orientingSamples (State& state)
{
  const Scan& scan = scanFor (state);
  pcl::search::KdTree<pcl::PointXYZ> tree;
  tree.setInputCloud (scan.cloud);
  NeighbourSearch search;
  search.nearest = [&] (pcl::index_t point, int k, auto& neighbours, auto& distances) {
    tree.nearestKSearch ((*scan.cloud)[point], k, neighbours, distances);
  };
  const Indices sample = drawSample (scan.points.size(), 0.03, seed);
  measure (state, [&] {
    return orientSamples (
        CloudView (*scan.cloud), scan.points, sample, search, 30, std::nullopt);
  });
}

void
buildingFixedRadiusSearch (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] { return FixedRadiusSearch (scan.points, 0.14, threads); });
}

void
buildingKdTree (State& state)
{
  const Scan& scan = scanFor (state);
  measure (state, [&] {
    pcl::search::KdTree<pcl::PointXYZ> tree;
    tree.setInputCloud (scan.cloud);
    return tree.getInputCloud();
  });
}

/** Reads all coordinates and writes them: the limit that memory sets. */
void
copyingPoints (State& state)
{
  const Scan& scan = scanFor (state);
  Coordinates copy = scan.points;
  measure (state, [&] {
    copy = scan.points;
    benchmark::ClobberMemory();
    return copy.x.data();
  });
}

#define PCL_OPS_STAGE(stage)                                                           \
  BENCHMARK (stage)->Arg (300000)->Arg (3000000)->Unit (benchmark::kMillisecond)
PCL_OPS_STAGE (copyingPoints);
PCL_OPS_STAGE (finitePointsOfACloud);
PCL_OPS_STAGE (voxelSizeOfACloud);
PCL_OPS_STAGE (voxelizing);
PCL_OPS_STAGE (findingSurfels);
PCL_OPS_STAGE (extractingPlanesOfSurfels);
PCL_OPS_STAGE (measuringNoise);
PCL_OPS_STAGE (refining);
PCL_OPS_STAGE (growingPlanes);
PCL_OPS_STAGE (reassigningVoxels);
PCL_OPS_STAGE (mergingPlanes);
PCL_OPS_STAGE (assigningToBoundedPlanes);
PCL_OPS_STAGE (assigningToUnboundedPlanes);
PCL_OPS_STAGE (orientingSamples);
PCL_OPS_STAGE (buildingFixedRadiusSearch);
PCL_OPS_STAGE (buildingKdTree);

} // namespace
