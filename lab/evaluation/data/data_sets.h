// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluate/labeled_clouds.h>

#include <functional>

namespace pcl_ops::evaluation {

/** Default of EvaluationCloud::thick_length: in rooms, the bend of walls and the sensor
 * noise stay below this rms distance [m]. */
constexpr double usual_thick_length = 0.03;

/** A cloud on which detectors are run, and what is known of it. */
struct EvaluationCloud {
  XyzCloud::Ptr cloud;
  std::optional<PlaneLabels> truth; // exact truth, one label per point; 0: no plane
  /** Replaces \ref TruthParameters::min_points if it is smaller, so that small planes
   * of this cloud count. */
  std::optional<std::size_t> min_plane_points = std::nullopt;
  Vector3d up = Vector3d::UnitZ(); // against gravity, of length 1
  /** The organized cloud of which \ref cloud has the finite points, in the same order;
   * nullptr: there is none. */
  XyzCloud::ConstPtr image = nullptr;
  /** For each point, whether its truth is unknown; empty: all truth is known. */
  std::vector<char> is_ignored = {};
  /** Whether \ref growRegions makes the truth of a cloud that has no exact truth. */
  bool grows_truth = true;
  /** A found plane counts as thick if the rms distance of its points is larger [m]. */
  double thick_length = usual_thick_length;
};

/** Returns the finite points of a cloud; an organized cloud is also kept as the image.
 * \param[in] labels one per point of the cloud; empty: no truth */
EvaluationCloud
finiteOf (const XyzCloud::ConstPtr& cloud, const PlaneLabels& labels);

/** A cloud that is loaded only when it is used. */
struct CloudSource {
  std::string data_set;
  std::string name; // unique within its data set
  /** \throw apps::WorkError that names the file if the cloud cannot be loaded */
  std::function<EvaluationCloud()> load;
};

/** At least one cloud. */
using DataSet = std::vector<CloudSource>;

/** Syntax of the texts that \ref dataSetOf takes, for --help. */
extern const char* const data_set_help;

/** Returns the data set that a text names. Simulated clouds have exact truth. Files
 * have it in the field label, or instance for "real-instances"; "wild" has no truth,
 * SUN RGB-D has grown truth.
 * \param[in] text see \ref data_set_help
 * \param[in] up direction against gravity in point cloud files, of any length
 * \throw apps::UsageError for any other text, apps::WorkError if the folder has no
 * cloud */
DataSet
dataSetOf (const std::string& text,
           const Eigen::Vector3f& up = Eigen::Vector3f::UnitZ());

/** Lists all frames of SUN RGB-D (Song, Lichtenberg & Xiao, CVPR 2015) below a folder.
 * A frame is a folder with a depth PNG file in a folder, intrinsics.txt (3 x 3) and a
 * folder extrinsics, whose last file by name is read (3 x 4). The clouds have the
 * origin at the camera, x to the right and z against gravity [m]. Pixels without a
 * reading give no point. As in the toolbox of the data set, depths above 8 m
 * become 8 m.
 * \param[in] is_raw true: depth as measured (folder "depth"); false: refined depth with
 * filled holes (folder "depth_bfx"), the default of the toolbox
 * \throw apps::WorkError if there is no frame, or a folder cannot be read */
DataSet
sunRgbdDataSet (const std::string& folder, bool is_raw);

/** Makes true planes of a cloud without labels by region growing (paper section IV-A).
 * Seeds are taken by ascending curvature. A neighbor of a region's point joins the
 * region if it is within 5 cm of the region's plane and the normals of the two points
 * differ by at most 7 degrees. Points of regions below 50 points get label 0.
 * \param[in] cloud finite points
 * \param[in] neighbors size of the neighborhood for the normal and for growing; the
 * point itself counts
 * \return labels 1 .. P by falling number of points */
PlaneLabels
growRegions (const XyzCloud& cloud, int neighbors);

struct TruthParameters {
  /** Neighborhood of \ref growRegions. The paper gives no number; on raw depth, 30
   * neighbors leave many points without a plane. */
  int neighbors = 100;
  /** A true plane with fewer points gets label 0, in exact and in grown truth. */
  std::size_t min_points = 50;
};

/** Returns the exact truth of a cloud, else grown truth; all labels are 0 if the cloud
 * has no exact truth and \ref EvaluationCloud::grows_truth is false. */
PlaneLabels
truthOf (const EvaluationCloud& cloud, const TruthParameters& parameters);

} // namespace pcl_ops::evaluation
