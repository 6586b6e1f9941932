// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "fspf_method.h"

#include "method_table.h"
#include <pcl_ops/fast_sampling_plane_filtering.h>

namespace pcl_ops::apps {

namespace {

using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;

OptionTable<Fspf::Parameters>
fspfOptions ()
{
  using P = Fspf::Parameters;
  constexpr double points_of_a_plane = 3;
  return {{"inner-radius",
           "M",
           Range::above (0),
           [] (P& p) -> double& { return p.local.inner_radius; },
           "three points this near make a hypothesis"},
          {"outer-radius",
           "M",
           Range::above (0),
           [] (P& p) -> double& { return p.local.outer_radius; },
           "it is tested on points this near"},
          {"local-samples",
           "N",
           Range::from (points_of_a_plane),
           [] (P& p) -> unsigned& { return p.local.local_samples; },
           "it is tested on so many of them"},
          {"min-inlier-share",
           "R",
           Range::from (0).below (1),
           [] (P& p) -> double& { return p.local.min_inlier_fraction; },
           "a larger share of these must be inliers"},
          {"inliers-per-point",
           "R",
           Range::above (0),
           [] (P& p) -> double& { return p.local.max_inliers_per_point; },
           "sampling ends at so many inliers"}};
}

/** \brief Where one radius is given the other follows: r2 = 2 r1, where the paper finds
 * FSPF most accurate (Table I). */
void
relateRadii (const GivenNumbers& given, Fspf::Parameters& parameters)
{
  constexpr double ratio = 2.0;
  LocalSamplingParameters& local = parameters.local;
  const bool has_inner = given.count ("inner-radius") > 0;
  const bool has_outer = given.count ("outer-radius") > 0;
  if (has_inner && !has_outer)
    local.outer_radius = ratio * local.inner_radius;
  if (has_outer && !has_inner)
    local.inner_radius = local.outer_radius / ratio;
  if (local.outer_radius < local.inner_radius)
    throw UsageError ("--outer-radius",
                      "is below --inner-radius; leave one of them out or raise it");
}

} // namespace

Method
fspfMethod ()
{
  MethodTable<Fspf> table{"fspf", "Fast Sampling Plane Filtering"};
  table.options = fspfOptions();
  table.relate = relateRadii;
  return methodOf (table);
}

} // namespace pcl_ops::apps
