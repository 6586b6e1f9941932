// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_detector.h>

#include <cstddef>
#include <string>

namespace pcl_ops {

/** \brief Parameters of KernelHoughTransform; the defaults are recommended. */
struct PCL_OPS_EXPORT KernelHoughTransformParameters : PlaneDetectorParameters {
  /** \brief Name of the detector's class, for error messages. */
  static constexpr const char* class_name = "KernelHoughTransform";

  /** \brief Tests whether the points of an octree node are a cluster of approximately
   * coplanar points (Limberger & Oliveira 2015, section 3.1). The eigenvalues of their
   * covariance are l1 <= l2 <= l3. */
  struct Clusters {
    /** \brief Nodes with fewer points are not used. */
    std::size_t min_samples = 30;
    /** \brief s_level: the first level whose nodes are tested; the root is level 0. As
     * published; KernelHoughTransformParameters sets 3. */
    int first_level = 5;
    /** \brief s_alpha: the thickness l1 / l2 of coplanar nodes is below 1 / s_alpha. As
     * published; KernelHoughTransformParameters sets 15. */
    double s_alpha = 25.0;
    /** \brief s_beta: the elongation l2 / l3 of coplanar nodes is above 1 / s_beta. */
    double s_beta = 6.0;
    /** \brief The deepest level, up to 60. Nodes of this level are not split, which
     * ends the recursion for many equal points. */
    int max_level = 20;
  };

  /** \brief How planes are refitted, away from the centers of accumulator bins. */
  struct Refit {
    /** \brief False: planes stay at the centers of their bins and are unbounded. Each
     * point goes to the first plane within theta_h. */
    bool enabled = true;
    /** \brief Planes are dropped if their clusters hold a smaller share of all points.
     */
    double min_share = 0.001;
  };

  /** \brief phi_num: steps of the accumulator from pole to pole, 2 .. 1000. */
  int phi_num = 30;
  /** \brief rho_num: steps of the accumulator from its center to the farthest point,
   * 2 .. 10000. */
  int rho_num = 300;
  /** \brief The smallest number of samples, s_level, s_alpha and s_beta. The defaults
   * are s_level 3 and s_alpha 15 here: the published 5 and 25 lose the surfaces of
   * noisy clouds. */
  Clusters clusters;
  /** \brief Refits the planes to the points of their clusters. A refitted plane is
   * bounded: it covers the voxels of its clusters and grows from there over occupied
   * voxels. */
  Refit refit;

  KernelHoughTransformParameters();

  /** \brief The algorithm as published, with the best parameters of the OPS paper's
   * Table II: 80 / 800 bins, clusters of 30 points or more from level 5 on; each point
   * goes to the first plane within theta_h, and no planes are merged or refitted. */
  static KernelHoughTransformParameters
  paper ();
};

/** \brief Returns the first problem of the parameters; empty if they are valid. */
PCL_OPS_EXPORT std::string
validate (const KernelHoughTransformParameters& parameters);

namespace detail {

/** \brief Detects planes; the parameters must be valid, which is not checked. */
PCL_OPS_EXPORT Detection
detect (const DetectorInput& input, const KernelHoughTransformParameters& parameters);

} // namespace detail

/** \brief 3D-KHT: finds planes by a Hough transform in which octree nodes vote.
 *
 * Limberger & Oliveira, "Real-time detection of planar regions in unorganized point
 * clouds", Pattern Recognition 48(6), 2015.
 *
 * The preset \c paper () is the method as published: normals are quantized to the bins
 * of the accumulator, planes are unbounded, and a point goes to the first plane in the
 * list. The defaults fit planes to their clusters, bound and merge them. \c
 * setSearchMethod and \c setSeed have no effect.
 *
 * PlaneDetector has its member functions. Set its own parameters by \c setParameters.
 * \ingroup segmentation */
template <typename PointT>
class KernelHoughTransform
: public PlaneDetector<PointT, KernelHoughTransformParameters> {
public:
  using Ptr = pcl::shared_ptr<KernelHoughTransform<PointT>>;
  using ConstPtr = pcl::shared_ptr<const KernelHoughTransform<PointT>>;
};

} // namespace pcl_ops
