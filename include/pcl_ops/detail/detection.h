// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cloud_view.h>
#include <pcl_ops/detection_report.h>
#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <functional>
#include <string>
#include <vector>

// What the classes of the detectors hand to the functions behind them, and get back.
namespace pcl_ops::detail {

/** \brief A neighbor search of the user, as the stages ask it. Neighbors come as
 * indices into the input cloud with their squared distances [m^2]. */
struct NeighborSearch {
  /** \brief The k points nearest to a point of the cloud, itself included. */
  std::function<void (pcl::index_t, int k, pcl::Indices&, std::vector<float>&)> nearest;
  /** \brief The points up to a radius [m] from one of the cloud, itself included. */
  std::function<void (pcl::index_t, double radius, pcl::Indices&, std::vector<float>&)>
      within;
  /** \brief Threads that may ask at once; 0: all. */
  unsigned threads = 1;
};

/** \brief What a detector works on. */
struct DetectorInput {
  CloudView cloud;
  /** \brief The points to use, within the cloud, in any order, given twice or not;
   * null: all. */
  const pcl::Indices* indices;
  /** \brief Where the sensor was, in the frame of the cloud. */
  Eigen::Vector3d viewpoint;
  /** \brief Builds the user's search over the finite ones of the points, no indices
   * standing for the whole cloud. Empty: the library searches by itself. */
  std::function<NeighborSearch (const pcl::Indices& finite)> search_over;
};

/** \brief What is wrong with an input, as a sentence; empty if nothing is: a cloud or
 * indices without points, or an index outside the cloud. */
PCL_OPS_EXPORT std::string
validate (const DetectorInput& input);

/** \brief What a detector found. */
struct Detection {
  /** \brief By falling size, in the frame of the input cloud. */
  std::vector<PlaneSegment> planes;
  StageDurations durations;
  std::size_t planes_before_merging = 0;
  UsedLengths used;
};

/** \brief Throws std::invalid_argument if there is a problem. */
PCL_OPS_EXPORT void
throwOn (const std::string& problem);

/** \brief The same of both arguments, then the work of a detector. */
template <typename Parameters>
Detection
detectChecked (const DetectorInput& input, const Parameters& parameters)
{
  throwOn (validate (input));
  throwOn (validate (parameters));
  return detect (input, parameters);
}

} // namespace pcl_ops::detail
