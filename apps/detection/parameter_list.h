// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cli/option_value.h>
#include <pcl_ops/fast_sampling_plane_filtering.h>
#include <pcl_ops/kernel_hough_transform.h>
#include <pcl_ops/oriented_point_sampling.h>

#include <optional>

namespace pcl_ops::apps {

/** \brief What there is to say about a parameter that is a number. In reports its name
 * has '_' for '-'. */
struct NumberOption {
  const char* name;
  const char* placeholder;
  Range range;
  const char* help;
};

/** \brief An angle that is an option in degrees. */
struct Degrees {
  double& radians;
};

/** \brief A length whose option is 0 where it is not given. */
struct ZeroIfNone {
  std::optional<double>& length;
};

/** \brief Calls \p visit (option, number) for what all detectors have. */
template <typename Visit>
void
visitShared (PlaneDetectorParameters& p, Visit&& visit)
{
  constexpr double right_angle = 90, max_threads = 1024;
  using Option = NumberOption;
  visit (Option{"threshold",
                "M",
                Range::above (0),
                "farthest point of a plane (0.05; ops: auto)"},
         p.distance_threshold);
  visit (
      Option{"merge-distance",
             "M",
             Range::from (0),
             "planes this near one another are one (--threshold; ops: by the noise)"},
      p.merging.distance_threshold);
  visit (Option{"angle-tolerance",
                "DEG",
                Range::from (0).upTo (right_angle),
                "largest tilt of horizontal and vertical planes (7)"},
         Degrees{p.angle_tolerance});
  visit (Option{"seed", "S", Range::from (0), "same seed, same result (42)"}, p.seed);
  visit (Option{"threads",
                "T",
                Range::from (0).upTo (max_threads),
                "0 for all; the result stays the same (1)"},
         p.threads);
}

/** \brief The same for what one detector has alone; the values of the presets follow in
 * the help. */
template <typename Visit>
void
visitOwn (OrientedPointSamplingParameters& p, Visit&& visit)
{
  using Option = NumberOption;
  visit (Option{"sampling-rate",
                "R",
                Range::above (0).upTo (1),
                "share of the points that get a normal"},
         p.sampling_rate);
  visit (Option{"k",
                "K",
                Range::from (2),
                "neighbors of a normal; on surfels the fewest points"},
         p.k);
  visit (Option{"min-inliers",
                "N",
                Range::from (1),
                "a plane has more sampled points than this"},
         p.min_inliers);
  visit (Option{"probability",
                "P",
                Range::above (0).below (1),
                "of drawing a point of the largest plane"},
         p.paper_only.probability);
  visit (
      Option{
          "cell", "M", Range::from (0), "edge of a voxel; 0: by the number of points"},
      ZeroIfNone{p.surfels.voxel_size});
}

template <typename Visit>
void
visitOwn (FastSamplingPlaneFilteringParameters& p, Visit&& visit)
{
  using Option = NumberOption;
  constexpr double points_of_a_plane = 3;
  visit (Option{"inner-radius",
                "M",
                Range::above (0),
                "three points this near make a hypothesis"},
         p.local.inner_radius);
  visit (
      Option{"outer-radius", "M", Range::above (0), "it is tested on points this near"},
      p.local.outer_radius);
  visit (Option{"local-samples",
                "N",
                Range::from (points_of_a_plane),
                "it is tested on so many of them"},
         p.local.local_samples);
  visit (Option{"min-inlier-share",
                "R",
                Range::from (0).below (1),
                "a larger share of these must be inliers"},
         p.local.min_inlier_fraction);
  visit (Option{"inliers-per-point",
                "R",
                Range::above (0),
                "sampling ends at so many inliers"},
         p.local.max_inliers_per_point);
}

template <typename Visit>
void
visitOwn (KernelHoughTransformParameters& p, Visit&& visit)
{
  using Option = NumberOption;
  constexpr double max_phi = 1000, max_rho = 10000;
  constexpr double points_of_a_plane = 3, max_level = 20;
  visit (Option{"phi-num", "N", Range::from (2).upTo (max_phi), "steps of half a turn"},
         p.phi_num);
  visit (Option{"rho-num",
                "N",
                Range::from (2).upTo (max_rho),
                "steps out to the farthest point"},
         p.rho_num);
  visit (Option{"min-samples",
                "N",
                Range::from (points_of_a_plane),
                "smaller octree nodes are left out"},
         p.clusters.min_samples);
  visit (Option{"s-level",
                "N",
                Range::from (0).upTo (max_level),
                "first level of the octree that is tested"},
         p.clusters.first_level);
  visit (Option{"s-alpha",
                "R",
                Range::above (0),
                "larger: a node must be thinner to count as flat"},
         p.clusters.s_alpha);
  visit (Option{"s-beta", "R", Range::above (0), "larger: it may be more elongated"},
         p.clusters.s_beta);
}

} // namespace pcl_ops::apps
