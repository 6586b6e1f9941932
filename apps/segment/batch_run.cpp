// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "batch_run.h"

#include <boost/format.hpp>

#include <Eigen/Geometry>

#include "segment_cloud.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <cli/text.h>
#include <detection/common_up.h>
#include <detection/warning_lines.h>
#include <io/output_file.h>
#include <io/pose_file.h>
#include <pcl_ops/plane_tracker.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <iostream>
#include <mutex>

namespace pcl_ops::apps {

namespace {

/** \brief Returns the sensor pose of each cloud in one common frame; all identities
 * without --poses.
 * \param[in] clouds number of clouds
 * \throws WorkError if the file has a different number of poses */
std::vector<Eigen::Isometry3d>
posesOf (const TrackOptions& options, std::size_t clouds)
{
  if (options.poses_file.empty())
    return std::vector<Eigen::Isometry3d> (clouds, Eigen::Isometry3d::Identity());
  std::vector<Eigen::Isometry3d> poses = loadPoses (options.poses_file);
  if (poses.size() != clouds)
    throw WorkError (options.poses_file,
                     "has " + std::to_string (poses.size()) + " poses for " +
                         std::to_string (clouds) +
                         " clouds; give one for each, in the order of their names");
  if (!options.calibration_file.empty()) {
    // The file has poses of the camera in the frame of its first pose. They become
    // poses of the lidar in the frame of its first pose.
    const Eigen::Isometry3d lidar_to_camera =
        loadCalibration (options.calibration_file);
    for (Eigen::Isometry3d& pose : poses)
      pose = lidar_to_camera.inverse() * pose * lidar_to_camera;
  }
  return poses;
}

/** \brief Whether the input may be a lidar scan of KITTI, by the extension: these are
 * .bin files. */
bool
isScanOfKitti (const Task& task)
{
  return extensionOf (task.input) == ".bin";
}

/** \brief How the work on one cloud ended. */
struct Status {
  enum { Done, Failed, Interrupted } end;
  /** \brief What failed, or what makes the cloud look damaged; empty for neither. */
  std::string problem = {};
  /** \brief The line to print on a cloud that is done. */
  std::string summary = {};
  /** \brief Task::input of a cloud that is done, for its warnings. */
  std::string input = {};
  std::vector<ResultWarning> warnings = {};
};

/** \brief The state of one call of \ref runBatch. */
class BatchRun {
public:
  BatchRun (const SegmentOptions& options, const Batch& batch)
  : options_ (options)
  , common_frame_options_ (options)
  , batch_ (batch)
  , tracker_ (options.track.matching)
  , whole_plane_tracker_ (options.track.matching)
  , progress_ (batch.tasks.size(),
               std::cerr,
               ::isatty (STDERR_FILENO) == 1 ? ProgressStyle::Bar : ProgressStyle::None)
  , statuses_ (batch.tasks.size())
  {
    if (options.track.is_on && !batch.tasks.empty())
      poses_ = posesOf (options.track, batch.tasks.size());
    const bool has_uncalibrated_poses =
        options.track.calibration_file.empty() && !options.track.poses_file.empty();
    common_frame_options_.track.has_camera_poses =
        has_uncalibrated_poses &&
        std::any_of (batch.tasks.begin(), batch.tasks.end(), isScanOfKitti) &&
        lookLikeCameraOfKitti (options.track.poses_file, poses_);
  }

  int
  run ()
  {
    for (const std::string& problem : batch_.problems)
      print ({Status::Failed, problem});
    if (options_.track.is_on && !batch_.tasks.empty())
      setCommonUp();
    runInParallel (statuses_.size(), options_.jobs, [this] (std::size_t i) {
      try {
        finish (i, statusOf (i));
      }
      catch (...) {
        // Not even enough memory to report it: later clouds must not wait for this one.
        const std::lock_guard<std::mutex> lock (mutex_);
        gives_up_ = true;
        printed_changed_.notify_all();
        throw;
      }
    });
    progress_.erase();
    if (!options_.quiet)
      for (const std::string& line : warnings_.lines())
        warn (line);
    return conclude();
  }

private:
  /** \brief Gives the planes of a cloud their ids, once the statuses of all earlier
   * clouds are printed.
   * \param[in] cloud index into Batch::tasks
   * \param[in] sensor as in \ref GiveIds. Planes are matched relative to it, as the
   * rotation error of a pose turns them about the sensor.
   * \throws Interrupted if \ref gives_up_ */
  void
  giveIds (std::size_t cloud, const Eigen::Vector3d& sensor, Report& report)
  {
    std::unique_lock<std::mutex> lock (mutex_);
    printed_changed_.wait (lock, [&] { return printed_ == cloud || gives_up_; });
    if (gives_up_)
      throw Interrupted();
    const auto track = [&] (PlaneTracker& tracker, std::vector<PlaneSegment> planes) {
      for (PlaneSegment& plane : planes)
        plane.moveBy (-sensor);
      return tracker.track (planes, poses_[cloud] * Eigen::Translation3d (sensor));
    };
    report.ids = track (tracker_, report.detected.planes);
    if (options_.divides_into_pieces)
      report.whole_plane_ids =
          track (whole_plane_tracker_, report.detected.whole_planes);
  }

  /** \brief Estimates the up axis of single clouds from their planes, and returns the
   * axes that were found, in the frame of the poses. Of a long sequence it uses a
   * sample of clouds, evenly spread. */
  std::vector<UpAxis>
  upAxesOfClouds ()
  {
    constexpr std::size_t max_samples = 64; // as the pages say; chosen by hand
    const std::size_t clouds = batch_.tasks.size();
    const std::size_t samples = std::min (clouds, max_samples);
    std::vector<std::optional<UpAxis>> found (samples);
    runInParallel (samples, options_.jobs, [&] (std::size_t sample) {
      const std::size_t i = sample * clouds / samples;
      try {
        stopIfInterrupted();
        const FileCloud cloud = loadCloud (batch_.tasks[i].input);
        const ShiftedCloud shifted =
            shiftedCloudOf (cloud, voxelStepOf (options_.detector));
        found[sample] = findUpAxis (options_.detector, *shifted.cloud);
        if (found[sample])
          found[sample]->direction = poses_[i].rotation() * found[sample]->direction;
      }
      catch (const std::exception&) {
        // The error is reported when the cloud is segmented.
      }
    });
    std::vector<UpAxis> axes;
    for (const std::optional<UpAxis>& axis : found)
      if (axis)
        axes.push_back (*axis);
    return axes;
  }

  /** \brief Returns the up axis of a level camera in the frame of the poses: the mean
   * of the directions opposite to its y axes, as y points down in camera frames.
   * \throws UsageError if the directions differ too much to have one up axis */
  Eigen::Vector3d
  upOfCamera () const
  {
    // The more the unit vectors differ, the shorter is their mean: its length is 0.5 if
    // each is 60 degrees away from it.
    constexpr double min_length_of_mean = 0.5;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Isometry3d& pose : poses_)
      sum -= pose.rotation().col (1);
    if (sum.norm() < min_length_of_mean * static_cast<double> (poses_.size()))
      throw UsageError ("--up", "camera: by --poses it is not level; give auto");
    return sum.normalized();
  }

  /** \brief Sets one up axis for all clouds of a sequence, as many single clouds cannot
   * tell it. */
  void
  setCommonUp ()
  {
    DetectorOptions& detector = common_frame_options_.detector;
    const bool has_poses = !options_.track.poses_file.empty();
    if (detector.up_is_camera && has_poses)
      detector.up = upOfCamera().cast<float>();
    if (!detector.finds_up)
      return;
    const std::vector<UpAxis> axes = upAxesOfClouds();
    const std::optional<CommonUp> common = commonUp (axes);
    detector.finds_up = false;
    detector.is_up_of_sequence_estimated = true;
    if (common) {
      detector.up = common->axis.direction.cast<float>();
      detector.up_confidence = common->axis.confidence;
    }
    if (!options_.quiet)
      progress_.note (noteOnUp (common, axes.size(), has_poses), std::cout);
  }

  /** \brief Returns the line on the up axis for the standard output.
   * \param[in] axes number of clouds that tell an up axis */
  static std::string
  noteOnUp (const std::optional<CommonUp>& common, std::size_t axes, bool has_poses)
  {
    if (!common)
      return "Up axis of all clouds: they cannot tell, 0,0,1 is used; give --up x,y,z";
    const Eigen::Vector3d& up = common->axis.direction;
    return str (
        boost::format ("Up axis of all clouds: %.3f,%.3f,%.3f%s, as %d of the %d "
                       "say that can tell") %
        up.x() % up.y() % up.z() % (has_poses ? " in the frame of --poses" : "") %
        common->agreeing % axes);
  }

  /** \brief Returns the options for one cloud, with the up axis in its frame. */
  SegmentOptions
  optionsOf (std::size_t cloud) const
  {
    SegmentOptions options = common_frame_options_;
    DetectorOptions& detector = options.detector;
    const Eigen::Vector3f default_up = Eigen::Vector3f::UnitZ();
    if (!options.track.poses_file.empty() && !detector.finds_up)
      detector.up = poses_[cloud].rotation().transpose().cast<float>() *
                    detector.up.value_or (default_up);
    return options;
  }

  /** \brief Segments a cloud and returns how that ended. Exceptions become statuses. */
  Status
  statusOf (std::size_t cloud)
  {
    const Task& task = batch_.tasks[cloud];
    GiveIds give_ids;
    if (options_.track.is_on)
      give_ids = [&] (const Eigen::Vector3d& sensor, Report& report) {
        giveIds (cloud, sensor, report);
      };
    try {
      stopIfInterrupted();
      const char* const fix =
          options_.jobs == 1 ? "give a smaller cloud" : "give fewer --jobs";
      const Report report = inMemory (task.input, fix, [&] {
        return segmentCloud (optionsOf (cloud), task, give_ids, nullptr);
      });
      return {Status::Done,
              report.damage.empty() ? "" : task.input + ": " + report.damage,
              task.input + " -> " + task.outputs.cloud + ": " + summaryOf (report),
              task.input,
              report.warnings};
    }
    catch (const Interrupted&) {
      return {Status::Interrupted};
    }
    catch (const std::exception& error) {
      return {Status::Failed, error.what()};
    }
  }

  /** \brief Stores the status of a cloud, and prints the statuses that waited for it:
   * each is printed after those of all earlier clouds. */
  void
  finish (std::size_t cloud, const Status& status)
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    statuses_[cloud] = status;
    for (; printed_ < statuses_.size() && statuses_[printed_]; ++printed_)
      print (*statuses_[printed_]);
    printed_changed_.notify_all();
    if (status.end != Status::Interrupted)
      progress_.step();
  }

  /** \brief Prints a status, counts it, and keeps its warnings for the end. */
  void
  print (const Status& status)
  {
    ++counts_.at (status.end);
    warnings_.add (status.input, status.warnings);
    if (!status.problem.empty())
      progress_.note (errorLine (status.problem), std::cerr);
    if (status.end == Status::Done && !options_.quiet)
      progress_.note (oneLine (status.summary), std::cout);
  }

  /** \brief Returns or throws what \ref runBatch does. */
  int
  conclude () const
  {
    const std::size_t all = batch_.tasks.size() + batch_.problems.size();
    const std::size_t failed = counts_[Status::Failed];
    const std::string done = std::to_string (counts_[Status::Done]) + " of " +
                             std::to_string (all) + " inputs are done";
    if (counts_[Status::Interrupted] > 0)
      throw WorkError ("interrupted", done + ", none is half-written; run it again");
    if (failed > 0 && all > 1)
      throw WorkError (std::to_string (failed) + " failed", done + "; see above");
    return failed > 0 ? ExitCode::work_failed : ExitCode::done;
  }

  const SegmentOptions& options_;
  /** \brief The options with the up axis of the sequence, in the frame of the poses. */
  SegmentOptions common_frame_options_;
  const Batch& batch_;
  /** \brief Gives ids to planes, or to pieces of planes. */
  PlaneTracker tracker_;
  /** \brief Gives ids to the planes on which pieces lie. */
  PlaneTracker whole_plane_tracker_;
  /** \brief Of each cloud; empty without --track. */
  std::vector<Eigen::Isometry3d> poses_;
  Progress progress_;
  /** \brief Guards all members below and both trackers. */
  std::mutex mutex_;
  /** \brief Signals a change of \ref printed_ or \ref gives_up_. */
  std::condition_variable printed_changed_;
  /** \brief Of each cloud, once it has ended. */
  std::vector<std::optional<Status>> statuses_;
  /** \brief Number of printed statuses: they are those of the first clouds. */
  std::size_t printed_ = 0;
  /** \brief Whether a status could not be stored, so that \ref printed_ never passes
   * it. */
  bool gives_up_ = false;
  /** \brief Number of printed statuses for each value of Status::end. */
  std::array<std::size_t, 3> counts_{};
  WarningLines warnings_;
};

} // namespace

int
runBatch (const SegmentOptions& options, const Batch& batch)
{
  return BatchRun (options, batch).run();
}

} // namespace pcl_ops::apps
