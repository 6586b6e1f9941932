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

/** \brief Converts planes to PCL's types. Moves the inliers out of \p planes. */
PCL_OPS_EXPORT void
toModels (std::vector<PlaneSegment>& planes,
          const pcl::PCLHeader& header,
          std::vector<pcl::ModelCoefficients>& coefficients,
          std::vector<pcl::PointIndices>& inliers);

/** \brief Calls \p detect. Reports an exception by PCL_ERROR, with the class name of
 * the detector.
 * \return false if \p detect threw an exception */
PCL_OPS_EXPORT bool
runAndReport (const std::string& class_name, const std::function<void()>& detect);

/** \brief Makes the input of a detector from PCL's types. Null \p indices stand for all
 * points. With a null \p search the library searches by itself. */
template <typename PointT>
DetectorInput
detectorInput (const typename pcl::PointCloud<PointT>::ConstPtr& cloud,
               const pcl::Indices* indices,
               const typename pcl::search::Search<PointT>::Ptr& search,
               unsigned threads);

template <typename PointT>
using PlanarRegions = std::vector<pcl::PlanarRegion<PointT>,
                                  Eigen::aligned_allocator<pcl::PlanarRegion<PointT>>>;

/** \brief Converts planes to regions with a contour, the convex hull of the inliers. */
template <typename PointT>
void
toRegions (const pcl::PointCloud<PointT>& cloud,
           const std::vector<PlaneSegment>& planes,
           PlanarRegions<PointT>& regions);

} // namespace detail

/** \brief Base class of all detectors: takes a cloud and returns planes as other PCL
 * classes do. Each type of parameters needs two functions, which \ref segment calls: \c
 * validate (parameters), and \c detail::detect (input, parameters), which does the work
 * for all point types.
 * \tparam PointT a point type with x, y, z
 * \tparam ParametersT parameters of the detector: derived from
 * PlaneDetectorParameters, with a member \c class_name */
template <typename PointT, typename ParametersT>
class PlaneDetector : public pcl::PCLBase<PointT> {
public:
  using Parameters = ParametersT;
  using Search = pcl::search::Search<PointT>;
  using SearchPtr = typename Search::Ptr;
  using PlanarRegions = detail::PlanarRegions<PointT>;

  /** \brief Finds the planes of the input cloud. Use one detector for each thread, with
   * a search of its own where one is set: copies of a detector share it.
   * \param[out] planes sorted by descending number of inliers; empty on failure
   * \return false on failure, which PCL_ERROR reports: no input, empty input, wrong
   * indices or parameters. True with empty output if the cloud has no planes. */
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

  /** \brief The same planes in PCL's types, with the arguments in the order of
   * pcl::OrganizedMultiPlaneSegmentation.
   * \param[out] coefficients a b c d of a x + b y + c z + d = 0 with the unit normal
   * \ref PlaneSegment::normal, in the frame of the input cloud. They are in single
   * precision: far from the origin the overload above is more exact
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

  /** \brief Finds the planes and returns only the one with the most inliers. Both
   * outputs are empty if there is no plane.
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

  /** \brief Calls segmentLargest(). The arguments are in the order of
   * pcl::SACSegmentation. */
  bool
  segment (pcl::PointIndices& inliers, pcl::ModelCoefficients& coefficients)
  {
    return segmentLargest (inliers, coefficients);
  }

  /** \brief The same planes as regions with a contour, the type that
   * pcl::OrganizedMultiPlaneSegmentation returns.
   * \param[out] regions centroid, covariance and number of the inliers, coefficients,
   * and the contour: the convex hull (\ref planeExtent), counter-clockwise seen from
   * the side the normal points to. Points of a contour have only x, y and z set */
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

  /** \brief Returns only the inliers of each plane, with the signature of
   * pcl::RegionGrowing and pcl::EuclideanClusterExtraction. */
  bool
  extract (std::vector<pcl::PointIndices>& clusters)
  {
    std::vector<pcl::ModelCoefficients> coefficients;
    return segment (coefficients, clusters);
  }

  /** \brief Sets all parameters at once, for example to a preset. */
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

  /** \brief theta_h: largest distance of a point to its plane [m]. 0: the distance
   * follows the noise of the cloud. Only OPS accepts 0, and not with Sampling::Points.
   */
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

  /** \brief Smallest number of inliers of a plane. Smaller planes are dropped, and
   * their points are on no plane. 0, the default: no limit. */
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

  /** \brief Direction against gravity in the frame of the input cloud, of any length
   * but 0. */
  void
  setUpAxis (const Eigen::Vector3f& up_axis)
  {
    parameters_.up_axis = up_axis;
  }
  /** \brief The same for vectors in double precision, which estimateUpAxis() and
   * cameraUp() return. */
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

  /** \brief Largest angle of a horizontal plane to the horizontal, and of a vertical
   * plane to the vertical [rad]. */
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

  /** \brief Sets the seed of random draws: equal seeds give equal results, with any
   * number of threads. Only FSPF and OPS with Sampling::Points draw at random. */
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

  /** \brief Number of threads; 0: one for each processor. */
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

  /** \brief Sets a neighbor search that replaces the library's own. The detector sets
   * the input cloud of the search. Only FSPF and OPS with Sampling::Points use it. */
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

  /** \brief Time of each stage of the last call [ms]. */
  const StageDurations&
  getStageDurations () const
  {
    return last_.durations;
  }

  /** \brief Number of planes that the last call found before it merged planes. With
   * Sampling::Neighborhoods it counts all grown regions, including regions that did not
   * become planes. */
  std::size_t
  getNumberOfPlanesBeforeMerging () const
  {
    return last_.planes_before_merging;
  }

  /** \brief Voxel size and distance threshold of the last call, whether parameters
   * gave them or they were chosen for the cloud. */
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
  /** \brief Durations and numbers of the last call, without its planes. */
  detail::Detection last_;
};

} // namespace pcl_ops

#ifdef PCL_NO_PRECOMPILE
#include <pcl_ops/impl/plane_detector.hpp>
#endif
