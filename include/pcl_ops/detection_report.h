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
  double search = 0.0;
  double normals = 0.0;
  double extraction = 0.0;
  double assignment = 0.0;
  double merging = 0.0;
  /** \brief Everything between a loaded cloud and labels for all points. */
  double detection = 0.0;
};

/** \brief Lengths that a detection worked with, whether they were given or followed the
 * cloud [m]. */
struct UsedLengths {
  /** \brief Edge of the voxels of Sampling::Surfels, some of which are divided into
   * halves of it. None: of all others. */
  std::optional<double> voxel_size;
  /** \brief Largest distance of a point to its plane, as it was given; where it follows
   * the noise, 3 times the median noise of the planes. None: no plane was found to tell
   * it. */
  std::optional<double> distance_threshold;
};

/** \brief What OPS on neighborhoods finds out from all points of a cloud before it
 * looks at single places. A part of a cloud that is given that of the whole cloud has
 * the planes of the whole. */
struct CloudNoise {
  /** \brief Number of distinct points of the cloud; the more there are, the more a
   * plane needs. */
  double points = 0.0;
  /** \brief By how much neighborhoods of each size scatter more until they hold many
   * independent errors; 1 and more, from the smallest on. */
  std::vector<double> growth;
  /** \brief How many neighboring points err as one; 1 for white noise. */
  double common_errors = 1.0;
  /** \brief What points scatter by in the median [m], and the same where the density of
   * points [1/m^2] has this logarithm to base 2, rounded down. */
  double usual = 0.0;
  std::map<int, double> usual_of_octave;
};

/** \brief The stages of OPS on neighborhoods that can be looked at, in their order, and
 * what StageResult has of each. */
enum class Stage {
  /** \brief Values: the points per area around each point, roughly [1/m^2]. */
  Density,
  /** \brief Values: how far the points around each scatter about their surface [m]. */
  Noise,
  /** \brief Values: the width [m] of the support that each point is taken for. Labels:
   * 0 where it is flat, else no_plane. */
  Supports,
  /** \brief Labels: the region that grew over each point. */
  Regions,
  /** \brief Labels: the same after pieces of one plane were joined, by the number of
   * the region that took the others. */
  Joined,
  /** \brief Labels: the same, of regions alone for which more speaks that they are
   * planes than against it. */
  Planes,
  /** \brief Labels: the positions of the planes in the result, after each point went to
   * the likeliest one, layers were told apart and thick planes left out. */
  Labels
};

inline constexpr Stage all_stages[] = {Stage::Density,
                                       Stage::Noise,
                                       Stage::Supports,
                                       Stage::Regions,
                                       Stage::Joined,
                                       Stage::Planes,
                                       Stage::Labels};

/** \brief "density", "noise" and so on. */
PCL_OPS_EXPORT const char*
toString (Stage stage);

/** \brief What a stage made of each point of the input cloud, equal ones too. Points
 * that are not searched, as those without coordinates, have NaN and no_plane. */
struct StageResult {
  Stage stage = Stage::Density;
  /** \brief Empty where the stage has labels alone. */
  std::vector<float> values = {};
  /** \brief Empty where the stage has values alone. */
  pcl_ops::Labels labels = {};
};

/** \brief Gets each result once, in the order of the stages, in the thread of the call;
 * of a cloud with too few points for the first stage the labels alone. */
using StageObserver = std::function<void (const StageResult& result)>;

} // namespace pcl_ops
