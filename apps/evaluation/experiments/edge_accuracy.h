// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <evaluation/data/data_sets.h>
#include <evaluation/report/text_table.h>
#include <pcl_ops/plane_edges.h>

#include <string>
#include <vector>

namespace pcl_ops::evaluation {

/** \brief Where the true planes of a cloud meet, and where those found do. */
struct EdgePair {
  PlaneEdges truth, found;
  /** \brief Of each true edge, whether it is between a horizontal and a vertical plane
   * and long enough to be one of floor and wall. */
  std::vector<bool> is_of_wall;
};

/** \brief Edges of the planes of the true labels, and of those found by the default
 * preset. \param[in] cloud with exact truth */
EdgePair
findBothEdges (const EvaluationCloud& cloud);

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

/** \brief Compares edges and corners: those nearer than 5 cm, edges also within 7
 * degrees, are the same.
 * \param[in,out] score takes the lengths, numbers and errors in */
void
addScore (const EdgePair& edges, EdgeScore& score);

/** \brief The scores on a data set. */
struct EdgeScores {
  std::string data_set;
  EdgeScore score;
};

TextTable
edgeTable (const std::vector<EdgeScores>& data_sets);

} // namespace pcl_ops::evaluation
