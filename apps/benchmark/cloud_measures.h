// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "measure.h"
#include <evaluation/detectors/detector_run.h>

#include <cstdint>

namespace pcl_ops::benchmark {

/** \brief Names of measures that are no detector's. @{ */
constexpr const char* cloud_copy = "copy of the cloud";
constexpr const char* kdtree_construction = "KdTreeFLANN construction";
constexpr const char* kdtree_with_searches = "KdTreeFLANN and FSPF's radius searches";
constexpr const char* default_on_two_threads = "ops, two threads";
/** @} */

/** \brief Names of detectors, as the evaluation has them. @{ */
constexpr const char* default_preset = "ops";
constexpr const char* paper_preset = "ops-3-30";
constexpr const char* sparse_paper_preset = "ops-0.3-10";
constexpr const char* hough_preset = "kht";
constexpr const char* sphere_preset = "fspf-0.07-0.14";
constexpr const char* sac_loop = "pcl-sac";
constexpr const char* efficient_ransac = "cgal-ransac";
/** @} */

/** \brief How often things are measured. */
struct MeasureParameters {
  std::size_t runs = 5;
  /** \brief Of the foreign detectors; 0: they are left out. */
  std::size_t peer_runs = 1;
  std::uint32_t seed = 42;
};

/** \brief A detector of this project with all its parameters, threads too. */
template <typename Detector>
Measure
detectorMeasure (const std::string& name,
                 std::size_t runs,
                 const typename Detector::Parameters& parameters,
                 const evaluation::XyzCloud::ConstPtr& cloud)
{
  return {name, runs, [parameters, cloud] {
            return evaluation::runDetector<Detector> (parameters, cloud).durations;
          }};
}

/** \brief Building pcl::KdTreeFLANN. */
Measure
kdTreeMeasure (const evaluation::XyzCloud::ConstPtr& cloud, std::size_t runs);

/** \brief Everything the ratios need on a cloud.
 * \param[in] cloud finite points */
std::vector<Measure>
measuresOf (const evaluation::XyzCloud::ConstPtr& cloud,
            const MeasureParameters& parameters);

} // namespace pcl_ops::benchmark
