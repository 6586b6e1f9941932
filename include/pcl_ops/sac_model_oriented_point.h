// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/memory.h>

#include <cstdint>

namespace pcl_ops {

/** \brief A plane model from one oriented point, for PCL's own estimators
 * (pcl::RandomSampleConsensus, MSAC, MLESAC, LMedS, PROSAC). With a sample of one point
 * their number of iterations log (1 - p) / log (1 - w) is the paper's N_iter. Before
 * PCL 1.15 RRANSAC and RMSAC may never end, with this model and with PCL's own models.
 *
 * The points of the cloud need unit normals. Coefficients are a b c d with a
 * unit normal. Distances, inliers and counts are those of
 * pcl::SampleConsensusModelPlane.
 * \tparam PointNT a point type with x, y, z and normal_x, normal_y, normal_z
 * \ingroup sample_consensus */
template <typename PointNT>
class SampleConsensusModelOrientedPoint
: public pcl::SampleConsensusModelPlane<PointNT> {
public:
  using Base = pcl::SampleConsensusModelPlane<PointNT>;
  using PointCloudConstPtr = typename Base::PointCloudConstPtr;
  using Ptr = pcl::shared_ptr<SampleConsensusModelOrientedPoint<PointNT>>;
  using ConstPtr = pcl::shared_ptr<const SampleConsensusModelOrientedPoint<PointNT>>;

  /** \param[in] cloud points with unit normals
   * \param[in] random true: seed from the clock, as PCL does; false: its fixed seed */
  explicit SampleConsensusModelOrientedPoint (const PointCloudConstPtr& cloud,
                                              bool random = false);

  /** \brief Makes the model of the points with these indices. */
  SampleConsensusModelOrientedPoint (const PointCloudConstPtr& cloud,
                                     const pcl::Indices& indices,
                                     bool random = false);

  /** \brief Seeds the random draws and restarts them: equal seeds give equal samples.
   * PCL's own models have only a fixed seed and one from the clock. */
  void
  setSeed (std::uint32_t seed);

  /** \brief Computes the plane through a point, perpendicular to its normal.
   * \param[in] samples index of the point
   * \param[out] model_coefficients a b c d
   * \return false if the number of samples is not one, if the point or its normal is
   * not finite, or if the normal is zero */
  bool
  computeModelCoefficients (const pcl::Indices& samples,
                            Eigen::VectorXf& model_coefficients) const override;

  /** \brief Fits a plane to the inliers by centered least squares.
   * \param[in] inliers indices of points
   * \param[in] model_coefficients a b c d of the model
   * \param[out] optimized_coefficients a b c d, with the normal on the side of the
   * model's normal; \p model_coefficients if the inliers span no plane (fewer than
   * three, or all on a line), or if the given or the fitted model is not valid */
  void
  optimizeModelCoefficients (const pcl::Indices& inliers,
                             const Eigen::VectorXf& model_coefficients,
                             Eigen::VectorXf& optimized_coefficients) const override;

protected:
  bool
  isSampleGood (const pcl::Indices& samples) const override;
};

} // namespace pcl_ops

#ifdef PCL_NO_PRECOMPILE
#include <pcl_ops/impl/sac_model_oriented_point.hpp>
#endif
