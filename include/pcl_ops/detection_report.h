// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl_ops/export.h>
#include <pcl_ops/plane.h>

#include <functional>
#include <map>
#include <optional>
#include <vector>

namespace pcl_ops {

/** \brief Wall time of each stage of the last call [ms]. */
struct StageDurations {
  /** \brief Search of the neighbors of points, or division of the cloud into voxels.
   * With Sampling::Neighborhoods also the fits of local planes. */
  double search = 0.0;
  /** \brief Normals of points or voxels. With Sampling::Neighborhoods the noise, and
   * the choice among the local planes. */
  double normals = 0.0;
  /** \brief Extraction of planes, or of the regions that become planes. */
  double extraction = 0.0;
  /** \brief Assignment of points to planes. */
  double assignment = 0.0;
  /** \brief Merging of planes. With Sampling::Neighborhoods joins of regions, and the
   * decision which of them are planes. */
  double merging = 0.0;
  /** \brief The whole detection, from the input cloud to the list of planes. */
  double detection = 0.0;
};

/** \brief Lengths that a detection used [m], either given by the user or chosen for the
 * cloud. */
struct UsedLengths {
  /** \brief Edge of the voxels of Sampling::Surfels, some of which are divided into
   * voxels of half the edge. Not set for all other samplings and detectors. */
  std::optional<double> voxel_size;
  /** \brief Largest distance of a point to its plane. With Sampling::Neighborhoods the
   * given one, or 3 times the median noise of the planes. With Sampling::Surfels the
   * median, over the planes, of assignment_noise_factor times the noise, or of the
   * given one where that is smaller. Else the given one. Not set if none is given and
   * no plane is found. */
  std::optional<double> distance_threshold;
};

/** \brief Noise statistics of a cloud, which Sampling::Neighborhoods measures before it
 * searches planes. If a cloud is searched in tiles with the statistics of the whole
 * cloud, the tiles have the same planes as the whole cloud. */
struct CloudNoise {
  /** \brief Number of distinct points of the cloud. In larger clouds a plane needs more
   * points. */
  double points = 0.0;
  /** \brief For each size of neighborhoods, smallest first: the scatter of
   * neighborhoods with many independent errors over the scatter of those of this size;
   * 1 or more. */
  std::vector<double> growth;
  /** \brief Number of neighboring points that share one independent error; 1 for white
   * noise. */
  double common_errors = 1.0;
  /** \brief Median noise of the points of the whole cloud whose neighborhood is flat,
   * but not exact [m]; 0 if there are none. */
  double usual = 0.0;
  /** \brief Median noise of those points in each octave of the point density, with the
   * adjacent octaves at half the weight, but at most 3 times \ref usual [m]. The key is
   * log2 of the density [1/m^2], rounded down. */
  std::map<int, double> usual_of_octave;
};

/** \brief Stages of detection with Sampling::Neighborhoods, in their order, and the
 * content of StageResult for each stage. */
enum class Stage {
  /** \brief Values: the approximate density of points around each point [1/m^2]. */
  Density,
  /** \brief Values: the noise of each point, the scatter of the points around it about
   * their surface [m]. */
  Noise,
  /** \brief Values: the width [m] of the support (neighborhood) chosen for each point.
   * Labels: 0 if the support is flat, else no_plane. */
  Supports,
  /** \brief Labels: the number of the grown region that contains the point. */
  Regions,
  /** \brief Labels: the region of each point after pieces of one plane were joined. It
   * has the number of the region that absorbed the others. */
  Joined,
  /** \brief Labels: the same numbers, but no_plane for regions whose evidence speaks
   * against a plane. */
  Planes,
  /** \brief Labels: the index of each point's plane in the result. Before, points are
   * assigned to their likeliest plane, layers are separated, and thick planes dropped.
   */
  Labels
};

inline constexpr Stage all_stages[] = {Stage::Density,
                                       Stage::Noise,
                                       Stage::Supports,
                                       Stage::Regions,
                                       Stage::Joined,
                                       Stage::Planes,
                                       Stage::Labels};

/** \brief Returns the name of a stage: "density", "noise" and so on. */
PCL_OPS_EXPORT const char*
toString (Stage stage);

/** \brief Result of a stage for each point of the input cloud, including duplicates.
 * Points that are not searched, such as non-finite points, have NaN and no_plane. */
struct StageResult {
  Stage stage = Stage::Density;
  /** \brief One value per point; empty if the stage has only labels. */
  std::vector<float> values = {};
  /** \brief One label per point; empty if the stage has only values. */
  pcl_ops::Labels labels = {};
};

/** \brief Function that is called once per stage, in the order of the stages, in the
 * thread that called the detector. If a cloud has too few points for the first stage,
 * it is called only for Stage::Labels. */
using StageObserver = std::function<void (const StageResult& result)>;

} // namespace pcl_ops
