// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/plane_detector.h>

#include <cstddef>
#include <string>

namespace pcl_ops {

/** \brief Parameters of KernelHoughTransform; the defaults are the recommended ones. */
struct PCL_OPS_EXPORT KernelHoughTransformParameters : PlaneDetectorParameters {
  /** \brief Of the class, for messages. */
  static constexpr const char* class_name = "KernelHoughTransform";

  /** \brief What makes an octree node a cluster of approximately coplanar points
   * (Limberger & Oliveira 2015, section 3.1). */
  struct Clusters {
    /** \brief Nodes with fewer points are not used. */
    std::size_t min_samples = 30;
    /** \brief s_level: the first level whose nodes are tested; the root is level 0. */
    int first_level = 5;
    /** \brief s_alpha: the thickness l1 / l2 of coplanar nodes is below 1 / s_alpha. */
    double s_alpha = 25.0;
    /** \brief s_beta: the elongation l2 / l3 of coplanar nodes is above 1 / s_beta. */
    double s_beta = 6.0;
    /** \brief Nodes of this level, up to 60, are not split: many equal points end. */
    int max_level = 20;
  };

  /** \brief How planes are freed from the accumulator's bins. */
  struct Refit {
    /** \brief Off: planes stay at their bins' centers and have no end: each point goes
     * to the first one within theta_h. */
    bool enabled = true;
    /** \brief Smallest share of all points that the clusters of a plane hold. */
    double min_share = 0.001;
  };

  /** \brief phi_num: steps of the accumulator from pole to pole, 2 .. 1000. */
  int phi_num = 30;
  /** \brief rho_num: steps of the accumulator from its center to the farthest point,
   * 2 .. 10000. */
  int rho_num = 300;
  /** \brief Minimum samples, s_level, s_alpha and s_beta. The published s_level 5 and
   * s_alpha 25 lose the surfaces of noisy clouds: 3 and 15 are the defaults here. */
  Clusters clusters;
  /** \brief Fits the planes to the points of their clusters; they end where their
   * clusters end, as far as they grow from there over the occupied voxels of a grid. */
  Refit refit;

  KernelHoughTransformParameters();

  /** \brief The algorithm as published, with the best row of the OPS paper's Table II:
   * 80 / 800 bins, clusters of 30 points or more from level 5 on; each point goes to
   * the first plane within theta_h, and no planes are merged or refitted. */
  static KernelHoughTransformParameters
  paper ();
};

/** \brief What is wrong with parameters, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const KernelHoughTransformParameters& parameters);

namespace detail {

/** \brief The work behind the class; validate has found nothing wrong. */
PCL_OPS_EXPORT Detection
detect (const DetectorInput& input, const KernelHoughTransformParameters& parameters);

} // namespace detail

/** \brief 3D-KHT: finds planes by a Hough transform that nodes of an octree vote in.
 *
 * Limberger & Oliveira, "Real-time detection of planar regions in unorganized point
 * clouds", Pattern Recognition 48(6), 2015.
 *
 * The preset \c paper () is the method as published: normals quantized to the
 * accumulator's bins, planes without end, and a point's plane decided by their order.
 * The defaults fit planes to their clusters, end them where the clusters do and merge
 * them. \c setSearchMethod and \c setSeed change nothing.
 *
 * Its calls are those that PlaneDetector shares among all detectors; its own parameters
 * are set by \c setParameters.
 * \ingroup segmentation */
template <typename PointT>
class KernelHoughTransform
: public PlaneDetector<PointT, KernelHoughTransformParameters> {
public:
  using Ptr = pcl::shared_ptr<KernelHoughTransform<PointT>>;
  using ConstPtr = pcl::shared_ptr<const KernelHoughTransform<PointT>>;
};

} // namespace pcl_ops
