// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "inside_cells.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include "constants.h"

#include <cmath>

namespace pcl_ops::internal::buildings {
namespace {

/** \brief Capacities are integers, so that sums are exact and ties between cuts are
 * always broken the same way. */
using Capacity = long long;

using CutTraits =
    boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using CutGraph = boost::adjacency_list<
    boost::vecS,
    boost::vecS,
    boost::directedS,
    boost::property<boost::vertex_color_t,
                    boost::default_color_type,
                    boost::property<boost::vertex_predecessor_t,
                                    CutTraits::edge_descriptor,
                                    boost::property<boost::vertex_distance_t, long>>>,
    boost::property<boost::edge_capacity_t,
                    Capacity,
                    boost::property<boost::edge_residual_capacity_t,
                                    Capacity,
                                    boost::property<boost::edge_reverse_t,
                                                    CutTraits::edge_descriptor>>>>;

/** \brief Returns a part of the cost as a capacity [mm^2]. */
Capacity
toCapacity (double square_meters)
{
  constexpr double square_millimeters_per_square_meter = 1e6;
  return std::llround (square_millimeters_per_square_meter * square_meters);
}

/** \brief Adds two arcs, each the reverse of the other.
 * \param[in] capacity of the arc from \p from to \p to
 * \param[in] reverse_capacity of the arc back */
void
addArcs (std::size_t from,
         std::size_t to,
         Capacity capacity,
         Capacity reverse_capacity,
         CutGraph& graph)
{
  const auto arc = boost::add_edge (from, to, graph).first;
  const auto reverse = boost::add_edge (to, from, graph).first;
  boost::put (boost::edge_capacity, graph, arc, capacity);
  boost::put (boost::edge_capacity, graph, reverse, reverse_capacity);
  boost::put (boost::edge_reverse, graph, arc, reverse);
  boost::put (boost::edge_reverse, graph, reverse, arc);
}

} // namespace

std::vector<char>
cellsInside (const std::vector<CellEvidence>& cells,
             const std::vector<CellBorder>& borders)
{
  // The vertices: one for each cell, then the source and the sink of the flow.
  const std::size_t inside = cells.size();
  const std::size_t outside = cells.size() + 1;
  CutGraph graph (cells.size() + 2);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto& [covered, uncovered, border_without_wall] = cells[i];
    const Capacity cost_of_outside = toCapacity (covered);
    const Capacity cost_of_inside =
        toCapacity (uncovered + constants.max_unseen * border_without_wall);
    addArcs (inside, i, cost_of_outside, 0, graph);
    addArcs (i, outside, cost_of_inside, 0, graph);
  }
  for (const auto& [first, second, open_length] : borders) {
    const Capacity cost = toCapacity (constants.max_unseen * open_length);
    addArcs (first, second, cost, cost, graph);
  }
  boost::boykov_kolmogorov_max_flow (graph, inside, outside);
  // Vertices on the source's side of the cut are black.
  std::vector<char> is_inside;
  const auto colors = boost::get (boost::vertex_color, graph);
  for (std::size_t i = 0; i < cells.size(); ++i)
    is_inside.push_back (colors[i] ==
                         boost::color_traits<boost::default_color_type>::black());
  return is_inside;
}

} // namespace pcl_ops::internal::buildings
