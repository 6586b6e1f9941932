// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "kht_method.h"

#include "method_table.h"
#include <pcl_ops/kernel_hough_transform.h>

namespace pcl_ops::apps {

namespace {

using Kht = KernelHoughTransform<pcl::PointXYZ>;

OptionTable<Kht::Parameters>
khtOptions ()
{
  using P = Kht::Parameters;
  constexpr double most_phi = 1000, most_rho = 10000;
  constexpr double points_of_a_plane = 3, deepest_level = 20;
  return {{"phi-num",
           "N",
           Range::from (2).upTo (most_phi),
           [] (P& p) -> int& { return p.phi_num; },
           "steps of half a turn"},
          {"rho-num",
           "N",
           Range::from (2).upTo (most_rho),
           [] (P& p) -> int& { return p.rho_num; },
           "steps out to the farthest point"},
          {"min-samples",
           "N",
           Range::from (points_of_a_plane),
           [] (P& p) -> std::size_t& { return p.clusters.min_samples; },
           "smaller octree nodes are left out"},
          {"s-level",
           "N",
           Range::from (0).upTo (deepest_level),
           [] (P& p) -> int& { return p.clusters.first_level; },
           "first level of the octree that is tested"},
          {"s-alpha",
           "R",
           Range::above (0),
           [] (P& p) -> double& { return p.clusters.s_alpha; },
           "larger: a node must be thinner to count as flat"},
          {"s-beta",
           "R",
           Range::above (0),
           [] (P& p) -> double& { return p.clusters.s_beta; },
           "larger: it may be more elongated"}};
}

} // namespace

Method
khtMethod ()
{
  MethodTable<Kht> table{"kht", "3D Kernel-based Hough Transform"};
  table.options = khtOptions();
  table.last_settings = [] (const Kht::Parameters& p) -> Settings {
    return {{"refit", p.refit.enabled},
            {"merging", p.merging.enabled}};
  };
  return methodOf (table);
}

} // namespace pcl_ops::apps
