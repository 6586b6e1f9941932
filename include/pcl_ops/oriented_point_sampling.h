// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/detection_report.h>
#include <pcl_ops/plane_detector.h>

#include <cmath>
#include <optional>
#include <string>

namespace pcl_ops {

/** \brief The kind of oriented samples: points with a normal. */
enum class Sampling {
  /** \brief A point drawn at random; its normal comes from its k nearest neighbors
   * (the paper). */
  Points,
  /** \brief Flat voxels of a grid. The normal of a voxel comes from the moments of the
   * voxels around it. Planes are bounded by their voxels. */
  Surfels,
  /** \brief All points. The normal of a point comes from its largest neighborhood whose
   * scatter the noise of the cloud explains. There is no grid: the planes hardly change
   * if the cloud is translated or rotated. */
  Neighborhoods,
  /** \brief Surfels if \ref OrientedPointSamplingParameters::Surfels::voxel_size is
   * given; otherwise Neighborhoods. */
  Automatic
};

/** \brief Parameters of Sampling::Points, the paper's algorithm. Other samplings ignore
 * them. */
struct PaperParameters {
  /** \brief When planes are divided by orientation (paper, "Detecting planes in
   * multiple orientations"). */
  enum class Strategy {
    /** \brief Strategy 1: planes are found among all samples and then divided. */
    DetectThenDivide = 1,
    /** \brief Strategy 2: samples are divided by their normals into three groups, and
     * planes are found in each group. */
    DivideThenDetect = 2
  };

  /** \brief The points among which inliers of a RANSAC hypothesis are counted. */
  enum class Verification {
    /** \brief The oriented samples (the paper's Algorithm 1, and its times). */
    Samples,
    /** \brief All points that are not yet on a plane (the paper's text). */
    AllPoints
  };

  /** \brief sigma of the Gaussian weight of neighbors in a normal [m]. Not given: the
   * distance to the farthest neighbor. */
  std::optional<double> normal_sigma;
  /** \brief p: probability that RANSAC draws an inlier of the largest plane, above 0
   * and below 1. */
  double probability = 0.99;
  Strategy strategy = Strategy::DetectThenDivide;
  Verification verification = Verification::Samples;
  /** \brief Which plane gets a point within theta_h of several planes. First, the plane
   * found first, is what "remove all its inliers from the point cloud" means. */
  AssignmentRule assignment_rule = AssignmentRule::First;
  /** \brief Whether a plane is refitted to its inliers repeatedly, while their number
   * grows; otherwise it is refitted once. */
  bool local_optimization = true;
};

/** \brief Parameters of OrientedPointSampling; the defaults are recommended. */
struct PCL_OPS_EXPORT OrientedPointSamplingParameters : PlaneDetectorParameters {
  /** \brief Name of the detector's class, for error messages. */
  static constexpr const char* class_name = "OrientedPointSampling";

  /** \brief Expert parameters of Sampling::Surfels. */
  struct Surfels {
    /** \brief Edge of a voxel [m]. Points that no plane explains are searched again in
     * voxels of half the edge. If it is given, voxels begin at whole multiples of it
     * from the cloud's zero: tiles of a cloud have the same voxels as the whole cloud.
     * Not given: it follows from the number of points and the area of the surfaces. It
     * also follows from the noise if voxels have many points or the density of the
     * cloud varies much. */
    std::optional<double> voxel_size;
    /** \brief Number of grids, 1 to 10, from which the neighborhood of a normal is
     * chosen. Each grid has twice the voxel size of the one before. */
    int resolutions = 3;
    /** \brief Smallest number of points of a normal's neighborhood, in units of the
     * average number of points in a voxel. So neighborhoods are larger where points are
     * sparse: far from a camera, where points are also noisy. */
    double min_average_voxels = 6.0;
    /** \brief Largest rms distance of a surfel's points to its plane, in units of the
     * noise around the surfel. */
    double noise_factor = 2.0;
    /** \brief Largest angle between the normals of a surfel and its plane [rad]; by
     * default 30 degrees. */
    double angle_threshold = 30.0 * (M_PI / 180.0);
    /** \brief Largest thickness of surfels that may be on a plane: noise over the
     * spread in the narrow direction of the surfel, 0 for an exact plane, 1 for a ball.
     */
    double sure_thickness = 0.24;
    /** \brief The same for voxels of half the edge, which are searched last. */
    double max_thickness = 0.3;
    /** \brief A plane is merged into a larger adjacent plane if the rms distance of its
     * points to that plane is below this, in units of the larger plane's noise or rms,
     * whichever is larger, but at most 6 times that of the smaller plane. */
    double absorption_noise_factor = 3.5;
    /** \brief Largest distance of a point to a plane, in units of the plane's noise. */
    double assignment_noise_factor = 5.0;
  };

  /** \brief Leaves theta_h unset: distances of points to planes follow the noise. */
  OrientedPointSamplingParameters() { distance_threshold.reset(); }

  Sampling sampling = Sampling::Automatic;
  /** \brief alpha_s: share of the points that get a normal, above 0 and up to 1. With
   * Sampling::Surfels it decides the number of voxels if their size is not given. With
   * Sampling::Neighborhoods all points get a normal, and a larger rate makes the
   * neighborhoods smaller: 16 times the rate halves the number of neighbors. */
  double sampling_rate = 0.03;
  /** \brief k: number of neighbors from which the normal of a sample is computed, 2 or
   * more. With Sampling::Neighborhoods the smallest neighborhoods have k / 3 to 1.2 k
   * points at the default rate (10 to 36 for k = 30), and 6 to 128 at any rate. With
   * Sampling::Surfels a normal comes from at least k / 2 points. */
  int k = 30;
  /** \brief theta_N: with Sampling::Points a plane needs more sample inliers than this,
   * and at least three. With Sampling::Surfels a plane needs at least this many voxels.
   * With Sampling::Neighborhoods 20 stands for 6 independent points. It counts samples;
   * \ref PlaneDetectorParameters::min_points counts points. */
  unsigned min_samples = 20;
  PaperParameters paper_only;
  Surfels surfels;
  /** \brief If the cloud is a part of a larger one: the result of \ref measureNoise for
   * the whole cloud. Only Sampling::Neighborhoods uses it. Not given: the cloud is no
   * part. */
  std::optional<CloudNoise> noise_of_whole;
  /** \brief Called with the result of each stage, for example to draw it. Empty: no
   * results are computed or copied. Only Sampling::Neighborhoods calls it. The time of
   * a call is added to the duration of the stage, except for Stage::Labels. The planes
   * do not depend on it. */
  StageObserver on_stage;

  /** \brief The algorithm of the paper with its best parameters (Table III): 3 %, 30
   * neighbors, 0.05 m, 20 samples, p 0.99, 7 degrees, strategy 2. */
  static OrientedPointSamplingParameters
  paper ();
};

/** \brief Returns the first problem of the parameters; empty if they are valid. */
PCL_OPS_EXPORT std::string
validate (const OrientedPointSamplingParameters& parameters);

/** \brief Measures the noise of a cloud as Sampling::Neighborhoods does, for \ref
 * OrientedPointSamplingParameters::noise_of_whole.
 * \param[in] cloud the whole cloud, or all points of some of its parts; non-finite
 * points are skipped
 * \param[in] parameters those of the later searches of the parts
 * \param[in] points_of_whole number of points of the whole cloud, if \p cloud has
 * fewer; the share that is skipped in \p cloud is skipped in the whole cloud, too
 * \return the noise; CloudNoise::points is 0 if the cloud has too few points
 * \throw std::invalid_argument if the parameters are wrong */
PCL_OPS_EXPORT CloudNoise
measureNoise (const CloudView& cloud,
              const OrientedPointSamplingParameters& parameters,
              std::size_t points_of_whole = 0);

namespace detail {

/** \brief Detects planes; the parameters must be valid, which is not checked. */
PCL_OPS_EXPORT Detection
detect (const DetectorInput& input, const OrientedPointSamplingParameters& parameters);

} // namespace detail

/** \brief OPS: finds all planes of an unorganized point cloud. By default it computes
 * the normals of all points and grows regions within limits that follow the noise. With
 * Sampling::Points, the paper's algorithm, a few per cent of the points get normals. A
 * point with a normal is a RANSAC hypothesis by itself.
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
class OrientedPointSampling
: public PlaneDetector<PointT, OrientedPointSamplingParameters> {
public:
  using Ptr = pcl::shared_ptr<OrientedPointSampling<PointT>>;
  using ConstPtr = pcl::shared_ptr<const OrientedPointSampling<PointT>>;

  /** \brief alpha_s: share of the points that get a normal, above 0 and up to 1. */
  void
  setSamplingRate (double rate)
  {
    this->parameters_.sampling_rate = rate;
  }
  double
  getSamplingRate () const
  {
    return this->parameters_.sampling_rate;
  }

  /** \brief k: number of neighbors from which the normal of a sample is computed, 2 or
   * more (\ref OrientedPointSamplingParameters::k). */
  void
  setKSearch (int k)
  {
    this->parameters_.k = k;
  }
  int
  getKSearch () const
  {
    return this->parameters_.k;
  }

  /** \brief theta_N: a plane needs more sample inliers than this (\ref
   * OrientedPointSamplingParameters::min_samples). setMinPoints() counts points. */
  void
  setMinSamples (unsigned min_samples)
  {
    this->parameters_.min_samples = min_samples;
  }
  unsigned
  getMinSamples () const
  {
    return this->parameters_.min_samples;
  }

  /** \deprecated Calls setMinSamples(). The number counts samples, while inliers of
   * other PCL classes are points. */
  void
  setMinInliers (unsigned min_samples)
  {
    setMinSamples (min_samples);
  }
  /** \deprecated Call getMinSamples(). */
  unsigned
  getMinInliers () const
  {
    return getMinSamples();
  }

  /** \brief p: probability that RANSAC draws an inlier of the largest plane, above 0
   * and below 1. Only Sampling::Points uses it. */
  void
  setProbability (double probability)
  {
    this->parameters_.paper_only.probability = probability;
  }
  double
  getProbability () const
  {
    return this->parameters_.paper_only.probability;
  }
};

} // namespace pcl_ops
