// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/metrics/metrics.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief A cloud file with its field `label`. */
struct LabeledCloud {
  /** \brief Every point in the file's order; zero of the file's frame is at -\ref
   * shift. */
  XyzCloud::Ptr cloud;
  Eigen::Vector3d shift = Eigen::Vector3d::Zero();
  PlaneLabels labels;
};

/** \brief Reads a file of \ref apps::loadCloud whose points have an integer field
 * `label`, or a text whose column of that name has whole numbers.
 * \param[in] needs_labels whether it is an error that there is no such field
 * \throw apps::WorkError if that fails */
LabeledCloud
loadLabeledCloud (const std::string& file, bool needs_labels = false);

/** \brief Reads the truth and a result that label the same points in the same order.
 * \param[in] min_plane_points true planes with fewer points become none
 * \throw apps::WorkError naming the file that has no labels, or \p result_file if the
 * number of points or their coordinates differ */
std::pair<LabeledCloud, LabeledCloud>
loadLabeledClouds (const std::string& truth_file,
                   const std::string& result_file,
                   std::size_t min_plane_points);

/** \brief A cloud to evaluate detectors on. */
struct EvaluationCloud {
  XyzCloud::Ptr cloud;
  /** \brief Exact truth where there is one; otherwise it is made by region growing. */
  std::optional<PlaneLabels> truth;
  /** \brief Unit vector against gravity in the cloud's frame. */
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  /** \brief The organized cloud whose finite points these are, in the same order; null
   * where they are from no image. */
  XyzCloud::ConstPtr image = nullptr;
};

/** \brief The finite points, and the cloud itself if it is organized.
 * \param[in] labels their truth; empty: not known */
EvaluationCloud
finiteOf (const XyzCloud::ConstPtr& cloud, const PlaneLabels& labels);

/** \brief A cloud that is loaded when its turn comes, so that memory is bounded by the
 * clouds in flight. */
struct CloudSource {
  std::string data_set;
  /** \brief Unique within its data set. */
  std::string name;
  /** \brief Throws apps::WorkError that names the file if the cloud cannot be had. */
  std::function<EvaluationCloud()> load;
};

/** \brief At least one cloud. */
using DataSet = std::vector<CloudSource>;

/** \brief How the data sets of \ref dataSetOf are written, for --help. */
extern const char* const data_set_help;

/** \brief The data set a text as in \ref data_set_help stands for. Simulated ones have
 * exact truth; of files their field label is the truth where there is one.
 * \param[in] up direction against gravity in the files of "clouds"
 * \throw apps::UsageError for any other text, apps::WorkError if the folder has no
 * cloud */
DataSet
dataSetOf (const std::string& text,
           const Eigen::Vector3d& up = Eigen::Vector3d::UnitZ());

/** \brief The same of several, for a direction of any length. */
std::vector<DataSet>
dataSetsOf (const std::vector<std::string>& texts, const Eigen::Vector3f& up);

/** \brief All frames of SUN RGB-D (Song, Lichtenberg & Xiao, CVPR 2015) below a folder,
 * by name. A frame is a folder with the PNG file of its depth, intrinsics.txt (3 x 3)
 * and a folder extrinsics whose last file by name counts (3 x 4). Its origin is at the
 * camera, x to the right and z against gravity [m]. Pixels without a reading give no
 * point; as in the data set's toolbox, depths beyond 8 m are set to 8 m. Loading throws
 * apps::WorkError that names the missing, damaged or malformed file.
 * \param[in] is_raw depth as measured (folder "depth"); else refined, with holes filled
 * ("depth_bfx"): the toolbox's default
 * \throw apps::WorkError if there is none */
DataSet
sunRgbdDataSet (const std::string& folder, bool is_raw);

/** \brief True planes for clouds without labels (paper section IV-A), by region growing
 * from the flattest points on: a neighbor of a point joins its region if it is within 5
 * cm of the region's plane and both normals agree to 7 degrees. Regions of under 50
 * points are on no plane.
 * \param[in] cloud finite points
 * \param[in] neighbors of a point its normal comes from and its region may grow to
 * \return labels 1 .. P by falling size */
PlaneLabels
growRegions (const XyzCloud& cloud, int neighbors);

/** \brief Where the truth of a cloud comes from that has none. */
struct TruthParameters {
  /** \brief Of \ref growRegions. The paper does not say; on raw depth 30 leave many
   * points without a plane. */
  int neighbors = 100;
  /** \brief True planes with fewer points are none, whatever the truth's source. */
  std::size_t min_points = 50;
};

/** \brief The exact truth of a cloud, or else the one grown from it. */
PlaneLabels
truthOf (const EvaluationCloud& cloud, const TruthParameters& parameters);

/** \brief How the truth of a cloud was had: "exact", or "grown-k100" with its number of
 * neighbors. */
inline std::string
truthName (bool is_exact, const TruthParameters& parameters)
{
  return is_exact ? "exact" : "grown-k" + std::to_string (parameters.neighbors);
}

} // namespace pcl_ops::evaluation
