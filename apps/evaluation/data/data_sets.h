// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/labels/labels.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace pcl_ops::evaluation {

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
dataSetOf (const std::string& text, const Eigen::Vector3d& up);

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

} // namespace pcl_ops::evaluation
