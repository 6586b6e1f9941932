// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "scaling.h"

#include <pcl/common/io.h>

#include "boards.h"
#include "machine.h"
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <simulation/dense_scan.h>

#include <algorithm>

namespace pcl_ops::benchmark {

namespace {

using evaluation::XyzCloud;
using Ops = OrientedPointSampling<pcl::PointXYZ>;
using Kht = KernelHoughTransform<pcl::PointXYZ>;

class Scaling {
public:
  Scaling (const MeasureParameters& parameters, const Notify& notify)
  : runs_ (parameters.runs), notify_ (notify)
  {
    default_.seed = paper_.seed = parameters.seed;
  }

  void
  overThreads (const XyzCloud::ConstPtr& cloud, unsigned most)
  {
    for (unsigned threads = 1; threads <= most; ++threads) {
      default_.threads = paper_.threads = threads;
      add (over_threads, threads, cloud, presetsOn (cloud));
    }
    default_.threads = paper_.threads = 1;
  }

  void
  overSamplingRate (const XyzCloud::ConstPtr& cloud)
  {
    constexpr double per_cent = 100.0;
    const double usual = default_.sampling_rate;
    for (const double rate : {0.003, 0.005, 0.01, 0.03, 0.05, 0.1}) {
      default_.sampling_rate = paper_.sampling_rate = rate;
      add (over_sampling_rate, per_cent * rate, cloud, presetsOn (cloud));
    }
    default_.sampling_rate = paper_.sampling_rate = usual;
  }

  void
  overPoints (const std::vector<evaluation::CloudSource>& growing)
  {
    for (const evaluation::CloudSource& source : growing) {
      notify_ ("simulating " + source.name, 0.0);
      const XyzCloud::ConstPtr cloud = source.load().cloud;
      add (over_points, static_cast<double> (cloud->size()), cloud, allOn (cloud));
    }
  }

  void
  overPlanes (std::size_t points)
  {
    for (const unsigned planes : {1u, 3u, 10u, 30u, 100u, 300u}) {
      const auto scan =
          simulation::scanDensely (makeBoards (planes), points, 1.0, default_.seed);
      const XyzCloud::Ptr cloud (new XyzCloud);
      pcl::copyPointCloud (scan.cloud, *cloud);
      add (over_planes, planes, cloud, allOn (cloud));
    }
  }

  std::vector<ScalingRow> rows;

private:
  std::vector<Measure>
  presetsOn (const XyzCloud::ConstPtr& cloud) const
  {
    return {detectorMeasure<Ops> ("ops", runs_, default_, cloud),
            detectorMeasure<Ops> ("ops paper", runs_, paper_, cloud)};
  }

  std::vector<Measure>
  allOn (const XyzCloud::ConstPtr& cloud) const
  {
    std::vector<Measure> measures = presetsOn (cloud);
    measures.push_back (detectorMeasure<Kht> ("kht", runs_, {}, cloud));
    measures.push_back (kdTreeMeasure (cloud, runs_));
    return measures;
  }

  void
  add (const char* series,
       double x,
       const XyzCloud::ConstPtr& cloud,
       const std::vector<Measure>& measures)
  {
    measureInTurns (measures, notify_, [&] (const BestTime& time) {
      rows.push_back ({series, x, cloud->size(), time});
    });
  }

  std::size_t runs_;
  const Notify& notify_;
  OrientedPointSamplingParameters default_;
  OrientedPointSamplingParameters paper_ = OrientedPointSamplingParameters::paper();
};

} // namespace

std::vector<ScalingRow>
measureScaling (const XyzCloud::ConstPtr& cloud,
                const std::vector<evaluation::CloudSource>& growing,
                const MeasureParameters& parameters,
                const Notify& notify)
{
  Scaling scaling (parameters, notify);
  scaling.overThreads (cloud, std::max (2u, describeMachine().cores));
  scaling.overSamplingRate (cloud);
  scaling.overPlanes (cloud->size());
  scaling.overPoints (growing);
  return scaling.rows;
}

} // namespace pcl_ops::benchmark
