// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "base/parallel.h"
#include "cloud/octant_neighbors.h"
#include "geometry/inliers.h"
#include <pcl_ops/detail/detection.h>
#include <pcl_ops/plane_extent.h>
#include <pcl_ops/plane_pieces.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace pcl_ops {
using namespace internal;
namespace {

/** \brief The finite inliers of a plane, projected onto it and sorted by their places,
 * the distinct positions there. So the pieces do not depend on the order of the points
 * in the cloud. */
struct PlacedInliers {
  /** \brief Indices into the cloud. */
  pcl::Indices indices;
  /** \brief For each of \ref indices the index of its place in \ref places. */
  std::vector<std::uint32_t> place_of;
  /** \brief Distinct positions on the plane [m]. */
  PlanarPoints places;
};

PlacedInliers
placedInliersOf (const CloudView& cloud, const PlaneSegment& plane)
{
  const PlaneFrame frame (plane.centroid, plane.normal);
  struct Placed {
    Eigen::Vector2d place;
    double height;
    pcl::index_t index;
  };
  std::vector<Placed> all;
  for (const pcl::index_t index : plane.inliers) {
    const Eigen::Vector3d point =
        Eigen::Map<const Eigen::Vector3f> (cloud[index]).cast<double>();
    if (point.allFinite()) // NaN cannot be sorted
      all.push_back (
          {frame.toPlane (point), plane.normal.dot (point - plane.centroid), index});
  }
  std::sort (all.begin(), all.end(), [] (const Placed& a, const Placed& b) {
    return std::make_tuple (a.place.x(), a.place.y(), a.height) <
           std::make_tuple (b.place.x(), b.place.y(), b.height);
  });
  PlacedInliers inliers;
  for (const Placed& placed : all) {
    if (inliers.places.empty() || inliers.places.back() != placed.place)
      inliers.places.push_back (placed.place);
    inliers.indices.push_back (placed.index);
    inliers.place_of.push_back (static_cast<std::uint32_t> (inliers.places.size() - 1));
  }
  return inliers;
}

/** \brief Two places, first < second, and the distance between them [m]. */
struct Link {
  double length;
  std::uint32_t first, second;

  bool
  operator<(const Link& other) const
  {
    return std::tie (length, first, second) <
           std::tie (other.length, other.first, other.second);
  }
};

/** \brief Union-find with sizes; the root of a set is its smallest member. */
class DisjointSets {
public:
  explicit DisjointSets (const std::vector<std::size_t>& sizes)
  : parents_ (sizes.size()), sizes_ (sizes)
  {
    std::iota (parents_.begin(), parents_.end(), 0U);
  }

  std::uint32_t
  find (std::uint32_t i)
  {
    while (parents_[i] != i) {
      parents_[i] = parents_[parents_[i]];
      i = parents_[i];
    }
    return i;
  }

  std::size_t
  sizeOf (std::uint32_t i)
  {
    return sizes_[find (i)];
  }

  void
  join (std::uint32_t i, std::uint32_t j)
  {
    const auto [root, child] = std::minmax ({find (i), find (j)});
    if (root == child)
      return;
    parents_[child] = root;
    sizes_[root] += sizes_[child];
  }

private:
  std::vector<std::uint32_t> parents_;
  std::vector<std::size_t> sizes_;
};

/** \brief The second shortest of four distances, one for each pair of opposite octants:
 * to the nearer neighbor of both. The shortest if no other is finite. Along a line of
 * places only one is short; at a corner of an area two or more are. At the border of an
 * area a neighbor on one side is enough.
 * \param[in] lengths by octant; squares of lengths give the square of the result */
double
secondShortest (const std::array<double, octants>& lengths)
{
  constexpr std::size_t directions = octants / 2;
  std::array<double, directions> shorter;
  for (std::size_t i = 0; i < directions; ++i)
    shorter[i] = std::min (lengths[i], lengths[i + directions]);
  std::sort (shorter.begin(), shorter.end());
  return std::isfinite (shorter[1]) ? shorter[1] : shorter[0];
}

/** \brief Spacing of the places around one of them [m]. */
double
spacingAt (const OctantNeighbors& neighbors)
{
  return std::sqrt (secondShortest (neighbors.squared_distances));
}

/** \brief Gap between a group of places and the next places around it [m]. Where noise
 * has widened the scan lines of a lidar, it is the distance between two lines. */
double
distanceAround (const OctantTree::Group& group, const PlanarPoints& places)
{
  std::array<double, octants> lengths;
  for (std::size_t o = 0; o < octants; ++o) {
    lengths[o] = std::sqrt (group.neighbors.squared_distances[o]);
    const std::uint32_t neighbor = group.neighbors.points[o];
    if (neighbor == no_neighbor)
      continue;
    const Eigen::Vector2d direction = (places[neighbor] - group.center) / lengths[o];
    double reach = 0.0;
    for (const std::uint32_t place : group.points)
      reach = std::max (reach, direction.dot (places[place] - group.center));
    lengths[o] -= reach;
  }
  return secondShortest (lengths);
}

/** \brief Links each place to its nearest neighbor in each octant, and has the spacing
 * around each place. The links contain the minimum spanning tree of all places (Yao,
 * 1982). */
struct PlaceGraph {
  std::vector<OctantNeighbors> neighbors;
  std::vector<double> spacings;
};

PlaceGraph
graphOf (const PlanarPoints& places, unsigned threads)
{
  const OctantTree tree (places);
  PlaceGraph graph;
  graph.neighbors.resize (places.size());
  graph.spacings.resize (places.size());
  forEach (threads, places.size(), [&] (std::size_t i) {
    graph.neighbors[i] = tree.neighborsOf (static_cast<std::uint32_t> (i));
  });
  // A single place may have near neighbors by chance, a group of places does not.
  for (const OctantTree::Group& group : tree.groups (threads)) {
    double sum = 0.0;
    for (const std::uint32_t place : group.points)
      sum += spacingAt (graph.neighbors[place]);
    const double mean = sum / static_cast<double> (group.points.size());
    const double around = distanceAround (group, places);
    for (const std::uint32_t place : group.points)
      graph.spacings[place] = std::max (mean, around);
  }
  return graph;
}

/** \brief Returns for each place the label of its piece: the smallest index of the
 * places of the piece.
 * \param[in] points_at number of points at each place */
std::vector<std::uint32_t>
pieceOfEachPlace (const PlanarPoints& places,
                  const std::vector<std::size_t>& points_at,
                  const PlanePiecesParameters& parameters,
                  unsigned threads)
{
  const PlaceGraph graph = graphOf (places, threads);
  DisjointSets pieces (points_at);
  std::vector<Link> wide; // links over gaps
  for (std::uint32_t i = 0; i < places.size(); ++i)
    for (std::size_t o = 0; o < octants; ++o) {
      const std::uint32_t j = graph.neighbors[i].points[o];
      if (j == no_neighbor)
        continue;
      const double length = std::sqrt (graph.neighbors[i].squared_distances[o]);
      const double spacing = std::min (graph.spacings[i], graph.spacings[j]);
      if (length <= parameters.max_gap * spacing)
        pieces.join (i, j);
      else
        wide.push_back ({length, std::min (i, j), std::max (i, j)});
    }
  // Joins small pieces over gaps, the narrowest first.
  std::sort (wide.begin(), wide.end());
  for (const Link& link : wide)
    if (std::min (pieces.sizeOf (link.first), pieces.sizeOf (link.second)) <
        parameters.min_points)
      pieces.join (link.first, link.second);
  std::vector<std::uint32_t> labels;
  for (std::uint32_t i = 0; i < places.size(); ++i)
    labels.push_back (pieces.find (i));
  return labels;
}

/** \brief A piece of a plane.
 * \param[in] inliers sorted by places, as rounding of sums depends on the order */
PlaneSegment
pieceOf (const CloudView& cloud, const PlaneSegment& plane, pcl::Indices inliers)
{
  PlaneSegment piece = plane;
  piece.moments = Moments();
  piece.moments.origin = plane.centroid;
  for (const pcl::index_t index : inliers) {
    const Eigen::Vector3d offset =
        Eigen::Map<const Eigen::Vector3f> (cloud[index]).cast<double>() -
        plane.centroid;
    piece.moments.add (offset.x(), offset.y(), offset.z());
  }
  piece.centroid = piece.moments.centroid();
  piece.centroid -= plane.plane().distance (piece.centroid) * plane.normal;
  piece.moments = piece.moments.about (piece.centroid);
  std::sort (inliers.begin(), inliers.end());
  piece.inliers = std::move (inliers);
  return piece;
}

/** \brief The pieces of a plane, in the order of their first places. */
std::vector<PlaneSegment>
piecesOf (const CloudView& cloud,
          const PlaneSegment& plane,
          const PlanePiecesParameters& parameters,
          unsigned threads)
{
  const PlacedInliers inliers = placedInliersOf (cloud, plane);
  std::vector<std::size_t> points_at (inliers.places.size(), 0);
  for (const std::uint32_t place : inliers.place_of)
    ++points_at[place];
  const std::vector<std::uint32_t> label_of_place =
      pieceOfEachPlace (inliers.places, points_at, parameters, threads);
  std::vector<pcl::Indices> inliers_of_label (inliers.places.size());
  for (std::size_t i = 0; i < inliers.indices.size(); ++i)
    inliers_of_label[label_of_place[inliers.place_of[i]]].push_back (
        inliers.indices[i]);
  // Most labels have no piece.
  inliers_of_label.erase (
      std::remove_if (inliers_of_label.begin(),
                      inliers_of_label.end(),
                      [] (const pcl::Indices& of_piece) { return of_piece.empty(); }),
      inliers_of_label.end());
  if (inliers_of_label.size() <= 1)
    return {plane};
  std::vector<PlaneSegment> pieces;
  for (pcl::Indices& of_piece : inliers_of_label)
    pieces.push_back (pieceOf (cloud, plane, std::move (of_piece)));
  return pieces;
}

} // namespace

std::string
validate (const PlanePiecesParameters& parameters)
{
  if (!(parameters.max_gap >= 1.0 && std::isfinite (parameters.max_gap)))
    return "the widest gap must be a number of spacings from 1";
  return {};
}

PlanePieces
findPlanePieces (const CloudView& cloud,
                 const std::vector<PlaneSegment>& planes,
                 const PlanePiecesParameters& parameters,
                 unsigned threads)
{
  detail::throwOn (validate (parameters));
  PlanePieces found;
  for (std::size_t p = 0; p < planes.size(); ++p) {
    checkInliers (cloud, planes[p]);
    for (PlaneSegment& piece : piecesOf (cloud, planes[p], parameters, threads)) {
      found.pieces.push_back (std::move (piece));
      found.planes.push_back (p);
    }
  }
  std::vector<std::size_t> order (found.pieces.size());
  std::iota (order.begin(), order.end(), 0U);
  std::stable_sort (order.begin(), order.end(), [&] (std::size_t a, std::size_t b) {
    return found.pieces[a].inliers.size() > found.pieces[b].inliers.size();
  });
  PlanePieces sorted;
  for (const std::size_t i : order) {
    sorted.pieces.push_back (std::move (found.pieces[i]));
    sorted.planes.push_back (found.planes[i]);
  }
  return sorted;
}

} // namespace pcl_ops
