// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/data/data_sets.h>
#include <pcl_ops/plane_detector.h>

#include <ctime>
#include <set>

namespace pcl_ops::evaluation {

struct DetectorRun {
  PlaneLabels labels; // in any order
  std::size_t planes_before_merging = 0;
  /** [ms]; of detectors of others only normals and detection. */
  StageDurations durations;
};

/** As in PCL's tutorials [m]. */
constexpr double usual_peer_threshold = 0.05;

/** What detectors are told beside the points; peers are those of others. */
struct RunSettings {
  Vector3d up = Vector3d::UnitZ(); // against gravity, of length 1
  std::uint32_t seed = 42;
  XyzCloud::ConstPtr image = nullptr;           // as of EvaluationCloud
  double peer_threshold = usual_peer_threshold; // distance to a plane [m]
  /** Of the points; none: as measured from the cloud [m]. */
  std::optional<double> peer_noise = std::nullopt;
  /** That those of others estimate a normal from; none: as usual. */
  std::optional<int> peer_neighbors = std::nullopt;
  /** Points of the smallest plane that those of others are to find; none: as usual. */
  std::optional<std::size_t> peer_min_points = std::nullopt;
  /** Of detectors of this project; with several, time is that of the wall. */
  unsigned threads = 1;
  /** Of OPS; none: that of its configuration. */
  std::optional<double> sampling_rate = std::nullopt;
  /** Of the cloud, as in results.csv. */
  std::string data_set = {}, cloud_name = {};
};

/** [ms] */
inline double
now (clockid_t clock)
{
  timespec time{};
  clock_gettime (clock, &time);
  return 1e3 * double (time.tv_sec) + 1e-6 * double (time.tv_nsec);
}

/** Adds the time of some work to a duration [ms]. The processor time of the calling
 * thread is the same while others use the machine, too, but leaves further threads
 * out. */
template <typename Work>
void
timed (double& duration, const Work& work, clockid_t clock = CLOCK_THREAD_CPUTIME_ID)
{
  const double start = now (clock);
  work();
  duration += now (clock) - start;
}

struct Configuration {
  std::string name;
  std::set<std::string> groups; // of allConfigurations
  /** The points are finite. */
  std::function<DetectorRun (const XyzCloud::ConstPtr& cloud,
                             const RunSettings& settings)>
      run;
  /** A detector of others, which may take any time. */
  bool is_peer = false;
  bool needs_image = false;
  std::string version = {}; // empty: of this project
  /** Of \ref ownLabels, which may be others by the next run. */
  bool is_own = false;
};

/** By groups:
 * - table1: fspf-R1-R2, with the radii [m]
 * - table2: kht-PHI-RHO, with the numbers of bins
 * - table3: ops-RATE-K and ops-s1-RATE-K (strategy 1), with the sampling rate [%]
 * - table4: the best rows
 * - presets: ops, fspf, kht as recommended
 * - peers: those of PCL, of CGAL and Open3D if found when this was built, and a voxel
 * octree; at the values of their tutorials
 * - peers-measured: the same at values measured from the cloud
 * - pieces: ops-pieces, the default with each connected piece of a plane by itself
 * - ablation: ops-without-INGREDIENT, the default with one ingredient off */
const std::vector<Configuration>&
allConfigurations ();

/** \param[in] list of names and groups, "ops,table4"; "all" for all but the ablation,
 * "none" for none
 * \throw apps::UsageError for an unknown name */
std::vector<Configuration>
selectConfigurations (const std::string& list);

/** Does something in a process of its own, whose memory goes with it.
 * \param[in] seconds of wall time, after which it is ended; 0: none
 * \return whether it was done before that
 * \throw std::runtime_error if it fails, however it does */
bool
runInChild (const std::function<void()>& work, unsigned seconds);

/** Runs a detector of others by \ref runInChild; nothing if it takes longer. */
std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds);

} // namespace pcl_ops::evaluation
