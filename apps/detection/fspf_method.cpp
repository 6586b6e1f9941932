// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detector_run.h"
#include <cli/errors.h>

namespace pcl_ops::apps {

namespace {

using Fspf = FastSamplingPlaneFiltering<pcl::PointXYZ>;

/** \brief r2 / r1 where the paper finds FSPF most accurate (Table I). */
constexpr double radii_ratio = 2.0;

void
declareRadii (CommandLine& line, FspfOptions& options)
{
  const LocalSamplingParameters usual;
  const LocalSamplingParameters paper = Fspf::Parameters::paper().local;
  line.addNumber ("inner-radius",
                  "M",
                  Range::above (0),
                  options.inner_radius,
                  withPresets ("three points this near make a hypothesis",
                               usual.inner_radius,
                               paper.inner_radius));
  line.addNumber ("outer-radius",
                  "M",
                  Range::above (0),
                  options.outer_radius,
                  withPresets ("it is tested on points this near",
                               usual.outer_radius,
                               paper.outer_radius));
}

void
declareOptions (CommandLine& line, DetectorOptions& detector)
{
  constexpr double points_of_a_plane = 3;
  const LocalSamplingParameters usual;
  const LocalSamplingParameters paper = Fspf::Parameters::paper().local;
  FspfOptions& options = detector.fspf;
  declareRadii (line, options);
  line.addNumber ("local-samples",
                  "N",
                  Range::from (points_of_a_plane),
                  options.local_samples,
                  withPresets ("it is tested on so many of them",
                               usual.local_samples,
                               paper.local_samples));
  line.addNumber ("min-inlier-share",
                  "R",
                  Range::from (0).below (1),
                  options.min_inlier_share,
                  withPresets ("a larger share of these must be inliers",
                               usual.min_inlier_fraction,
                               paper.min_inlier_fraction));
  line.addNumber ("inliers-per-point",
                  "R",
                  Range::above (0),
                  options.inliers_per_point,
                  withPresets ("sampling ends at so many inliers",
                               usual.max_inliers_per_point,
                               paper.max_inliers_per_point));
}

void
overrideRadii (const FspfOptions& options, LocalSamplingParameters& local)
{
  if (options.inner_radius)
    local.outer_radius = radii_ratio * *options.inner_radius;
  if (options.outer_radius)
    local.inner_radius = *options.outer_radius / radii_ratio;
  override (options.inner_radius, local.inner_radius);
  override (options.outer_radius, local.outer_radius);
  if (local.outer_radius < local.inner_radius)
    throw UsageError ("--outer-radius",
                      "is below --inner-radius; leave one of them out or raise it");
}

Fspf::Parameters
parametersOf (const DetectorOptions& options)
{
  auto parameters = presetOf<Fspf::Parameters> (options);
  LocalSamplingParameters& local = parameters.local;
  overrideRadii (options.fspf, local);
  override (options.fspf.local_samples, local.local_samples);
  override (options.fspf.min_inlier_share, local.min_inlier_fraction);
  override (options.fspf.inliers_per_point, local.max_inliers_per_point);
  return parameters;
}

nlohmann::ordered_json
describeOwn (const LocalSamplingParameters& local)
{
  nlohmann::ordered_json json;
  json["inner_radius"] = local.inner_radius;
  json["outer_radius"] = local.outer_radius;
  json["local_samples"] = local.local_samples;
  json["min_inlier_share"] = local.min_inlier_fraction;
  json["inliers_per_point"] = local.max_inliers_per_point;
  return json;
}

Detected
detect (const DetectorOptions& options, const XyzCloud::ConstPtr& cloud)
{
  const Fspf::Parameters parameters = parametersOf (options);
  return detectBy<Fspf> (
      parameters,
      describe (options.preset, describeOwn (parameters.local), parameters),
      cloud);
}

} // namespace

Method
fspfMethod ()
{
  return {"fspf", "Fast Sampling Plane Filtering", declareOptions, detect};
}

} // namespace pcl_ops::apps
