// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_detector.h>

#include <string>

namespace pcl_ops {

/** \brief Parameters of FastSamplingPlaneFiltering. The defaults are recommended: they
 * are the paper's, with the most accurate radii of its Table I. */
struct PCL_OPS_EXPORT FastSamplingPlaneFilteringParameters : PlaneDetectorParameters {
  /** \brief Name of the detector's class, for error messages. */
  static constexpr const char* class_name = "FastSamplingPlaneFiltering";

  /** \brief How planes are sampled in spheres (paper section III-B, Algorithm 2). */
  struct Local {
    /** \brief Which points are inliers of a sphere's plane: the paper says both. */
    enum class Inliers {
      /** \brief All points of the sphere within theta_h of the plane (its text). */
      Sphere,
      /** \brief Only the N_loc tested points within theta_h (its Algorithm 2). */
      Samples
    };

    /** \brief r1: p_r1 and p_r2 are drawn within this distance of p_r0 [m]. */
    double inner_radius = 0.1;
    /** \brief r2: a hypothesis is tested on points within this radius of p_r0 [m]: the
     * sphere. */
    double outer_radius = 0.2;
    /** \brief N_loc: number of test points, drawn from the sphere with replacement.
     * Spheres with fewer points give no plane. */
    unsigned local_samples = 80;
    /** \brief alpha_min: a hypothesis is accepted if more than this share of the test
     * points are inliers. */
    double min_inlier_fraction = 0.8;
    /** \brief Which inliers of an accepted hypothesis count, for plane and N_max. */
    Inliers inliers = Inliers::Sphere;
    /** \brief N_max, as a multiple of the number of points: sampling ends at this
     * number of inliers. A point counts once for each plane of which it is an inlier,
     * with Inliers::Samples once for each time it was drawn as a test point. */
    double max_inliers_per_point = 2.0;
    /** \brief K_max, as a multiple of the number of points: sampling ends after this
     * number of spheres, also those that gave no hypothesis. */
    double max_hypotheses_per_point = 1.0;
    /** \brief Limit of visits, as a multiple of the number of points: sampling also
     * ends after more visits. A sphere counts as 100 visits, plus its points, or a
     * third of the points examined to find them if that is more, plus 1000 if its draws
     * give no plane. Not in the paper: with dense noise, equal points or bad radii
     * K_max would take hours. In clouds of rooms there are some 10 visits per point,
     * with Inliers::Samples some 100: this limit may then end sampling before N_max and
     * K_max do. */
    double max_visits_per_point = 100.0;
  };

  /** \brief r1, r2, N_loc, alpha_min, N_max and K_max. */
  Local local;

  /** \brief The algorithm of the paper with the parameters of its Table IV: r1 0.07 m,
   * r2 0.14 m, N_loc 80, alpha_min 0.8, theta_h 0.05 m. */
  static FastSamplingPlaneFilteringParameters
  paper ();
};

/** \brief Returns the first problem of the parameters; empty if they are valid. */
PCL_OPS_EXPORT std::string
validate (const FastSamplingPlaneFilteringParameters& parameters);

namespace detail {

/** \brief Detects planes; the parameters must be valid, which is not checked. */
PCL_OPS_EXPORT Detection
detect (const DetectorInput& input,
        const FastSamplingPlaneFilteringParameters& parameters);

} // namespace detail

/** \brief FSPF: finds planes in small spheres all over a point cloud. It tests whether
 * the points of a sphere lie on the plane through three of them.
 *
 * Sun & Mordohai, "Oriented Point Sampling for Plane Detection in Unorganized Point
 * Clouds", ICRA 2019, section III-B: the method of Biswas & Veloso, "Planar polygon
 * extraction and merging from depth images", IROS 2012, in spheres instead of image
 * windows.
 *
 * Hundreds of small planes are merged first. Then each point is assigned to the largest
 * merged plane within theta_h. Last the planes are fitted to their points, and merged
 * again if they have become coplanar.
 *
 * Without \c setSearchMethod the points of a sphere are found in a voxel grid, several
 * times faster than in a k-d tree. Their order is different, so that the random draws,
 * and the planes, differ from those with a k-d tree.
 *
 * PlaneDetector has its member functions. Set its own parameters by \c setParameters.
 * \ingroup segmentation */
template <typename PointT>
class FastSamplingPlaneFiltering
: public PlaneDetector<PointT, FastSamplingPlaneFilteringParameters> {
public:
  using Ptr = pcl::shared_ptr<FastSamplingPlaneFiltering<PointT>>;
  using ConstPtr = pcl::shared_ptr<const FastSamplingPlaneFiltering<PointT>>;
};

} // namespace pcl_ops
