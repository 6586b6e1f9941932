// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scaling.h"

#include <pcl/common/io.h>

#include <detection/methods.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <simulation/simulated_cloud.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <thread>

namespace pcl_ops::benchmark {

namespace {

using Ops = OrientedPointSampling<pcl::PointXYZ>;
using Kht = KernelHoughTransform<pcl::PointXYZ>;

/** \brief The presets on a cloud.
 * \param[in] sampling_rate that of the preset where there is none */
std::vector<Measure>
presetsOn (const XyzCloud::ConstPtr& cloud,
           const MeasureParameters& measuring,
           unsigned threads = 1,
           std::optional<double> sampling_rate = std::nullopt)
{
  std::vector<Measure> measures;
  for (const bool of_paper : {false, true}) {
    Ops::Parameters parameters;
    if (of_paper)
      parameters = Ops::Parameters::paper();
    parameters.seed = measuring.seed;
    parameters.threads = threads;
    parameters.sampling_rate = sampling_rate.value_or (parameters.sampling_rate);
    measures.push_back (detectorMeasure<Ops> (
        of_paper ? "ops paper" : "ops", measuring.runs, parameters, cloud));
  }
  return measures;
}

/** \brief The presets, 3D-KHT, and what no method is faster than. */
std::vector<Measure>
allOn (const XyzCloud::ConstPtr& cloud, const MeasureParameters& measuring)
{
  std::vector<Measure> measures = presetsOn (cloud, measuring);
  measures.push_back (detectorMeasure<Kht> ("kht", measuring.runs, {}, cloud));
  for (const Measure& least : leastMeasures (cloud, measuring.runs))
    measures.push_back (least);
  return measures;
}

void
writeRow (std::ostream& csv,
          const char* series,
          double x,
          std::size_t points,
          const std::string& cloud,
          const BestTime& time)
{
  csv << series << ',' << x << ',' << points << ',' << time.name << ',' << time.runs
      << ',' << std::quoted (cloud, '"', '"');
  for (const auto& [stage, duration] : apps::detection_stages)
    csv << ',' << time.durations.*duration;
  csv << '\n';
}

} // namespace

simulation::Scene
makeBoards (unsigned number)
{
  constexpr double spacing = 2.0; // [m]; a board is 1 m wide
  // No two of its multiples are near each other on the circle [rad].
  constexpr double golden_angle = 2.399963229728653;
  constexpr double steepest = 0.5; // [rad]
  const auto columns =
      static_cast<unsigned> (std::ceil (std::sqrt (static_cast<double> (number))));
  simulation::Scene scene;
  for (unsigned i = 0; i < number; ++i) {
    simulation::Body board;
    board.addSurface ({});
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.translate (Eigen::Vector3d (
        spacing * (i % columns), spacing * std::floor (i / columns), 0.0));
    pose.rotate (Eigen::AngleAxisd (golden_angle * i, Eigen::Vector3d::UnitZ()));
    pose.rotate (Eigen::AngleAxisd (steepest * i / number, Eigen::Vector3d::UnitX()));
    scene.add (board, pose);
  }
  return scene;
}

std::string
measureScaling (const evaluation::DataSet& clouds,
                const evaluation::DataSet& growing,
                const MeasureParameters& parameters,
                const Notify& notify)
{
  std::ostringstream csv;
  csv << "series,x,points,measure,runs,cloud";
  for (const auto& stage : apps::detection_stages)
    csv << ',' << stage.first << "_ms";
  csv << '\n';
  std::string name = clouds.front().name;
  const auto add = [&] (const char* series,
                        double x,
                        const XyzCloud::ConstPtr& cloud,
                        const std::vector<Measure>& measures) {
    for (const BestTime& time : measureInTurns (measures, notify))
      writeRow (csv, series, x, cloud->size(), name, time);
  };
  const XyzCloud::ConstPtr cloud = clouds.front().load().cloud;
  const unsigned most = std::max (2u, std::thread::hardware_concurrency());
  for (const evaluation::CloudSource& source : clouds) {
    name = source.name;
    const XyzCloud::ConstPtr kind = source.load().cloud;
    add ("threads", 1, kind, allOn (kind, parameters));
    for (unsigned threads = 2; threads <= most; ++threads)
      add ("threads", threads, kind, presetsOn (kind, parameters, threads));
  }
  for (const double rate : {0.003, 0.005, 0.01, 0.03, 0.05, 0.1})
    add ("sampling_rate", 100.0 * rate, cloud, presetsOn (cloud, parameters, 1, rate));
  for (const unsigned planes : {1u, 3u, 10u, 30u, 100u, 300u}) {
    const auto scan = simulation::scanDensely (
        makeBoards (planes), cloud->size(), 1.0, parameters.seed);
    const XyzCloud::Ptr boards (new XyzCloud);
    pcl::copyPointCloud (scan.cloud, *boards);
    add ("planes", planes, boards, allOn (boards, parameters));
  }
  for (const evaluation::CloudSource& source : growing) {
    name = source.name;
    notify ("simulating " + name);
    const XyzCloud::ConstPtr scan = source.load().cloud;
    add ("points", double (scan->size()), scan, allOn (scan, parameters));
  }
  return csv.str();
}

} // namespace pcl_ops::benchmark
