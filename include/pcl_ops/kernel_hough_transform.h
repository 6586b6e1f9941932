// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cell_planes.h>
#include <pcl_ops/hough_planes.h>
#include <pcl_ops/octree_clusters.h>
#include <pcl_ops/plane_detector.h>

#include <string>
#include <vector>

namespace pcl_ops {

/** \brief Parameters of KernelHoughTransform; the defaults are the recommended ones. */
struct KernelHoughTransformParameters : PlaneDetectorParameters {
  /** \brief Steps of the accumulator from pole to pole. */
  int phi_num = 30;
  /** \brief Steps of the accumulator from its centre to the farthest point. */
  int rho_num = 300;
  /** \brief Minimum samples, s_level, s_alpha and s_beta. The published s_level 5 and
   * s_alpha 25 lose the surfaces of noisy clouds: 3 and 15 are the defaults here. */
  OctreeClusterParameters clusters;
  /** \brief Fits the planes to the points of their clusters. */
  PlaneRefitParameters refit;
  /** \brief Planes end where their clusters end, as far as they grow from there over
   * the occupied cells of a grid. Off, or where planes are not refitted: planes are
   * endless. */
  bool bounded = true;
  /** \brief Which of the endless planes within theta_h gets a point. */
  AssignmentRule assignment = AssignmentRule::Nearest;

  KernelHoughTransformParameters();

  /** \brief The algorithm as published, with the best row of the OPS paper's Table II:
   * 80 / 800 bins, clusters of 30 points or more from level 5 on; each point goes to
   * the first plane within theta_h, and no planes are merged or refitted. */
  static KernelHoughTransformParameters
  paper ();
};

/** \brief What is wrong with a set of parameters, as a sentence; empty if nothing is.
 */
std::string
problemOf (const KernelHoughTransformParameters& parameters);

/** \brief The planes of the clusters: \ref voteForPlanes, and \ref refitPlanes where
 * the parameters ask for it. */
std::vector<HoughPlane>
houghPlanes (const OctreeClusters& found,
             const KernelHoughTransformParameters& parameters);

/** \brief Assignment and merging of planes without bounds: \ref assignPoints, block by
 * block of the octree, where most planes are far away, and \ref mergePlanes.
 * \param[in] points the points
 * \param[in] found their clusters
 * \param[in] planes planes in the frame of the points
 * \param[in] parameters thresholds, the rule and the number of threads
 * \param[in,out] durations of assignment and merging */
Detection
assignToEndlessPlanes (Points points,
                       const OctreeClusters& found,
                       const std::vector<HoughPlane>& planes,
                       const KernelHoughTransformParameters& parameters,
                       StageDurations& durations);

/** \brief The same with planes that support what their clusters cover and what they
 * grow into: merging first, on the cells of a grid, and then \ref assignToBoundedPlanes
 * of cells. */
Detection
assignToOutlinedPlanes (Points points,
                        const OctreeClusters& found,
                        const std::vector<HoughPlane>& planes,
                        const KernelHoughTransformParameters& parameters,
                        StageDurations& durations);

/** \brief Replaces each least squares plane by the plane its points were assigned to,
 * with the centroid moved onto it: the first one's where planes were merged. */
void
restorePlanes (MergedPlanes& merged, const std::vector<Plane>& planes);

/** \brief 3D-KHT: finds planes by a Hough transform that nodes of an octree vote in.
 *
 * Limberger & Oliveira, "Real-time detection of planar regions in unorganized point
 * clouds", Pattern Recognition 48(6), 2015.
 *
 * The preset \c paper () has the method's known weak points: normals quantised to the
 * accumulator's bins, no fit to the points, planes without end, and a point's plane
 * decided by the planes' order. The defaults fit the planes to their clusters, end them
 * where the clusters do and merge planes as all detectors of this library do.
 *
 * It needs no neighbour search and draws no random numbers: \c setSearchMethod and
 * \c setSeed change nothing.
 *
 * \code
 * pcl_ops::KernelHoughTransform<pcl::PointXYZ> kht;
 * kht.setInputCloud (cloud);
 * std::vector<pcl::ModelCoefficients> coefficients;
 * std::vector<pcl::PointIndices> inliers;
 * kht.segment (coefficients, inliers);
 * \endcode
 * \ingroup segmentation */
template <typename PointT>
class KernelHoughTransform : public PlaneDetector<PointT,
                                                  KernelHoughTransform<PointT>,
                                                  KernelHoughTransformParameters> {
  using Base = PlaneDetector<PointT,
                             KernelHoughTransform<PointT>,
                             KernelHoughTransformParameters>;
  friend Base;

public:
  using Ptr = pcl::shared_ptr<KernelHoughTransform<PointT>>;
  using ConstPtr = pcl::shared_ptr<const KernelHoughTransform<PointT>>;

  static std::string
  className ()
  {
    return "KernelHoughTransform";
  }

  /** \brief phi_num: steps of the accumulator from pole to pole, 2 .. 1000. */
  void
  setPhiNum (int phi_num)
  {
    parameters_.phi_num = phi_num;
  }
  int
  getPhiNum () const
  {
    return parameters_.phi_num;
  }

  /** \brief rho_num: steps of the accumulator from its centre outwards, 2 .. 10000. */
  void
  setRhoNum (int rho_num)
  {
    parameters_.rho_num = rho_num;
  }
  int
  getRhoNum () const
  {
    return parameters_.rho_num;
  }

  /** \brief Minimum samples, s_level, s_alpha and s_beta of the clusters. */
  void
  setClusterParameters (const OctreeClusterParameters& clusters)
  {
    parameters_.clusters = clusters;
  }
  const OctreeClusterParameters&
  getClusterParameters () const
  {
    return parameters_.clusters;
  }

  /** \brief Whether and how planes are fitted to their clusters. */
  void
  setRefitParameters (const PlaneRefitParameters& refit)
  {
    parameters_.refit = refit;
  }
  const PlaneRefitParameters&
  getRefitParameters () const
  {
    return parameters_.refit;
  }

  /** \brief Whether planes end where their clusters end. */
  void
  setBounded (bool bounded)
  {
    parameters_.bounded = bounded;
  }
  bool
  getBounded () const
  {
    return parameters_.bounded;
  }

  /** \brief Which of the endless planes within theta_h gets a point. */
  void
  setAssignmentRule (AssignmentRule rule)
  {
    parameters_.assignment = rule;
  }
  AssignmentRule
  getAssignmentRule () const
  {
    return parameters_.assignment;
  }

private:
  using Base::durations_;
  using Base::indices_;
  using Base::input_;
  using Base::parameters_;

  Detection
  detect ();
};

} // namespace pcl_ops

#ifdef PCL_NO_PRECOMPILE
#include <pcl_ops/impl/kernel_hough_transform.hpp>
#endif
