// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/memory.h>

#include <cstdint>

namespace pcl_ops {

/** \brief A plane from one oriented point, for PCL's own estimators
 * (pcl::RandomSampleConsensus, MSAC, MLESAC, LMedS, PROSAC): with a sample of one point
 * their stop rule log (1 - p) / log (1 - w) is the paper's N_iter. RRANSAC and RMSAC
 * may never end before PCL 1.15, with this model as with PCL's own.
 *
 * The points of the cloud carry their unit normals. Coefficients are a b c d with a
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

  /** \brief The model over some points of a cloud. */
  SampleConsensusModelOrientedPoint (const PointCloudConstPtr& cloud,
                                     const pcl::Indices& indices,
                                     bool random = false);

  /** \brief Seeds the draws and starts them over; PCL itself offers no way to. */
  void
  setSeed (std::uint32_t seed);

  /** \brief The plane through a point perpendicular to its normal.
   * \param[in] samples one index
   * \param[out] model_coefficients a b c d
   * \return false if there is not one sample, or it or its normal is not finite or the
   * normal is zero */
  bool
  computeModelCoefficients (const pcl::Indices& samples,
                            Eigen::VectorXf& model_coefficients) const override;

  /** \brief The centered least squares plane of the inliers.
   * \param[in] inliers indices of points
   * \param[in] model_coefficients kept where the inliers, fewer than three or all on a
   * line, have no plane of their own, or one that breaks the model constraints
   * \param[out] optimized_coefficients a b c d, on the same side as the model */
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
