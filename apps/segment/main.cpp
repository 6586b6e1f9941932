// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>

#include "options.h"
#include "report.h"
#include "segment_cloud.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <io/cloud_file.h>
#include <io/pose_file.h>
#include <numbers/angles.h>
#include <pcl_ops/plane_tracker.h>
#include <unistd.h>

#include <condition_variable>
#include <cstdint>
#include <iostream>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace pcl_ops::apps {

namespace {

PlaneMatchingParameters
parametersOf (const TrackOptions& options)
{
  PlaneMatchingParameters parameters;
  if (options.rotation_error)
    parameters.rotation_error = toRadians (*options.rotation_error);
  if (options.translation_error)
    parameters.translation_error = *options.translation_error;
  return parameters;
}

std::vector<Eigen::Isometry3d>
posesOf (const TrackOptions& options, std::size_t frames)
{
  if (options.poses.empty())
    return std::vector<Eigen::Isometry3d> (frames, Eigen::Isometry3d::Identity());
  std::vector<Eigen::Isometry3d> poses = loadPoses (options.poses);
  if (poses.size() != frames)
    throw WorkError (options.poses,
                     "has " + std::to_string (poses.size()) + " poses for " +
                         std::to_string (frames) +
                         " clouds; give one for each, in the order of their names");
  return poses;
}

/** \brief Numbers for the planes of a sequence of clouds. Its frames may be worked on
 * at the same time; their planes are numbered in their order, so that the numbers are
 * the same for any number of threads. */
class SequenceTracker {
public:
  SequenceTracker (const TrackOptions& options, std::size_t frames)
  : tracker_ (parametersOf (options))
  , poses_ (posesOf (options, frames))
  , is_finished_ (frames, false)
  {}

  /** \brief The ids of the planes of a frame, once the frames before are done.
   * \param[in] planes in the frame of their cloud
   * \param[in] sensor in that frame: what a pose's error turns about */
  std::vector<std::uint32_t>
  idsOf (std::size_t frame,
         std::vector<PlaneSegment> planes,
         const Eigen::Vector3d& sensor)
  {
    for (PlaneSegment& plane : planes)
      plane.moveBy (-sensor);
    std::unique_lock<std::mutex> lock (mutex_);
    is_next_.wait (lock, [&] { return next_ == frame; });
    return tracker_.track (planes, poses_[frame] * Eigen::Translation3d (sensor));
  }

  /** \brief An axis of the frame that the poses share, in that of a cloud. */
  Eigen::Vector3f
  inFrame (std::size_t frame, const Eigen::Vector3f& axis) const
  {
    return poses_[frame].rotation().transpose().cast<float>() * axis;
  }

  void
  finish (std::size_t frame)
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    is_finished_[frame] = true;
    while (next_ < is_finished_.size() && is_finished_[next_])
      ++next_;
    is_next_.notify_all();
  }

private:
  PlaneTracker tracker_;
  std::vector<Eigen::Isometry3d> poses_;
  std::vector<bool> is_finished_;
  std::size_t next_ = 0;
  std::mutex mutex_;
  std::condition_variable is_next_;
};

/** \brief What became of a cloud, in a line. */
struct Status {
  bool is_done;
  std::string line;
  std::string warning = {};
};

/** \brief Segments one cloud after the other, options.jobs at a time. Goes on after one
 * that fails; ends early when the user interrupts it, with each cloud's outputs either
 * complete or untouched. Prints a line for each cloud done unless quiet, and one for
 * each problem, in the order of the tasks. */
class BatchRun {
public:
  BatchRun (const SegmentOptions& options, const Batch& batch)
  : options_ (options)
  , batch_ (batch)
  , progress_ (batch.tasks.size(),
               std::cerr,
               ::isatty (STDERR_FILENO) == 1 ? ProgressStyle::Bar : ProgressStyle::None)
  , statuses_ (batch.tasks.size())
  {
    if (options.track.is_on && !batch.tasks.empty())
      tracker_.emplace (options.track, batch.tasks.size());
  }

  /** \return the exit code, ExitCode::work_failed if any failed or was left */
  int
  run ()
  {
    for (const std::string& problem : batch_.problems)
      print ({false, problem});
    runInParallel (statuses_.size(), options_.jobs, [this] (std::size_t i) {
      std::optional<Status> status = statusOf (i);
      if (status)
        store (i, std::move (*status));
    });
    // After an interruption there are gaps, behind which some may be done.
    for (; printed_ < statuses_.size(); ++printed_)
      if (statuses_[printed_])
        print (*statuses_[printed_]);
    progress_.erase();
    return conclude();
  }

private:
  /** \brief Those of a cloud: up is given in the frame that poses share. */
  SegmentOptions
  optionsOf (std::size_t i) const
  {
    SegmentOptions options = options_;
    DetectorOptions& detector = options.detector;
    if (!options.track.poses.empty() && !detector.finds_up)
      detector.up = tracker_->inFrame (
          i, detector.up.value_or (Eigen::Vector3f (Eigen::Vector3f::UnitZ())));
    return options;
  }

  /** \brief Segments a cloud. \return nothing if the user interrupted it */
  std::optional<Status>
  statusOf (std::size_t i)
  {
    const Task& task = batch_.tasks[i];
    // However its work ends: the next ones wait for it.
    const auto finish = [i] (SequenceTracker* tracker) { tracker->finish (i); };
    const std::unique_ptr<SequenceTracker, decltype (finish)> turn (
        tracker_ ? &*tracker_ : nullptr, finish);
    const auto tracked = [&] (const std::vector<PlaneSegment>& planes,
                              const Eigen::Vector3d& sensor) {
      return tracker_->idsOf (i, planes, sensor);
    };
    try {
      stopIfInterrupted();
      const Report report = tracker_ ? segmentCloud (optionsOf (i), task, tracked)
                                     : segmentCloud (options_, task);
      return Status{true,
                    task.input + " -> " + task.outputs.cloud + ": " +
                        summaryOf (report),
                    report.damage.empty() ? "" : task.input + ": " + report.damage};
    }
    catch (const Interrupted&) {
      return {};
    }
    catch (const std::exception& error) {
      return Status{false, error.what()};
    }
  }

  void
  store (std::size_t i, Status status)
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    statuses_[i] = std::move (status);
    for (; printed_ < statuses_.size() && statuses_[printed_]; ++printed_)
      print (*statuses_[printed_]);
    progress_.step();
  }

  void
  print (const Status& status)
  {
    if (!status.is_done) {
      ++failed_;
      progress_.note (errorLine (status.line), std::cerr);
    }
    else {
      ++done_;
      if (!status.warning.empty())
        progress_.note (errorLine (status.warning), std::cerr);
      if (!options_.quiet)
        progress_.note (status.line, std::cout);
    }
  }

  int
  conclude ()
  {
    const std::size_t all = batch_.tasks.size() + batch_.problems.size();
    const std::string done =
        std::to_string (done_) + " of " + std::to_string (all) + " inputs are done";
    if (done_ + failed_ < all)
      throw WorkError ("interrupted", done + ", none is half-written; run it again");
    if (failed_ > 0 && all > 1)
      throw WorkError (std::to_string (failed_) + " failed", done + "; see above");
    return failed_ > 0 ? ExitCode::work_failed : ExitCode::done;
  }

  const SegmentOptions& options_;
  const Batch& batch_;
  Progress progress_;
  std::optional<SequenceTracker> tracker_;
  std::mutex mutex_;
  std::vector<std::optional<Status>> statuses_;
  std::size_t printed_ = 0, done_ = 0, failed_ = 0;
};

Report
segmentTold (const SegmentOptions& options, const Task& task)
{
  if (options.quiet)
    return segmentCloud (options, task);
  StageLines lines (std::cerr);
  return segmentCloud (options, task, idsBySize, [&] (const std::string& stage) {
    lines.begin (stage);
  });
}

int
segmentOne (const SegmentOptions& options)
{
  const Task task = taskOf (options);
  const Report report = segmentTold (options, task);
  if (!report.damage.empty())
    warn (report.input + ": " + report.damage);
  const bool prints_json = task.outputs.planes == standard_stream;
  if (options.quiet || prints_json)
    return ExitCode::done;
  printTable (report, std::cout);
  if (!task.outputs.image.empty())
    std::cout << task.outputs.image
              << ": left each plane in its color; right horizontal "
              << "green, vertical blue, other orange; no plane gray\n";
  return ExitCode::done;
}

int
segment (int argc, const char* const* argv)
{
  SegmentOptions options;
  if (!readOptions (argc, argv, options))
    return ExitCode::done;
  if (!options.isBatch())
    return segmentOne (options);
  // A batch is about its files, whose writing a closed pipe must not cut short.
  ignoreClosedPipes();
  return BatchRun (options, batchOf (options)).run();
}

} // namespace

} // namespace pcl_ops::apps

int
main (int argc, char** argv)
{
  using namespace pcl_ops::apps;
  noteInterruptions();
  const int code = runProgram (program_name, [&] { return segment (argc, argv); });
  if (code != ExitCode::done)
    endAsInterrupted();
  return code;
}
