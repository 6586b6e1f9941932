// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include <boost/format.hpp>

#include <Eigen/Geometry>

#include "report.h"
#include "warnings.h"
#include <cli/errors.h>
#include <cli/program.h>
#include <cli/progress.h>
#include <cli/text.h>
#include <detection/common_up.h>
#include <detection/known_sensor.h>
#include <detection/warning_lines.h>
#include <io/las_crs.h>
#include <io/las_file.h>
#include <io/output_file.h>
#include <io/pose_file.h>
#include <pcl_ops/plane_tracker.h>
#include <pcl_ops/visibility.h>
#include <unistd.h>

#include <algorithm>
#include <condition_variable>
#include <iostream>
#include <iterator>
#include <mutex>
#include <numeric>

#if PCL_OPS_WITH_SURFACE
#include <pcl_ops/surface/concave_hull.h>
#endif

namespace pcl_ops::apps {

namespace {

/** \brief Gives what was found in a cloud, in the cloud's frame, its ids.
 * \param[in] sensor where it was or, if that is not known, a place among the points */
using GiveIds = std::function<void (const Eigen::Vector3d& sensor, Report& report)>;

std::vector<std::uint32_t>
numbersUpTo (std::size_t size)
{
  std::vector<std::uint32_t> numbers (size);
  std::iota (numbers.begin(), numbers.end(), 1U);
  return numbers;
}

/** \brief Has the pieces in place of the planes, beside what these are without them. */
void
divideIntoPieces (const SegmentOptions& options,
                  const XyzCloud& cloud,
                  Detected& detected)
{
  const auto threads = options.detector.numbers.find ("threads");
  PlanePieces found = findPlanePieces (cloud,
                                       detected.planes,
                                       options.of_pieces,
                                       threads == options.detector.numbers.end()
                                           ? 1
                                           : static_cast<unsigned> (threads->second));
  detected.whole_planes = std::move (detected.planes);
  for (PlaneSegment& plane : detected.whole_planes)
    plane.inliers.clear();
  detected.planes = std::move (found.pieces);
  detected.lies_on = std::move (found.planes);
  detected.settings["piece_gap"] = options.of_pieces.max_gap;
}

Detected
detectPlanes (const SegmentOptions& options,
              const ShiftedCloud& shifted,
              const FileCloud& cloud)
{
  Detected detected =
      runMethod (methodCalled (options.method), options.detector, shifted.cloud);
  // Of other clouds the detector knows.
  if (!shifted.shift.isZero (0.0) && cloud.origin.head<3>().isZero (0.0f))
    turnUnseenUp (*shifted.cloud,
                  shifted.cloud->sensor_origin_.head<3>().cast<double>(),
                  detected.up.cast<double>(),
                  detected.planes);
  if (options.pieces)
    divideIntoPieces (options, *shifted.cloud, detected);
  for (auto* planes : {&detected.planes, &detected.whole_planes}) {
    for (PlaneSegment& plane : *planes)
      plane.moveBy (shifted.shift);
    if (cloud.is_survey)
      turnUp (*planes, detected.up.cast<double>());
  }
  return detected;
}

std::string
nameOfInput (const Task& task)
{
  return task.input == standard_stream ? standard_input : task.input;
}

/** \brief Refuses an output that cannot have all of the input and labels. */
void
checkTakesLabels (const SegmentOptions& options,
                  const Task& task,
                  const FileCloud& cloud)
{
  const std::string& output = task.outputs.cloud;
  if (!isLasName (output))
    return;
  if (cloud.las == nullptr)
    throw UsageError (output, "is LAS, which the input is not; give a file .pcd");
  std::vector<LasField> fields = {label_field};
  if (options.distances)
    fields.push_back (distance_field);
  if (options.pieces)
    fields.push_back (plane_field);
  const std::string problem = cloud.las->validate (fields);
  if (!problem.empty())
    throw WorkError (nameOfInput (task), problem);
}

PlanarRings
outlineOf (const PlanarPoints& points, [[maybe_unused]] const std::string& hull)
{
#if PCL_OPS_WITH_SURFACE
  if (hull == "concave")
    return concaveOutline (points);
#endif
  return {convexHull (points)};
}

/** \brief Where a plane ends, in the file's frame.
 * \param[in] shifted the cloud the plane was found in
 * \param[in] hull "convex" or "concave" */
PlaneExtent
extentInFile (const ShiftedCloud& shifted,
              const PlaneSegment& plane,
              const std::string& hull)
{
  const PlaneFrame in_cloud (plane.centroid - shifted.shift, plane.normal);
  const PlaneFrame in_file (plane.centroid, plane.normal);
  const PlanarPoints points = pointsOnPlane (*shifted.cloud, plane, in_cloud);
  return extentOf (outlineOf (points, hull), points, in_file);
}

/** \brief Moves planes to where they are exactly parallel, orthogonal and coplanar. */
void
regularize (Detected& detected)
{
  RegularizedPlanes found = regularizePlanes (detected.planes);
  detected.planes = std::move (found.planes);
  detected.moves = std::move (found.moves);
}

/** \brief Says what planes are, by their convex outlines, which are kept.
 * \param[in] meter its length in the unit of the cloud */
void
nameKinds (const FileCloud& cloud,
           const ShiftedCloud& shifted,
           double meter,
           Detected& detected)
{
  for (const PlaneSegment& plane : detected.planes)
    detected.extents.push_back (extentInFile (shifted, plane, "convex"));
  detected.kinds = planeKinds (detected.planes,
                               detected.extents,
                               detected.up.cast<double>(),
                               meter,
                               knownSensor (cloud, shifted));
  if (meter != 1.0)
    detected.settings["meter"] = meter;
}

/** \brief Why so few points are on planes, with the fix. What is wrong with a cloud
 * comes before what might be wrong with parameters. */
std::string
likeliestCause (const Report& report)
{
  if (!report.damage.empty())
    return "the cloud " + report.damage;
  for (const ResultWarning& warning : report.warnings)
    if (warning.code == "degrees")
      return warning.text;
  return report.detected.advice;
}

/** \param[in] counts of the planes before any was left out */
void
drawPlan (const SegmentOptions& options,
          const ShiftedCloud& shifted,
          PlanCounts counts,
          Report& report)
{
  const Detected& detected = report.detected;
  report.plan = findFloorPlan (*shifted.cloud,
                               detected.planes,
                               detected.kinds,
                               detected.up.cast<double>(),
                               options.of_plan,
                               shifted.shift);
  counts.walls = report.plan->walls.size();
  counts.wall_planes_kept = countOf (PlaneKind::Wall, detected);
  putWarningOnPlan (counts, report.warnings);
}

/** \brief Has the reference system of a file name maps and say the unit, unless the
 * user does. */
SegmentOptions
withSystemOf (const FileCloud& cloud, SegmentOptions options)
{
  if (cloud.las == nullptr)
    return options;
  if (options.map.crs.empty())
    options.map.crs = crsOf (*cloud.las);
  const double meter = unitsInMeter (*cloud.las);
  if (!options.has_meter && meter != 1.0) {
    options.of_plan.meter = meter;
    options.has_meter = true;
  }
  return options;
}

/** \brief Reads a cloud, finds its planes and writes its outputs.
 * \param[in] give_ids where it is missing, planes are numbered by falling size
 * \param[in] lines what tells the stages; nullptr for none
 * \throws UsageError or WorkError if the cloud cannot be read or an output cannot be
 * written, Interrupted before anything is written */
Report
segmentCloud (const SegmentOptions& given,
              const Task& task,
              const GiveIds& give_ids,
              StageLines* lines)
{
  const std::string name = nameOfInput (task);
  const auto begin = [&] (const std::string& stage) {
    stopIfInterrupted();
    if (lines != nullptr)
      lines->begin (name + ": " + stage);
  };
  begin ("reading");
  const bool is_piped = task.input == standard_stream;
  const FileCloud cloud = is_piped ? loadStandardInput() : loadCloud (task.input);
  const SegmentOptions options = withSystemOf (cloud, given);
  checkTakesLabels (options, task, cloud);
  begin ("finding planes in " + std::to_string (cloud.size()) + " points");
  const ShiftedCloud shifted = shiftedCloudOf (cloud, voxelStepOf (options.detector));
  Report report;
  report.input = name;
  report.method = options.method;
  report.points = cloud.size();
  report.damage = damageOf (shifted);
  report.detected = detectPlanes (options, shifted, cloud);
  turnToScanners (report.detected.planes, cloud.scans);
  if (!options.quiet || !task.outputs.planes.empty())
    report.warnings = warningsOn (options, task, cloud, shifted, report.detected);
  if (!report.detected.advice.empty())
    report.detected.advice = likeliestCause (report);
  if (options.regularize)
    regularize (report.detected);
  nameKinds (cloud, shifted, options.of_plan.meter, report.detected);
  const std::vector<PlaneSegment>& planes = report.detected.planes;
  const auto extent_of = [&] (const PlaneSegment& plane) {
    return extentInFile (shifted, plane, options.hull);
  };
  PlanCounts counts;
  counts.wall_planes_found = countOf (PlaneKind::Wall, report.detected);
  counts.has_floor = countOf (PlaneKind::Floor, report.detected) > 0;
  report.dropped = keepChosen (options.choice, extent_of, report.detected);
  if (!task.outputs.plan.empty())
    drawPlan (options, shifted, counts, report);
  report.ids = numbersUpTo (planes.size());
  report.ids_of_whole = numbersUpTo (report.detected.whole_planes.size());
  const Eigen::Vector3d sensor = cloud.origin.head<3>().cast<double>();
  if (give_ids)
    give_ids (sensor.isZero (0.0) ? shifted.shift : sensor, report);
  if (options.hull == "convex")
    report.extents = report.detected.extents;
  else if (!task.outputs.planes.empty() || !task.outputs.mesh.empty() ||
           !task.outputs.view.empty())
    std::transform (
        planes.begin(), planes.end(), std::back_inserter (report.extents), extent_of);
  begin ("writing");
  report.written = saveOutputs (options, task.outputs, cloud, shifted, report);
  return report;
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
  if (!options.calibration.empty()) {
    const Eigen::Isometry3d to_camera = loadCalibration (options.calibration);
    for (Eigen::Isometry3d& pose : poses)
      pose = to_camera.inverse() * pose * to_camera;
  }
  return poses;
}

bool
isScanOfKitti (const Task& task)
{
  return extensionOf (task.input) == ".bin";
}

struct Status {
  enum { Done, Failed, Interrupted } end;
  std::string problem = {}, summary = {}, input = {};
  std::vector<ResultWarning> warnings = {};
};

/** \brief Segments clouds, options.jobs at a time. Goes on after one that fails; ends
 * early when the user interrupts it, with each cloud's outputs either complete or
 * untouched. Prints lines and numbers planes in the order of the tasks: both are the
 * same for any number of jobs. */
class BatchRun {
public:
  BatchRun (const SegmentOptions& options, const Batch& batch)
  : options_ (options)
  , in_common_frame_ (options)
  , batch_ (batch)
  , tracker_ (options.track.matching)
  , tracker_of_whole_ (options.track.matching)
  , progress_ (batch.tasks.size(),
               std::cerr,
               ::isatty (STDERR_FILENO) == 1 ? ProgressStyle::Bar : ProgressStyle::None)
  , statuses_ (batch.tasks.size())
  {
    if (options.track.is_on && !batch.tasks.empty())
      poses_ = posesOf (options.track, batch.tasks.size());
    in_common_frame_.track.has_camera_poses =
        options.track.calibration.empty() && !options.track.poses.empty() &&
        std::any_of (batch.tasks.begin(), batch.tasks.end(), isScanOfKitti) &&
        lookLikeCameraOfKitti (options.track.poses, poses_);
  }

  /** \return the exit code, ExitCode::work_failed if any failed or was left */
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
        // No memory even to say so: those behind must not wait for this one.
        const std::lock_guard<std::mutex> lock (mutex_);
        is_given_up_ = true;
        is_next_.notify_all();
        throw;
      }
    });
    progress_.erase();
    if (!options_.quiet)
      for (const std::string& line : doubts_.lines())
        warn (line);
    return conclude();
  }

private:
  /** \brief Gives the planes of a cloud their ids, once the clouds before are done.
   * \param[in] sensor in the frame of the cloud: what a pose's error turns about */
  void
  giveIds (std::size_t i, const Eigen::Vector3d& sensor, Report& report)
  {
    std::unique_lock<std::mutex> lock (mutex_);
    is_next_.wait (lock, [&] { return finished_ == i || is_given_up_; });
    if (is_given_up_)
      throw Interrupted();
    const auto track = [&] (PlaneTracker& tracker, std::vector<PlaneSegment> planes) {
      for (PlaneSegment& plane : planes)
        plane.moveBy (-sensor);
      return tracker.track (planes, poses_[i] * Eigen::Translation3d (sensor));
    };
    report.ids = track (tracker_, report.detected.planes);
    if (options_.pieces)
      report.ids_of_whole = track (tracker_of_whole_, report.detected.whole_planes);
  }

  /** \brief What single clouds say which way is up, in the frame that poses share; of
   * long sequences evenly chosen ones. */
  std::vector<UpAxis>
  answersOnUp ()
  {
    constexpr std::size_t max_asked = 64;
    const std::size_t all = batch_.tasks.size();
    const std::size_t asked = std::min (all, max_asked);
    std::vector<std::optional<UpAxis>> found (asked);
    runInParallel (asked, options_.jobs, [&] (std::size_t k) {
      const std::size_t i = k * all / asked;
      try {
        stopIfInterrupted();
        const FileCloud cloud = loadCloud (batch_.tasks[i].input);
        const ShiftedCloud shifted =
            shiftedCloudOf (cloud, voxelStepOf (options_.detector));
        found[k] = findUpAxis (options_.detector, *shifted.cloud);
        if (found[k])
          found[k]->direction = poses_[i].rotation() * found[k]->direction;
      }
      catch (const std::exception&) {
        // The cloud's own turn tells what is wrong with it.
      }
    });
    std::vector<UpAxis> answers;
    for (const std::optional<UpAxis>& answer : found)
      if (answer)
        answers.push_back (*answer);
    return answers;
  }

  /** \brief One axis for the clouds of a sequence, of which many cannot tell. */
  void
  setCommonUp ()
  {
    DetectorOptions& detector = in_common_frame_.detector;
    const bool has_poses = !options_.track.poses.empty();
    if (detector.up_is_camera && has_poses) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      for (const Eigen::Isometry3d& pose : poses_)
        sum -= pose.rotation().col (1);
      if (sum.norm() < 0.5 * static_cast<double> (poses_.size()))
        throw UsageError ("--up", "camera: by --poses it is not level; give auto");
      detector.up = sum.normalized().cast<float>();
    }
    if (!detector.finds_up)
      return;
    const std::vector<UpAxis> answers = answersOnUp();
    const std::optional<CommonUp> common = commonUp (answers);
    detector.finds_up = false;
    detector.sequence_has_up = true;
    if (common) {
      detector.up = common->axis.direction.cast<float>();
      detector.up_confidence = common->axis.confidence;
    }
    if (!options_.quiet)
      progress_.note (noteOnUp (common, answers.size(), has_poses), std::cout);
  }

  static std::string
  noteOnUp (const std::optional<CommonUp>& common, std::size_t answers, bool has_poses)
  {
    if (!common)
      return "Up axis of all clouds: they cannot tell, 0,0,1 is used; give --up x,y,z";
    const Eigen::Vector3d& up = common->axis.direction;
    return str (
        boost::format ("Up axis of all clouds: %.3f,%.3f,%.3f%s, as %d of the %d "
                       "say that can tell") %
        up.x() % up.y() % up.z() % (has_poses ? " in the frame of --poses" : "") %
        common->answers % answers);
  }

  /** \brief Those of a cloud: up is given in the frame that poses share. */
  SegmentOptions
  optionsOf (std::size_t i) const
  {
    SegmentOptions options = in_common_frame_;
    DetectorOptions& detector = options.detector;
    const Eigen::Vector3f upwards = Eigen::Vector3f::UnitZ();
    if (!options.track.poses.empty() && !detector.finds_up)
      detector.up = poses_[i].rotation().transpose().cast<float>() *
                    detector.up.value_or (upwards);
    return options;
  }

  Status
  statusOf (std::size_t i)
  {
    const Task& task = batch_.tasks[i];
    GiveIds tracked;
    if (options_.track.is_on)
      tracked = [&] (const Eigen::Vector3d& sensor, Report& report) {
        giveIds (i, sensor, report);
      };
    try {
      stopIfInterrupted();
      const char* const fix =
          options_.jobs == 1 ? "give a smaller cloud" : "give fewer --jobs";
      const Report report = inMemory (task.input, fix, [&] {
        return segmentCloud (optionsOf (i), task, tracked, nullptr);
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

  void
  finish (std::size_t i, const Status& status)
  {
    const std::lock_guard<std::mutex> lock (mutex_);
    statuses_[i] = status;
    for (; finished_ < statuses_.size() && statuses_[finished_]; ++finished_)
      print (*statuses_[finished_]);
    is_next_.notify_all();
    if (status.end != Status::Interrupted)
      progress_.step();
  }

  void
  print (const Status& status)
  {
    ++counts_.at (status.end);
    doubts_.add (status.input, status.warnings);
    if (!status.problem.empty())
      progress_.note (errorLine (status.problem), std::cerr);
    if (status.end == Status::Done && !options_.quiet)
      progress_.note (oneLine (status.summary), std::cout);
  }

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
  /** \brief With the up axis that all clouds of a sequence have. */
  SegmentOptions in_common_frame_;
  const Batch& batch_;
  PlaneTracker tracker_;
  /** \brief Of the planes that pieces lie on. */
  PlaneTracker tracker_of_whole_;
  std::vector<Eigen::Isometry3d> poses_;
  Progress progress_;
  std::mutex mutex_;
  std::condition_variable is_next_;
  std::vector<std::optional<Status>> statuses_;
  /** \brief So many from the first on have a status, which is printed. */
  std::size_t finished_ = 0;
  bool is_given_up_ = false;
  std::array<std::size_t, 3> counts_{};
  WarningLines doubts_;
};

/** \brief What files hold, and what is doubtful, on stderr. */
void
sayWhatIsDoubtful (const Report& report)
{
  for (const std::string& line : report.written)
    warn (line);
  WarningLines doubts;
  doubts.add (report.input, report.warnings);
  for (const std::string& line : doubts.lines())
    warn (line);
}

int
segmentOne (const SegmentOptions& options)
{
  const Task task = taskOf (options);
  std::optional<StageLines> lines;
  if (!options.quiet)
    lines.emplace (std::cerr);
  const Report report = inMemory (nameOfInput (task), "give a smaller cloud", [&] {
    return segmentCloud (options, task, {}, lines ? &*lines : nullptr);
  });
  lines.reset();
  if (!report.damage.empty())
    warn (report.input + ": " + report.damage);
  if (!options.quiet)
    sayWhatIsDoubtful (report);
  if (options.quiet || task.outputs.planes == standard_stream)
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
