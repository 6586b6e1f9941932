// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/data/data_sets.h>
#include <pcl_ops/plane_detector.h>

#include <ctime>
#include <set>

namespace pcl_ops::evaluation {

/** The result of one run of a detector. */
struct DetectorRun {
  PlaneLabels labels; // one per point; plane numbers in any order; 0: no plane
  std::size_t planes_before_merging = 0;
  /** [ms]; peers set only the durations of normals and of the whole detection. */
  StageDurations durations;
};

/** Distance threshold of PCL's tutorials [m]. */
constexpr double usual_peer_threshold = 0.05;

/** Input of detectors beside the points. A peer is a detector of another project. */
struct RunSettings {
  Vector3d up = Vector3d::UnitZ(); // against gravity, of length 1
  std::uint32_t seed = 42;
  XyzCloud::ConstPtr image = nullptr; // EvaluationCloud::image
  /** Largest distance of a point to its plane, for peers with the parameters of their
   * tutorials [m]. */
  double peer_threshold = usual_peer_threshold;
  /** Standard deviation of the distances of points to their plane [m], for peers with
   * parameters from the cloud; nullopt: measured from the cloud. */
  std::optional<double> peer_noise = std::nullopt;
  /** Number of neighbors from which peers estimate a normal; nullopt: their default. */
  std::optional<int> peer_neighbors = std::nullopt;
  /** Number of points of the smallest plane that peers look for; nullopt: their
   * default.
   */
  std::optional<std::size_t> peer_min_points = std::nullopt;
  /** For detectors of this project; the time of the detection is processor time of one
   * thread, or wall time of several. */
  unsigned threads = 1;
  /** Share of the points that OPS samples; nullopt: that of the configuration. */
  std::optional<double> sampling_rate = std::nullopt;
  /** Names of the data set and of the cloud in results.csv. */
  std::string data_set = {}, cloud_name = {};
};

/** Returns the time of a clock of the operating system [ms]. */
inline double
now (clockid_t clock)
{
  timespec time{};
  clock_gettime (clock, &time);
  return 1e3 * double (time.tv_sec) + 1e-6 * double (time.tv_nsec);
}

/** Adds the time that some work takes to a duration [ms]. The default is the processor
 * time of the calling thread: other programs do not change it, but it leaves out the
 * time of further threads. */
template <typename Work>
void
timed (double& duration, const Work& work, clockid_t clock = CLOCK_THREAD_CPUTIME_ID)
{
  const double start = now (clock);
  work();
  duration += now (clock) - start;
}

/** A detector with its parameters. */
struct Configuration {
  std::string name;
  std::set<std::string> groups; // see allConfigurations
  /** Finds planes in a cloud of finite points. */
  std::function<DetectorRun (const XyzCloud::ConstPtr& cloud,
                             const RunSettings& settings)>
      run;
  /** Whether it is a detector of another project, whose time has no known bound. */
  bool is_peer = false;
  bool needs_image = false; // RunSettings::image
  std::string version = {}; // name and version of its project; empty: this project
  /** Whether it reads a user's labels (\ref ownLabels), which may have changed by the
   * next run. */
  bool is_own = false;
};

/** Returns all configurations. Their groups are:
 * - table1: fspf-R1-R2, with the inner and outer radius [m]
 * - table2: kht-PHI-RHO, with the numbers of bins
 * - table3: ops-RATE-K and ops-s1-RATE-K (the paper's strategy 1), with sampling rate
 * [%] and k
 * - table4: the best row of each method in the paper
 * - presets: ops, fspf, kht with default parameters
 * - sampling: ops-voxels, the default with Sampling::Surfels
 * - peers: detectors of PCL, of CGAL and Open3D if found at build time, and a voxel
 * octree, with the parameters of their tutorials
 * - peers-measured: the peers with parameters measured from the cloud
 * - pieces: ops-pieces, the default; each connected component of a plane is a plane
 * - ablation: ops-without-INGREDIENT, the default with one parameter switched off;
 * parameters of surfels have no effect on neighborhoods */
const std::vector<Configuration>&
allConfigurations ();

/** Returns the configurations that a list names, each once.
 * \param[in] list names and groups, as "ops,table4"; "all" selects every configuration
 * outside the group ablation, "none" selects no configuration
 * \throw apps::UsageError for an unknown name */
std::vector<Configuration>
selectConfigurations (const std::string& list);

/** Runs work in a child process, whose memory is freed when it ends.
 * \param[in] seconds wall time after which the child is ended; 0: no limit
 * \return false if the time limit ended the child
 * \throw std::runtime_error if the work throws, or a signal ends the child */
bool
runInChild (const std::function<void()>& work, unsigned seconds);

/** Runs a peer detector by \ref runInChild, any other one in this process without a
 * limit.
 * \param[in] seconds time limit of a peer, see \ref runInChild
 * \return nullopt if the time limit ended the run */
std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds);

} // namespace pcl_ops::evaluation
