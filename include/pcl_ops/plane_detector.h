// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/search/search.h>
#include <pcl/segmentation/planar_region.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/pcl_base.h>
#include <pcl/PointIndices.h>

#include <pcl_ops/orientation.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_assignment.h>
#include <pcl_ops/plane_extent.h>
#include <pcl_ops/plane_merging.h>
#include <pcl_ops/points.h>

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_ops {

/** \brief What the parameters of all detectors have in common. */
struct PlaneDetectorParameters {
  /** \brief theta_h: largest distance of a point to its plane [m]. */
  double distance_threshold = 0.05;
  /** \brief Direction against gravity in the frame of the input cloud, any length but
   * 0. It only names the orientation of a plane; detection does not depend on it,
   * except where planes are looked for per orientation (Strategy::DivideThenDetect). */
  Eigen::Vector3f up_axis = Eigen::Vector3f::UnitZ();
  /** \brief Largest angle to be horizontal or vertical [rad]; default 7 degrees. */
  double angle_tolerance = 0.12217304763960307;
  /** \brief Seed of every random choice. */
  std::uint32_t seed = 42;
  /** \brief Number of threads; 0: all. The result does not depend on it. */
  unsigned threads = 1;
  MergingParameters merging;
};

/** \brief What is wrong with a set of parameters, as a sentence; empty if nothing is.
 * \param[in] parameters those of any detector
 * \param[in] threshold_may_follow_noise whether a distance threshold of 0 has a meaning
 */
std::string
problemOf (const PlaneDetectorParameters& parameters,
           bool threshold_may_follow_noise = false);

/** \brief Wall time of each stage of the last call [ms]. */
struct StageDurations {
  double search = 0.0;
  double normals = 0.0;
  double extraction = 0.0;
  double assignment = 0.0;
  double merging = 0.0;
  /** \brief Everything between a loaded cloud and labels for all points. */
  double detection = 0.0;
};

/** \brief What a detector found, in the local frame of its points. */
struct Detection {
  Points points;
  /** \brief For each point the position of its plane in \ref planes, or no_plane. */
  Labels labels;
  MergedPlanes planes;
};

/** \brief The planes of a detection in the frame of the input cloud, by falling size.
 * \param[in] detection the planes and the points on them
 * \param[in] viewpoint origin of the sensor: normals point to its side
 * \param[in] parameters up axis and angle tolerance for the orientation */
std::vector<PlaneSegment>
toSegments (const Detection& detection,
            const Eigen::Vector3d& viewpoint,
            const PlaneDetectorParameters& parameters);

/** \brief The calls all detectors share: PCL's ways to hand in a cloud and to take
 * planes out. A detector derives from it, gives a method \c detect () that returns a
 * Detection, and a \c className (). \tparam PointT a point type with x, y, z \tparam
 * Detector the detector itself \tparam ParametersT its parameters, derived from
 * PlaneDetectorParameters */
template <typename PointT, typename Detector, typename ParametersT>
class PlaneDetector : public pcl::PCLBase<PointT> {
public:
  using Parameters = ParametersT;
  using Search = pcl::search::Search<PointT>;
  using SearchPtr = typename Search::Ptr;
  using PlanarRegions =
      std::vector<pcl::PlanarRegion<PointT>,
                  Eigen::aligned_allocator<pcl::PlanarRegion<PointT>>>;

  /** \brief Finds the planes of the input cloud.
   * \param[out] planes by falling size; cleared first
   * \return false for misuse (no input, empty input, wrong indices or parameters), said
   * by PCL_ERROR. No plane found is success with empty output. */
  bool
  segment (std::vector<PlaneSegment>& planes);

  /** \brief As above, in the order of pcl::OrganizedMultiPlaneSegmentation.
   * \param[out] coefficients a b c d of a x + b y + c z + d = 0 with a unit normal
   * towards the sensor's origin, in the frame of the input cloud \param[out] inliers
   * ascending, disjoint indices into the input cloud */
  bool
  segment (std::vector<pcl::ModelCoefficients>& coefficients,
           std::vector<pcl::PointIndices>& inliers);

  /** \brief The largest plane alone, in the order of pcl::SACSegmentation. */
  bool
  segment (pcl::PointIndices& inliers, pcl::ModelCoefficients& coefficients);

  /** \brief Where each plane ends, as pcl::OrganizedMultiPlaneSegmentation says it.
   * \param[out] regions centroid, covariance and number of the inliers, coefficients,
   * and as contour the convex hull (\ref planeExtent), counter-clockwise seen from the
   * side the normal points to; of a contour's points only x, y and z are set */
  bool
  segment (PlanarRegions& regions);

  /** \brief The points of each plane, as pcl::RegionGrowing and
   * pcl::EuclideanClusterExtraction give their clusters. */
  bool
  extract (std::vector<pcl::PointIndices>& clusters);

  /** \brief All parameters at once, for example a preset. */
  void
  setParameters (const Parameters& parameters)
  {
    parameters_ = parameters;
  }
  const Parameters&
  getParameters () const
  {
    return parameters_;
  }

  /** \brief theta_h: largest distance of a point to its plane [m]. For OPS on cells 0,
   * its default, follows the noise of the cloud, whatever its unit. */
  void
  setDistanceThreshold (double threshold)
  {
    parameters_.distance_threshold = threshold;
  }
  double
  getDistanceThreshold () const
  {
    return parameters_.distance_threshold;
  }

  /** \brief Direction against gravity; any length but 0. */
  void
  setUpAxis (const Eigen::Vector3f& up_axis)
  {
    parameters_.up_axis = up_axis;
  }
  const Eigen::Vector3f&
  getUpAxis () const
  {
    return parameters_.up_axis;
  }

  /** \brief Largest angle to be horizontal or vertical [rad]. */
  void
  setAngleTolerance (double tolerance)
  {
    parameters_.angle_tolerance = tolerance;
  }
  double
  getAngleTolerance () const
  {
    return parameters_.angle_tolerance;
  }

  /** \brief Same seed, same result, whatever the number of threads. */
  void
  setSeed (std::uint32_t seed)
  {
    parameters_.seed = seed;
  }
  std::uint32_t
  getSeed () const
  {
    return parameters_.seed;
  }

  /** \brief Number of threads; 0: all. */
  void
  setNumberOfThreads (unsigned threads)
  {
    parameters_.threads = threads;
  }
  unsigned
  getNumberOfThreads () const
  {
    return parameters_.threads;
  }

  /** \brief Thresholds of the merging process (paper section III-C). */
  void
  setMergingParameters (const MergingParameters& merging)
  {
    parameters_.merging = merging;
  }
  const MergingParameters&
  getMergingParameters () const
  {
    return parameters_.merging;
  }

  /** \brief Any neighbour search, in place of GridSearch; its input cloud is set by the
   * detector. */
  void
  setSearchMethod (const SearchPtr& search)
  {
    search_ = search;
  }
  const SearchPtr&
  getSearchMethod () const
  {
    return search_;
  }

  /** \brief Time of each stage of the last call. */
  const StageDurations&
  getStageDurations () const
  {
    return durations_;
  }

  /** \brief How many planes the last call had before it merged them. */
  std::size_t
  getNumberOfPlanesBeforeMerging () const
  {
    return planes_before_merging_;
  }

protected:
  PlaneDetector() = default;
  ~PlaneDetector() = default;

  std::string
  getClassName () const
  {
    return Detector::className();
  }

  /** \brief The search method of the user, or a GridSearch, over the points. */
  SearchPtr
  searchOver (const Points& points) const;

  /** \brief Where the sensor was, in the frame of the input cloud. */
  Eigen::Vector3d
  viewpoint () const;

  /** \brief Threads that may query the search at once: only GridSearch and kd-trees are
   * known to be safe. */
  unsigned
  searchThreads () const;

  /** \brief theta_h where the merging process has no distance of its own. */
  MergingParameters
  mergingParameters () const;

  Parameters parameters_;
  SearchPtr search_;
  StageDurations durations_;
  std::size_t planes_before_merging_ = 0;

private:
  bool
  isReady ();
  bool
  hasIndicesInRange () const;
};

} // namespace pcl_ops

#include <pcl_ops/impl/plane_detector.hpp>
