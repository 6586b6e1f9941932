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

// Input and output of the detection functions that the detector classes call.
namespace pcl_ops::detail {

/** \brief A neighbor search as functions: the user's or the library's. They return
 * neighbors as indices into the input cloud with squared distances [m^2]. */
struct NeighborSearch {
  /** \brief Finds the k nearest neighbors of a point of the cloud, itself included. */
  std::function<void (pcl::index_t point,
                      int k,
                      pcl::Indices& neighbors,
                      std::vector<float>& squared_distances)>
      nearest;
  /** \brief Finds all points within a radius [m] of a point of the cloud, itself
   * included. Empty for the library's own search. */
  std::function<void (pcl::index_t point,
                      double radius,
                      pcl::Indices& neighbors,
                      std::vector<float>& squared_distances)>
      within;
  /** \brief Number of threads that may search at the same time; 0: all. */
  unsigned threads = 1;
};

/** \brief Checks what a search of the user has found.
 * \throw std::invalid_argument for an index outside of the cloud
 * \param[in] points number of points of the cloud */
PCL_OPS_EXPORT void
checkNeighbors (const pcl::Indices& neighbors, std::size_t points);

/** \brief Input of a detector. */
struct DetectorInput {
  CloudView cloud;
  /** \brief Indices of the points to use, in any order, with or without repetition;
   * null: all points. */
  const pcl::Indices* indices;
  /** \brief Position of the sensor in the frame of the cloud. */
  Eigen::Vector3d viewpoint;
  /** \brief Builds the user's search over the finite points; empty indices stand for
   * the whole cloud. An empty function: the library searches by itself. */
  std::function<NeighborSearch (const pcl::Indices& finite)> search_over;
};

/** \brief Returns the first problem of an input: an empty cloud, one of 2^31 points or
 * more, empty indices, or an index outside the cloud. Empty if the input is valid. */
PCL_OPS_EXPORT std::string
validate (const DetectorInput& input);

/** \brief Result of a detector. */
struct Detection {
  /** \brief By descending number of inliers, in the frame of the input cloud. */
  std::vector<PlaneSegment> planes;
  StageDurations durations;
  std::size_t planes_before_merging = 0; // their number
  UsedLengths used;
};

/** \brief Throws std::invalid_argument with the text, unless it is empty. */
PCL_OPS_EXPORT void
throwOn (const std::string& problem);

/** \brief Throws std::invalid_argument if an argument is not valid; else runs the
 * detector. */
template <typename Parameters>
Detection
detectChecked (const DetectorInput& input, const Parameters& parameters)
{
  throwOn (validate (input));
  throwOn (validate (parameters));
  return detect (input, parameters);
}

} // namespace pcl_ops::detail
