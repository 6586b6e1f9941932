// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "commands.h"
#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <evaluation/data/data_sets.h>
#include <evaluation/report/text_table.h>
#include <numbers/fraction.h>
#include <numbers/quantile.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_edges.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

namespace pcl_ops::evaluation {

namespace {

/** \brief Where the true planes of a cloud meet, and where those found do. */
struct EdgePair {
  PlaneEdges truth, found;
  /** \brief Of each true edge, whether it is between a horizontal and a vertical plane
   * and long enough to be one of floor and wall. */
  std::vector<bool> is_of_wall;
};

/** \brief Of true and found edges, which share lies where the other's are. */
struct EdgeScore {
  double true_length = 0.0, true_length_found = 0.0;
  double wall_length = 0.0, wall_length_found = 0.0;
  double found_length = 0.0, found_length_true = 0.0;
  std::size_t true_corners = 0, found_corners = 0, corners_matched = 0;
  /** \brief How far the found edges are off, at each centimeter of the true ones that
   * were found, and the corners [m]. */
  std::vector<double> edge_errors, corner_errors;
};

constexpr double farthest = 0.05; // [m]
constexpr double sample_step = 0.01;
constexpr double wall_length = 1.0;

std::vector<PlaneSegment>
truePlanes (const EvaluationCloud& cloud)
{
  const PlaneIds ids = planeIds (*cloud.truth);
  std::vector<PlaneSegment> planes = planesOf (*cloud.cloud, ids, {cloud.up});
  for (std::size_t i = 0; i < ids.of_point.size(); ++i)
    if (ids.of_point[i] != PlaneIds::none)
      planes[ids.of_point[i]].inliers.push_back (static_cast<pcl::index_t> (i));
  return planes;
}

double
distanceTo (const PlaneEdge& edge, const Eigen::Vector3d& point)
{
  const Eigen::Vector3d along = edge.to - edge.from;
  const double place = along.dot (point - edge.from) / along.squaredNorm();
  return (edge.from + std::clamp (place, 0.0, 1.0) * along - point).norm();
}

/** \brief For each centimeter of an edge the distance to the nearest of the others that
 * runs alike; infinite where there is none near. */
std::vector<double>
distancesAlong (const PlaneEdge& edge, const std::vector<PlaneEdge>& others)
{
  std::vector<double> distances;
  const Eigen::Vector3d direction = (edge.to - edge.from).normalized();
  constexpr double max_samples = 1e5;
  const auto samples =
      static_cast<int> (std::min (max_samples, edge.length() / sample_step)) + 1;
  for (int sample = 0; sample < samples; ++sample) {
    const double place = (sample + 0.5) / samples;
    const Eigen::Vector3d point = edge.from + place * (edge.to - edge.from);
    double least = std::numeric_limits<double>::infinity();
    for (const PlaneEdge& other : others)
      if (std::abs (direction.dot ((other.to - other.from).normalized())) >=
          std::cos (paper_angle))
        least = std::min (least, distanceTo (other, point));
    distances.push_back (least);
  }
  return distances;
}

double
shareNear (const std::vector<double>& distances)
{
  const auto near = std::count_if (
      distances.begin(), distances.end(), [] (double d) { return d <= farthest; });
  return static_cast<double> (near) / static_cast<double> (distances.size());
}

/** \brief Pairs corners off, the nearest first found for each true one. */
void
matchCorners (const EdgePair& edges, EdgeScore& score)
{
  std::vector<bool> is_taken (edges.found.corners.size(), false);
  for (const PlaneCorner& corner : edges.truth.corners) {
    double least = farthest;
    std::size_t nearest = is_taken.size();
    for (std::size_t i = 0; i < is_taken.size(); ++i) {
      const double distance =
          (edges.found.corners[i].position - corner.position).norm();
      if (!is_taken[i] && distance <= least) {
        least = distance;
        nearest = i;
      }
    }
    if (nearest == is_taken.size())
      continue;
    is_taken[nearest] = true;
    ++score.corners_matched;
    score.corner_errors.push_back (least);
  }
  score.true_corners += edges.truth.corners.size();
  score.found_corners += edges.found.corners.size();
}

/** \brief Edges of the planes of the true labels, and of those found by the default
 * preset. */
EdgePair
findBothEdges (const EvaluationCloud& cloud)
{
  const std::vector<PlaneSegment> truth = truePlanes (cloud);
  OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (cloud.cloud);
  std::vector<PlaneSegment> planes;
  ops.segment (planes);
  EdgePair edges{
      findPlaneEdges (*cloud.cloud, truth), findPlaneEdges (*cloud.cloud, planes), {}};
  for (const PlaneEdge& edge : edges.truth.edges) {
    const auto has = [&] (Orientation orientation) {
      return truth[edge.planes[0]].orientation == orientation ||
             truth[edge.planes[1]].orientation == orientation;
    };
    edges.is_of_wall.push_back (edge.length() >= wall_length &&
                                has (Orientation::Horizontal) &&
                                has (Orientation::Vertical));
  }
  return edges;
}

void
addScore (const EdgePair& edges, EdgeScore& score)
{
  for (std::size_t i = 0; i < edges.truth.edges.size(); ++i) {
    const PlaneEdge& edge = edges.truth.edges[i];
    const std::vector<double> distances = distancesAlong (edge, edges.found.edges);
    const double found = shareNear (distances) * edge.length();
    score.true_length += edge.length();
    score.true_length_found += found;
    if (edges.is_of_wall[i]) {
      score.wall_length += edge.length();
      score.wall_length_found += found;
    }
    std::copy_if (distances.begin(),
                  distances.end(),
                  std::back_inserter (score.edge_errors),
                  [] (double distance) { return distance <= farthest; });
  }
  for (const PlaneEdge& edge : edges.found.edges) {
    score.found_length += edge.length();
    score.found_length_true +=
        shareNear (distancesAlong (edge, edges.truth.edges)) * edge.length();
  }
  matchCorners (edges, score);
}

std::vector<std::string>
rowOf (const std::string& data_set, const EdgeScore& score)
{
  constexpr double millimeters = 1e3;
  const auto share = [] (double part, double whole) {
    return percent (whole > 0.0 ? part / whole : NAN);
  };
  const auto corners = [&score] (std::size_t all) {
    return percent (apps::fraction (score.corners_matched, all, NAN));
  };
  return {data_set,
          share (score.wall_length_found, score.wall_length),
          share (score.true_length_found, score.true_length),
          share (score.found_length_true, score.found_length),
          decimal (millimeters * apps::quantile (score.edge_errors, 0.5), 1),
          decimal (millimeters * apps::quantile (score.edge_errors, 0.95), 1),
          corners (score.true_corners),
          corners (score.found_corners),
          decimal (millimeters * apps::quantile (score.corner_errors, 0.5), 1)};
}

} // namespace

int
edgesCommand (int argc, const char* const* argv)
{
  std::vector<std::string> texts;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  apps::CommandLine line (
      "pcl_ops_evaluate edges",
      "Tells how well it is found where planes meet: compares the edges and corners\n"
      "of planes found by the default preset with those of the true planes, by "
      "length.\n"
      "The same are those within 5 cm. Wall edges are of a horizontal and a vertical\n"
      "plane, 1 m and longer.",
      PCL_OPS_VERSION);
  line.addArguments ("DATASET", texts, data_set_help);
  line.addUpAxis (up, "against gravity in clouds; camera: 0,-1,0 (0,0,1)");
  if (!line.parse (argc, argv))
    return apps::ExitCode::done;
  TextTable table{"Where planes meet",
                  {"data set",
                   "wall edges found %",
                   "edges found %",
                   "edges true %",
                   "median [mm]",
                   "95 % [mm]",
                   "corners found %",
                   "corners true %",
                   "median [mm]"},
                  {}};
  for (const DataSet& data_set : dataSetsOf (texts, up)) {
    EdgeScore score;
    for (const CloudSource& source : data_set.clouds) {
      apps::inMemory (source.name, "give a smaller cloud", [&] {
        const EvaluationCloud cloud = source.load();
        if (!cloud.truth)
          throw apps::WorkError (source.name, "has no true labels; give another cloud");
        addScore (findBothEdges (cloud), score);
      });
      std::cerr << data_set.name << ' ' << source.name << std::endl;
    }
    table.rows.push_back (rowOf (data_set.name, score));
  }
  std::cout << table;
  return apps::ExitCode::done;
}

} // namespace pcl_ops::evaluation
