// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_detector.h>

#include <string>

namespace pcl_ops {

/** \brief Parameters of FastSamplingPlaneFiltering; the defaults are the recommended
 * ones: the paper's, with the radii it finds the most accurate (Table I). */
struct PCL_OPS_EXPORT FastSamplingPlaneFilteringParameters : PlaneDetectorParameters {
  /** \brief Of the class, for messages. */
  static constexpr const char* class_name = "FastSamplingPlaneFiltering";

  /** \brief How planes are sampled in spheres (paper section III-B, Algorithm 2). */
  struct Local {
    /** \brief The inliers of a sphere's plane: the paper says both. */
    enum class Inliers {
      /** \brief All points of the sphere within theta_h of it (its text). */
      Sphere,
      /** \brief Those of the N_loc tested points that are (its Algorithm 2). */
      Samples
    };

    /** \brief r1: p_r1 and p_r2 are drawn from the points this near to p_r0 [m]. */
    double inner_radius = 0.1;
    /** \brief r2: a hypothesis is tested on the points this near to p_r0 [m]. */
    double outer_radius = 0.2;
    /** \brief N_loc: how many of these it is tested on, drawn with repetition;
     * spheres with fewer points have no plane. */
    unsigned local_samples = 80;
    /** \brief alpha_min: it needs more than this share of inliers among them. */
    double min_inlier_fraction = 0.8;
    /** \brief Which points of an accepted sphere count, for its plane and for N_max. */
    Inliers inliers = Inliers::Sphere;
    /** \brief N_max, as a multiple of the number of points: sampling ends at so many
     * inliers, a point counted as often as it is one. */
    double max_inliers_per_point = 2.0;
    /** \brief K_max: hypotheses sampling ends after, as a multiple of the points. */
    double max_hypotheses_per_point = 1.0;
    /** \brief Points looked at in all spheres, and 100 for each, as a multiple of the
     * number of points, before sampling gives up: in dense noise, among equal points,
     * or with radii far from right K_max would take hours. Not in the paper; clouds of
     * rooms come to some 10, with Inliers::Samples to 100. */
    double max_visits_per_point = 100.0;
  };

  /** \brief r1, r2, N_loc, alpha_min, N_max and K_max. */
  Local local;

  /** \brief The algorithm of the paper with the row of its Table IV: r1 0.07 m, r2
   * 0.14 m, 80 local samples, four fifths of them inliers, 0.05 m. */
  static FastSamplingPlaneFilteringParameters
  paper ();
};

/** \brief What is wrong with parameters, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const FastSamplingPlaneFilteringParameters& parameters);

namespace detail {

/** \brief The work behind the class; validate has found nothing wrong. */
PCL_OPS_EXPORT Detection
detect (const DetectorInput& input,
        const FastSamplingPlaneFilteringParameters& parameters);

} // namespace detail

/** \brief FSPF: finds planes by testing, all over a point cloud, whether the points in
 * a small sphere lie on the plane through three of them.
 *
 * Sun & Mordohai, "Oriented Point Sampling for Plane Detection in Unorganized Point
 * Clouds", ICRA 2019, section III-B: the method of Biswas & Veloso, "Planar polygon
 * extraction and merging from depth images", IROS 2012, in spheres instead of image
 * windows.
 *
 * Its planes, hundreds of small ones, are merged before points are assigned to them:
 * each point goes to the largest merged plane within theta_h.
 *
 * Without \c setSearchMethod spheres are found in a grid of voxels, several times
 * faster than by a kd-tree, and in another order: other points are drawn from them.
 *
 * Its calls are those that PlaneDetector shares among all detectors; its own parameters
 * are set by \c setParameters.
 * \ingroup segmentation */
template <typename PointT>
class FastSamplingPlaneFiltering
: public PlaneDetector<PointT, FastSamplingPlaneFilteringParameters> {
public:
  using Ptr = pcl::shared_ptr<FastSamplingPlaneFiltering<PointT>>;
  using ConstPtr = pcl::shared_ptr<const FastSamplingPlaneFiltering<PointT>>;
};

} // namespace pcl_ops
