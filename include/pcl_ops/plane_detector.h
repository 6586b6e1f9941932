// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/search/search.h>
#include <pcl/segmentation/planar_region.h>
#include <pcl/ModelCoefficients.h>
#include <pcl/pcl_base.h>
#include <pcl/PointIndices.h>

#include <pcl_ops/detail/detection.h>
#include <pcl_ops/detection_report.h>
#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>
#include <pcl_ops/plane_detector_parameters.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace pcl_ops {

namespace detail {

/** \brief Planes as PCL has them; their inliers are moved out. */
PCL_OPS_EXPORT void
toModels (std::vector<PlaneSegment>& planes,
          const pcl::PCLHeader& header,
          std::vector<pcl::ModelCoefficients>& coefficients,
          std::vector<pcl::PointIndices>& inliers);

/** \brief Does it, and says by PCL_ERROR in the name of the detector what it threw.
 * \return whether it threw nothing */
PCL_OPS_EXPORT bool
runAndReport (const std::string& class_name, const std::function<void()>& detect);

/** \brief What a detector works on, from what PCL hands in: no indices, all points; no
 * search, none used. */
template <typename PointT>
DetectorInput
detectorInput (const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
               const pcl::Indices* indices,
               const typename pcl::search::Search<PointT>::Ptr& search,
               unsigned threads);

template <typename PointT>
using PlanarRegions = std::vector<pcl::PlanarRegion<PointT>,
                                  Eigen::aligned_allocator<pcl::PlanarRegion<PointT>>>;

/** \brief Where planes end, as pcl::OrganizedMultiPlaneSegmentation says it. */
template <typename PointT>
void
toRegions (const pcl::PointCloud<PointT>& cloud,
           const std::vector<PlaneSegment>& planes,
           PlanarRegions<PointT>& regions);

} // namespace detail

/** \brief The calls all detectors share: PCL's ways to hand in a cloud and to take
 * planes out. A detector derives from it; for its parameters there are a \c validate
 * (parameters) and a \c detail::detect (input, parameters), which does the work for all
 * point types.
 * \tparam PointT a point type with x, y, z
 * \tparam ParametersT its parameters, derived from PlaneDetectorParameters, with the
 * name of its class */
template <typename PointT, typename ParametersT>
class PlaneDetector : public pcl::PCLBase<PointT> {
public:
  using Parameters = ParametersT;
  using Search = pcl::search::Search<PointT>;
  using SearchPtr = typename Search::Ptr;
  using PlanarRegions = detail::PlanarRegions<PointT>;

  /** \brief Finds the planes of the input cloud. Use one detector for each thread.
   * \param[out] planes by falling size; cleared first
   * \return false for misuse (no input, empty input, wrong indices or parameters), said
   * by PCL_ERROR. No plane found is success with empty output. */
  bool
  segment (std::vector<PlaneSegment>& planes)
  {
    last_ = detail::Detection();
    const bool success = detail::runAndReport (Parameters::class_name, [this] {
      detail::throwOn (this->input_ ? "" : "no input cloud; call setInputCloud");
      // Not initCompute, which would list all points.
      const pcl::Indices* const indices =
          this->fake_indices_ ? nullptr : this->indices_.get();
      last_ = detail::detectChecked (
          detail::detectorInput<PointT> (
              this->input_, indices, search_, parameters_.threads),
          parameters_);
    });
    planes = std::move (last_.planes);
    last_.planes.clear();
    return success;
  }

  /** \brief As above, in the order of pcl::OrganizedMultiPlaneSegmentation.
   * \param[out] coefficients a b c d of a x + b y + c z + d = 0 with a unit normal
   * as \ref PlaneSegment::normal, in the frame of the input cloud; single precision,
   * so that far from zero the overload above is better
   * \param[out] inliers ascending, disjoint indices into the input cloud */
  bool
  segment (std::vector<pcl::ModelCoefficients>& coefficients,
           std::vector<pcl::PointIndices>& inliers)
  {
    std::vector<PlaneSegment> planes;
    const bool success = segment (planes);
    detail::toModels (planes, header(), coefficients, inliers);
    return success;
  }

  /** \brief The largest plane alone.
   * \param[out] inliers ascending indices into the input cloud
   * \param[out] coefficients a b c d of that plane */
  bool
  segmentLargest (pcl::PointIndices& inliers, pcl::ModelCoefficients& coefficients)
  {
    std::vector<pcl::ModelCoefficients> models;
    std::vector<pcl::PointIndices> clusters;
    const bool success = segment (models, clusters);
    inliers = clusters.empty() ? pcl::PointIndices() : std::move (clusters.front());
    coefficients = models.empty() ? pcl::ModelCoefficients() : models.front();
    if (success)
      inliers.header = coefficients.header = header();
    return success;
  }

  /** \brief The largest plane alone, in the order of pcl::SACSegmentation: what
   * segmentLargest() does. */
  bool
  segment (pcl::PointIndices& inliers, pcl::ModelCoefficients& coefficients)
  {
    return segmentLargest (inliers, coefficients);
  }

  /** \brief Where each plane ends, as pcl::OrganizedMultiPlaneSegmentation says it.
   * \param[out] regions centroid, covariance and number of the inliers, coefficients,
   * and as contour the convex hull (\ref planeExtent), counter-clockwise seen from the
   * side the normal points to; of a contour's points only x, y and z are set */
  bool
  segment (PlanarRegions& regions)
  {
    std::vector<PlaneSegment> planes;
    const bool success = segment (planes);
    regions.clear();
    if (success)
      detail::toRegions (*this->input_, planes, regions);
    return success;
  }

  /** \brief The points of each plane, as pcl::RegionGrowing and
   * pcl::EuclideanClusterExtraction give their clusters. */
  bool
  extract (std::vector<pcl::PointIndices>& clusters)
  {
    std::vector<pcl::ModelCoefficients> coefficients;
    return segment (coefficients, clusters);
  }

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

  /** \brief theta_h: largest distance of a point to its plane [m]. 0: it follows the
   * noise of the cloud, which OPS alone allows, but for Sampling::Points. */
  void
  setDistanceThreshold (double threshold)
  {
    parameters_.distance_threshold =
        threshold == 0.0 ? std::nullopt : std::make_optional (threshold);
  }
  double
  getDistanceThreshold () const
  {
    return parameters_.distance_threshold.value_or (0.0);
  }

  /** \brief A plane with fewer points (inliers) than this is not returned, and its
   * points are on no plane; 0, the default: no limit. */
  void
  setMinPoints (std::size_t min_points)
  {
    parameters_.min_points = min_points;
  }
  std::size_t
  getMinPoints () const
  {
    return parameters_.min_points;
  }

  /** \brief Direction against gravity; any length but 0. */
  void
  setUpAxis (const Eigen::Vector3f& up_axis)
  {
    parameters_.up_axis = up_axis;
  }
  /** \brief In double precision, as estimateUpAxis() and cameraUp() give it. */
  template <typename Derived>
  void
  setUpAxis (const Eigen::MatrixBase<Derived>& up_axis)
  {
    parameters_.up_axis = up_axis.template cast<float>();
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

  /** \brief Same seed, same result, whatever the number of threads. Only FSPF and
   * OPS with Sampling::Points draw at random. */
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
  setMergingParameters (const MergingParameters& parameters)
  {
    parameters_.merging = parameters;
  }
  const MergingParameters&
  getMergingParameters () const
  {
    return parameters_.merging;
  }

  /** \brief Any neighbor search, in place of the library's own; its input cloud is set
   * by the detector. Only FSPF and OPS with Sampling::Points ask it. */
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
    return last_.durations;
  }

  /** \brief How many planes the last call had before any of them were merged; on
   * neighborhoods all regions that grew, also those that became no plane. */
  std::size_t
  getNumberOfPlanesBeforeMerging () const
  {
    return last_.planes_before_merging;
  }

  /** \brief Lengths that the last call worked with, where parameters leave them to the
   * cloud. */
  const UsedLengths&
  getUsedLengths () const
  {
    return last_.used;
  }

protected:
  PlaneDetector() = default;
  ~PlaneDetector() = default;

  Parameters parameters_;

private:
  pcl::PCLHeader
  header () const
  {
    return this->input_ ? this->input_->header : pcl::PCLHeader();
  }

  SearchPtr search_;
  /** \brief The last call's durations and numbers, its planes given out. */
  detail::Detection last_;
};

} // namespace pcl_ops

#ifdef PCL_NO_PRECOMPILE
#include <pcl_ops/impl/plane_detector.hpp>
#endif
