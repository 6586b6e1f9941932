// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluate/labeled_clouds.h>

#include <functional>

namespace pcl_ops::evaluation {

/** In rooms, what walls bend and sensors err by is below [m]. */
constexpr double usual_thick_length = 0.03;

struct EvaluationCloud {
  XyzCloud::Ptr cloud;
  std::optional<PlaneLabels> truth; // exact, if there is one
  /** In place of a larger \ref TruthParameters::min_points: these are to be found. */
  std::optional<std::size_t> min_plane_points = std::nullopt;
  Vector3d up = Vector3d::UnitZ(); // against gravity, of length 1
  /** The organized cloud whose finite points these are, if any. */
  XyzCloud::ConstPtr image = nullptr;
  /** Of each point, whether its truth is unknown; empty: all are known. */
  std::vector<char> is_ignored = {};
  /** Without truth one is grown, except where nobody has asked for it. */
  bool grows_truth = true;
  /** A plane with a larger rms is none of a cloud like this [m]. */
  double thick_length = usual_thick_length;
};

/** \param[in] labels empty: not known */
EvaluationCloud
finiteOf (const XyzCloud::ConstPtr& cloud, const PlaneLabels& labels);

/** A cloud that is loaded when its turn comes. */
struct CloudSource {
  std::string data_set;
  std::string name; // unique within its data set
  /** \throw apps::WorkError that names the file if the cloud cannot be had */
  std::function<EvaluationCloud()> load;
};

/** At least one cloud. */
using DataSet = std::vector<CloudSource>;

/** How \ref dataSetOf has them written, for --help. */
extern const char* const data_set_help;

/** Simulated ones have exact truth; of files their field label is the truth.
 * \param[in] up direction against gravity in the files of "clouds", of any length
 * \throw apps::UsageError for any other text, apps::WorkError if the folder has no
 * cloud */
DataSet
dataSetOf (const std::string& text,
           const Eigen::Vector3f& up = Eigen::Vector3f::UnitZ());

/** All frames of SUN RGB-D (Song, Lichtenberg & Xiao, CVPR 2015) below a folder. A
 * frame is a folder with the PNG file of its depth, intrinsics.txt (3 x 3) and a folder
 * extrinsics whose last file by name counts (3 x 4). Its origin is at the camera, x to
 * the right and z against gravity [m]. Pixels without a reading give no point; as in
 * the data set's toolbox, depths beyond 8 m are set to 8 m.
 * \param[in] is_raw depth as measured (folder "depth"); else refined, with holes filled
 * ("depth_bfx"): the toolbox's default
 * \throw apps::WorkError if there is none */
DataSet
sunRgbdDataSet (const std::string& folder, bool is_raw);

/** True planes for clouds without labels (paper section IV-A), from the flattest points
 * on: a neighbor of a point joins its region if it is within 5 cm of the region's plane
 * and both normals agree to 7 degrees. Regions of under 50 points are on no plane.
 * \param[in] cloud finite points
 * \param[in] neighbors of a point its normal comes from and its region may grow to
 * \return labels 1 .. P by falling size */
PlaneLabels
growRegions (const XyzCloud& cloud, int neighbors);

struct TruthParameters {
  /** Of \ref growRegions. The paper does not say; on raw depth 30 leave many points
   * without a plane. */
  int neighbors = 100;
  /** True planes with fewer points are none, whatever the truth's source. */
  std::size_t min_points = 50;
};

/** The exact truth of a cloud, or else the one grown from it, or no plane where none is
 * grown. */
PlaneLabels
truthOf (const EvaluationCloud& cloud, const TruthParameters& parameters);

} // namespace pcl_ops::evaluation
