// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "edges_command.h"

#include <cli/command_line.h>
#include <cli/errors.h>
#include <cli/program.h>
#include <evaluate/answer.h>
#include <evaluation/data/data_sets.h>
#include <numbers/statistics.h>
#include <pcl_ops/oriented_point_sampling.h>
#include <pcl_ops/plane_edges.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <set>

namespace pcl_ops::evaluation {

using namespace apps;

namespace {

/** A found edge or corner is right if it is within this distance of a true one [m]. */
constexpr double max_distance = 0.05;

/** A length of edges [m] or a number of corners (whole), and the part of it that is
 * near other edges or corners, within \ref max_distance. */
struct Share {
  double part = 0.0, whole = 0.0;

  /** \param[in] distances from points of the edge, evenly spread, to other edges [m] */
  void
  add (const PlaneEdge& edge, const std::vector<double>& distances)
  {
    const auto near =
        std::count_if (distances.begin(), distances.end(), [] (double distance) {
          return distance <= max_distance;
        });
    part += edge.length() * double (near) / double (distances.size());
    whole += edge.length();
  }
};

struct EdgeScore {
  /** How much of the true edges and corners was found. */
  Share wall_edges_found, edges_found, corners_found;
  /** How much of the found edges and corners is true. */
  Share edges_true, corners_true;
  /** Distance to the nearest found edge at each centimeter of the true edges where it
   * is within \ref max_distance [m]. */
  std::vector<double> edge_errors;
  /** Distances of the found corners to their true ones [m]. */
  std::vector<double> corner_errors;
};

/** Returns for each centimeter of an edge the distance to the nearest of the others
 * whose direction differs by at most 7 degrees [m]; infinity if there is none. An edge
 * longer than 1 km has as many distances as one of 1 km, at larger steps. */
std::vector<double>
distancesAlong (const PlaneEdge& edge, const std::vector<PlaneEdge>& others)
{
  constexpr double max_samples = 1e5;
  constexpr double sample_step = 0.01; // [m]
  const Vector3d direction = (edge.to - edge.from).normalized();
  const int samples = int (std::min (max_samples, edge.length() / sample_step)) + 1;
  std::vector<double> distances (samples, std::numeric_limits<double>::infinity());
  for (const PlaneEdge& other : others) {
    const Vector3d along = other.to - other.from;
    const double cosine = std::abs (direction.dot (along.normalized()));
    if (cosine < std::cos (paper_angle_tolerance))
      continue;
    for (int sample = 0; sample < samples; ++sample) {
      const double share = (sample + 0.5) / samples; // of the edge
      const Vector3d point = edge.from + share * (edge.to - edge.from);
      const double share_of_other =
          along.dot (point - other.from) / along.squaredNorm();
      const Vector3d nearest =
          other.from + std::clamp (share_of_other, 0.0, 1.0) * along;
      distances[sample] = std::min (distances[sample], (nearest - point).norm());
    }
  }
  return distances;
}

/** Pairs each true corner in turn with the nearest found corner that is still free, if
 * it is within \ref max_distance. */
void
addCorners (const std::vector<PlaneCorner>& truth,
            std::vector<PlaneCorner> found,
            EdgeScore& score)
{
  score.corners_found.whole += double (truth.size());
  score.corners_true.whole += double (found.size());
  for (const PlaneCorner& corner : truth) {
    const auto distance = [&corner] (const PlaneCorner& other) {
      return (other.position - corner.position).norm();
    };
    const auto nearest = std::min_element (
        found.begin(), found.end(), [&] (const auto& one, const auto& other) {
          return distance (one) < distance (other);
        });
    if (nearest == found.end() || distance (*nearest) > max_distance)
      continue;
    score.corner_errors.push_back (distance (*nearest));
    found.erase (nearest); // keeps the order, by which equal distances are decided
    ++score.corners_found.part;
    ++score.corners_true.part;
  }
}

/** Finds planes in a cloud by the default preset, and adds to a score how their edges
 * and corners agree with those of the true planes. */
void
addCloud (const EvaluationCloud& cloud, EdgeScore& score)
{
  const std::vector<PlaneSegment> true_planes =
      planesOf (*cloud.cloud, planeIds (*cloud.truth), {cloud.up});
  OrientedPointSampling<pcl::PointXYZ> ops;
  ops.setInputCloud (cloud.cloud);
  std::vector<PlaneSegment> planes;
  ops.segment (planes);
  const PlaneEdges truth = findPlaneEdges (*cloud.cloud, true_planes);
  const PlaneEdges found = findPlaneEdges (*cloud.cloud, planes);
  for (const PlaneEdge& edge : truth.edges) {
    constexpr double min_wall_length = 1.0; // [m]
    const std::set<Orientation> orientations{true_planes[edge.planes[0]].orientation,
                                             true_planes[edge.planes[1]].orientation};
    const std::vector<double> distances = distancesAlong (edge, found.edges);
    score.edges_found.add (edge, distances);
    const bool is_wall_edge =
        edge.length() >= min_wall_length &&
        orientations == std::set{Orientation::Horizontal, Orientation::Vertical};
    if (is_wall_edge)
      score.wall_edges_found.add (edge, distances);
    for (const double distance : distances)
      if (distance <= max_distance)
        score.edge_errors.push_back (distance);
  }
  for (const PlaneEdge& edge : found.edges)
    score.edges_true.add (edge, distancesAlong (edge, truth.edges));
  addCorners (truth.corners, found.corners, score);
}

Answer
answerOf (const std::string& data_set, const EdgeScore& score)
{
  const auto quantile_mm = [] (const std::vector<double>& errors, double share) {
    return 1e3 * quantile (errors, share);
  };
  const auto value = [] (const Share& share) { return share.part / share.whole; };
  return {{"data_set", data_set},
          {"wall_edges_found", value (score.wall_edges_found)},
          {"edges_found", value (score.edges_found)},
          {"edges_true", value (score.edges_true)},
          {"median_mm", quantile_mm (score.edge_errors, 0.5)},
          {"95_%_mm", quantile_mm (score.edge_errors, 0.95)},
          {"corners_found", value (score.corners_found)},
          {"corners_true", value (score.corners_true)},
          {"corners_median_mm", quantile_mm (score.corner_errors, 0.5)}};
}

} // namespace

int
edgesCommand (int argc, const char* const* argv)
{
  std::vector<std::string> data_set_texts;
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();
  CommandLine line (
      "pcl_ops_evaluate edges",
      "Measures how well edges and corners of planes are found: compares those of the\n"
      "planes found by the default preset with those of the true planes. They agree "
      "if\n"
      "they are within 5 cm. Edges count by length, corners by number. Wall edges are\n"
      "of a horizontal and a vertical plane, 1 m and longer.",
      PCL_OPS_VERSION);
  line.addArguments ("DATASET", data_set_texts, data_set_help);
  bool prints_json = false;
  line.add ("json", prints_json).help ("print JSON instead of text");
  line.addUpAxis (up).help ("against gravity in clouds; camera: 0,-1,0 (0,0,1)");
  if (!line.parse (argc, argv))
    return ExitCode::done;
  std::vector<DataSet> data_sets;
  for (const std::string& text : data_set_texts)
    data_sets.push_back (dataSetOf (text, up));
  Answer rows = Answer::array();
  for (const DataSet& data_set : data_sets) {
    EdgeScore score;
    for (const CloudSource& source : data_set) {
      inMemory (source.name, "give a smaller cloud", [&] {
        const EvaluationCloud cloud = source.load();
        if (!cloud.truth)
          throw WorkError (source.name, "has no true labels; give another cloud");
        addCloud (cloud, score);
      });
      std::cerr << source.data_set << ' ' << source.name << std::endl;
    }
    rows.push_back (answerOf (data_set.front().data_set, score));
  }
  print ({{"edges", rows}}, prints_json);
  return ExitCode::done;
}

} // namespace pcl_ops::evaluation
