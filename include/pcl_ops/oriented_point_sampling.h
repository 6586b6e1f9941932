// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/detection_report.h>
#include <pcl_ops/plane_detector.h>

#include <cmath>
#include <optional>
#include <string>

namespace pcl_ops {

/** \brief What an oriented sample is. */
enum class Sampling {
  /** \brief A point drawn at random; its normal comes from its k nearest neighbors
   * (the paper). */
  Points,
  /** \brief A flat voxel of a grid; its normal comes from the moments of the voxels
   * around it, its plane knows where it ends. */
  Surfels,
  /** \brief Each point with its nearest ones: its normal comes from the largest
   * neighborhood that the noise of the cloud explains. Nothing divides space, so that
   * the planes stay the same where the cloud is moved or turned. */
  Neighborhoods,
  /** \brief Neighborhoods; surfels where
   * \ref OrientedPointSamplingParameters::Surfels::voxel_size is given. */
  Automatic
};

/** \brief Parameters of Sampling::Points, the paper's algorithm; others ignore them. */
struct PaperParameters {
  /** \brief When planes are divided by orientation (paper, "Detecting planes in
   * multiple orientations"). */
  enum class Strategy {
    /** \brief Strategy 1: planes are found among all samples and then divided. */
    DetectThenDivide = 1,
    /** \brief Strategy 2: samples are divided by normals, planes found per group. */
    DivideThenDetect = 2
  };

  /** \brief What hypotheses of one-point RANSAC are counted on. */
  enum class Verification {
    /** \brief The oriented samples (the paper's Algorithm 1, and its times). */
    Samples,
    /** \brief All points no plane has taken yet (the paper's text). */
    AllPoints
  };

  /** \brief sigma of the weight of a neighbor [m]. Not given: the distance to the
   * farthest one. */
  std::optional<double> normal_sigma;
  /** \brief p: probability that RANSAC draws an inlier of the largest plane, above 0
   * and below 1. */
  double probability = 0.99;
  Strategy strategy = Strategy::DetectThenDivide;
  Verification verification = Verification::Samples;
  /** \brief Which plane gets a point that several could have. The first, as found, is
   * what "remove all its inliers from the point cloud" means. */
  AssignmentRule assignment_rule = AssignmentRule::First;
  /** \brief Refit and select again while the support of a plane grows. */
  bool local_optimization = true;
};

/** \brief Parameters of OrientedPointSampling; the defaults are recommended. */
struct PCL_OPS_EXPORT OrientedPointSamplingParameters : PlaneDetectorParameters {
  /** \brief Of the class, for messages. */
  static constexpr const char* class_name = "OrientedPointSampling";

  /** \brief Expert knobs of Sampling::Surfels; Sampling::Neighborhoods has none. */
  struct Surfels {
    /** \brief Edge of a voxel [m]; where no plane explains the points, they are looked
     * at in voxels of half the edge. Voxels then begin at whole multiples of it from
     * the cloud's zero, and tiles of a cloud have the voxels of the whole. Not given:
     * from the number of points, the surface they are spread over, and, where voxels
     * have many points or a cloud is far denser in some places than in others, their
     * noise. */
    std::optional<double> voxel_size;
    /** \brief Grids to choose a normal's neighborhood from, each of twice the voxel
     * size of the one before, 1 to 10. */
    int resolutions = 3;
    /** \brief A normal comes from at least as many points as this many voxels hold on
     * average. Where points are sparse, as they are far from a camera and noisy there,
     * the neighborhoods are larger. */
    double min_average_voxels = 6.0;
    /** \brief Largest rms distance of a surfel's points to its plane in units of the
     * noise around it. */
    double noise_factor = 2.0;
    /** \brief Largest angle between a surfel and its plane [rad]; 30 degrees. */
    double angle_threshold = 30.0 * (M_PI / 180.0);
    /** \brief Largest thickness of the surfels planes are looked for among: noise over
     * the spread in the narrow direction, 0 for an exact plane, 1 for a ball. */
    double sure_thickness = 0.24;
    /** \brief The same of the voxels of half the edge, the last to be looked at. */
    double max_thickness = 0.3;
    /** \brief A plane goes into a larger neighbor if its points are no farther from it
     * than this, in units of the noise of both. */
    double absorption_noise_factor = 3.5;
    /** \brief Largest distance of a point to its plane in units of the noise there. */
    double assignment_noise_factor = 5.0;
  };

  /** \brief theta_h is not given: what is near enough to a plane follows the noise. */
  OrientedPointSamplingParameters() { distance_threshold.reset(); }

  Sampling sampling = Sampling::Automatic;
  /** \brief alpha_s: share of the points that get a normal, above 0 and up to 1. On
   * surfels it decides how many voxels the cloud is divided into. On neighborhoods all
   * points get a normal, from fewer neighbors the larger it is: half of them at 16
   * times the rate. */
  double sampling_rate = 0.03;
  /** \brief k: the neighbors of each sample that its normal comes from, 2 or more. The
   * smallest neighborhoods have k / 3 to 1.2 k points at the default rate, 10 to 36,
   * and 6 to 128 at any; the normal of a voxel comes from at least k / 2. */
  int k = 30;
  /** \brief theta_N: a plane needs more inliers than this among the samples, and three
   * in any case; of surfels at least as many. On neighborhoods 20 stand for 6
   * independent points. It counts samples, not points: a number of points is \ref
   * PlaneDetectorParameters::min_points. */
  unsigned min_samples = 20;
  PaperParameters paper_only;
  Surfels surfels;
  /** \brief Where the cloud is a part of a larger one: what \ref measureNoise says of
   * the whole. Sampling::Neighborhoods alone reads it. Not given: the cloud is a whole.
   */
  std::optional<CloudNoise> noise_of_whole;
  /** \brief Gets what each stage made of the points, to look at it or to draw it.
   * Empty: nothing is computed or copied for it. Only Sampling::Neighborhoods has such
   * stages; voxels and the paper's algorithm never call it. Its time counts as that of
   * the stage, but for Stage::Labels, and nothing of the result depends on it. */
  StageObserver on_stage;

  /** \brief The algorithm of the paper with its best row (Table III): 3 %, 30
   * neighbors, 0.05 m, 20 samples, p 0.99, 7 degrees, strategy 2. */
  static OrientedPointSamplingParameters
  paper ();
};

/** \brief What is wrong with parameters, as a sentence; empty if nothing is. */
PCL_OPS_EXPORT std::string
validate (const OrientedPointSamplingParameters& parameters);

/** \brief What Sampling::Neighborhoods finds out about the noise of a cloud, for \ref
 * OrientedPointSamplingParameters::noise_of_whole.
 * \param[in] cloud finite points or not: all of the cloud, or all points of some of its
 * parts
 * \param[in] parameters as they will be for the parts
 * \param[in] points_of_whole how many points the whole has, where it has more
 * \return no points where there are too few to tell
 * \throw std::invalid_argument if the parameters are wrong */
PCL_OPS_EXPORT CloudNoise
measureNoise (const CloudView& cloud,
              const OrientedPointSamplingParameters& parameters,
              std::size_t points_of_whole = 0);

namespace detail {

/** \brief The work behind the class; validate has found nothing wrong. */
PCL_OPS_EXPORT Detection
detect (const DetectorInput& input, const OrientedPointSamplingParameters& parameters);

} // namespace detail

/** \brief OPS: finds all planes of an unorganized point cloud. By default regions grow
 * over the normals of all points, by their noise. With Sampling::Points, the paper's
 * algorithm, a few per cent of the points have normals, and each of them is a
 * hypothesis of RANSAC by itself.
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

  /** \brief k: the neighbors of each sample that its normal comes from, 2 or more
   * (\ref OrientedPointSamplingParameters::k). */
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

  /** \brief theta_N: a plane needs more inliers than this among the samples. It counts
   * samples, not points: for a number of points call setMinPoints(). */
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

  /** \deprecated Call setMinSamples(), which this forwards to: it counts samples, while
   * the inliers of other classes of PCL are points. */
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
   * and below 1. Belongs to the paper preset: neighborhoods and voxels are not drawn.
   */
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
