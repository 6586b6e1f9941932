// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cloud_measures.h"

#include <pcl/kdtree/kdtree_flann.h>

#include <evaluation/detectors/timed.h>
#include <fspf/local_plane_sampling.h>
#include <geometry/points.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <search/fixed_radius_search.h>

#include <algorithm>
#include <map>
#include <numeric>

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

/** The centres of all spheres FSPF asks for. */
std::vector<pcl::PointXYZ>
sphereCentres (const XyzCloud& cloud,
               const FastSamplingPlaneFilteringParameters& parameters)
{
  pcl::Indices all (cloud.size());
  std::iota (all.begin(), all.end(), 0);
  using namespace internal;
  const Points points = finitePoints (CloudView (cloud), all, 1);
  const FixedRadiusSearch search (points, parameters.local.outer_radius, 1);
  std::vector<pcl::PointXYZ> centres;
  const auto find_sphere = [&] (std::uint32_t centre, Indices& sphere) {
    const Eigen::Vector3f position =
        (search.points()[centre] + points.origin).cast<float>();
    centres.emplace_back (position.x(), position.y(), position.z());
    return search.find (centre, sphere);
  };
  sampleLocalPlanes (search.points(),
                     find_sphere,
                     parameters.local,
                     *parameters.distance_threshold,
                     parameters.seed);
  return centres;
}

/** The part of FSPF that a kd-tree would do. */
Measure
sphereSearchMeasure (const XyzCloud::ConstPtr& cloud,
                     const MeasureParameters& parameters)
{
  auto fspf = FastSamplingPlaneFilteringParameters::paper();
  fspf.seed = parameters.seed;
  const auto search_all = [cloud, centres = sphereCentres (*cloud, fspf), fspf] {
    StageDurations durations;
    const bool sorted = false;
    KdTree tree (sorted);
    timed (durations.search, [&] { tree.setInputCloud (cloud); });
    timed (durations.extraction, [&] {
      pcl::Indices neighbours;
      std::vector<float> squared_distances;
      for (const pcl::PointXYZ& centre : centres)
        tree.radiusSearch (
            centre, fspf.local.outer_radius, neighbours, squared_distances);
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

/** About how long a foreign detector takes on a machine of the year 2026 [ms].
 */
double
expectedTime (const std::string& peer, std::size_t points)
{
  // In microseconds per point, as measured on some hundred thousand points.
  static const std::map<std::string, double> time_per_point{
      {sac_loop, 20.0},
      {"pcl-region-growing", 7.0},
      {efficient_ransac, 4.0},
      {"cgal-region-growing", 25.0}};
  const auto found = time_per_point.find (peer);
  return found == time_per_point.end()
             ? 0.0
             : 1e-3 * found->second * static_cast<double> (points);
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
        {detector.name,
         runs,
         [detector, cloud, seed] {
           return detector.run (cloud, Eigen::Vector3d::UnitZ(), seed).durations;
         },
         expectedTime (detector.name, cloud->size())});
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
