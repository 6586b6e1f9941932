// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_targets.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <cmath>
#include <initializer_list>
#include <limits>
#include <set>

namespace pcl_ops::fuzz {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Planes = std::vector<PlaneSegment>;
using Points = pcl::PointCloud<pcl::PointXYZ>;

/** Leaves a value as it is for most bytes, else takes another. */
template <typename Target, typename Value>
void
vary (ByteReader& bytes, Target& target, std::initializer_list<Value> others)
{
  const auto chosen = bytes.take<std::uint8_t>();
  if (chosen >= 128)
    target = *(others.begin() + chosen % others.size());
}

void
vary (ByteReader& bytes, PlaneDetectorParameters& parameters)
{
  vary (bytes, parameters.distance_threshold, {1e-30, 1e-3, 0.5, 1e30, 0.0, -1.0, nan});
  vary (bytes, parameters.seed, {0u, 1u, 4294967295u});
  vary (bytes, parameters.angle_tolerance, {0.0, 0.5, 1.5, 2.0, nan});
  vary (bytes, parameters.merging.enabled, {false, true});
  vary (bytes, parameters.merging.angle_threshold, {0.0, 0.5, 1.5, -1.0, nan});
  vary (bytes, parameters.merging.distance_threshold, {0.0, 1e-30, 1.0, 1e30, nan});
  vary (bytes, parameters.merging.noise_factor, {0.0, 1.0, 1e30, nan});
  vary (bytes, parameters.up_axis.x(), {1.0f, 1e-40f, 1e30f, std::nanf ("")});
}

void
vary (ByteReader& bytes, OrientedPointSamplingParameters::Surfels& surfels)
{
  vary (bytes, surfels.voxel_size, {1e-40, 1e-6, 0.01, 1.0, 1e9, 1e38, 0.0, nan});
  vary (bytes, surfels.resolutions, {1, 2, 10, 0, 11});
  vary (bytes, surfels.min_average_voxels, {0.0, 1.0, 1000.0, 1e300, -1.0, nan});
  vary (bytes, surfels.noise_factor, {0.0, 0.1, 100.0, 1e300, nan});
  vary (bytes, surfels.angle_threshold, {0.0, 0.01, 1.5, 2.0, nan});
  vary (bytes, surfels.sure_thickness, {0.0, 0.01, 1.0, 2.0, nan});
  vary (bytes, surfels.max_thickness, {0.0, 0.01, 1.0, 2.0, nan});
  vary (bytes, surfels.absorption_noise_factor, {0.0, 100.0, 1e300, nan});
  vary (bytes, surfels.assignment_noise_factor, {0.0, 0.1, 100.0, 1e300, nan});
}

void
vary (ByteReader& bytes, OrientedPointSamplingParameters& parameters)
{
  vary (bytes, static_cast<PlaneDetectorParameters&> (parameters));
  vary (bytes, parameters.sampling_rate, {1e-9, 0.001, 0.3, 1.0, 0.0, 2.0, nan});
  vary (bytes, parameters.k, {2, 3, 100, 2147483647, 1, -1});
  vary (bytes, parameters.paper_only.normal_sigma, {1e-30, 0.01, 1e30, 0.0, nan});
  vary (bytes, parameters.min_inliers, {0u, 1u, 3u, 200u, 4294967295u});
  vary (bytes, parameters.paper_only.probability, {1e-9, 0.5, 0.999999999, 1.0, nan});
  vary (bytes,
        parameters.paper_only.strategy,
        {PaperParameters::Strategy::DetectThenDivide,
         PaperParameters::Strategy::DivideThenDetect});
  vary (bytes,
        parameters.paper_only.verification,
        {PaperParameters::Verification::Samples,
         PaperParameters::Verification::AllPoints});
  vary (bytes,
        parameters.paper_only.assignment_rule,
        {AssignmentRule::First, AssignmentRule::Nearest});
  vary (bytes, parameters.paper_only.local_optimization, {false, true});
  vary (bytes, parameters.surfels);
}

void
vary (ByteReader& bytes, FastSamplingPlaneFilteringParameters& parameters)
{
  vary (bytes, static_cast<PlaneDetectorParameters&> (parameters));
  FastSamplingPlaneFilteringParameters::Local& local = parameters.local;
  vary (bytes, local.inner_radius, {1e-30, 0.01, 1.0, 1e30, 1e-310, nan});
  vary (bytes, local.outer_radius, {0.01, 0.5, 1.0, 1e30, 0.0, nan});
  vary (bytes, local.local_samples, {3u, 10u, 1000u, 4294967295u, 2u});
  vary (bytes, local.min_inlier_fraction, {0.0, 0.3, 0.999, 1.0, nan});
  vary (bytes,
        local.inliers,
        {FastSamplingPlaneFilteringParameters::Local::Inliers::Sphere,
         FastSamplingPlaneFilteringParameters::Local::Inliers::Samples});
  vary (bytes, local.max_inliers_per_point, {0.1, 5.0, 1e30, 0.0, nan});
  vary (bytes, local.max_hypotheses_per_point, {0.01, 3.0, 0.0, nan});
  vary (bytes, local.max_visits_per_point, {1.0, 500.0, 0.0, nan});
}

void
vary (ByteReader& bytes, KernelHoughTransformParameters& parameters)
{
  vary (bytes, static_cast<PlaneDetectorParameters&> (parameters));
  vary (bytes, parameters.phi_num, {2, 3, 7, 180, 1, 1001});
  vary (bytes, parameters.rho_num, {2, 3, 50, 2000, 1, 10001});
  KernelHoughTransformParameters::Clusters& clusters = parameters.clusters;
  vary (bytes,
        clusters.min_samples,
        {std::size_t (3), std::size_t (10), std::size_t (0)});
  vary (bytes, clusters.first_level, {0, 1, 6, 20, -1});
  vary (bytes, clusters.max_level, {0, 5, 30, 1000, 2147483647});
  vary (bytes, clusters.s_alpha, {1e-3, 1.0, 1e9, 0.0, nan});
  vary (bytes, clusters.s_beta, {1e-3, 1.0, 1e9, 0.0, nan});
  vary (bytes, parameters.refit.enabled, {false, true});
  vary (bytes, parameters.refit.min_share, {0.0, 0.5, 1.0, 2.0, nan});
}

/** Planes by falling size with ascending indices of finite points, each of one plane
 * alone, and finite unit normals. */
void
promiseOrderedPlanes (const Planes& planes, const Points& cloud)
{
  std::vector<bool> is_taken (cloud.size(), false);
  std::size_t last_size = cloud.size();
  for (const PlaneSegment& plane : planes) {
    promise (std::abs (plane.normal.norm() - 1.0) < 1e-6, "normals have length 1");
    promise (plane.centroid.allFinite(), "centroids are finite");
    promise (!plane.inliers.empty(), "a plane has points");
    promise (plane.inliers.size() <= last_size, "planes come by falling size");
    last_size = plane.inliers.size();
    pcl::index_t before = -1;
    for (const pcl::index_t index : plane.inliers) {
      promise (index > before, "indices ascend");
      before = index;
      promise (static_cast<std::size_t> (index) < cloud.size(),
               "they are in the cloud");
      promise (!is_taken[index], "planes share no point");
      is_taken[index] = true;
      promise (cloud[index].getVector3fMap().allFinite(), "their points are finite");
    }
  }
}

void
promiseEqual (const Planes& one, const Planes& other)
{
  promise (one.size() == other.size(), "a second call finds as many planes");
  for (std::size_t p = 0; p < one.size(); ++p) {
    promise (one[p].inliers == other[p].inliers, "it finds the same points");
    promise (one[p].normal == other[p].normal && one[p].centroid == other[p].centroid,
             "it finds the same planes");
  }
}

void
promiseGivenPoints (const Planes& planes, const pcl::Indices& given)
{
  const std::set<pcl::index_t> allowed (given.begin(), given.end());
  for (const PlaneSegment& plane : planes)
    for (const pcl::index_t index : plane.inliers)
      promise (allowed.count (index) == 1, "only points it was given are on planes");
}

template <typename Detector>
void
detect (const Bytes& bytes, typename Detector::Parameters parameters)
{
  ByteReader reader (bytes);
  vary (reader, parameters);
  const FuzzedCloud fuzzed = cloudFrom (reader);
  Detector detector;
  detector.setInputCloud (fuzzed.cloud);
  if (fuzzed.indices)
    detector.setIndices (fuzzed.indices);
  parameters.threads = 1;
  detector.setParameters (parameters);
  Planes planes, again;
  const bool worked = detector.segment (planes);
  promise (worked || planes.empty(), "misuse gives no planes");
  promise (!worked || validate (parameters).empty(), "wrong parameters are misuse");
  promiseOrderedPlanes (planes, *fuzzed.cloud);
  if (fuzzed.indices)
    promiseGivenPoints (planes, *fuzzed.indices);
  detector.setNumberOfThreads (3);
  promise (detector.segment (again) == worked, "a second call does as the first");
  promiseEqual (planes, again);
}

} // namespace

Targets
detectorTargets ()
{
  using Ops = OrientedPointSampling<pcl::PointXYZ>;
  using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;
  using Kht = KernelHoughTransform<pcl::PointXYZ>;
  return {{"ops", [] (const Bytes& bytes) { detect<Ops> (bytes, {}); }},
          {"ops_paper",
           [] (const Bytes& bytes) { detect<Ops> (bytes, Ops::Parameters::paper()); }},
          {"fspf", [] (const Bytes& bytes) { detect<Fspf> (bytes, {}); }},
          {"kht", [] (const Bytes& bytes) { detect<Kht> (bytes, {}); }},
          {"kht_paper",
           [] (const Bytes& bytes) { detect<Kht> (bytes, Kht::Parameters::paper()); }}};
}

} // namespace pcl_ops::fuzz
