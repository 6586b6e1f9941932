// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ops_method.h"

#include "method_table.h"
#include <pcl_ops/oriented_point_sampling.h>

namespace pcl_ops::apps {

Method
opsMethod ()
{
  using Ops = OrientedPointSampling<pcl::PointXYZ>;
  using P = Ops::Parameters;
  MethodTable<Ops> table{"ops", "Oriented Point Sampling"};
  table.options = {{"sampling-rate",
                    "R",
                    Range::above (0).upTo (1),
                    [] (P& p) -> double& { return p.sampling_rate; },
                    "share of the points that get a normal"},
                   {"k",
                    "K",
                    Range::from (2),
                    [] (P& p) -> int& { return p.k; },
                    "neighbours of a normal; on surfels the fewest points"},
                   {"min-inliers",
                    "N",
                    Range::from (1),
                    [] (P& p) -> unsigned& { return p.min_inliers; },
                    "a plane has more sampled points than this"},
                   {"probability",
                    "P",
                    Range::above (0).below (1),
                    [] (P& p) -> double& { return p.probability; },
                    "of drawing a point of the largest plane"}};
  table.first_settings = [] (const P& p) -> Settings {
    const bool on_surfels = p.sampling == Sampling::Surfels;
    return {{"sampling", std::string (on_surfels ? "surfels" : "points")}};
  };
  return methodOf (table);
}

} // namespace pcl_ops::apps
