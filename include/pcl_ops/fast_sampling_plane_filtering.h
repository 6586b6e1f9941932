// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/local_plane_sampling.h>
#include <pcl_ops/plane_detector.h>

#include <string>

namespace pcl_ops {

/** \brief Parameters of FastSamplingPlaneFiltering; the defaults are the recommended
 * ones: the paper's, with the radii it finds the most accurate (Table I). */
struct FastSamplingPlaneFilteringParameters : PlaneDetectorParameters {
  /** \brief r1, r2, N_loc, alpha_min, N_max and K_max. */
  LocalSamplingParameters local;

  /** \brief The algorithm of the paper with the row of its Table IV: r1 0.07 m, r2
   * 0.14 m, 80 local samples, four fifths of them inliers, 0.05 m. */
  static FastSamplingPlaneFilteringParameters
  paper ();
};

/** \brief What is wrong with a set of parameters, as a sentence; empty if nothing is.
 */
std::string
problemOf (const FastSamplingPlaneFilteringParameters& parameters);

/** \brief \ref sampleLocalPlanes with a search of the library's own for the spheres.
 * \param[in] points the finite points
 * \param[in] parameters those of the detector
 * \param[in,out] durations the time of each stage is added */
LocalPlanes
sampleLocalPlanes (const Points& points,
                   const FastSamplingPlaneFilteringParameters& parameters,
                   StageDurations& durations);

/** \brief The planes of merged moments, the largest first. */
std::vector<Plane>
planesOf (const MergedPlanes& merged);

/** \brief Fits merged planes to the points assigned to them, and merges those that have
 * become coplanar.
 * \param[in] points the points
 * \param[in,out] labels plane of each point; replaced by the plane it was merged into
 * \param[in] merged the planes \p labels speaks of
 * \param[in] parameters thresholds; its distance_threshold must be above 0
 * \param[in] threads number of threads; 0: all. The result does not depend on it
 * \return the planes, with where each of those put into \p merged has gone */
MergedPlanes
refitAssigned (const Points& points,
               Labels& labels,
               const MergedPlanes& merged,
               const MergingParameters& parameters,
               unsigned threads);

/** \brief FSPF: finds planes by testing, all over a point cloud, whether the points in
 * a small sphere lie on the plane through three of them.
 *
 * Sun & Mordohai, "Oriented Point Sampling for Plane Detection in Unorganized Point
 * Clouds", ICRA 2019, section III-B: the method of Biswas & Veloso, "Planar polygon
 * extraction and merging from depth images", IROS 2012, in spheres instead of image
 * windows.
 *
 * Unlike those of the other detectors its planes, hundreds of small ones, are merged
 * before points are assigned to them: extended through a whole room, each would take
 * points of others. Each point goes to the largest merged plane within theta_h.
 *
 * Without \c setSearchMethod spheres are found by FixedRadiusSearch, several times
 * faster than by a kd-tree. A search method of the user gives the same spheres with
 * their points in another order, and so other random draws from them.
 *
 * \code
 * pcl_ops::FastSamplingPlaneFiltering<pcl::PointXYZ> fspf;
 * fspf.setInputCloud (cloud);
 * std::vector<pcl::ModelCoefficients> coefficients;
 * std::vector<pcl::PointIndices> inliers;
 * fspf.segment (coefficients, inliers);
 * \endcode
 * \ingroup segmentation */
template <typename PointT>
class FastSamplingPlaneFiltering
: public PlaneDetector<PointT,
                       FastSamplingPlaneFiltering<PointT>,
                       FastSamplingPlaneFilteringParameters> {
  using Base = PlaneDetector<PointT,
                             FastSamplingPlaneFiltering<PointT>,
                             FastSamplingPlaneFilteringParameters>;
  friend Base;

public:
  using Ptr = pcl::shared_ptr<FastSamplingPlaneFiltering<PointT>>;
  using ConstPtr = pcl::shared_ptr<const FastSamplingPlaneFiltering<PointT>>;

  static std::string
  className ()
  {
    return "FastSamplingPlaneFiltering";
  }

  /** \brief r1: radius of the sphere a hypothesis' three points are from [m]. */
  void
  setInnerRadius (double radius)
  {
    parameters_.local.inner_radius = radius;
  }
  double
  getInnerRadius () const
  {
    return parameters_.local.inner_radius;
  }

  /** \brief r2: radius of the sphere a hypothesis is tested in, r1 or more [m]. */
  void
  setOuterRadius (double radius)
  {
    parameters_.local.outer_radius = radius;
  }
  double
  getOuterRadius () const
  {
    return parameters_.local.outer_radius;
  }

  /** \brief N_loc: points each hypothesis is tested on, 3 or more. */
  void
  setLocalSamples (unsigned samples)
  {
    parameters_.local.local_samples = samples;
  }
  unsigned
  getLocalSamples () const
  {
    return parameters_.local.local_samples;
  }

  /** \brief alpha_min: a hypothesis needs more than this share of inliers, 0 to 1. */
  void
  setMinInlierFraction (double fraction)
  {
    parameters_.local.min_inlier_fraction = fraction;
  }
  double
  getMinInlierFraction () const
  {
    return parameters_.local.min_inlier_fraction;
  }

  /** \brief Which points of an accepted sphere are the inliers of its plane. */
  void
  setLocalInliers (LocalInliers inliers)
  {
    parameters_.local.inliers = inliers;
  }
  LocalInliers
  getLocalInliers () const
  {
    return parameters_.local.inliers;
  }

  /** \brief N_max: sampling ends at this multiple of the number of points. */
  void
  setMaxInliersPerPoint (double inliers)
  {
    parameters_.local.max_inliers_per_point = inliers;
  }
  double
  getMaxInliersPerPoint () const
  {
    return parameters_.local.max_inliers_per_point;
  }

  /** \brief K_max: hypotheses looked at, as a multiple of the number of points. */
  void
  setMaxHypothesesPerPoint (double hypotheses)
  {
    parameters_.local.max_hypotheses_per_point = hypotheses;
  }
  double
  getMaxHypothesesPerPoint () const
  {
    return parameters_.local.max_hypotheses_per_point;
  }

private:
  using Base::durations_;
  using Base::indices_;
  using Base::input_;
  using Base::parameters_;
  using Base::search_;

  LocalPlanes
  samplePlanes (const Points& points);

  Detection
  detect ();
};

} // namespace pcl_ops

#ifdef PCL_NO_PRECOMPILE
#include <pcl_ops/impl/fast_sampling_plane_filtering.hpp>
#endif
