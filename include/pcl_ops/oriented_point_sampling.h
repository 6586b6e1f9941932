// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/cell_planes.h>
#include <pcl_ops/oriented_samples.h>
#include <pcl_ops/plane_detector.h>
#include <pcl_ops/plane_extraction.h>

#include <string>
#include <vector>

namespace pcl_ops {

/** \brief What an oriented sample is. */
enum class Sampling {
  /** \brief A point drawn at random; its normal comes from its k nearest neighbours
   * (the paper). */
  Points,
  /** \brief An occupied cell of a grid; its normal comes from the moments of the cells
   * around it, its plane knows where it ends. */
  Cells
};

/** \brief When planes are divided by orientation (paper, "Detecting planes in multiple
 * orientations"). */
enum class Strategy {
  /** \brief Strategy 1: planes are found among all samples and then divided. */
  DetectThenDivide = 1,
  /** \brief Strategy 2: samples are divided by their normals, planes found per group.
   */
  DivideThenDetect = 2
};

/** \brief What hypotheses of one-point RANSAC are counted on. */
enum class Verification {
  /** \brief The oriented samples (the paper's Algorithm 1, and its times). */
  Samples,
  /** \brief All points no plane has taken yet (the paper's text). */
  AllPoints
};

/** \brief The stages of Sampling::Cells. */
struct CellParameters {
  /** \brief Edge of a cell [m]; 0: from the number of points and the surface they are
   * spread over. */
  double size = 0.0;
  CellNormalParameters normals;
  CellInlierParameters inlier;
  /** \brief Planes are looked for among cells up to this thickness first, and among all
   * up to inlier.largest_thickness where these left room. */
  double sure_thickness = 0.2;
  GrowingParameters growing;
  /** \brief See absorbPlanes. */
  double absorption_noise_factor = 1.8;
  /** \brief See separateSurfaces; off: surfaces in one plane are one. */
  bool separates_surfaces = true;
  BoundedAssignmentParameters assignment;
};

/** \brief Parameters of OrientedPointSampling; the defaults are the recommended ones.
 */
struct OrientedPointSamplingParameters : PlaneDetectorParameters {
  /** \brief theta_h is 0: what is near enough to a plane follows the measured noise, up
   * to two cells. A length instead is the largest distance of a point to its plane.
   * Whether two planes are one follows their noise, too: real walls are not flat. */
  OrientedPointSamplingParameters()
  {
    constexpr double merging_noise_factor = 2.25;
    distance_threshold = 0.0;
    merging.noise_factor = merging_noise_factor;
  }

  Sampling sampling = Sampling::Cells;
  /** \brief alpha_s: share of the points that get a normal, above 0 and up to 1. */
  double sampling_rate = 0.03;
  /** \brief k and sigma of the normals. */
  NormalParameters normals;
  /** \brief Normals, support and growth of planes on the cells of a grid. */
  CellParameters cells;
  /** \brief theta_N: a plane needs more inliers than this among the samples, and three
   * in any case. */
  unsigned min_inliers = 20;
  /** \brief p: probability that RANSAC draws an inlier of the largest plane. */
  double probability = 0.99;
  Strategy strategy = Strategy::DetectThenDivide;
  Verification verification = Verification::Samples;
  /** \brief Which plane gets a point that several could have, with Sampling::Points.
   * The first, as found, is what "remove all its inliers from the point cloud" means.
   */
  AssignmentRule assignment_rule = AssignmentRule::First;
  /** \brief Refit and select again while the support of a plane grows. */
  bool local_optimisation = true;

  /** \brief The algorithm of the paper with its best row (Table III): 3 %, 30
   * neighbours, 0.05 m, 20 samples, p 0.99, 7 degrees, strategy 2. */
  static OrientedPointSamplingParameters
  paper ();
};

/** \brief What is wrong with a set of parameters, as a sentence; empty if nothing is.
 */
std::string
problemOf (const OrientedPointSamplingParameters& parameters);

/** \brief RANSAC parameters of the planes' extraction. */
RansacParameters
ransacParameters (const OrientedPointSamplingParameters& parameters);

/** \brief All planes of the samples: extraction per group of orientations.
 * \param[in] samples oriented samples
 * \param[in] points all points, for Verification::AllPoints
 * \param[in] parameters those of the detector
 * \return planes in the order found */
std::vector<Plane>
extractPlanes (const OrientedSamples& samples,
               const Points& points,
               const OrientedPointSamplingParameters& parameters);

/** \brief Detection with Sampling::Cells.
 * \param[in] points the finite points
 * \param[in] viewpoint of the sensor in the frame of the input cloud
 * \param[in] parameters those of the detector
 * \param[in,out] durations the time of each stage is added */
Detection
detectOnCells (Points points,
               const Eigen::Vector3d& viewpoint,
               const OrientedPointSamplingParameters& parameters,
               StageDurations& durations);

/** \brief OPS: finds all planes of an unorganized point cloud from the normals of a few
 * per cent of its points, by one-point RANSAC.
 *
 * Sun & Mordohai, "Oriented Point Sampling for Plane Detection in Unorganized Point
 * Clouds", ICRA 2019.
 *
 * \code
 * pcl_ops::OrientedPointSampling<pcl::PointXYZ> ops;
 * ops.setInputCloud (cloud);
 * std::vector<pcl::ModelCoefficients> coefficients;
 * std::vector<pcl::PointIndices> inliers;
 * ops.segment (coefficients, inliers);
 * \endcode
 * \ingroup segmentation */
template <typename PointT>
class OrientedPointSampling : public PlaneDetector<PointT,
                                                   OrientedPointSampling<PointT>,
                                                   OrientedPointSamplingParameters> {
  using Base = PlaneDetector<PointT,
                             OrientedPointSampling<PointT>,
                             OrientedPointSamplingParameters>;
  friend Base;

public:
  using Ptr = pcl::shared_ptr<OrientedPointSampling<PointT>>;
  using ConstPtr = pcl::shared_ptr<const OrientedPointSampling<PointT>>;

  static std::string
  className ()
  {
    return "OrientedPointSampling";
  }

  /** \brief alpha_s: share of the points that get a normal, above 0 and up to 1. */
  void
  setSamplingRate (double rate)
  {
    parameters_.sampling_rate = rate;
  }
  double
  getSamplingRate () const
  {
    return parameters_.sampling_rate;
  }

  /** \brief k: neighbours of each sample its normal comes from, 2 or more; the normal
   * of a cell comes from at least as many points. */
  void
  setKSearch (int k)
  {
    parameters_.normals.k = k;
  }
  int
  getKSearch () const
  {
    return parameters_.normals.k;
  }

  /** \brief sigma of the weight of a neighbour [m]; 0: the neighbourhood's radius. */
  void
  setNormalSigma (double sigma)
  {
    parameters_.normals.sigma = sigma;
  }
  double
  getNormalSigma () const
  {
    return parameters_.normals.sigma;
  }

  /** \brief theta_N: a plane needs more inliers than this among the samples. */
  void
  setMinInliers (unsigned min_inliers)
  {
    parameters_.min_inliers = min_inliers;
  }
  unsigned
  getMinInliers () const
  {
    return parameters_.min_inliers;
  }

  /** \brief p: probability that RANSAC draws an inlier of the largest plane, in (0, 1).
   */
  void
  setProbability (double probability)
  {
    parameters_.probability = probability;
  }
  double
  getProbability () const
  {
    return parameters_.probability;
  }

  /** \brief Strategy 1 or 2 of the paper. */
  void
  setStrategy (Strategy strategy)
  {
    parameters_.strategy = strategy;
  }
  Strategy
  getStrategy () const
  {
    return parameters_.strategy;
  }

  /** \brief What hypotheses are counted on. */
  void
  setVerification (Verification verification)
  {
    parameters_.verification = verification;
  }
  Verification
  getVerification () const
  {
    return parameters_.verification;
  }

  /** \brief Refit and select again while the support of a plane grows. */
  void
  setLocalOptimisation (bool local_optimisation)
  {
    parameters_.local_optimisation = local_optimisation;
  }
  bool
  getLocalOptimisation () const
  {
    return parameters_.local_optimisation;
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
#include <pcl_ops/impl/oriented_point_sampling.hpp>
#endif
