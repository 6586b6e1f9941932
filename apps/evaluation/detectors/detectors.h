// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/data/data_sets.h>
#include <pcl_ops/plane_detector.h>

#include <ctime>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief What a detector made of a cloud. */
struct DetectorRun {
  /** \brief 0: no plane; 1 .. P: planes, in any order. */
  PlaneLabels labels;
  std::size_t planes_before_merging = 0;
  /** \brief Times [ms]; of the foreign detectors only normals and detection are known.
   * Detection is everything from the loaded cloud to labels. */
  StageDurations durations;
};

/** \brief The distance to their planes that detectors of others are given [m], as in
 * PCL's tutorials. */
constexpr double usual_peer_threshold = 0.05;

/** \brief How time is taken: the processor time of the calling thread is the same while
 * others use the machine, too, but leaves further threads out. */
enum class Clock { Wall, Processor };

/** \brief What detectors are told beside the points. */
struct RunSettings {
  /** \brief Unit vector against gravity. */
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /** \brief Of every random choice the detector lets be seeded. */
  std::uint32_t seed = 42;
  /** \brief As of \ref EvaluationCloud. */
  XyzCloud::ConstPtr image = nullptr;
  double peer_threshold = usual_peer_threshold;
  /** \brief Noise of the points that detectors of others are tuned to; none: as
   * measured from the cloud [m]. */
  std::optional<double> peer_noise = std::nullopt;
  Clock clock = Clock::Wall;
};

/** \brief What a clock shows [ms]. */
inline double
now (Clock clock)
{
  timespec time{};
  clock_gettime (clock == Clock::Wall ? CLOCK_MONOTONIC : CLOCK_THREAD_CPUTIME_ID,
                 &time);
  return 1e3 * double (time.tv_sec) + 1e-6 * double (time.tv_nsec);
}

/** \brief Runs something and adds its time to a duration [ms]. */
template <typename Work>
void
timed (double& duration, Clock clock, const Work& work)
{
  const double start = now (clock);
  work();
  duration += now (clock) - start;
}

/** \brief Runs a detector of this project.
 * \param[in] parameters all of them: up axis, seed and threads too
 * \param[in] cloud finite points
 * \param[in] clock of the whole; that of the stages is the wall's */
template <typename Detector>
DetectorRun
runDetector (const typename Detector::Parameters& parameters,
             const XyzCloud::ConstPtr& cloud,
             Clock clock = Clock::Wall)
{
  DetectorRun result;
  double detection = 0.0;
  timed (detection, clock, [&] {
    Detector detector;
    detector.setParameters (parameters);
    detector.setInputCloud (cloud);
    std::vector<pcl::PointIndices> planes;
    detector.extract (planes);
    result.labels = labelsOf (planes, cloud->size());
    result.durations = detector.getStageDurations();
    result.planes_before_merging = detector.getNumberOfPlanesBeforeMerging();
  });
  result.durations.detection = detection;
  return result;
}

/** \brief A detector with its parameters, under a name. */
struct Configuration {
  std::string name;
  /** \brief Names that stand for it among others: table1 to table4, presets, peers. */
  std::set<std::string> groups;
  /** \brief On one thread. The points are finite. */
  std::function<DetectorRun (const XyzCloud::ConstPtr& cloud,
                             const RunSettings& settings)>
      run;
  /** \brief A detector of others, which may take any time. */
  bool is_peer = false;
  /** \brief It works on images alone: \ref RunSettings::image. */
  bool needs_image = false;
  /** \brief Whose it is and which; empty: of this project. */
  std::string version = {};
};

/** \brief Every row of the paper's tables, the product's presets, and the detectors
 * people use today:
 * - table1: fspf-R1-R2, with the radii in meters
 * - table2: kht-PHI-RHO, with the numbers of bins
 * - table3: ops-RATE-K and ops-s1-RATE-K (strategy 1), with the sampling rate in per
 * cent
 * - table4: the best rows
 * - presets: ops, fspf, kht as this product recommends them
 * - peers: detectors of PCL and, if found when this was built, of CGAL and Open3D, and
 * a voxel octree; at the values of their tutorials
 * - peers-measured: the same at values measured from the cloud
 * - ablation: ops-without-INGREDIENT, the default preset with one ingredient off */
const std::vector<Configuration>&
allConfigurations ();

/** \brief The configurations of a list of names and groups, "ops,table4"; "all" for all
 * but the ablation. None comes twice.
 * \throw apps::UsageError for an unknown name */
std::vector<Configuration>
selectConfigurations (const std::string& list);

/** \brief Does something in a process of its own, whose memory but for what is shared
 * goes with it.
 * \param[in] seconds of wall time, after which it is ended; 0: none
 * \return whether it was done before that
 * \throw std::runtime_error if it fails, however it does */
bool
runInChild (const std::function<void()>& work, unsigned seconds);

/** \brief Runs a detector, one of others in a process of its own.
 * \param[in] seconds, and errors, as of \ref runInChild
 * \return nothing if it takes longer */
std::optional<DetectorRun>
runLimited (const Configuration& configuration,
            const XyzCloud::ConstPtr& cloud,
            const RunSettings& settings,
            unsigned seconds);

} // namespace pcl_ops::evaluation
