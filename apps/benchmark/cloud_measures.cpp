// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_measures.h"

#include <pcl/kdtree/kdtree_flann.h>
#include <pcl/search/kdtree.h>

#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <algorithm>

namespace pcl_ops::benchmark {

namespace {

using evaluation::timed;
using evaluation::XyzCloud;
using KdTree = pcl::KdTreeFLANN<pcl::PointXYZ>;

/** Onto memory that is there already: what reading and writing it takes at least. */
Measure
copyMeasure (const XyzCloud::ConstPtr& cloud, std::size_t runs)
{
  const auto copy = std::make_shared<XyzCloud> (*cloud);
  return {cloud_copy, runs, [cloud, copy] {
            StageDurations durations;
            timed (durations.detection, [&] {
              return std::copy (cloud->begin(), cloud->end(), copy->begin());
            });
            return durations;
          }};
}

/** A search that remembers which spheres it was asked for. */
class RememberingTree : public pcl::search::KdTree<pcl::PointXYZ> {
public:
  int
  radiusSearch (const pcl::PointXYZ& center,
                double radius,
                pcl::Indices& neighbors,
                std::vector<float>& squared_distances,
                unsigned most = 0) const override
  {
    centers.push_back (center);
    return pcl::search::KdTree<pcl::PointXYZ>::radiusSearch (
        center, radius, neighbors, squared_distances, most);
  }

  mutable std::vector<pcl::PointXYZ> centers;
};

std::vector<pcl::PointXYZ>
sphereCenters (const XyzCloud::ConstPtr& cloud,
               const FastSamplingPlaneFilteringParameters& parameters)
{
  const pcl::shared_ptr<RememberingTree> tree (new RememberingTree);
  FastSamplingPlaneFiltering<pcl::PointXYZ> fspf;
  fspf.setParameters (parameters);
  fspf.setSearchMethod (tree);
  fspf.setInputCloud (cloud);
  std::vector<pcl::PointIndices> planes;
  fspf.extract (planes);
  return tree->centers;
}

/** The part of FSPF that a kd-tree would do. */
Measure
sphereSearchMeasure (const XyzCloud::ConstPtr& cloud,
                     const MeasureParameters& parameters)
{
  auto fspf = FastSamplingPlaneFilteringParameters::paper();
  fspf.seed = parameters.seed;
  const auto search_all = [cloud, centers = sphereCenters (cloud, fspf), fspf] {
    StageDurations durations;
    const bool sorted = false;
    KdTree tree (sorted);
    timed (durations.search, [&] { tree.setInputCloud (cloud); });
    timed (durations.extraction, [&] {
      pcl::Indices neighbors;
      std::vector<float> squared_distances;
      for (const pcl::PointXYZ& center : centers)
        tree.radiusSearch (
            center, fspf.local.outer_radius, neighbors, squared_distances);
    });
    durations.detection = durations.search + durations.extraction;
    return durations;
  };
  return {kdtree_with_searches, parameters.runs, search_all};
}

Measure
twoThreadsMeasure (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters)
{
  using Ops = OrientedPointSampling<pcl::PointXYZ>;
  OrientedPointSamplingParameters ops;
  ops.seed = parameters.seed;
  ops.threads = 2;
  return detectorMeasure<Ops> (default_on_two_threads, parameters.runs, ops, cloud);
}

void
addDetectors (const std::string& names,
              std::size_t runs,
              const XyzCloud::ConstPtr& cloud,
              std::uint32_t seed,
              std::vector<Measure>& measures)
{
  for (const evaluation::Configuration& detector :
       evaluation::selectConfigurations (names))
    measures.push_back (
        {detector.name, runs, [detector, cloud, seed] {
           return detector.run (cloud, Eigen::Vector3d::UnitZ(), seed).durations;
         }});
}

} // namespace

Measure
kdTreeMeasure (const XyzCloud::ConstPtr& cloud, std::size_t runs)
{
  return {kdtree_construction, runs, [cloud] {
            StageDurations durations;
            KdTree tree;
            timed (durations.detection, [&] { tree.setInputCloud (cloud); });
            return durations;
          }};
}

std::vector<Measure>
measuresOf (const XyzCloud::ConstPtr& cloud, const MeasureParameters& parameters)
{
  const std::string ours = std::string (default_preset) + "," + paper_preset + "," +
                           sparse_paper_preset + "," + hough_preset + "," +
                           sphere_preset;
  std::vector<Measure> measures{copyMeasure (cloud, parameters.runs),
                                kdTreeMeasure (cloud, parameters.runs),
                                sphereSearchMeasure (cloud, parameters),
                                twoThreadsMeasure (cloud, parameters)};
  addDetectors (ours, parameters.runs, cloud, parameters.seed, measures);
  if (parameters.peer_runs > 0)
    addDetectors ("peers", parameters.peer_runs, cloud, parameters.seed, measures);
  return measures;
}

} // namespace pcl_ops::benchmark
