// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "detector_run.h"

namespace pcl_ops::apps {

namespace {

using Kht = KernelHoughTransform<pcl::PointXYZ>;

void
declareAccumulator (CommandLine& line, KhtOptions& options)
{
  constexpr double most_phi = 1000;
  constexpr double most_rho = 10000;
  const Kht::Parameters usual;
  const Kht::Parameters paper = Kht::Parameters::paper();
  line.addNumber ("phi-num",
                  "N",
                  Range::from (2).upTo (most_phi),
                  options.phi_num,
                  withPresets ("steps of half a turn", usual.phi_num, paper.phi_num));
  line.addNumber (
      "rho-num",
      "N",
      Range::from (2).upTo (most_rho),
      options.rho_num,
      withPresets ("steps out to the farthest point", usual.rho_num, paper.rho_num));
}

void
declareClusters (CommandLine& line, KhtOptions& options)
{
  constexpr double points_of_a_plane = 3;
  constexpr double deepest_level = 20;
  const OctreeClusterParameters usual = Kht::Parameters().clusters;
  const OctreeClusterParameters paper = Kht::Parameters::paper().clusters;
  line.addNumber ("min-samples",
                  "N",
                  Range::from (points_of_a_plane),
                  options.min_samples,
                  withPresets ("smaller octree nodes are left out",
                               usual.min_samples,
                               paper.min_samples));
  line.addNumber ("s-level",
                  "N",
                  Range::from (0).upTo (deepest_level),
                  options.s_level,
                  withPresets ("first level of the octree that is tested",
                               usual.first_level,
                               paper.first_level));
  line.addNumber ("s-alpha",
                  "R",
                  Range::above (0),
                  options.s_alpha,
                  withPresets ("larger: a node must be thinner to count as flat",
                               usual.s_alpha,
                               paper.s_alpha));
  line.addNumber (
      "s-beta",
      "R",
      Range::above (0),
      options.s_beta,
      withPresets ("larger: it may be more elongated", usual.s_beta, paper.s_beta));
}

void
declareOptions (CommandLine& line, DetectorOptions& detector)
{
  declareAccumulator (line, detector.kht);
  declareClusters (line, detector.kht);
}

Kht::Parameters
parametersOf (const DetectorOptions& options)
{
  auto parameters = presetOf<Kht::Parameters> (options);
  OctreeClusterParameters& clusters = parameters.clusters;
  override (options.kht.phi_num, parameters.phi_num);
  override (options.kht.rho_num, parameters.rho_num);
  override (options.kht.min_samples, clusters.min_samples);
  override (options.kht.s_level, clusters.first_level);
  override (options.kht.s_alpha, clusters.s_alpha);
  override (options.kht.s_beta, clusters.s_beta);
  return parameters;
}

nlohmann::ordered_json
describeOwn (const Kht::Parameters& parameters)
{
  const OctreeClusterParameters& clusters = parameters.clusters;
  nlohmann::ordered_json json;
  json["phi_num"] = parameters.phi_num;
  json["rho_num"] = parameters.rho_num;
  json["min_samples"] = clusters.min_samples;
  json["s_level"] = clusters.first_level;
  json["s_alpha"] = clusters.s_alpha;
  json["s_beta"] = clusters.s_beta;
  json["refit"] = parameters.refit.enabled;
  json["bounded"] = parameters.bounded;
  json["merging"] = parameters.merging.enabled;
  return json;
}

Detected
detect (const DetectorOptions& options, const XyzCloud::ConstPtr& cloud)
{
  const Kht::Parameters parameters = parametersOf (options);
  return detectBy<Kht> (parameters,
                        describe (options.preset, describeOwn (parameters), parameters),
                        cloud);
}

} // namespace

Method
khtMethod ()
{
  return {"kht", "3D Kernel-based Hough Transform", declareOptions, detect};
}

} // namespace pcl_ops::apps
