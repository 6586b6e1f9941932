// SPDX-FileCopyrightText: 2026 The pcl_ops authors
// SPDX-License-Identifier: BSD-3-Clause
#include "plane_joining.h"

#include <pcl_ops/plane_merging.h>

#include <map>
#include <numeric>

namespace pcl_ops::apps {

namespace {

/** \brief Two pieces of neighboring tiles, by their positions among all pieces. */
struct PiecePair {
  std::size_t first, second;
  /** \brief Number of cells in which both have points. */
  std::uint32_t shared_cells;
};

/** \brief Groups of pieces that were joined (union-find). */
class PieceGroups {
public:
  explicit PieceGroups (const std::vector<TilePiece>& pieces) : parent_ (pieces.size())
  {
    std::iota (parent_.begin(), parent_.end(), std::size_t (0));
    for (const TilePiece& piece : pieces)
      moments_.push_back (piece.seen_moments);
  }

  /** \brief Returns the first piece of the group of a piece. */
  std::size_t
  rootOf (std::size_t piece)
  {
    while (parent_[piece] != piece) {
      parent_[piece] = parent_[parent_[piece]]; // shortens the path of later calls
      piece = parent_[piece];
    }
    return piece;
  }

  /** \brief Joins the groups of two pieces if \ref mergePlanes merges them. */
  void
  join (std::size_t piece, std::size_t other)
  {
    const auto [first, second] = std::minmax ({rootOf (piece), rootOf (other)});
    if (first == second)
      return;
    // With a threshold of 0 no pair passes the test by the distances of centroids: only
    // the angle and the noise decide. The factor is that of Sampling::Surfels, also for
    // tiles that were searched on neighborhoods.
    MergingParameters by_noise;
    by_noise.distance_threshold = 0.0;
    by_noise.noise_factor = 1.5;
    const MergedPlanes merged =
        mergePlanes ({moments_[first], moments_[second]}, by_noise);
    const bool are_merged =
        merged.moments.size() == 1 && merged.merged_into[0] == merged.merged_into[1];
    if (!are_merged)
      return;
    parent_[second] = first;
    moments_[first] = merged.moments[0];
  }

private:
  /** \brief For each piece an earlier piece of its group, or the piece itself if it is
   * the first one. */
  std::vector<std::size_t> parent_;
  /** \brief For the first piece of each group: moments of the points of all its pieces,
   * with those in halos. */
  std::vector<Moments> moments_;
};

/** \brief Adds the pairs of pieces of two tiles, a and b, that both have points in at
 * least three cells.
 * \param[in] a, b border voxels of the tiles, in ascending order
 * \param[in] first_of_a, first_of_b positions of the first pieces of the tiles among
 * all pieces
 */
void
addPairs (const std::vector<BorderVoxel>& a,
          const std::vector<BorderVoxel>& b,
          std::size_t first_of_a,
          std::size_t first_of_b,
          std::vector<PiecePair>& pairs)
{
  using PieceOfAAndOfB = std::pair<std::uint32_t, std::uint32_t>;
  std::map<PieceOfAAndOfB, std::uint32_t> shared_cells;
  auto in_b = b.begin();
  for (const BorderVoxel& voxel : a) {
    while (in_b != b.end() && in_b->cell < voxel.cell)
      ++in_b;
    for (auto other = in_b; other != b.end() && other->cell == voxel.cell; ++other)
      ++shared_cells[{voxel.piece, other->piece}];
  }
  // Chosen by hand. It only limits which pairs are tested: PieceGroups::join decides
  // whether two pieces are one plane.
  constexpr std::uint32_t min_shared_cells = 3;
  for (const auto& [pieces, cells] : shared_cells) {
    const auto [piece_of_a, piece_of_b] = pieces;
    if (cells >= min_shared_cells)
      pairs.push_back ({first_of_a + piece_of_a, first_of_b + piece_of_b, cells});
  }
}

/** \brief Returns the pairs of pieces of all neighboring tiles, by falling number of
 * shared cells.
 * \param[in] first_piece position of each tile's first piece among all pieces */
std::vector<PiecePair>
pairsOf (const std::vector<TileKey>& tiles,
         const std::vector<std::size_t>& first_piece,
         const std::function<TilePlanes (const TileKey&)>& load)
{
  // Steps to four of the eight neighbors of a tile: so each pair of tiles is visited
  // once.
  constexpr std::array<TileKey, 4> steps = {{{0, 1}, {1, -1}, {1, 0}, {1, 1}}};
  std::vector<PiecePair> pairs;
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    std::optional<TilePlanes> own;
    for (const TileKey& step : steps) {
      const TileKey next{tiles[i][0] + step[0], tiles[i][1] + step[1]};
      const auto found = std::lower_bound (tiles.begin(), tiles.end(), next);
      if (found == tiles.end() || *found != next)
        continue;
      if (!own)
        own = load (tiles[i]);
      const std::size_t other = found - tiles.begin();
      addPairs (own->border_voxels,
                load (next).border_voxels,
                first_piece[i],
                first_piece[other],
                pairs);
    }
  }
  const auto shares_more = [] (const PiecePair& one, const PiecePair& other) {
    return one.shared_cells > other.shared_cells;
  };
  std::stable_sort (pairs.begin(), pairs.end(), shares_more);
  return pairs;
}

/** \brief Adds a piece to its plane, and moves its edges there. Has to be called for
 * all pieces of a tile before those of the next tile. */
void
addPiece (TilePiece& piece, const TileKey& tile, JoinedPlane& plane)
{
  const bool is_first = plane.tiles.empty();
  if (is_first) {
    plane.moments.unit = piece.own_moments.unit; // the same for all pieces
    plane.normal = piece.normal;
    plane.fit = fitPlane (piece.seen_moments).value_or (PlaneFit());
  }
  plane.moments.sums += piece.own_moments.sums;
  const bool is_same_side = plane.normal.dot (piece.normal) >= 0.0;
  for (const OutlineEdge& edge : piece.edges)
    plane.edges.push_back (is_same_side ? edge : OutlineEdge{edge.to, edge.from});
  piece.edges = {}; // frees much memory
  if (is_first || plane.tiles.back() != tile)
    plane.tiles.push_back (tile);
  for (const std::uint32_t input : piece.inputs)
    if (std::find (plane.inputs.begin(), plane.inputs.end(), input) ==
        plane.inputs.end())
      plane.inputs.push_back (input);
}

/** \brief Returns the number of each piece's plane. Planes are numbered from 1 on by
 * falling number of points, and those of equal size in the order of their first pieces.
 */
std::vector<std::uint32_t>
planeNumbersOf (const std::vector<TilePiece>& pieces, PieceGroups& groups)
{
  // Number of points of each group, for the first piece of the group.
  std::vector<ExactMoments::Int128> points (pieces.size());
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const std::size_t root = groups.rootOf (i);
    points[root] += pieces[i].own_moments.count();
    if (root == i)
      roots.push_back (i);
  }
  const auto is_larger = [&] (std::size_t one, std::size_t other) {
    return points[one] > points[other];
  };
  std::stable_sort (roots.begin(), roots.end(), is_larger);
  std::vector<std::uint32_t> numbers (pieces.size());
  for (std::size_t plane = 0; plane < roots.size(); ++plane)
    numbers[roots[plane]] = plane + 1;
  for (std::size_t i = 0; i < pieces.size(); ++i)
    numbers[i] = numbers[groups.rootOf (i)];
  return numbers;
}

} // namespace

JoinedPlanes
joinPlanes (const std::vector<TileKey>& tiles,
            const std::function<TilePlanes (const TileKey&)>& load)
{
  std::vector<TilePiece> pieces;
  // Of each tile, by its position among all pieces.
  std::vector<std::size_t> first_piece;
  for (const TileKey& tile : tiles) {
    first_piece.push_back (pieces.size());
    for (TilePiece& piece : load (tile).pieces)
      pieces.push_back (std::move (piece));
  }
  PieceGroups groups (pieces);
  for (const PiecePair& pair : pairsOf (tiles, first_piece, load))
    groups.join (pair.first, pair.second);

  const std::vector<std::uint32_t> numbers = planeNumbersOf (pieces, groups);
  first_piece.push_back (pieces.size()); // end of the pieces of the last tile
  JoinedPlanes joined{{}, std::vector<std::vector<std::uint32_t>> (tiles.size())};
  if (!numbers.empty())
    joined.planes.resize (*std::max_element (numbers.begin(), numbers.end()));
  for (std::size_t t = 0; t < tiles.size(); ++t)
    for (std::size_t i = first_piece[t]; i < first_piece[t + 1]; ++i) {
      addPiece (pieces[i], tiles[t], joined.planes[numbers[i] - 1]);
      joined.numbers[t].push_back (numbers[i]);
    }
  for (JoinedPlane& plane : joined.planes)
    plane.fit = fitPlane (plane.moments.toMoments()).value_or (plane.fit);
  return joined;
}

} // namespace pcl_ops::apps
