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

/** \brief The finite inliers of a plane, projected onto it and sorted by their
 * positions there. So the pieces do not depend on the order of the points in the cloud.
 */
struct ProjectedInliers {
  /** \brief Indices into the cloud. */
  pcl::Indices indices;
  /** \brief For each of \ref indices the index of its position in \ref positions. */
  std::vector<std::uint32_t> position_of;
  /** \brief Distinct positions in the plane [m]. */
  PlanarPoints positions;
};

ProjectedInliers
projectedInliersOf (const CloudView& cloud, const PlaneSegment& plane)
{
  const PlaneFrame frame (plane.centroid, plane.normal);
  struct Inlier {
    Eigen::Vector2d position; // in the plane [m]
    double height;            // over the plane [m]
    pcl::index_t index;       // into the cloud
  };
  std::vector<Inlier> sorted;
  for (const pcl::index_t index : plane.inliers) {
    const Eigen::Vector3d point =
        Eigen::Map<const Eigen::Vector3f> (cloud[index]).cast<double>();
    if (point.allFinite()) // NaN cannot be sorted
      sorted.push_back (
          {frame.toPlane (point), plane.normal.dot (point - plane.centroid), index});
  }
  std::sort (sorted.begin(), sorted.end(), [] (const Inlier& a, const Inlier& b) {
    return std::make_tuple (a.position.x(), a.position.y(), a.height) <
           std::make_tuple (b.position.x(), b.position.y(), b.height);
  });
  ProjectedInliers inliers;
  for (const Inlier& inlier : sorted) {
    if (inliers.positions.empty() || inliers.positions.back() != inlier.position)
      inliers.positions.push_back (inlier.position);
    inliers.indices.push_back (inlier.index);
    inliers.position_of.push_back (
        static_cast<std::uint32_t> (inliers.positions.size() - 1));
  }
  return inliers;
}

/** \brief Two positions, and the distance between them [m]. */
struct Link {
  double length;
  std::uint32_t first, second; // indices of the positions, first < second

  bool
  operator<(const Link& other) const
  {
    return std::tie (length, first, second) <
           std::tie (other.length, other.first, other.second);
  }
};

/** \brief Disjoint sets of indices (union-find). The root of a set is its smallest
 * index; its size is the sum of the sizes given for its indices. */
class DisjointSets {
public:
  /** \param[in] sizes of the sets at first: each index is a set of its own */
  explicit DisjointSets (const std::vector<std::size_t>& sizes)
  : parents_ (sizes.size()), sizes_ (sizes)
  {
    std::iota (parents_.begin(), parents_.end(), 0U);
  }

  /** \brief Returns the root of the set of an index. */
  std::uint32_t
  rootOf (std::uint32_t i)
  {
    while (parents_[i] != i) {
      parents_[i] = parents_[parents_[i]];
      i = parents_[i];
    }
    return i;
  }

  /** \brief Returns the size of the set of an index. */
  std::size_t
  sizeOf (std::uint32_t i)
  {
    return sizes_[rootOf (i)];
  }

  /** \brief Joins the sets of two indices. */
  void
  join (std::uint32_t i, std::uint32_t j)
  {
    const auto [root, child] = std::minmax ({rootOf (i), rootOf (j)});
    if (root == child)
      return;
    parents_[child] = root;
    sizes_[root] += sizes_[child];
  }

private:
  std::vector<std::uint32_t> parents_; // of each index; a root is its own parent
  std::vector<std::size_t> sizes_;     // of the sets, at their roots
};

/** \brief Returns the second shortest of four distances, one for each pair of opposite
 * octants: the distance to the nearer of their two neighbors. Returns the shortest if
 * no other one is finite. Along a line of positions only one of the four is short; at a
 * corner of an area at least two are. At the border of an area a neighbor in one of two
 * opposite octants is enough.
 * \param[in] lengths by octant; squares of lengths give the square of the result */
double
secondShortest (const std::array<double, octants>& lengths)
{
  constexpr std::size_t directions = octants / 2;
  std::array<double, directions> shorter; // of both lengths in opposite octants
  for (std::size_t i = 0; i < directions; ++i)
    shorter[i] = std::min (lengths[i], lengths[i + directions]);
  std::sort (shorter.begin(), shorter.end());
  return std::isfinite (shorter[1]) ? shorter[1] : shorter[0];
}

/** \brief Spacing of the positions around one of them [m].
 * \param[in] neighbors of that position */
double
spacingAt (const OctantNeighbors& neighbors)
{
  return std::sqrt (secondShortest (neighbors.squared_distances));
}

/** \brief Gap between a group of positions and the next positions around it [m]. Where
 * noise has widened the scan lines of a lidar, it is the gap between two lines. */
double
gapAround (const OctantTree::Group& group, const PlanarPoints& positions)
{
  std::array<double, octants> gaps;
  for (std::size_t octant = 0; octant < octants; ++octant) {
    gaps[octant] = std::sqrt (group.neighbors.squared_distances[octant]);
    const std::uint32_t neighbor = group.neighbors.points[octant];
    if (neighbor == no_neighbor)
      continue;
    const Eigen::Vector2d direction =
        (positions[neighbor] - group.center) / gaps[octant];
    double reach = 0.0; // of the group from its center in this direction
    for (const std::uint32_t position : group.points)
      reach = std::max (reach, direction.dot (positions[position] - group.center));
    gaps[octant] -= reach;
  }
  return secondShortest (gaps);
}

/** \brief For each position its nearest neighbor in each octant, and the spacing around
 * it [m]. The links to these neighbors contain the minimum spanning tree of all
 * positions (A. C. Yao, 1982). */
struct PositionGraph {
  std::vector<OctantNeighbors> neighbors;
  std::vector<double> spacings;
};

PositionGraph
graphOf (const PlanarPoints& positions, unsigned threads)
{
  const OctantTree tree (positions);
  PositionGraph graph;
  graph.neighbors.resize (positions.size());
  graph.spacings.resize (positions.size());
  forEach (threads, positions.size(), [&] (std::size_t i) {
    graph.neighbors[i] = tree.neighborsOf (static_cast<std::uint32_t> (i));
  });
  // A single position may have near neighbors by chance, a group of positions does not.
  for (const OctantTree::Group& group : tree.groups (threads)) {
    double sum = 0.0;
    for (const std::uint32_t position : group.points)
      sum += spacingAt (graph.neighbors[position]);
    const double mean_spacing = sum / static_cast<double> (group.points.size());
    const double gap = gapAround (group, positions);
    for (const std::uint32_t position : group.points)
      graph.spacings[position] = std::max (mean_spacing, gap);
  }
  return graph;
}

/** \brief Returns for each position the label of its piece: the smallest index of the
 * positions of the piece.
 * \param[in] points_at number of points at each position */
std::vector<std::uint32_t>
pieceOfEachPosition (const PlanarPoints& positions,
                     const std::vector<std::size_t>& points_at,
                     const PlanePiecesParameters& parameters,
                     unsigned threads)
{
  const PositionGraph graph = graphOf (positions, threads);
  DisjointSets pieces (points_at);
  std::vector<Link> links_over_gaps;
  for (std::uint32_t i = 0; i < positions.size(); ++i)
    for (std::size_t octant = 0; octant < octants; ++octant) {
      const std::uint32_t j = graph.neighbors[i].points[octant];
      if (j == no_neighbor)
        continue;
      const double length = std::sqrt (graph.neighbors[i].squared_distances[octant]);
      const double spacing = std::min (graph.spacings[i], graph.spacings[j]);
      if (length <= parameters.max_gap * spacing)
        pieces.join (i, j);
      else
        links_over_gaps.push_back ({length, std::min (i, j), std::max (i, j)});
    }
  // Join pieces with fewer than min_points points to others, over the narrowest gaps
  // first.
  std::sort (links_over_gaps.begin(), links_over_gaps.end());
  for (const Link& link : links_over_gaps)
    if (std::min (pieces.sizeOf (link.first), pieces.sizeOf (link.second)) <
        parameters.min_points)
      pieces.join (link.first, link.second);
  std::vector<std::uint32_t> labels;
  for (std::uint32_t i = 0; i < positions.size(); ++i)
    labels.push_back (pieces.rootOf (i));
  return labels;
}

/** \brief Makes a piece of a plane: it has the normal of the plane, and its own
 * centroid and moments.
 * \param[in] inliers of the piece, sorted by their positions in the plane: the order
 * determines the rounding of sums */
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

/** \brief The pieces of a plane, in the order of their first positions. */
std::vector<PlaneSegment>
piecesOf (const CloudView& cloud,
          const PlaneSegment& plane,
          const PlanePiecesParameters& parameters,
          unsigned threads)
{
  const ProjectedInliers inliers = projectedInliersOf (cloud, plane);
  std::vector<std::size_t> points_at (inliers.positions.size(), 0);
  for (const std::uint32_t position : inliers.position_of)
    ++points_at[position];
  const std::vector<std::uint32_t> label_of_position =
      pieceOfEachPosition (inliers.positions, points_at, parameters, threads);
  std::vector<pcl::Indices> inliers_of_label (inliers.positions.size());
  for (std::size_t i = 0; i < inliers.indices.size(); ++i)
    inliers_of_label[label_of_position[inliers.position_of[i]]].push_back (
        inliers.indices[i]);
  // Most positions are not the first one of a piece: their indices are no labels.
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
  PlanePieces found; // in the order of the planes
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
  PlanePieces sorted; // by descending number of inliers
  for (const std::size_t i : order) {
    sorted.pieces.push_back (std::move (found.pieces[i]));
    sorted.planes.push_back (found.planes[i]);
  }
  return sorted;
}

} // namespace pcl_ops
